"""Outlines: closed or open lines with a place and an angle, and what the hand asks of them."""

from __future__ import annotations

import math
from collections.abc import Sequence

import msgspec
import numpy as np
from numpy.typing import NDArray

from game.physics.kernels import elementary, linear

Point = tuple[float, float]
HANDLE_SHARE = 0.55  # of an outline's size, where its handle for turning is


class Outline(msgspec.Struct, frozen=True):
    """A closed or open line. points: m, about its own place; position: m; angle: rad."""

    points: tuple[Point, ...]
    closed: bool = True
    position: Point = (0.0, 0.0)
    angle: float = 0.0


def placed(outline: Outline) -> NDArray[np.float64]:
    """Corners (n, 2) in the world, m."""
    points = np.array(outline.points).reshape(-1, 2)
    c, s = elementary.cos(outline.angle), elementary.sin(outline.angle)
    return linear.product(points, np.array([[c, s], [-s, c]])) + outline.position


def outline_through(corners: Sequence[Point], closed: bool) -> Outline:
    """An outline whose place is the middle of its extent, not turned."""
    points = np.array(corners, dtype=np.float64).reshape(-1, 2)
    middle = 0.5 * (points.min(axis=0) + points.max(axis=0))
    own = tuple((float(x), float(y)) for x, y in points - middle)
    return Outline(own, closed, (float(middle[0]), float(middle[1])))


def size_of(outline: Outline) -> float:
    """Distance of the farthest corner from the outline's place, m."""
    return max((math.sqrt(x * x + y * y) for x, y in outline.points), default=0.0)


def handle_of(outline: Outline) -> Point:
    """Where the handle for turning is, m."""
    reach = HANDLE_SHARE * size_of(outline)
    x, y = outline.position
    return x - reach * elementary.sin(outline.angle), y + reach * elementary.cos(outline.angle)


def is_inside(point: Point, corners: NDArray[np.float64]) -> bool:
    """Whether a closed line goes round a point (crossings of a ray, Shimrat 1962)."""
    x, y = point
    a, b = corners, np.roll(corners, -1, axis=0)
    crosses = (a[:, 1] > y) != (b[:, 1] > y)
    rise = np.where(crosses, b[:, 1] - a[:, 1], 1.0)
    return bool(np.count_nonzero(crosses & (x < a[:, 0] + (y - a[:, 1]) / rise * (b[:, 0] - a[:, 0]))) % 2)


def nearest_edge(point: Point, corners: NDArray[np.float64], closed: bool) -> tuple[int, float]:
    """The edge (by its first corner) that is nearest to a point, and its distance, m."""
    if len(corners) == 1:
        return 0, elementary.dist(point, corners[0].tolist())
    a = corners if closed else corners[:-1]
    edges = (np.roll(corners, -1, axis=0) if closed else corners[1:]) - a
    off = np.array(point) - a
    length = (edges * edges).sum(axis=1)
    along = np.clip((off * edges).sum(axis=1) / np.where(length > 0.0, length, 1.0), 0.0, 1.0)
    rest = off - along[:, None] * edges
    distance = (rest * rest).sum(axis=1)
    edge = int(distance.argmin())
    return edge, math.sqrt(float(distance[edge]))
