"""What lies under a point, and what a line crosses."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from game.physics.kernels import elementary, elementwise
from game.physics.solids import SolidWorld
from game.scenes.solids.bodies import place_of, whole_joints
from game.scenes.solids.level import Point
from game.worlds.hands.grab import distance_to
from game.worlds.hands.hand import NOBODY


def bodies_at(world: SolidWorld, bodies: NDArray[np.int64], point: Point) -> list[int]:
    """All bodies of these that a point is in."""
    rows = world.bodies
    near = bodies[elementwise.hypot(*(rows.positions[bodies] - point).T) <= rows.reaches[bodies]]
    return [
        body for body in near.tolist()
        if any(distance_to(world, shape, point) <= 0.0 for shape in world.shapes_of(body).tolist())
    ]  # fmt: skip


def joint_at(world: SolidWorld, point: Point, reach: float) -> int:
    """The joint with an end within reach (m) of a point; NOBODY."""
    best, found = reach, NOBODY
    for joint in whole_joints(world):
        for end in (0, 1):
            away = elementary.dist(place_of(world, joint, end), point)
            if away < best:
                best, found = away, joint
    return found


def joints_across(world: SolidWorld, start: Point, end: Point, reach: float) -> list[int]:
    """Joints that a line crosses: between their ends, or within reach (m) of a point where both are."""
    found = []
    for joint in whole_joints(world):
        a, b = place_of(world, joint, 0), place_of(world, joint, 1)
        if elementary.dist(a, b) > reach:
            if _cross(a, b, start, end):
                found.append(joint)
        elif _distance(a, start, end) < reach:
            found.append(joint)
    return found


def _side(a: Point, b: Point, p: Point) -> float:
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])


def _cross(a: Point, b: Point, c: Point, d: Point) -> bool:
    return _side(a, b, c) * _side(a, b, d) < 0.0 and _side(c, d, a) * _side(c, d, b) < 0.0


def _distance(p: Point, a: Point, b: Point) -> float:
    dx, dy = b[0] - a[0], b[1] - a[1]
    length = dx * dx + dy * dy
    at = 0.0 if length == 0.0 else min(max(((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / length, 0.0), 1.0)
    return elementary.hypot(p[0] - a[0] - at * dx, p[1] - a[1] - at * dy)
