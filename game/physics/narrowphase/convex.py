"""Convex polygons: what comes in is cleaned, what is not convex is refused and its hull offered."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.kernels import elementary, linear
from game.physics.narrowphase.cleaning import NOT_CONVEX, clean_outline

LARGEST = 1e75  # m: products of four lengths stay finite
SMALLEST = 1e-75  # m: and do not vanish


class NonConvexError(ValueError):
    """An outline that is not convex. hull: the polygon to stand in; vertex: where it turns wrongly."""

    def __init__(self, hull: ConvexPolygon, vertex: int):
        super().__init__(f"outline: not convex at vertex {vertex}; its hull has {len(hull)} vertices")
        self.hull = hull
        self.vertex = vertex


class ConvexPolygon:
    """A convex polygon, a segment or a point, whose corners turn left one after the other.

    points: (n, 2) m in order, either way round; repeated vertices and flat corners are dropped.
    NonConvexError if the outline turns both ways, crosses itself or goes round twice; ValueError for no
    points, numbers that are not finite, and sizes beyond 1e75.

    vertices: (k, 2) m, counterclockwise, read-only. source: (k,) the given point of each. anchor: vertex 0;
    local: (k, 2) vertices from the anchor, so that what is far from the origin loses no digits. Edge i goes
    from vertex i to the next.
    """

    __slots__ = ("anchor", "centre", "local", "source", "vertices")
    vertices: Floats
    local: Floats
    anchor: Floats
    centre: Floats
    source: NDArray[np.int64]

    def __init__(self, points: Any) -> None:
        given = outline_points(points)
        kept = np.empty(len(given), dtype=np.int64)
        count, vertex = clean_outline(given, kept, np.empty_like(kept))
        if count == NOT_CONVEX:
            raise NonConvexError(convex_hull(given), int(vertex))
        self._take(given[kept[:count]], kept[:count].copy())

    def _take(self, vertices: Floats, source: NDArray[np.int64]) -> None:
        self.vertices = vertices
        self.source = source
        self.anchor = vertices[0].copy()
        self.local = vertices - self.anchor
        self.centre = self.local.mean(axis=0)
        for array in (self.vertices, self.source):
            array.flags.writeable = False

    def moved(self, x: float = 0.0, y: float = 0.0, angle: float = 0.0) -> ConvexPolygon:
        """The polygon turned by ``angle`` (rad) about the origin, then shifted by (x, y) m.

        ValueError unless these are finite.
        """
        if not (math.isfinite(x) and math.isfinite(y) and math.isfinite(angle)):
            raise ValueError(f"moved: x, y, angle must be finite, not {x}, {y}, {angle}")
        c, s = (elementary.cos(angle), elementary.sin(angle)) if angle else (1.0, 0.0)
        turned = np.array(((c, s), (-s, c)))
        copy = object.__new__(ConvexPolygon)
        copy.source = self.source
        copy.anchor = linear.product(self.anchor, turned) + np.array((x, y))
        copy.local = linear.product(self.local, turned)
        copy.centre = linear.product(self.centre, turned)
        copy.vertices = copy.local + copy.anchor
        copy.vertices.flags.writeable = False
        return copy

    def __len__(self) -> int:
        return len(self.vertices)

    def __repr__(self) -> str:
        return f"ConvexPolygon({len(self)} vertices, extent {self.extent:.6g} m)"

    @property
    def extent(self) -> float:
        """Larger side of the box around it, m."""
        return float(np.ptp(self.local, axis=0).max())

    @property
    def area(self) -> float:
        """m²; 0 for a segment or a point."""
        x, y = self.local.T
        return 0.5 * float(linear.product(x, np.roll(y, -1)) - linear.product(y, np.roll(x, -1)))

    def normals(self) -> Floats:
        """Outward unit normals (k, 2) of its edges; none for a point."""
        if len(self) == 1:
            return np.zeros((0, 2))
        edges = np.roll(self.local, -1, axis=0) - self.local
        lengths = np.sqrt((edges * edges).sum(axis=1))
        return np.column_stack((edges[:, 1], -edges[:, 0])) / lengths[:, None]

    def holds(self, x: float, y: float) -> bool:
        """True if a point is inside or on the border."""
        dx, dy = x - self.anchor[0], y - self.anchor[1]
        if len(self) == 1:
            return bool(dx == 0.0 and dy == 0.0)
        edges = np.roll(self.local, -1, axis=0) - self.local
        beside = edges[:, 0] * (dy - self.local[:, 1]) - edges[:, 1] * (dx - self.local[:, 0])
        along = edges[:, 0] * (dx - self.local[:, 0]) + edges[:, 1] * (dy - self.local[:, 1])
        return bool((beside >= 0.0).all() and (len(self) > 2 or (along >= 0.0).all()))

    def check(self) -> None:
        """ValueError unless all corners turn left, once round."""
        kept = np.empty(len(self), dtype=np.int64)
        count, vertex = clean_outline(self.local, kept, np.empty_like(kept))
        if count != len(self):
            raise ValueError(f"convex polygon: does not turn left at vertex {vertex}")


def outline_points(points: Any) -> Floats:
    """Points (n, 2) of an outline as float64, contiguous; ValueError if they are none."""
    try:
        given = np.ascontiguousarray(points, dtype=np.float64)
    except (TypeError, ValueError):
        raise ValueError("outline: expected rows of two numbers") from None
    if given.ndim != 2 or given.shape[1:] != (2,) or not len(given):
        raise ValueError(f"outline: expected at least one point (x, y), not an array {given.shape}")
    if not np.isfinite(given).all():
        raise ValueError(f"outline: point {int(np.argmin(np.isfinite(given).all(axis=1)))} is not finite")
    if np.abs(given).max() > LARGEST:
        raise ValueError(f"outline: coordinates must be within {LARGEST:g} m")
    extent = float(np.ptp(given, axis=0).max())
    if 0.0 < extent < SMALLEST:
        raise ValueError(f"outline: must be larger than {SMALLEST:g} m, or a point")
    return given


def convex_hull(points: Any) -> ConvexPolygon:
    """Hull of any points (n, 2), by a chain below and one above. Source: A. M. Andrew 1979."""
    given = outline_points(points)
    order = np.lexsort((given[:, 1], given[:, 0])).tolist()
    rows = given.tolist()

    def chain(way: Iterable[int]) -> list[int]:
        stack: list[int] = []
        for k in way:
            while len(stack) > 1 and _turn(rows[stack[-2]], rows[stack[-1]], rows[k]) <= 0.0:
                stack.pop()
            stack.append(k)
        return stack

    below, above = chain(order), chain(reversed(order))
    corners = np.array(below[:-1] + above[:-1] or below[:1])
    polygon = ConvexPolygon(given[corners])
    polygon.source = corners[polygon.source]
    polygon.source.flags.writeable = False
    return polygon


def _turn(a: Sequence[float], b: Sequence[float], c: Sequence[float]) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def as_polygon(shape: Any) -> ConvexPolygon:
    """The polygon itself, or one made of its points; errors as `ConvexPolygon`."""
    return shape if isinstance(shape, ConvexPolygon) else ConvexPolygon(shape)
