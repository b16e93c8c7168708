"""Convex hull of points that are sorted already: what a fit has to look at.

Source: Andrew 1979, "Another efficient algorithm for convex hulls in two dimensions" (monotone chain).
"""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.compiler.decorator import lean_kernel


@lean_kernel(inline="always")
def turn_of(hull, h, x, y):
    """Twice the signed area of the last two corners and (x, y): above 0 turns left."""
    ax, ay = hull[h - 2, 0], hull[h - 2, 1]
    return (hull[h - 1, 0] - ax) * (y - ay) - (hull[h - 1, 1] - ay) * (x - ax)


@lean_kernel
def sorted_hull(points, ids, begin, end, hull):
    """Hull of ``points`` (n, 2) m listed by ``ids[begin:end]``, which sort them by x, then y.

    ``hull`` (>= 2 (end - begin) + 2, 2): written, corners counter-clockwise about the first point, so that
    nothing is lost far from the origin. Returns their number: no corner twice, none between two others.

    Turns are told by the points as they are: moved to the first one, two may come to stand above each other,
    in whatever order. The chain has to meet its points in order.
    """
    h = 0
    base = 1
    for turn in range(2):
        for k in range(end - begin):
            i = ids[begin + k] if turn == 0 else ids[end - 1 - k]
            x, y = points[i, 0], points[i, 1]
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
    return moved_hull(hull, h, points[ids[begin], 0], points[ids[begin], 1])


@lean_kernel(inline="always")
def is_passed(hull, h, x, y):
    """Whether the last corner says nothing, as the next one is (x, y): no turn to the left, and no way back.

    Where all corners are almost on a line, rounding hides the turn at its far end. It is the end, as there
    the next corner lies backwards; without it a volume would not hold its segments.
    """
    if turn_of(hull, h, x, y) > 0.0:
        return False
    px, py = hull[h - 1, 0], hull[h - 1, 1]
    return (px - hull[h - 2, 0]) * (x - px) + (py - hull[h - 2, 1]) * (y - py) >= 0.0


@lean_kernel
def moved_hull(hull, h, origin_x, origin_y):
    """A hull's ``h`` corners counted from an origin, its first one; those that then say nothing are left out.

    Written into ``hull``; returns how many are left.
    """
    n = 0
    for k in range(h):
        x, y = hull[k, 0] - origin_x, hull[k, 1] - origin_y
        if n > 0 and x == hull[n - 1, 0] and y == hull[n - 1, 1]:
            continue
        while n > 1 and is_passed(hull, n, x, y):
            n -= 1
        hull[n, 0] = x
        hull[n, 1] = y
        n += 1
    while n > 2 and is_passed(hull, n, 0.0, 0.0):
        n -= 1
    return n


def hull_of(points: Floats) -> tuple[Floats, Floats]:
    """Corners (h, 2) of the hull of points (n, 2), counter-clockwise about an origin, and that origin."""
    ids = np.lexsort((points[:, 1], points[:, 0]))
    hull = np.empty((2 * len(points) + 2, 2))
    h = int(sorted_hull(points, ids, 0, len(ids), hull))
    return hull[:h], points[ids[0]]
