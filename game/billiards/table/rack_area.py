"""The triangle of straight pool: fourteen places, the outline, and which balls are in the way of a rack (WPA
4.2, 4.8).
"""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.billiards.table.rack import BALL_RADIUS, FOOT_SPOT, HEAD_SPOT, eight_ball_rack
from game.billiards.table.table import Table
from game.physics.kernels import elementary

Point = tuple[float, float]

_TABLE = Table.pool()
MIDDLE = 0.5 * _TABLE.width
HEAD, CENTRE, FOOT = ((MIDDLE, share * _TABLE.length) for share in (HEAD_SPOT, 0.5, FOOT_SPOT))  # spots, m
APEX, LEFT_CORNER, RIGHT_CORNER = range(3)


def rack_places() -> Floats:
    """Places (15, 2) m of the rack, the apex on the foot spot first, then row by row."""
    places = eight_ball_rack(_TABLE, BALL_RADIUS)[1:]
    return places[np.lexsort((places[:, 0], places[:, 1]))]


def _corners() -> tuple[Point, Point, Point]:
    """Where the middles of the three outermost balls lie, m: apex, left and right end of the last row."""
    places = rack_places()
    apex, left, right = (tuple(places[k].tolist()) for k in (0, 10, 14))
    return apex, left, right


def in_rack_area(place: Point, radius: float = BALL_RADIUS) -> bool:
    """True if a ball at (x, y) m is within the outline of the rack, or overlaps it (4.8).

    The outline is drawn round the outermost balls, a ball's radius from their middles.
    """
    return _distance_to_triangle(place, _corners()) < radius + BALL_RADIUS


def blocks(place: Point, spot: Point, radius: float = BALL_RADIUS) -> bool:
    """True if no ball can lie on a spot (m) while one lies at (x, y) m."""
    return elementary.hypot(place[0] - spot[0], place[1] - spot[1]) < radius + BALL_RADIUS


def behind_head_string(place: Point) -> bool:
    """True if the middle of a ball at (x, y) m is on the head string, or behind it."""
    return place[1] <= HEAD[1]


def _distance_to_triangle(place: Point, corners: tuple[Point, Point, Point]) -> float:
    """Distance from (x, y) m to a triangle, 0 inside."""
    sides = [(corners[k], corners[(k + 1) % 3]) for k in range(3)]
    turns = [(b[0] - a[0]) * (place[1] - a[1]) - (b[1] - a[1]) * (place[0] - a[0]) for a, b in sides]
    if all(turn >= 0.0 for turn in turns) or all(turn <= 0.0 for turn in turns):
        return 0.0
    return min(_distance_to_side(place, a, b) for a, b in sides)


def _distance_to_side(place: Point, a: Point, b: Point) -> float:
    """Distance from (x, y) m to the stretch from a to b."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    share = ((place[0] - a[0]) * dx + (place[1] - a[1]) * dy) / (dx * dx + dy * dy)
    share = min(max(share, 0.0), 1.0)
    return elementary.hypot(place[0] - a[0] - share * dx, place[1] - a[1] - share * dy)
