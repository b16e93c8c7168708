"""Convex hull of points that are sorted already: what a fit has to look at.

Source: Andrew 1979, "Another efficient algorithm for convex hulls in two dimensions" (monotone chain).
"""

from __future__ import annotations

import numpy as np

from game.physics.bounds.door import Array
from game.physics.jit import kernel


@kernel(inline="always")
def turn_of(hull, h, x, y):
    """Twice the signed area of the last two corners and (x, y): above 0 turns left."""
    ax, ay = hull[h - 2, 0], hull[h - 2, 1]
    return (hull[h - 1, 0] - ax) * (y - ay) - (hull[h - 1, 1] - ay) * (x - ax)


@kernel
def sorted_hull(points, ids, begin, end, hull):
    """Hull of ``points`` (n, 2) m listed by ``ids[begin:end]``, which sort them by x, then y.

    ``hull`` (>= 2 (end - begin) + 2, 2): written, corners counter-clockwise about the first point, so that
    nothing is lost far from the origin. Returns their number: no corner twice, none between two others.
    """
    origin_x, origin_y = points[ids[begin], 0], points[ids[begin], 1]
    h = 0
    base = 1
    for turn in range(2):
        for k in range(end - begin):
            i = ids[begin + k] if turn == 0 else ids[end - 1 - k]
            x, y = points[i, 0] - origin_x, points[i, 1] - origin_y
            if h > 0 and x == hull[h - 1, 0] and y == hull[h - 1, 1]:
                continue
            while h > base and turn_of(hull, h, x, y) <= 0.0:
                h -= 1
            hull[h, 0] = x
            hull[h, 1] = y
            h += 1
        base = h
    if h > 1:
        h -= 1  # the first corner again
    return h


def hull_of(points: Array) -> tuple[Array, Array]:
    """Corners (h, 2) of the hull of points (n, 2), counter-clockwise about an origin, and that origin."""
    ids = np.lexsort((points[:, 1], points[:, 0]))
    hull = np.empty((2 * len(points) + 2, 2))
    h = int(sorted_hull(points, ids, 0, len(ids), hull))
    return hull[:h], points[ids[0]]
