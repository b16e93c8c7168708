"""What a query answers, and the proof that it is right."""

from __future__ import annotations

from typing import Any, NamedTuple

from game.physics.narrowphase.convex import ConvexPolygon, as_polygon
from game.physics.narrowphase.features import Feature

CERTAIN = 1e-12  # of the extent: what the certificate may lack by rounding
Point = tuple[float, float]


class Proximity(NamedTuple):
    """How near two convex polygons are.

    distance: m; minus the depth if they overlap: so far must one be shifted to part them. point_a,
    point_b: the closest points (m); in an overlap the deepest point, and where it comes to the border.
    feature_a, feature_b: what they lie on. iterations: steps of the method. normal: unit vector from A to
    B, along which B goes away.
    """

    distance: float
    point_a: Point
    point_b: Point
    feature_a: Feature
    feature_b: Feature
    iterations: int
    normal: Point = (0.0, 0.0)

    @property
    def overlapping(self) -> bool:
        """True if they touch or overlap."""
        return self.distance <= 0.0

    def swapped(self) -> Proximity:
        """The same with A and B exchanged."""
        x, y = self.normal
        return Proximity(
            self.distance, self.point_b, self.point_a, self.feature_b, self.feature_a, self.iterations,
            (-x, -y),
        )  # fmt: skip


def extent_of(a: ConvexPolygon, b: ConvexPolygon) -> float:
    """Largest difference of a coordinate among both, m."""
    low = [min(p.vertices[:, k].min() for p in (a, b)) for k in (0, 1)]
    high = [max(p.vertices[:, k].max() for p in (a, b)) for k in (0, 1)]
    return float(max(top - least for least, top in zip(low, high, strict=True)))


def gap_along(a: ConvexPolygon, b: ConvexPolygon, normal: Point) -> float:
    """How far apart two polygons are along a unit vector from A to B, m; negative if they overlap in it."""
    x, y = normal
    offset = b.anchor - a.anchor
    farthest = (a.local[:, 0] * x + a.local[:, 1] * y).max()
    nearest = (b.local[:, 0] * x + b.local[:, 1] * y).min()
    return float(nearest - farthest + offset[0] * x + offset[1] * y)


def certify(shape_a: Any, shape_b: Any, found: Proximity) -> float:
    """Prove an answer without searching for a better one; how much is lacking, in extents of the pair.

    The points lie on the polygons, so they cannot be nearer than said; and no points are nearer than the gap
    along the normal. In an overlap the gap is the depth, and the normal is one of those that bound A - B.
    ValueError, saying what is wrong, if more than 1e-12 is lacking.
    """
    a, b = as_polygon(shape_a), as_polygon(shape_b)
    extent = extent_of(a, b) or 1.0
    gap = gap_along(a, b, found.normal) if found.normal != (0.0, 0.0) else 0.0
    lacking = (found.distance - gap) / extent
    if not abs(lacking) <= CERTAIN:
        raise ValueError(f"proximity: says {found.distance!r} m, but along its normal the gap is {gap!r} m")
    dx, dy = (q - p for p, q in zip(found.point_a, found.point_b, strict=True))
    x, y = found.normal
    apart = max(abs(dx - found.distance * x), abs(dy - found.distance * y)) / extent
    if found.normal != (0.0, 0.0) and not apart <= CERTAIN + 8e-16 * abs(a.anchor).max() / extent:
        raise ValueError(f"proximity: the points are off by {apart:.3g} extents from distance and normal")
    return max(abs(lacking), apart)
