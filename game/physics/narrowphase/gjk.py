"""GJK: the distance of two convex polygons by walking towards the origin in their Minkowski difference.

The closest point v of a simplex of A - B to the origin gives a direction; the support vertices of A and B
along it give a new corner w. If w is no nearer to the origin than v, seen along v, then v is the answer.
Else the best simplex with w is the next one. In the plane at most two corners are kept.

Directions of edges are taken from the polygons, not from v, which keeps digits where v is short: that is what
slivers and near contacts need. Sources: Gilbert, Johnson and Keerthi 1988; van den Bergen 1999 (stopping).
"""

from __future__ import annotations

import math

import numpy as np

from game.physics.kernels.lean import inner_kernel, lean_kernel
from game.physics.narrowphase.features import after, known_feature, measure
from game.physics.narrowphase.separating_axis import measure_touching
from game.physics.narrowphase.simplex import (
    FIRST_AND_NEW,
    INSIDE,
    NEW_ONLY,
    best_simplex,
    closest_point,
    support_cold,
    support_hc,
    support_scan,
)

METHODS = ("climb", "scan")  # how support vertices are found
SCAN = 1
TOLERANCE = 1e-14  # relative: v.v - v.w below this times v.v ends the walk
LIMIT = 100  # steps; 12 are many
APART, INSIDE_SIMPLEX, AT_ORIGIN, UNFINISHED = 0, 1, 2, 3
STALLS = 3  # steps that bring it no nearer by rounding alone; an edge can then still turn the right way
TRACE_WIDTH = 16  # count, i0 j0 i1 j1, direction x y, v x y, i j, w x y, distance, lower bound, what is kept
NO_TRACE = np.empty((0, TRACE_WIDTH))


@inner_kernel
def local_edge(va, fa, vb, fb, c, s, i0, j0, i1, j1):
    """The edge of A - B between two of its corners, from differences within A and within B."""
    hx, hy = vb[fb + j1, 0] - vb[fb + j0, 0], vb[fb + j1, 1] - vb[fb + j0, 1]
    return (
        va[fa + i1, 0] - va[fa + i0, 0] - (c * hx - s * hy),
        va[fa + i1, 1] - va[fa + i0, 1] - (s * hx + c * hy),
    )


@inner_kernel
def corner(va, fa, vb, fb, c, s, tx, ty, i, j):
    """The corner a_i - b_j of A - B."""
    x, y = vb[fb + j, 0], vb[fb + j, 1]
    return va[fa + i, 0] - (c * x - s * y + tx), va[fa + i, 1] - (s * x + c * y + ty)


@inner_kernel(forceinline=True)
def first_simplex(va, fa, na, vb, fb, nb, c, s, tx, ty, hx, hy, start_a, start_b):
    """Where the walk begins: corners (count, i0, j0, i1, j1), the second the same as the first for one."""
    if known_feature(start_a, na) and known_feature(start_b, nb):
        i0, j0 = start_a >> 1, start_b >> 1
        i1, j1 = i0, j0
        if start_a & 1:
            i1 = after(i0, na)
        elif start_b & 1:
            j1 = after(j0, nb)
        w0x, w0y = corner(va, fa, vb, fb, c, s, tx, ty, i0, j0)
        w1x, w1y = corner(va, fa, vb, fb, c, s, tx, ty, i1, j1)
        part = closest_point(w0x, w0y, w1x, w1y)[2]
        if part == 0.0:
            return 1, i0, j0, i0, j0
        if part == 1.0:
            return 1, i1, j1, i1, j1
        return 2, i0, j0, i1, j1
    if hx == 0.0 and hy == 0.0:
        hx = 1.0  # any direction will do, but the first corner must be a support vertex
    i0 = support_cold(va, fa, na, hx, hy)
    j0 = support_cold(vb, fb, nb, -(c * hx + s * hy), s * hx - c * hy)
    return 1, i0, j0, i0, j0


@inner_kernel(forceinline=True)
def note_step(trace, step, count, i0, j0, i1, j1, mx, my, length, distance, i, j, wx, wy, bound, kept):
    """Write one step into the trace, as far as it has room; see TRACE_WIDTH."""
    if step < trace.shape[0]:
        row = trace[step]
        row[0], row[1], row[2], row[3], row[4] = count, i0, j0, i1, j1
        row[5], row[6], row[9], row[10], row[11], row[12] = -mx / length, -my / length, i, j, wx, wy
        row[7], row[8] = mx / length * distance, my / length * distance
        row[13], row[14], row[15] = distance, bound / length, kept


@inner_kernel
def walk(
    va, fa, na, vb, fb, nb, c, s, tx, ty, hx, hy, start_a, start_b, tolerance, limit, method, trace
):  # fmt: skip
    """GJK from two features (-1: from the support vertices along h): (status, steps, i0, j0, i1, j1, i, j).

    Two corners i0, j0 and i1, j1 (the same twice for one) are the closest simplex; with INSIDE_SIMPLEX i, j
    is the third that closes the triangle round the origin.
    """
    count, i0, j0, i1, j1 = first_simplex(
        va, fa, na, vb, fb, nb, c, s, tx, ty, hx, hy, start_a, start_b
    )  # fmt: skip
    w0x, w0y = corner(va, fa, vb, fb, c, s, tx, ty, i0, j0)
    w1x, w1y = w0x, w0y
    if count == 2:
        w1x, w1y = corner(va, fa, vb, fb, c, s, tx, ty, i1, j1)
    k0, l0, k1, l1 = i0, j0, i1, j1  # the nearest simplex
    i, j = i0, j0
    nearest, stalls = math.inf, 0
    for step in range(limit):
        if count == 1:
            mx, my = w0x, w0y
            height = mx * mx + my * my
            length = math.sqrt(height)
            distance = length
        else:
            ex, ey = local_edge(va, fa, vb, fb, c, s, i0, j0, i1, j1)
            mx, my = ey, -ex
            height = mx * w0x + my * w0y
            if height < 0.0:
                mx, my, height = -mx, -my, -height
            length = math.sqrt(mx * mx + my * my)
            distance = height / length
        if height == 0.0:
            return AT_ORIGIN, step, i0, j0, i1, j1, i0, j0
        if distance < nearest:
            nearest, stalls = distance, 0
            k0, l0, k1, l1 = i0, j0, i1, j1
        else:
            stalls += 1
            if stalls > STALLS:
                return APART, step, k0, l0, k1, l1, i, j
        if method == SCAN:
            i = support_scan(va, fa, na, -mx, -my)
            j = support_scan(vb, fb, nb, c * mx + s * my, c * my - s * mx)
        else:
            i = support_hc(va, fa, na, i, -mx, -my)
            j = support_hc(vb, fb, nb, j, c * mx + s * my, c * my - s * mx)
        wx, wy = corner(va, fa, vb, fb, c, s, tx, ty, i, j)
        bound = mx * wx + my * wy
        done = height - bound <= tolerance * height or (i == i0 and j == j0) or (i == i1 and j == j1)
        kept = 0 if done else best_simplex(count, w0x, w0y, w1x, w1y, wx, wy)
        note_step(trace, step, count, i0, j0, i1, j1, mx, my, length, distance, i, j, wx, wy, bound, kept)
        if done:
            return APART, step + 1, i0, j0, i1, j1, i, j
        if kept == INSIDE:
            return INSIDE_SIMPLEX, step + 1, i0, j0, i1, j1, i, j
        if kept == NEW_ONLY:
            i0, j0, w0x, w0y = i, j, wx, wy
            i1, j1, w1x, w1y = i, j, wx, wy
            count = 1
        elif kept == FIRST_AND_NEW:
            i1, j1, w1x, w1y = i, j, wx, wy
            count = 2
        else:
            i0, j0, w0x, w0y = i, j, wx, wy
            count = 2
    return UNFINISHED, limit, i0, j0, i1, j1, i, j


@inner_kernel
def edge_between(i0, i1, count):
    """The edge between two neighbouring vertices, or -1."""
    if i1 == after(i0, count):
        return i0
    if i0 == after(i1, count):
        return i1
    return -1


@inner_kernel
def facing_edge(v, first, count, edge, x, y):
    """That edge; of a segment, the one of its two sides that faces the point (in the polygon's frame)."""
    if count != 2:
        return edge
    ox, oy = v[first, 0], v[first, 1]
    return 1 if (v[first + 1, 0] - ox) * (y - oy) - (v[first + 1, 1] - oy) * (x - ox) > 0.0 else 0


@inner_kernel
def measure_simplex(va, fa, na, vb, fb, nb, c, s, tx, ty, i0, j0, i1, j1):
    """As `measure`, of the simplex that a walk has ended with."""
    if i0 == i1 and j0 == j1:
        return measure(va, fa, na, vb, fb, nb, c, s, tx, ty, 2 * i0, 2 * j0)
    if j0 == j1:
        edge = edge_between(i0, i1, na)
        if edge >= 0:
            x, y = vb[fb + j0, 0], vb[fb + j0, 1]
            edge = facing_edge(va, fa, na, edge, c * x - s * y + tx, s * x + c * y + ty)
            return measure(va, fa, na, vb, fb, nb, c, s, tx, ty, 2 * edge + 1, 2 * j0)
    elif i0 == i1:
        edge = edge_between(j0, j1, nb)
        if edge >= 0:
            x, y = va[fa + i0, 0] - tx, va[fa + i0, 1] - ty
            edge = facing_edge(vb, fb, nb, edge, c * x + s * y, c * y - s * x)
            return measure(va, fa, na, vb, fb, nb, c, s, tx, ty, 2 * i0, 2 * edge + 1)
    return measure_chord(va, fa, na, vb, fb, nb, c, s, tx, ty, i0, j0, i1, j1)


@inner_kernel
def measure_chord(va, fa, na, vb, fb, nb, c, s, tx, ty, i0, j0, i1, j1):
    """As `measure`, of a simplex that moves on both polygons: two parallel edges, or a walk ended early."""
    ex, ey = local_edge(va, fa, vb, fb, c, s, i0, j0, i1, j1)
    ix, iy = va[fa + i1, 0] - va[fa + i0, 0], va[fa + i1, 1] - va[fa + i0, 1]
    edge_a, edge_b = edge_between(i0, i1, na), edge_between(j0, j1, nb)
    w0x, w0y = corner(va, fa, vb, fb, c, s, tx, ty, i0, j0)
    if i0 != i1 and j0 != j1 and edge_a >= 0 and edge_b >= 0 and ix * ey - iy * ex == 0.0:
        x, y = vb[fb + j0, 0], vb[fb + j0, 1]
        edge_a = facing_edge(va, fa, na, edge_a, c * x - s * y + tx, s * x + c * y + ty)
        x, y = va[fa + i0, 0] - tx, va[fa + i0, 1] - ty
        edge_b = facing_edge(vb, fb, nb, edge_b, c * x + s * y, c * y - s * x)
        return measure(va, fa, na, vb, fb, nb, c, s, tx, ty, 2 * edge_a + 1, 2 * edge_b + 1)
    w1x, w1y = corner(va, fa, vb, fb, c, s, tx, ty, i1, j1)
    part = closest_point(w0x, w0y, w1x, w1y)[2]
    length = math.sqrt(ex * ex + ey * ey)
    nx, ny = ey / length, -ex / length
    distance = nx * w0x + ny * w0y
    if distance > 0.0:
        nx, ny = -nx, -ny
    ax, ay = va[fa + i0, 0] + part * ix, va[fa + i0, 1] + part * iy
    i, j = (i0, j0) if part <= 0.5 else (i1, j1)
    distance = abs(distance)
    feature_a = 2 * edge_a + 1 if edge_a >= 0 and i0 != i1 else 2 * i
    feature_b = 2 * edge_b + 1 if edge_b >= 0 and j0 != j1 else 2 * j
    return distance, ax, ay, ax + distance * nx, ay + distance * ny, nx, ny, feature_a, feature_b


@lean_kernel
def gjk_query(
    va, fa, na, vb, fb, nb, c, s, tx, ty, hx, hy, start_a, start_b, tolerance, limit, method, deep,
    trace,
):  # fmt: skip
    """`walk` and what it has found: the nine numbers of `measure`, and the number of steps."""
    status, steps, i0, j0, i1, j1, _, _ = walk(
        va, fa, na, vb, fb, nb, c, s, tx, ty, hx, hy, start_a, start_b, tolerance, limit, method, trace
    )
    if status in (INSIDE_SIMPLEX, AT_ORIGIN):
        a, b = 2 * i0, 2 * j0
        return measure_touching(va, fa, na, vb, fb, nb, c, s, tx, ty, deep, a, b), steps
    return measure_simplex(va, fa, na, vb, fb, nb, c, s, tx, ty, i0, j0, i1, j1), steps
