"""A simplex of the Minkowski difference A - B: its closest point to the origin, and how it is made better.

The corners are differences w = a - b of support vertices. All tests are signs of products of two lengths,
with nothing added to them, so they mean the same at every scale: a tolerance in them would be cubic in
the length of a short edge. Sources: Gilbert, Johnson and Keerthi 1988; Ericson 2005, 9.5.
"""

from __future__ import annotations

from game.compiler.decorator import lean_kernel
from game.physics.narrowphase.features import after, before

NEW_ONLY, FIRST_AND_NEW, SECOND_AND_NEW, INSIDE = 1, 2, 3, 4


@lean_kernel
def closest_point(px, py, qx, qy):
    """The point of the segment p q closest to the origin, and its share of the path from p (0 to 1)."""
    ex, ey = qx - px, qy - py
    along = -(px * ex + py * ey)
    squared = ex * ex + ey * ey
    if along <= 0.0 or squared == 0.0:
        return px, py, 0.0
    if along >= squared:
        return qx, qy, 1.0
    part = along / squared
    return px + part * ex, py + part * ey, part


@lean_kernel
def best_simplex(count, px, py, qx, qy, wx, wy):
    """What to keep of a point p or a segment p, q when w, which lies beyond it, is added.

    NEW_ONLY, FIRST_AND_NEW (p and w), SECOND_AND_NEW (q and w), or INSIDE if the triangle holds the origin,
    borders included. Older parts alone cannot be closest, as w has brought the simplex nearer.
    """
    over_p = (px - wx) * wx + (py - wy) * wy < 0.0  # the origin lies before w, seen along the edge to p
    if count == 1:
        return FIRST_AND_NEW if over_p else NEW_ONLY
    over_q = (qx - wx) * wx + (qy - wy) * wy < 0.0
    side = px * qy - py * qx
    # outside of the edges from w; signs are compared, as products of four lengths could vanish
    past_p, past_q = wx * py - wy * px, qx * wy - qy * wx
    beyond_p = past_p != 0.0 and (past_p < 0.0) != (side < 0.0)
    beyond_q = past_q != 0.0 and (past_q < 0.0) != (side < 0.0)
    if beyond_p and over_p:
        return FIRST_AND_NEW
    if beyond_q and over_q:
        return SECOND_AND_NEW
    return NEW_ONLY if beyond_p or beyond_q else INSIDE


@lean_kernel
def support_hc(polygon, start, dx, dy):
    """The vertex farthest along (dx, dy), by climbing from vertex ``start`` to better neighbours.

    A convex polygon has no other hilltop. Next to the top two vertices may be equally far; either is right.
    With a zero direction the start itself.
    """
    v, first, count = polygon
    best = start
    here = v[first + best, 0] * dx + v[first + best, 1] * dy
    k = after(best, count)
    there = v[first + k, 0] * dx + v[first + k, 1] * dy
    if there > here:
        while there > here:
            best, here = k, there
            k = after(k, count)
            there = v[first + k, 0] * dx + v[first + k, 1] * dy
        return best
    k = before(best, count)
    there = v[first + k, 0] * dx + v[first + k, 1] * dy
    while there > here:
        best, here = k, there
        k = before(k, count)
        there = v[first + k, 0] * dx + v[first + k, 1] * dy
    return best


@lean_kernel
def support_scan(polygon, dx, dy):
    """The vertex farthest along (dx, dy), by looking at all of them."""
    v, first, count = polygon
    best = 0
    here = v[first, 0] * dx + v[first, 1] * dy
    for k in range(1, count):
        there = v[first + k, 0] * dx + v[first + k, 1] * dy
        if there > here:
            best, here = k, there
    return best


@lean_kernel
def support_cold(polygon, dx, dy):
    """The same with nothing to start from: eight vertices far apart are asked, then it climbs."""
    v, first, count = polygon
    if count <= 8:
        return support_scan(polygon, dx, dy)
    stride = count >> 3
    best = 0
    here = v[first, 0] * dx + v[first, 1] * dy
    for k in range(stride, count, stride):
        there = v[first + k, 0] * dx + v[first + k, 1] * dy
        if there > here:
            best, here = k, there
    return support_hc(polygon, best, dx, dy)
