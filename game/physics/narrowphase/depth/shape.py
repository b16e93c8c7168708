"""Shapes of convex parts: what comes in is checked, and measured for the object norm."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from game.arrays import Floats
from game.physics.kernels import elementary, elementwise, linear
from game.physics.narrowphase.depth.grid import overlap_of
from game.physics.narrowphase.depth.sums import Parts

MOST_PARTS, MOST_CORNERS = 24, 64
SAME = 1e-9  # of the extent: parts that overlap by less merely touch, corners nearer than that are one


class Shape:
    """A body of convex parts that do not overlap, about its centroid.

    parts: sequences of (n, 2) m, counterclockwise, convex, 3 to 64 corners each, at most 24 of them.
    ValueError naming part and reason otherwise.

    corners: (n, 2) m about the centroid; starts: (parts + 1,); reaches: (parts,) m, farthest corner from the
    centroid; area m²; gyration: m, root of the polar second moment of area over the area.
    """

    def __init__(self, parts: Sequence[Any]) -> None:
        if not 1 <= len(parts) <= MOST_PARTS:
            raise ValueError(f"parts: expected 1 to {MOST_PARTS}, not {len(parts)}")
        outlines = [_checked(number, part) for number, part in enumerate(parts)]
        self.starts = np.cumsum([0, *(len(outline) for outline in outlines)]).astype(np.int64)
        anchor = outlines[0][0]
        corners = np.concatenate(outlines) - anchor
        pieces = np.array(
            [_moments(corners[a:b]) for a, b in zip(self.starts, self.starts[1:], strict=False)]
        )
        self.area = float(pieces[:, 0].sum())
        middle = pieces[:, 1:3].sum(axis=0) / self.area
        self.centroid: Floats = middle + anchor
        self.corners: Floats = corners - middle
        polar = float(pieces[:, 3].sum()) / self.area - float(linear.product(middle, middle))
        self.gyration = math.sqrt(max(polar, 0.0))
        far = elementwise.hypot(*self.corners.T)
        self.reaches: Floats = np.maximum.reduceat(far, self.starts[:-1])
        self._refuse_overlaps()

    def _refuse_overlaps(self) -> None:
        for i in range(len(self)):
            for j in range(i):
                one, other = (
                    Parts(self.part(k), np.array((0, len(self.part(k)))), np.zeros(1)) for k in (j, i)
                )
                if overlap_of(one, other, 0.0, 0.0, 0.0) > SAME * self.reach:
                    raise ValueError(f"part {i}: overlaps part {j}")

    def __len__(self) -> int:
        return len(self.starts) - 1

    @property
    def reach(self) -> float:
        """m from the centroid to the farthest corner."""
        return float(self.reaches.max())

    def part(self, number: int) -> Floats:
        """Corners (n, 2) m of a part, about the centroid of all."""
        return self.corners[self.starts[number] : self.starts[number + 1]]

    def placed(self, x: float, y: float, angle: float) -> list[Floats]:
        """The corners (n, 2) m of each part, the centroid at (x, y) m, turned by ``angle`` rad."""
        turned = linear.product(self.corners, _turn(angle)) + np.array((x, y))
        return np.split(turned, self.starts[1:-1])

    def norm(self, x: float, y: float, angle: float) -> float:
        """The object norm (m) of a motion: root of the mean square displacement of all points."""
        return elementary.length(x, y, 2.0 * self.gyration * elementary.sin(0.5 * angle))


def _turn(angle: float) -> Floats:
    """What rows (x, y) are multiplied by, on the right."""
    c, s = elementary.cos(angle), elementary.sin(angle)
    return np.array(((c, s), (-s, c)))


def _checked(number: int, points: Any) -> Floats:
    """A part's corners; ValueError."""
    try:
        part = np.array(points, dtype=np.float64)
    except (TypeError, ValueError):
        raise ValueError(f"part {number}: expected rows of two numbers") from None
    if part.ndim != 2 or part.shape[1:] != (2,) or not 3 <= len(part) <= MOST_CORNERS:
        raise ValueError(f"part {number}: expected 3 to {MOST_CORNERS} corners (x, y), not {part.shape}")
    if not np.isfinite(part).all():
        raise ValueError(
            f"part {number}: corner {int(np.argmin(np.isfinite(part).all(axis=1)))} is not finite"
        )
    extent = float(np.ptp(part, axis=0).max())
    if not 1e-50 < extent < 1e50:
        raise ValueError(f"part {number}: its extent must be within 1e-50 to 1e50 m")
    edges = np.roll(part, -1, axis=0) - part
    lengths = elementwise.hypot(*edges.T)
    if lengths.min() <= SAME * extent:
        raise ValueError(f"part {number}: corners {int(np.argmin(lengths))} and the next coincide")
    after = np.roll(edges, -1, axis=0)
    crosses = edges[:, 0] * after[:, 1] - edges[:, 1] * after[:, 0]
    heading = elementwise.arctan2(crosses, np.sum(edges * after, axis=1))
    if heading.sum() < 0.0:
        raise ValueError(f"part {number}: goes clockwise")
    if heading.min() < -SAME:
        corner = (int(np.argmin(heading)) + 1) % len(part)
        raise ValueError(f"part {number}: not convex at corner {corner}")
    if abs(heading.sum() - 2.0 * math.pi) > 0.1:
        raise ValueError(f"part {number}: goes round more than once")
    if _moments(part - part[0])[0] <= 1e-12 * extent * extent:
        raise ValueError(f"part {number}: has no area")
    return part


def _moments(part: Floats) -> tuple[float, float, float, float]:
    """Area, its first moments about the origin, and its polar second moment, by triangles from corner 0."""
    root = part[0]
    u, v = part[1:-1] - root, part[2:] - root
    areas = 0.5 * (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])
    area = float(areas.sum())
    first = linear.product(areas, u + v) / 3.0
    second = float(linear.product(areas, np.sum(u * u + v * v + u * v, axis=1))) / 6.0
    polar = second + 2.0 * float(linear.product(root, first)) + area * float(linear.product(root, root))
    return area, float(first[0] + area * root[0]), float(first[1] + area * root[1]), polar
