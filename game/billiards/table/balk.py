"""Barred zones of a carom table: corners of straight rail, boxes and anchors of the balkline games.

Numbers of articles are those of the Union Mondiale de Billard, World rules of carom billiard. A ball is where
its middle is.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.billiards.table.table import CAROM_LENGTH, CAROM_WIDTH

Point = tuple[float, float]

CORNER_LONG, CORNER_SHORT = 0.71, 0.355  # m; legs of a barred corner of straight rail (52, paper B)
ANCHOR = 0.178  # m; side of an anchor (72)
BOX_47, BOX_71 = CAROM_WIDTH / 3.0, 0.5 * CAROM_WIDTH  # m; lines lie so far from the cushions (73)


class Zone(NamedTuple):
    """A part of the bed: planes (a, b, c) with a x + b y < c inside, and its corners (x, y) m in order."""

    planes: tuple[tuple[float, float, float], ...]
    corners: tuple[Point, ...]

    def holds(self, places: ArrayLike) -> NDArray[np.bool_]:
        """Which of the places (..., 2) m lie in it."""
        at = np.asarray(places, dtype=np.float64)
        inside = np.ones(at.shape[:-1], np.bool_)
        for a, b, c in self.planes:
            inside &= a * at[..., 0] + b * at[..., 1] < c
        return inside


class Barred(NamedTuple):
    """The zones of a game. boxes: corners or boxes, which do not overlap; anchors: squares beside those.

    strokes: points that may be made with both object balls in one zone before one of them leaves it, the one
    that enters it left out: 1 at a game of two strokes, 0 at a game of one; None: nothing is barred.
    """

    boxes: tuple[Zone, ...]
    anchors: tuple[Zone, ...] = ()
    strokes: int | None = None


def zone_at(zones: tuple[Zone, ...], place: Point) -> int:
    """Number of the zone at (x, y) m, -1 for none."""
    x, y = place
    for number, zone in enumerate(zones):
        if all(a * x + b * y < c for a, b, c in zone.planes):
            return number
    return -1


def _box(left: float, lower: float, right: float, upper: float) -> Zone:
    """A rectangle; sides on a cushion bar nothing."""
    planes = []
    if left > 0.0:
        planes.append((-1.0, 0.0, -left))
    if right < CAROM_WIDTH:
        planes.append((1.0, 0.0, right))
    if lower > 0.0:
        planes.append((0.0, -1.0, -lower))
    if upper < CAROM_LENGTH:
        planes.append((0.0, 1.0, upper))
    return Zone(tuple(planes), ((left, lower), (right, lower), (right, upper), (left, upper)))


def _corner(right: bool, upper: bool) -> Zone:
    """A triangle in a corner of the table."""
    x, y = (CAROM_WIDTH if right else 0.0), (CAROM_LENGTH if upper else 0.0)
    a, b = (-1.0 if right else 1.0) / CORNER_SHORT, (-1.0 if upper else 1.0) / CORNER_LONG
    ends = (x + 1.0 / a, y), (x, y + 1.0 / b)
    return Zone(((a, b, 1.0 + a * x + b * y),), ((x, y), *ends))


def _balkline(across: tuple[float, ...], along: tuple[float, ...], strokes: int) -> Barred:
    """Boxes between lines at x = across and y = along (m), and an anchor astride each end of a line (72)."""
    xs, ys = (0.0, *across, CAROM_WIDTH), (0.0, *along, CAROM_LENGTH)
    boxes = tuple(
        _box(xs[i], ys[j], xs[i + 1], ys[j + 1]) for j in range(len(ys) - 1) for i in range(len(xs) - 1)
    )
    half = 0.5 * ANCHOR
    at_short = [_box(x - half, y, x + half, y + ANCHOR) for x in across for y in (0.0, CAROM_LENGTH - ANCHOR)]
    at_long = [_box(x, y - half, x + ANCHOR, y + half) for y in along for x in (0.0, CAROM_WIDTH - ANCHOR)]
    return Barred(boxes, (*at_short, *at_long), strokes)


CORNERS = tuple(_corner(right, upper) for upper in (False, True) for right in (False, True))
STRAIGHT_RAIL = Barred(CORNERS, (), 1)
BALKLINE_47_2 = _balkline((BOX_47, CAROM_WIDTH - BOX_47), (BOX_47, CAROM_LENGTH - BOX_47), 1)
BALKLINE_47_1 = BALKLINE_47_2._replace(strokes=0)
BALKLINE_71_2 = _balkline((BOX_71,), (BOX_71, CAROM_LENGTH - BOX_71), 1)
FREE = Barred(CORNERS)  # of cushion games: nothing is barred
