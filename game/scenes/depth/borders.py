"""The outer border of a shape of parts, and what two convex parts have in common."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.physics.kernels import elementwise, linear
from game.physics.narrowphase.depth import Shape

NEAR = 1e-7  # of the reach: an edge as near to another runs along it


def border_of(shape: Shape) -> Floats:
    """(n, 2, 2) m about the centroid: the edges of all parts without where one runs along another's."""
    edges = []
    for number in range(len(shape)):
        corners = shape.part(number)
        edges += [(number, a, b) for a, b in zip(corners, np.roll(corners, -1, axis=0), strict=True)]
    near, kept = NEAR * shape.reach, []
    for number, a, b in edges:
        length = float(elementwise.hypot(*(b - a)))
        along = (b - a) / length
        free = [(0.0, length)]
        for other, p, q in edges:
            (s0, h0), (s1, h1) = (_beside(point - a, along) for point in (p, q))
            if other != number and max(abs(h0), abs(h1)) < near and s1 < s0:
                free = [
                    piece for low, high in free for piece in ((low, min(high, s1)), (max(low, s0), high))
                    if piece[1] - piece[0] > near
                ]  # fmt: skip
        kept += [(a + low * along, a + high * along) for low, high in free]
    return np.array(kept)


def _beside(away: Floats, along: Floats) -> tuple[float, float]:
    """How far along a direction, and beside it."""
    return float(linear.product(away, along)), float(along[0] * away[1] - along[1] * away[0])


def common(one: Floats, other: Floats) -> Floats:
    """Corners (n, 2) m of what two convex counterclockwise polygons share; none if that has no area."""
    points = [tuple(corner) for corner in one.tolist()]
    for (px, py), (qx, qy) in zip(other.tolist(), np.roll(other, -1, axis=0).tolist(), strict=True):
        sides = [(qx - px) * (y - py) - (qy - py) * (x - px) for x, y in points]
        clipped = []
        for k, (x, y) in enumerate(points):
            u, v = points[k - 1]
            if (sides[k] > 0.0) != (sides[k - 1] > 0.0):
                part = sides[k - 1] / (sides[k - 1] - sides[k])
                clipped.append((u + part * (x - u), v + part * (y - v)))
            if sides[k] > 0.0:
                clipped.append((x, y))
        points = clipped
        if not points:
            break
    return np.array(points).reshape(-1, 2)
