"""EPA: the depth of an overlap, by expanding a polygon within A - B to the border of A - B.

The origin lies inside. Of the polygon's edges the one nearest to the origin is taken; if A - B has a
corner farther out along its normal, the edge is broken there, else it lies on the border and is the
shortest way out. Source: van den Bergen 2001.
"""

from __future__ import annotations

import math

import numpy as np

from game.physics.lean import inner_kernel, lean_kernel
from game.physics.narrowphase.features import known_feature
from game.physics.narrowphase.gjk import (
    AT_ORIGIN,
    INSIDE_SIMPLEX,
    corner,
    local_edge,
    measure_chord,
    measure_simplex,
    walk,
)
from game.physics.narrowphase.separating_axis import measure_touching
from game.physics.narrowphase.simplex import support_cold, support_hc

TRACE_WIDTH = (
    5  # place of the edge in the polygon, its distance, new corner i j, 1 if inserted after the edge
)
NO_TRACE = np.empty((0, TRACE_WIDTH))


@lean_kernel
def first_polygon(va, fa, na, vb, fb, nb, c, s, tx, ty, i0, j0, i1, j1, i2, j2, corners):
    """Write two or three corners (i, j) of A - B to begin with, counterclockwise; return how many.

    A triangle of support vertices is taken as it is. If the three are on a line, or the same (which says that
    they are no support vertices), two opposite ones along an axis stand in.
    """
    ex, ey = local_edge(va, fa, vb, fb, c, s, i0, j0, i1, j1)
    gx, gy = local_edge(va, fa, vb, fb, c, s, i0, j0, i2, j2)
    turn = ex * gy - ey * gx
    corners[0, 0], corners[0, 1] = i0, j0
    if turn != 0.0:
        corners[1, 0], corners[1, 1] = i1, j1
        corners[2, 0], corners[2, 1] = i2, j2
        if turn < 0.0:
            corners[1, 0], corners[1, 1] = i2, j2
            corners[2, 0], corners[2, 1] = i1, j1
        return 3
    dx, dy = 1.0, 0.0
    for _ in range(2):
        corners[0, 0] = support_cold(va, fa, na, dx, dy)
        corners[0, 1] = support_cold(vb, fb, nb, -(c * dx + s * dy), s * dx - c * dy)
        corners[1, 0] = support_cold(va, fa, na, -dx, -dy)
        corners[1, 1] = support_cold(vb, fb, nb, c * dx + s * dy, c * dy - s * dx)
        ex, ey = local_edge(
            va, fa, vb, fb, c, s, corners[0, 0], corners[0, 1], corners[1, 0], corners[1, 1]
        )  # fmt: skip
        if ex != 0.0 or ey != 0.0:
            return 2
        dx, dy = dy, dx
    return 1


@inner_kernel
def edge_height(va, fa, vb, fb, c, s, tx, ty, corners, k, m):
    """Outward distance of the edge from corner k to corner m, and its normal, not of unit length."""
    i, j = corners[k, 0], corners[k, 1]
    ex, ey = local_edge(va, fa, vb, fb, c, s, i, j, corners[m, 0], corners[m, 1])
    x, y = corner(va, fa, vb, fb, c, s, tx, ty, i, j)
    length = math.sqrt(ex * ex + ey * ey)
    if length == 0.0:
        return math.inf, ey, -ex
    return (ey * x - ex * y) / length, ey, -ex


@inner_kernel
def expand(va, fa, na, vb, fb, nb, c, s, tx, ty, count, corners, heights, trace):
    """Expand the polygon in ``corners`` until its nearest edge is on the border: (place of the edge, count,
    steps). ``corners`` (n, 2) and ``heights`` (n,) need room for all vertices of A and B, and three more.
    """
    for k in range(count):
        m = k + 1 if k + 1 < count else 0
        heights[k] = edge_height(va, fa, vb, fb, c, s, tx, ty, corners, k, m)[0]
    best, steps = 0, 0
    while True:
        best = 0
        for k in range(1, count):
            if heights[k] < heights[best]:
                best = k
        m = best + 1 if best + 1 < count else 0
        height, nx, ny = edge_height(va, fa, vb, fb, c, s, tx, ty, corners, best, m)
        i = support_hc(va, fa, na, corners[best, 0], nx, ny)
        j = support_hc(vb, fb, nb, corners[best, 1], -(c * nx + s * ny), s * nx - c * ny)
        ax, ay = local_edge(va, fa, vb, fb, c, s, corners[best, 0], corners[best, 1], i, j)
        farther = nx * ax + ny * ay > 0.0  # exactly 0 for the edge's own ends
        done = not farther or count >= corners.shape[0]
        if steps < trace.shape[0]:
            trace[steps, 0], trace[steps, 1] = best, height
            trace[steps, 2], trace[steps, 3], trace[steps, 4] = i, j, not done
        steps += 1
        if done:
            return best, count, steps
        for k in range(count, best + 1, -1):
            corners[k, 0], corners[k, 1], heights[k] = corners[k - 1, 0], corners[k - 1, 1], heights[k - 1]
        corners[best + 1, 0], corners[best + 1, 1] = i, j
        count += 1
        heights[best] = edge_height(va, fa, vb, fb, c, s, tx, ty, corners, best, best + 1)[0]
        m = best + 2 if best + 2 < count else 0
        heights[best + 1] = edge_height(va, fa, vb, fb, c, s, tx, ty, corners, best + 1, m)[0]


@lean_kernel
def epa_query(
    va, fa, na, vb, fb, nb, c, s, tx, ty, hx, hy, start_a, start_b, tolerance, limit, method, deep, corners,
    heights, gjk_trace, trace,
):  # fmt: skip
    """GJK, and EPA where it finds an overlap: the nine numbers of `measure`, steps of GJK and of EPA."""
    status, steps, i0, j0, i1, j1, i, j = walk(
        va, fa, na, vb, fb, nb, c, s, tx, ty, hx, hy, start_a, start_b, tolerance, limit, method, gjk_trace
    )
    if status != INSIDE_SIMPLEX and status != AT_ORIGIN:
        return measure_simplex(va, fa, na, vb, fb, nb, c, s, tx, ty, i0, j0, i1, j1), steps, 0
    if known_feature(start_a, na) and known_feature(start_b, nb):
        i, j = i0, j0  # a walk from given features may have kept corners within A - B
    count = first_polygon(va, fa, na, vb, fb, nb, c, s, tx, ty, i0, j0, i1, j1, i, j, corners)
    if count == 1 or not deep:
        return measure_touching(va, fa, na, vb, fb, nb, c, s, tx, ty, deep, 2 * i0, 2 * j0), steps, 0
    best, count, more = expand(va, fa, na, vb, fb, nb, c, s, tx, ty, count, corners, heights, trace)
    m = best + 1 if best + 1 < count else 0
    _, ax, ay, _, _, _, _, feature_a, feature_b = measure_chord(
        va, fa, na, vb, fb, nb, c, s, tx, ty, corners[best, 0], corners[best, 1], corners[m, 0], corners[m, 1]
    )
    height, nx, ny = edge_height(va, fa, vb, fb, c, s, tx, ty, corners, best, m)
    length = math.sqrt(nx * nx + ny * ny)
    nx, ny = nx / length, ny / length
    found = 0.0 - height, ax, ay, ax - height * nx, ay - height * ny, nx, ny, feature_a, feature_b
    return found, steps, more
