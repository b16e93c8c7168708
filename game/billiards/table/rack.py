"""Racks: where the balls lie before the break.

Row i of the positions is ball i, row 0 the cue ball on the head spot; metres in the table's frame. The
apex ball lies on the foot spot, three quarters up the table.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from game.billiards.table.table import Table
from game.physics.kernels import elementwise, linear

BALL_RADIUS = 0.028575  # m; 2 1/4 inches across (WPA equipment specification 16)
BALL_MASS = 0.170097  # kg; 6 ounces

EIGHT_BALL_ORDER = (1, 9, 2, 3, 8, 10, 11, 4, 12, 5, 6, 13, 7, 14, 15)  # rows of 1, 2, 3, 4, 5 from the apex
NINE_BALL_ORDER = (1, 2, 3, 4, 9, 5, 6, 7, 8)  # rows of 1, 2, 3, 2, 1
TEN_BALL_ORDER = (1, 2, 3, 4, 10, 5, 6, 7, 8, 9)  # rows of 1, 2, 3, 4
EIGHT_PLACE = 4  # the middle of both racks
BACK_CORNERS = (10, 14)
HEAD_SPOT = 0.25  # of the table's length
FOOT_SPOT = 0.75


def eight_ball_rack(
    table: Table, radius: float = BALL_RADIUS, gap: float = 0.0, seed: int | None = None
) -> NDArray[np.float64]:
    """Positions (16, 2) m of an eight-ball rack: the 8 in the middle, a solid and a stripe at the back.

    Neighbours lie `gap` m apart (0: in contact). Without a seed the order is fixed and the rack exactly
    mirror symmetric about the long axis. With one the balls are drawn at random under the same rules. Each is
    moved within a disc of diameter `gap`, so that none overlap. ValueError for absurd measures.
    """
    order = list(EIGHT_BALL_ORDER)
    rng = None if seed is None else np.random.default_rng(seed)
    if rng is not None:
        others = rng.permutation([ball for ball in range(1, 16) if ball != 8]).tolist()
        solid = next(ball for ball in others if ball < 8)
        stripe = next(ball for ball in others if ball > 8)
        corners = [solid, stripe] if rng.random() < 0.5 else [stripe, solid]
        rest = iter([ball for ball in others if ball not in corners])
        fixed = {EIGHT_PLACE: 8, **dict(zip(BACK_CORNERS, corners, strict=True))}
        order = [fixed[place] if place in fixed else next(rest) for place in range(15)]
    return _rack(table, radius, gap, (1, 2, 3, 4, 5), order, rng)


def nine_ball_rack(
    table: Table, radius: float = BALL_RADIUS, gap: float = 0.0, seed: int | None = None
) -> NDArray[np.float64]:
    """Positions (10, 2) m of a nine-ball rack: a diamond, the 1 on the foot spot, the 9 in the middle.

    `gap`, `seed` and errors as in `eight_ball_rack`.
    """
    order = list(NINE_BALL_ORDER)
    rng = None if seed is None else np.random.default_rng(seed)
    if rng is not None:
        rest = rng.permutation(range(2, 9)).tolist()
        order = [1, *rest[:3], 9, *rest[3:]]
    return _rack(table, radius, gap, (1, 2, 3, 2, 1), order, rng)


def ten_ball_rack(
    table: Table, radius: float = BALL_RADIUS, gap: float = 0.0, seed: int | None = None
) -> NDArray[np.float64]:
    """Positions (11, 2) m of a ten-ball rack (WPA 9.2): a triangle, the 1 on the foot spot, the 10 in the
    middle. `gap`, `seed` and errors as in `eight_ball_rack`.
    """
    order = list(TEN_BALL_ORDER)
    rng = None if seed is None else np.random.default_rng(seed)
    if rng is not None:
        rest = rng.permutation(range(2, 10)).tolist()
        order = [1, *rest[:3], 10, *rest[3:]]
    return _rack(table, radius, gap, (1, 2, 3, 4), order, rng)


def _rack(
    table: Table,
    radius: float,
    gap: float,
    rows: tuple[int, ...],
    order: list[int],
    rng: np.random.Generator | None,
) -> NDArray[np.float64]:
    """Rows of balls on a hexagonal lattice, apex on the foot spot."""
    _check_measures(table, radius, gap, rows)
    pitch = 2.0 * radius + gap
    middle = 0.5 * table.width
    positions = np.empty((len(order) + 1, 2))
    positions[0] = middle, HEAD_SPOT * table.length
    place = 0
    for row, count in enumerate(rows):
        y = FOOT_SPOT * table.length + row * pitch * math.sqrt(0.75)
        for k in range(count):
            # an offset that can be added and taken away without rounding keeps the rack exactly symmetric
            steps = abs(2 * k - (count - 1))
            offset = (middle + 0.5 * steps * pitch) - middle
            x = middle + offset if 2 * k > count - 1 else middle - offset
            positions[order[place]] = x, y
            place += 1
    if rng is not None and gap > 0.0:
        angle = linear.uniform(rng, 0.0, 2.0 * math.pi, len(order))
        distance = 0.5 * gap * np.sqrt(rng.random(len(order)))
        positions[1:, 0] += distance * elementwise.cos(angle)
        positions[1:, 1] += distance * elementwise.sin(angle)
    return positions


def _check_measures(table: Table, radius: float, gap: float, rows: tuple[int, ...]) -> None:
    """ValueError where the rack would not be on the bed."""
    if not (math.isfinite(radius) and radius > 0.0):
        raise ValueError(f"rack radius: must be positive and finite, got {radius!r}")
    if not (math.isfinite(gap) and gap >= 0.0):
        raise ValueError(f"rack gap: must be finite and not negative, got {gap!r}")
    pitch = 2.0 * radius + gap
    depth = (len(rows) - 1) * pitch * math.sqrt(0.75) + radius
    if max(rows) * pitch > table.width or depth > (1.0 - FOOT_SPOT) * table.length:
        raise ValueError(f"rack radius, gap: a rack of balls {pitch!r} m apart does not fit on the table")
