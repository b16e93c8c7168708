"""What a hand does to tracks: finds the one that is meant, bends it, draws another with few points."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from game.arrays import Floats
from game.physics.kernels import elementwise, linear
from game.physics.solids.tracks import Curve
from game.worlds.entries.entry import Point

CORNER = 50.0  # degrees: a drawn track has a corner where it turns by more
EXACT = 0.12  # of the hand's reach: so far may a drawn track be from the hand's path
SHORTEST = 2.0  # of the hand's reach

NOBODY = -1


def nearest_curve(curves: Sequence[Curve], point: Point, reach: float) -> int:
    """The curve that comes nearest to a point (m), within ``reach``; NOBODY if none does."""
    best, found = reach, NOBODY
    for k, curve in enumerate(curves):
        points = np.asarray(curve.points)
        starts = points if curve.closed else points[:-1]
        along = (np.roll(points, -1, axis=0) if curve.closed else points[1:]) - starts
        at = ((np.array(point) - starts) * along).sum(axis=1) / np.maximum(
            (along * along).sum(axis=1), 1e-300
        )
        near = starts + np.clip(at, 0.0, 1.0)[:, None] * along
        away = float(elementwise.hypot(*(near - point).T).min())
        if away < best:
            best, found = away, k
    return found


def bent(curve: Curve, before: Point, point: Point, width: float) -> Curve:
    """A curve whose points have followed the hand, the nearer the farther; ``width``: m, of the bend."""
    points = np.array(curve.points, dtype=np.float64)
    away = elementwise.hypot(*(points - before).T) / width
    points += elementwise.exp(-(away * away))[:, None] * (np.array(point) - np.array(before))
    return Curve(points, curve.closed, curve.corner)


def drawn(path: Sequence[Point], reach: float, most: int | None = None) -> Curve | None:
    """The curve of a hand's path, of at most so many points; None if it is too short to be one."""
    points = simplified(np.array(path), EXACT * reach)[:most]
    if len(points) < 2 or float(elementwise.hypot(*np.diff(points, axis=0).T).sum()) < SHORTEST * reach:
        return None
    return Curve(points, corner=CORNER)


def simplified(points: Floats, tolerance: float) -> Floats:
    """Points (n, 2) m of a line, of which none that is left out lies farther than ``tolerance`` from it."""
    keep = np.zeros(len(points), dtype=bool)
    keep[0] = keep[-1] = True
    parts = [(0, len(points) - 1)]
    while parts:
        first, last = parts.pop()
        if last - first < 2:
            continue
        a, way = points[first], points[last] - points[first]
        between = points[first + 1 : last] - a
        length = float(elementwise.hypot(*way))
        if length > 0.0:
            along = np.clip(linear.product(between, way) / (length * length), 0.0, 1.0)
            away = elementwise.hypot(*(between - along[:, None] * way).T)
        else:
            away = elementwise.hypot(*between.T)
        k = int(away.argmax())
        if away[k] > tolerance:
            middle = first + 1 + k
            keep[middle] = True
            parts += [(first, middle), (middle, last)]
    return points[keep]
