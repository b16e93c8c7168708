"""Floors as chains of points, and where something stands on them."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats, Point
from game.physics.kernels import elementary
from game.scenes.domino.level import FloorEntry, PieceEntry, RowEntry

ARC_DEGREES = 3.0  # of a chord of an arc


class Standing(NamedTuple):
    """A domino's foot (m) and how it leans (rad, anticlockwise); ``turn``: its size over its row's."""

    x: float
    y: float
    lean: float
    larger: float


def floor_points(floor: FloorEntry) -> Floats:
    """Points (n, 2) m of a floor, from its left end on. ValueError for a piece that goes nowhere."""
    points, heading = [floor.start], 0.0
    for k, piece in enumerate(floor.pieces):
        added, heading = _piece(points[-1], heading, piece)
        if not added:
            raise ValueError(f"pieces[{k}]: it goes nowhere")
        points += added
    found = np.array(points)
    if not (np.diff(found[:, 0]) > 0.0).any():  # nothing can stand on it: `height_at` asks for such a piece
        raise ValueError("pieces: no part of the floor leads to the right")
    return found


def _piece(start: Point, heading: float, piece: PieceEntry) -> tuple[list[Point], float]:
    x, y = start
    if piece.radius and piece.turn:
        turn, side = math.radians(piece.turn), math.copysign(1.0, piece.turn)
        reach = side * piece.radius
        cx, cy = x - reach * elementary.sin(heading), y + reach * elementary.cos(heading)
        count = max(1, math.ceil(abs(piece.turn) / ARC_DEGREES))
        angles = [heading + turn * (k + 1) / count for k in range(count)]
        places = [(cx + reach * elementary.sin(a), cy - reach * elementary.cos(a)) for a in angles]
        return places, heading + turn
    if not (piece.run or piece.rise):
        return [], heading
    if piece.steps:
        tread, rise = piece.run / piece.steps, piece.rise / piece.steps
        places = []
        for k in range(piece.steps):
            places += [(x + k * tread, y + (k + 1) * rise), (x + (k + 1) * tread, y + (k + 1) * rise)]
        return places, 0.0
    return [(x + piece.run, y + piece.rise)], elementary.atan2(piece.rise, piece.run)


def height_at(points: Floats, x: float) -> Point:
    """Height (m) and slope (rad) of a floor at x; beyond its ends those of the ends.

    Of pieces one above the other the lowest counts.
    """
    low, high = points[:-1], points[1:]
    over = np.flatnonzero((low[:, 0] <= x) & (x < high[:, 0]) & (high[:, 0] > low[:, 0]))
    if len(over):
        k = int(over[0])
    else:
        rising = np.flatnonzero(high[:, 0] > low[:, 0])
        k = int(rising[0] if x < points[0, 0] or not len(rising) else rising[-1])
    (x0, y0), (x1, y1) = low[k].tolist(), high[k].tolist()
    slope = elementary.atan2(y1 - y0, x1 - x0)
    return y0 + (min(max(x, x0), x1) - x0) * elementary.tan(slope), slope


def row_places(row: RowEntry, points: Floats, gap: float) -> list[Standing]:
    """Where the dominoes of a row stand, upright to their floor, ``gap`` (m) apart."""
    found, x, larger = [], row.x, 1.0
    for _ in range(row.count):
        y, slope = height_at(points, x)
        found.append(Standing(x, y, slope, larger))
        pitch = gap * larger + 0.5 * row.size[0] * larger * (1.0 + row.grows)
        x += row.to * pitch
        larger *= row.grows
    return found
