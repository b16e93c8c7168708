"""What a straight shot first meets: the ghost ball, and the lines that leave it.

Geometry only: straight paths, no friction, no spin. The lecture's table plays so; for the exact table it is
the first guess that the simulator then corrects.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.billiards.table.table import Table
from game.physics.kernels import elementary


class FirstContact(NamedTuple):
    """What a ball meets first on a straight path.

    kind: "ball", "cushion", "pocket" or "nothing". distance: m along the path. ghost: centre of the moving
    ball there, (2,) m. target: index of the ball, rail or pocket, -1 for nothing. normal: unit vector from
    the ghost to what is met. cut: rad, angle between path and normal, for a ball.
    """

    kind: str
    distance: float
    ghost: tuple[float, float]
    target: int
    normal: tuple[float, float]
    cut: float


def first_contact(
    ball: int, angle: float, positions: Floats, radii: Floats, in_play: NDArray[np.bool_], table: Table
) -> FirstContact:
    """First contact of ball ``ball`` sent off at ``angle`` (rad from the x axis).

    positions (n, 2) m, radii (n,) m, in_play (n,) bool. Balls meet where their outlines in the plane do, at
    r1 + r2. Balls already in contact count only if the path leads into them.
    """
    x, y = float(positions[ball, 0]), float(positions[ball, 1])
    ux, uy = elementary.cos(angle), elementary.sin(angle)
    best = FirstContact("nothing", math.inf, (x, y), -1, (ux, uy), 0.0)
    for other in range(len(radii)):
        if other == ball or not in_play[other]:
            continue
        reach = float(radii[ball] + radii[other])
        dx, dy = float(positions[other, 0]) - x, float(positions[other, 1]) - y
        distance = _circle_entry(dx, dy, ux, uy, reach)
        if distance < best.distance:
            ghost = (x + distance * ux, y + distance * uy)
            normal = ((positions[other, 0] - ghost[0]) / reach, (positions[other, 1] - ghost[1]) / reach)
            cosine = min(max(ux * normal[0] + uy * normal[1], -1.0), 1.0)
            best = FirstContact("ball", distance, ghost, other, normal, elementary.acos(cosine))
    for index, row in enumerate(table.pockets):
        distance = _circle_entry(float(row[0]) - x, float(row[1]) - y, ux, uy, float(row[2]))
        if distance < best.distance:
            ghost = (x + distance * ux, y + distance * uy)
            best = FirstContact("pocket", distance, ghost, index, (ux, uy), 0.0)
    for index, rail in enumerate(table.cushions):
        distance = _rail_distance(rail, x, y, ux, uy, float(radii[ball]))
        if distance < best.distance:
            ghost = (x + distance * ux, y + distance * uy)
            best = FirstContact("cushion", distance, ghost, index, (-float(rail[4]), -float(rail[5])), 0.0)
    return best


def _circle_entry(dx: float, dy: float, ux: float, uy: float, reach: float) -> float:
    """Distance along unit vector u at which a point comes within ``reach`` of (dx, dy); inf if never."""
    along = dx * ux + dy * uy
    if along <= 0.0:
        return math.inf
    across = dx * uy - dy * ux
    under = (reach - across) * (reach + across)
    return math.inf if under <= 0.0 else max(along - math.sqrt(under), 0.0)


def _rail_distance(rail: Floats, x: float, y: float, ux: float, uy: float, radius: float) -> float:
    """Distance until a disc of ``radius`` meets the straight stretch of a rail; inf if it passes by."""
    from_x, from_y, to_x, to_y, nx, ny = (float(value) for value in rail)
    closing = -(ux * nx + uy * ny)
    if closing <= 1e-12:
        return math.inf
    distance = ((x - from_x) * nx + (y - from_y) * ny - radius) / closing
    if distance < -radius:
        return math.inf
    foot_x, foot_y = x + distance * ux, y + distance * uy
    dx, dy = to_x - from_x, to_y - from_y
    share = ((foot_x - from_x) * dx + (foot_y - from_y) * dy) / (dx * dx + dy * dy)
    return max(distance, 0.0) if 0.0 <= share <= 1.0 else math.inf
