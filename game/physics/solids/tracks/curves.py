"""Tracks as a person gives them, and the pieces that kernels roll along.

A curve through points is a cubic spline by chord length, with two continuous derivatives, but for corners. A
ball touches a side of a curve. Both sides and the round of each end and corner are pieces of one boundary,
which a ball always has on its right: normals point to the left.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats, Ints
from game.physics.kernels import elementary, elementwise
from game.physics.solids.outlines import checked_points, without_doubles

CUBIC, VERTEX = 0, 1
# columns of a piece: kind; x and y as polynomials of t, 0 to 1; of a vertex, direction of its normal at t = 0
# and how far it turns (rad); way along the curve at t = 0 and 1, m; number of the curve; its length if closed
KIND, CX, CY, PHI, SWEEP, FROM, TO, TRACK, AROUND = 0, 1, 5, 9, 10, 11, 12, 13, 14
PIECE_WIDTH = 15
SWEEPS = 60  # of Jacobi's method; each halves the error
MOST_POINTS = 20_000


@dataclass(frozen=True, slots=True)
class Curve:
    """Through points (n, 2) m. closed: the last is joined to the first. corner: a turn of more degrees than
    that between two chords is a corner; 0: all are (a polyline).
    """

    points: ArrayLike = field(compare=False)
    closed: bool = False
    corner: float = 35.0

    def checked(self) -> Floats:
        """Points without doubles. ValueError for nonsense."""
        points = without_doubles(checked_points("points", self.points, 2), self.closed)
        if len(points) < (3 if self.closed else 2):
            raise ValueError("points: a track needs at least two different points, three if it is closed")
        if len(points) > MOST_POINTS:
            raise ValueError(f"points: {len(points)}, expected at most {MOST_POINTS}")
        if not 0.0 <= self.corner <= 180.0:
            raise ValueError(f"corner = {self.corner!r}: expected 0 to 180 degrees")
        return points


class Pieces(NamedTuple):
    """rows (n, PIECE_WIDTH), links (n, 2): the piece before and the one after; boxes (n, 4) m."""

    rows: Floats
    links: Ints
    boxes: Floats


def moved_aside(points: ArrayLike, distance: float) -> Floats:
    """The curve (n, 2) at so many m to the left of an open one, for a track on which a centre follows it."""
    given = np.asarray(points, dtype=np.float64)
    chords = elementwise.hypot(*np.diff(given, axis=0).T)
    slopes = tangents(given, chords, closed=False)
    lengths = elementwise.hypot(slopes[:, 0], slopes[:, 1])[:, None]
    moved: Floats = given + distance * np.stack([-slopes[:, 1], slopes[:, 0]], axis=1) / lengths
    return moved


def tangents(points: Floats, chords: Floats, closed: bool) -> Floats:
    """Derivatives (n, 2) of the spline by chord length at its points; chords (n or n - 1,) m."""
    if closed:
        slopes = (np.roll(points, -1, axis=0) - points) / chords[:, None]
        after, before = 1.0 / chords, 1.0 / np.roll(chords, 1)
        target = 3.0 * (slopes * after[:, None] + np.roll(slopes, 1, axis=0) * before[:, None])
        found = 0.5 * (slopes + np.roll(slopes, 1, axis=0))
        for _ in range(SWEEPS):
            rest = (
                target
                - np.roll(found, -1, axis=0) * after[:, None]
                - np.roll(found, 1, axis=0) * before[:, None]
            )
            found = rest / (2.0 * (after + before))[:, None]
        return found
    slopes = np.diff(points, axis=0) / chords[:, None]
    if len(points) == 2:
        return np.concatenate([slopes, slopes])
    found = np.concatenate([slopes[:1], 0.5 * (slopes[1:] + slopes[:-1]), slopes[-1:]])
    found[0] = _end_slope(points[:4], chords[:3])
    found[-1] = -_end_slope(points[:-5:-1], chords[:-4:-1])
    after, before = 1.0 / chords[1:], 1.0 / chords[:-1]
    target = 3.0 * (slopes[1:] * after[:, None] + slopes[:-1] * before[:, None])
    for _ in range(SWEEPS):
        rest = target - found[2:] * after[:, None] - found[:-2] * before[:, None]
        found[1:-1] = rest / (2.0 * (after + before))[:, None]
    return found


def _end_slope(points: Floats, chords: Floats) -> Floats:
    """Derivative at the first of up to four points, of the polynomial through them."""
    places = np.concatenate([[0.0], np.cumsum(chords)])
    slope = np.zeros(2)
    for j in range(1, len(places)):
        others = [k for k in range(1, len(places)) if k != j]
        weight = math.prod(places[k] / (places[k] - places[j]) for k in others) / places[j]
        slope += weight * (points[j] - points[0])
    return slope


def pieces_of(curves: list[Curve]) -> Pieces:
    """Both sides of all curves."""
    rows: list[Floats] = []
    links: list[tuple[int, int]] = []
    for number, curve in enumerate(curves):
        forward = _runs(curve, number)
        backward = [_reversed(row) for row in reversed(forward)]
        for ring in [forward, backward] if curve.closed else [[*forward, *backward]]:
            around = _with_vertices(ring)
            first, count = len(rows), len(around)
            rows.extend(around)
            links.extend((first + (k - 1) % count, first + (k + 1) % count) for k in range(count))
    table = np.array(rows) if rows else np.zeros((0, PIECE_WIDTH))
    return Pieces(table, np.array(links, dtype=np.int32).reshape(-1, 2), _boxes(table))


def _runs(curve: Curve, number: int) -> list[Floats]:
    """Cubic pieces of a curve in its own direction, smooth between corners."""
    points = curve.checked()
    ring = np.concatenate([points, points[:1]]) if curve.closed else points
    chords = elementwise.hypot(*np.diff(ring, axis=0).T)
    ways = np.diff(ring, axis=0) / chords[:, None]
    before = np.roll(ways, 1, axis=0)
    turns = np.degrees(np.abs(elementwise.arctan2(
        before[:, 0] * ways[:, 1] - before[:, 1] * ways[:, 0], (before * ways).sum(axis=1)
    )))  # fmt: skip
    first = 0 if curve.closed else 1
    corners = [k for k in range(first, len(ways)) if turns[k] > curve.corner]
    if curve.closed and not corners:
        slopes = tangents(points, chords, closed=True)
        ends = np.concatenate([slopes, slopes[:1]])
        starts, stops = ends[:-1], ends[1:]
    else:
        if curve.closed and corners[0] != 0:  # begin at a corner
            return _runs(Curve(np.roll(points, -corners[0], axis=0), True, curve.corner), number)
        cuts = sorted({0, *corners, len(ways)})
        starts, stops = np.zeros_like(ways), np.zeros_like(ways)
        for a, b in pairwise(cuts):
            slopes = tangents(ring[a : b + 1], chords[a:b], closed=False)
            starts[a:b], stops[a:b] = slopes[:-1], slopes[1:]
    rows, way = [], 0.0
    total = float(chords.sum()) if curve.closed else 0.0
    for k, chord in enumerate(chords.tolist()):
        row = np.zeros(PIECE_WIDTH)
        a, b = ring[k], ring[k + 1]
        u, v = starts[k] * chord, stops[k] * chord
        for axis, column in ((0, CX), (1, CY)):
            row[column : column + 4] = (
                a[axis], u[axis], 3.0 * (b[axis] - a[axis]) - 2.0 * u[axis] - v[axis],
                2.0 * (a[axis] - b[axis]) + u[axis] + v[axis],
            )  # fmt: skip
        row[FROM], row[TO], row[TRACK], row[AROUND] = way, way + chord, number, total
        rows.append(row)
        way += chord
    return rows


def _reversed(row: Floats) -> Floats:
    """A cubic piece from its end to its beginning."""
    back = row.copy()
    for column in (CX, CY):
        a, b, c, d = row[column : column + 4]
        back[column : column + 4] = a + b + c + d, -(b + 2.0 * c + 3.0 * d), c + 3.0 * d, -d
    back[FROM], back[TO] = row[TO], row[FROM]
    return back


def _with_vertices(ring: list[Floats]) -> list[Floats]:
    """The pieces of a closed boundary, with the rounds of corners that turn to the right between them."""
    found = []
    for k, row in enumerate(ring):
        found.append(row)
        after = ring[(k + 1) % len(ring)]
        ux, uy = (row[c + 1] + 2.0 * row[c + 2] + 3.0 * row[c + 3] for c in (CX, CY))
        vx, vy = after[CX + 1], after[CY + 1]
        turn = elementary.atan2(ux * vy - uy * vx, ux * vx + uy * vy)
        if abs(abs(turn) - math.pi) < 1e-9:
            turn = -math.pi
        if turn < -1e-7:
            vertex = np.zeros(PIECE_WIDTH)
            vertex[KIND], vertex[CX], vertex[CY] = VERTEX, after[CX], after[CY]
            vertex[PHI], vertex[SWEEP] = elementary.atan2(ux, -uy), turn
            vertex[FROM] = vertex[TO] = row[TO]
            vertex[TRACK], vertex[AROUND] = row[TRACK], row[AROUND]
            found.append(vertex)
    return found


def _boxes(rows: Floats) -> Floats:
    """x0, y0, x1, y1 of each piece: of the points of its Bezier form."""
    boxes = np.zeros((len(rows), 4))
    for axis, column in ((0, CX), (1, CY)):
        a, b, c, d = (rows[:, column + k] for k in range(4))
        points = np.stack([a, a + b / 3.0, a + (2.0 * b + c) / 3.0, a + b + c + d])
        boxes[:, axis], boxes[:, 2 + axis] = points.min(axis=0), points.max(axis=0)
    return boxes


class Grid(NamedTuple):
    """Which pieces are in which cell: frame (x0, y0, cell) m, shape (columns, rows), starts, members."""

    frame: Floats
    shape: Ints
    starts: Ints
    members: Ints


def grid_of(boxes: Floats, most: int = 250_000) -> Grid:
    """Cells about as large as a piece, no more than ``most``."""
    if not len(boxes):
        return Grid(
            np.array([0.0, 0.0, 1.0]), np.zeros(2, np.int32), np.zeros(1, np.int32), np.zeros(0, np.int32)
        )
    low, high = boxes[:, :2].min(axis=0), boxes[:, 2:].max(axis=0)
    extent = np.maximum(high - low, 1e-6)
    size = max(
        2.0 * float(np.median((boxes[:, 2:] - boxes[:, :2]).max(axis=1))), float(extent.max()) / 400.0, 1e-6
    )
    size = max(size, math.sqrt(float(extent[0] * extent[1]) / most))
    columns, rows = (int(n) + 1 for n in (extent / size).tolist())
    first = np.floor((boxes[:, :2] - low) / size).astype(int)
    last = np.floor((boxes[:, 2:] - low) / size).astype(int)
    cells: list[list[int]] = [[] for _ in range(columns * rows)]
    for k in range(len(boxes)):
        for row in range(first[k, 1], last[k, 1] + 1):
            for column in range(first[k, 0], last[k, 0] + 1):
                cells[row * columns + column].append(k)
    starts = np.concatenate([[0], np.cumsum([len(cell) for cell in cells])]).astype(np.int32)
    members = np.array([k for cell in cells for k in cell], dtype=np.int32)
    return Grid(np.array([*low, size]), np.array([columns, rows], np.int32), starts, members)
