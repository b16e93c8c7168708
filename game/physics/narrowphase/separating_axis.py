"""How deep two polygons overlap: the edge whose normal separates them best, by the separating axis theorem.

The normals of A's edges turn one way round, so the vertex of B that lies deepest behind them moves one way
round B: all edges together cost one walk round both polygons. Source: Gottschalk 1996; rotating calipers by
Toussaint 1983.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.narrowphase.features import (
    after,
    before,
    pair_of,
    turned,
    turned_back,
    turned_round,
    vertex,
    vertex_in,
)


@inner_kernel
def deepest_of_edges(pair):
    """Of A's edges, the one that B is least behind: (signed distance of B's deepest vertex, edge, vertex)."""
    a, b, frame = pair
    vb, fb, nb = b
    best, best_edge, best_vertex = -math.inf, 0, 0
    if a.size == 1:
        return best, best_edge, best_vertex
    j = -1
    for i in range(a.size):
        ox, oy = vertex(a, i)
        px, py = vertex(a, after(i, a.size))
        nx, ny = py - oy, ox - px
        dx, dy = turned_back(frame, -nx, -ny)  # towards B's deepest vertex, in B's frame
        if j < 0:
            j = 0
            for k in range(1, nb):
                if (vb[fb + k, 0] - vb[fb + j, 0]) * dx + (vb[fb + k, 1] - vb[fb + j, 1]) * dy > 0.0:
                    j = k
        else:
            for _ in range(nb):
                k = after(j, nb)
                if (vb[fb + k, 0] - vb[fb + j, 0]) * dx + (vb[fb + k, 1] - vb[fb + j, 1]) * dy > 0.0:
                    j = k
                    continue
                k = before(j, nb)
                if (vb[fb + k, 0] - vb[fb + j, 0]) * dx + (vb[fb + k, 1] - vb[fb + j, 1]) * dy > 0.0:
                    j = k
                    continue
                break
        bx, by = vertex_in(frame, b, j)
        distance = (nx * (bx - ox) + ny * (by - oy)) / math.sqrt(nx * nx + ny * ny)
        if distance > best:
            best, best_edge, best_vertex = distance, i, j
    return best, best_edge, best_vertex


@inner_kernel
def separating_axis(pair):
    """The edge of A or B whose normal separates them best: (signed distance, feature of A, feature of B).

    Negative if they overlap: minus the shortest displacement that separates them. -inf for two points.
    """
    best, edge, deepest = deepest_of_edges(pair)
    other, other_edge, other_deepest = deepest_of_edges(turned_round(pair))
    if other > best:
        return other, 2 * other_deepest, 2 * other_edge + 1
    return best, 2 * edge + 1, 2 * deepest


@inner_kernel
def measure_overlap(pair):
    """As `measure`, for polygons that touch or overlap: the distance is minus the depth."""
    a, b, frame = pair
    distance, feature_a, feature_b = separating_axis(pair)
    i, j = feature_a >> 1, feature_b >> 1
    ax, ay = vertex(a, i)
    bx, by = vertex_in(frame, b, j)
    if distance == -math.inf:
        return 0.0, ax, ay, bx, by, 1.0, 0.0, feature_a, feature_b
    distance += 0.0  # no negative zero
    if feature_a & 1:
        kx, ky = vertex(a, after(i, a.size))
        nx, ny = ky - ay, ax - kx
        length = math.sqrt(nx * nx + ny * ny)
        nx, ny = nx / length, ny / length
        return distance, bx - distance * nx, by - distance * ny, bx, by, nx, ny, feature_a, feature_b
    jx, jy = vertex(b, j)
    kx, ky = vertex(b, after(j, b.size))
    hx, hy = jy - ky, kx - jx  # from B's edge into B
    length = math.sqrt(hx * hx + hy * hy)
    nx, ny = turned(frame, hx, hy)
    nx, ny = nx / length, ny / length
    return distance, ax, ay, ax + distance * nx, ay + distance * ny, nx, ny, feature_a, feature_b


@lean_kernel
def overlap_query(pair):
    """`measure_overlap` of a `Pair` in plain tuples."""
    return measure_overlap(pair_of(pair))


@inner_kernel
def measure_touching(pair, deep, feature_a, feature_b):
    """As `measure_overlap`; if not ``deep``, only that they overlap: distance 0, no normal."""
    if deep:
        return measure_overlap(pair)
    ax, ay = vertex(pair.a, feature_a >> 1)
    bx, by = vertex_in(pair.frame, pair.b, feature_b >> 1)
    return 0.0, ax, ay, bx, by, 0.0, 0.0, feature_a, feature_b
