"""GJK: the distance of two convex polygons by walking towards the origin in their Minkowski difference.

The closest point v of a simplex of A - B to the origin gives a direction. The support vertices of A and B
along it give a new corner w. If w is no nearer to the origin than v, seen along v, then v is the answer. Else
the best simplex with w is the next one. In the plane at most two corners are kept.

Directions of edges are taken from the polygons, not from v, which keeps digits where v is short: that is what
slivers and near contacts need. Sources: Gilbert, Johnson and Keerthi 1988; van den Bergen 1999 (stopping).
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.narrowphase.features import (
    after,
    known_feature,
    measure,
    pair_of,
    turned,
    turned_back,
    vertex,
    vertex_in,
)
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


class Start(NamedTuple):
    """Where a walk begins: at two features (-1: none), else at the support vertices along (x, y)."""

    feature_a: int
    feature_b: int
    x: float
    y: float


class Search(NamedTuple):
    """How a walk goes: when it may end (TOLERANCE, LIMIT); how vertices are found (a place in METHODS)."""

    tolerance: float
    limit: int
    method: int


@inner_kernel
def local_edge(pair, i0, j0, i1, j1):
    """The edge of A - B between two of its corners, from differences within A and within B."""
    px, py = vertex(pair.a, i0)
    qx, qy = vertex(pair.a, i1)
    kx, ky = vertex(pair.b, j0)
    mx, my = vertex(pair.b, j1)
    hx, hy = turned(pair.frame, mx - kx, my - ky)
    return qx - px - hx, qy - py - hy


@inner_kernel
def corner(pair, i, j):
    """The corner a_i - b_j of A - B."""
    ax, ay = vertex(pair.a, i)
    bx, by = vertex_in(pair.frame, pair.b, j)
    return ax - bx, ay - by


@inner_kernel(forceinline=True)
def first_simplex(pair, start):
    """Where the walk begins: corners (count, i0, j0, i1, j1), the second the same as the first for one."""
    a, b, frame = pair
    if known_feature(start.feature_a, a.size) and known_feature(start.feature_b, b.size):
        i0, j0 = start.feature_a >> 1, start.feature_b >> 1
        i1, j1 = i0, j0
        if start.feature_a & 1:
            i1 = after(i0, a.size)
        elif start.feature_b & 1:
            j1 = after(j0, b.size)
        w0x, w0y = corner(pair, i0, j0)
        w1x, w1y = corner(pair, i1, j1)
        part = closest_point(w0x, w0y, w1x, w1y)[2]
        if part == 0.0:
            return 1, i0, j0, i0, j0
        if part == 1.0:
            return 1, i1, j1, i1, j1
        return 2, i0, j0, i1, j1
    hx, hy = start.x, start.y
    if hx == 0.0 and hy == 0.0:
        hx = 1.0  # any direction will do, but the first corner must be a support vertex
    gx, gy = turned_back(frame, -hx, -hy)
    i0, j0 = support_cold(a, hx, hy), support_cold(b, gx, gy)
    return 1, i0, j0, i0, j0


@inner_kernel(forceinline=True)
def note_step(trace, step, simplex, nearest, found, bound, kept):
    """Write one step into the trace, as far as it has rows; see TRACE_WIDTH.

    simplex: count, i0, j0, i1, j1; nearest: away from the origin (mx, my), its length, and the distance;
    found: the support vertices i, j and their corner (wx, wy).
    """
    if step < trace.shape[0]:
        row = trace[step]
        mx, my, length, distance = nearest
        row[0], row[1], row[2], row[3], row[4] = simplex
        row[5], row[6] = -mx / length, -my / length
        row[9], row[10], row[11], row[12] = found
        row[7], row[8] = mx / length * distance, my / length * distance
        row[13], row[14], row[15] = distance, bound / length, kept


@inner_kernel
def walk(pair, start, search, trace):
    """GJK: (status, steps, i0, j0, i1, j1, i, j).

    Two corners i0, j0 and i1, j1 (the same twice for one) are the closest simplex; with INSIDE_SIMPLEX i, j
    is the third that closes the triangle round the origin.
    """
    a, b, frame = pair
    count, i0, j0, i1, j1 = first_simplex(pair, start)
    w0x, w0y = corner(pair, i0, j0)
    w1x, w1y = w0x, w0y
    if count == 2:
        w1x, w1y = corner(pair, i1, j1)
    k0, l0, k1, l1 = i0, j0, i1, j1  # the nearest simplex
    i, j = i0, j0
    nearest, stalls = math.inf, 0
    for step in range(search.limit):
        if count == 1:
            mx, my = w0x, w0y
            height = mx * mx + my * my
            length = math.sqrt(height)
            distance = length
        else:
            ex, ey = local_edge(pair, i0, j0, i1, j1)
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
        gx, gy = turned_back(frame, mx, my)
        if search.method == SCAN:
            i, j = support_scan(a, -mx, -my), support_scan(b, gx, gy)
        else:
            i, j = support_hc(a, i, -mx, -my), support_hc(b, j, gx, gy)
        wx, wy = corner(pair, i, j)
        bound = mx * wx + my * wy
        done = height - bound <= search.tolerance * height or (i == i0 and j == j0) or (i == i1 and j == j1)
        kept = 0 if done else best_simplex(count, w0x, w0y, w1x, w1y, wx, wy)
        simplex, away = (count, i0, j0, i1, j1), (mx, my, length, distance)
        note_step(trace, step, simplex, away, (i, j, wx, wy), bound, kept)
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
    return UNFINISHED, search.limit, i0, j0, i1, j1, i, j


@inner_kernel
def edge_between(i0, i1, count):
    """The edge between two neighbouring vertices, or -1."""
    if i1 == after(i0, count):
        return i0
    if i0 == after(i1, count):
        return i1
    return -1


@inner_kernel
def facing_edge(polygon, edge, x, y):
    """That edge; of a segment, the one of its two sides that faces the point (in the polygon's frame)."""
    if polygon.size != 2:
        return edge
    ox, oy = vertex(polygon, 0)
    px, py = vertex(polygon, 1)
    return 1 if (px - ox) * (y - oy) - (py - oy) * (x - ox) > 0.0 else 0


@inner_kernel
def edge_facing_b(pair, edge, j):
    """`facing_edge` of an edge of A, and vertex j of B."""
    x, y = vertex_in(pair.frame, pair.b, j)
    return facing_edge(pair.a, edge, x, y)


@inner_kernel
def edge_facing_a(pair, edge, i):
    """`facing_edge` of an edge of B, and vertex i of A."""
    x, y = vertex(pair.a, i)
    x, y = turned_back(pair.frame, x - pair.frame.x, y - pair.frame.y)
    return facing_edge(pair.b, edge, x, y)


@inner_kernel
def measure_simplex(pair, i0, j0, i1, j1):
    """As `measure`, of the simplex that a walk has ended with."""
    if i0 == i1 and j0 == j1:
        return measure(pair, 2 * i0, 2 * j0)
    if j0 == j1:
        edge = edge_between(i0, i1, pair.a.size)
        if edge >= 0:
            return measure(pair, 2 * edge_facing_b(pair, edge, j0) + 1, 2 * j0)
    elif i0 == i1:
        edge = edge_between(j0, j1, pair.b.size)
        if edge >= 0:
            return measure(pair, 2 * i0, 2 * edge_facing_a(pair, edge, i0) + 1)
    return measure_chord(pair, i0, j0, i1, j1)


@inner_kernel
def measure_chord(pair, i0, j0, i1, j1):
    """As `measure`, of a simplex that moves on both polygons: two parallel edges, or a walk ended early."""
    ex, ey = local_edge(pair, i0, j0, i1, j1)
    ax, ay = vertex(pair.a, i0)
    ix, iy = vertex(pair.a, i1)
    ix, iy = ix - ax, iy - ay
    edge_a, edge_b = edge_between(i0, i1, pair.a.size), edge_between(j0, j1, pair.b.size)
    w0x, w0y = corner(pair, i0, j0)
    if i0 != i1 and j0 != j1 and edge_a >= 0 and edge_b >= 0 and ix * ey - iy * ex == 0.0:
        edge_a, edge_b = edge_facing_b(pair, edge_a, j0), edge_facing_a(pair, edge_b, i0)
        return measure(pair, 2 * edge_a + 1, 2 * edge_b + 1)
    w1x, w1y = corner(pair, i1, j1)
    part = closest_point(w0x, w0y, w1x, w1y)[2]
    length = math.sqrt(ex * ex + ey * ey)
    nx, ny = ey / length, -ex / length
    distance = nx * w0x + ny * w0y
    if distance > 0.0:
        nx, ny = -nx, -ny
    ax, ay = ax + part * ix, ay + part * iy
    i, j = (i0, j0) if part <= 0.5 else (i1, j1)
    distance = abs(distance)
    feature_a = 2 * edge_a + 1 if edge_a >= 0 and i0 != i1 else 2 * i
    feature_b = 2 * edge_b + 1 if edge_b >= 0 and j0 != j1 else 2 * j
    return distance, ax, ay, ax + distance * nx, ay + distance * ny, nx, ny, feature_a, feature_b


@lean_kernel
def gjk_query(pair, start, search, deep, trace):
    """`walk` and what it has found: the nine numbers of `measure`, and the number of steps.

    pair, start, search: as for `walk`, or plain tuples of the same form.
    """
    pair = pair_of(pair)
    status, steps, i0, j0, i1, j1, _, _ = walk(pair, Start(*start), Search(*search), trace)
    if status in (INSIDE_SIMPLEX, AT_ORIGIN):
        return measure_touching(pair, deep, 2 * i0, 2 * j0), steps
    return measure_simplex(pair, i0, j0, i1, j1), steps
