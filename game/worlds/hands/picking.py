"""Which solid lies under a point, and how far a point is from one."""

from __future__ import annotations

import numpy as np

from game.arrays import Longs, Point
from game.physics.kernels import elementary, elementwise
from game.physics.solids import SolidWorld
from game.physics.solids.arrays.state import DISC, SEGMENT
from game.worlds.hands.hand import NOBODY


def distance_to(world: SolidWorld, shape: int, point: Point) -> float:
    """From a point to a shape, m; negative within."""
    corners, radius = world.corners(shape), float(world.shapes.radii[shape])
    if world.shapes.kinds[shape] == DISC:
        return elementary.dist(point, corners[0]) - radius
    ends = np.roll(corners, -1, axis=0)
    along = ends - corners
    lengths = (along * along).sum(axis=1)
    at = np.clip(
        ((np.array(point) - corners) * along).sum(axis=1) / np.where(lengths > 0.0, lengths, 1.0), 0, 1
    )
    nearest = float(elementwise.hypot(*(corners + at[:, None] * along - point).T).min())
    if world.shapes.kinds[shape] == SEGMENT or len(corners) == 2:
        return nearest - radius
    sides = along[:, 0] * (point[1] - corners[:, 1]) - along[:, 1] * (point[0] - corners[:, 0])
    return (-nearest if (sides >= 0.0).all() else nearest) - radius


def body_at(world: SolidWorld, bodies: Longs, point: Point, reach: float) -> int:
    """The body of these that a point is in, else the nearest within reach (m); NOBODY if there is none."""
    rows = world.bodies
    near = elementwise.hypot(*(rows.positions[bodies] - point).T) <= rows.reaches[bodies] + reach
    best, found = reach, NOBODY
    for body in bodies[near].tolist():
        for shape in world.shapes_of(body).tolist():
            away = distance_to(world, shape, point)
            if away < best:
                best, found = away, body
    return found
