"""How deep two polygons overlap: the edge whose normal parts them best, by the separating axis theorem.

The normals of A's edges turn one way round, so the vertex of B that lies deepest behind them moves one way
round B: all edges together cost one walk round both polygons. Source: Gottschalk 1996; rotating calipers by
Toussaint 1983.
"""

from __future__ import annotations

import math

from game.physics.kernels.lean import inner_kernel, lean_kernel
from game.physics.narrowphase.features import after, before, inverse_frame


@inner_kernel
def deepest_of_edges(va, fa, na, vb, fb, nb, c, s, tx, ty):
    """Of A's edges, the one that B is least behind: (signed distance of B's deepest vertex, edge, vertex)."""
    best, best_edge, best_vertex = -math.inf, 0, 0
    if na == 1:
        return best, best_edge, best_vertex
    j = -1
    for i in range(na):
        o, p = fa + i, fa + after(i, na)
        ox, oy = va[o, 0], va[o, 1]
        nx, ny = va[p, 1] - oy, ox - va[p, 0]
        # towards B's deepest vertex, in B's frame
        dx, dy = -(c * nx + s * ny), s * nx - c * ny
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
        bx = c * vb[fb + j, 0] - s * vb[fb + j, 1] + tx - ox
        by = s * vb[fb + j, 0] + c * vb[fb + j, 1] + ty - oy
        distance = (nx * bx + ny * by) / math.sqrt(nx * nx + ny * ny)
        if distance > best:
            best, best_edge, best_vertex = distance, i, j
    return best, best_edge, best_vertex


@inner_kernel
def separating_axis(va, fa, na, vb, fb, nb, c, s, tx, ty):
    """The edge of A or B whose normal parts them best: (signed distance, feature of A, feature of B).

    Negative if they overlap: minus the shortest way that parts them. -inf for two points.
    """
    best, edge, vertex = deepest_of_edges(va, fa, na, vb, fb, nb, c, s, tx, ty)
    ci, si, ux, uy = inverse_frame(c, s, tx, ty)
    other, other_edge, other_vertex = deepest_of_edges(vb, fb, nb, va, fa, na, ci, si, ux, uy)
    if other > best:
        return other, 2 * other_vertex, 2 * other_edge + 1
    return best, 2 * edge + 1, 2 * vertex


@lean_kernel
def measure_overlap(va, fa, na, vb, fb, nb, c, s, tx, ty):
    """As `measure`, for polygons that touch or overlap: the distance is minus the depth."""
    distance, feature_a, feature_b = separating_axis(va, fa, na, vb, fb, nb, c, s, tx, ty)
    i, j = feature_a >> 1, feature_b >> 1
    ax, ay = va[fa + i, 0], va[fa + i, 1]
    bx, by = c * vb[fb + j, 0] - s * vb[fb + j, 1] + tx, s * vb[fb + j, 0] + c * vb[fb + j, 1] + ty
    if distance == -math.inf:
        return 0.0, ax, ay, bx, by, 1.0, 0.0, feature_a, feature_b
    distance += 0.0  # no negative zero
    if feature_a & 1:
        k = fa + after(i, na)
        nx, ny = va[k, 1] - ay, ax - va[k, 0]
        length = math.sqrt(nx * nx + ny * ny)
        nx, ny = nx / length, ny / length
        return distance, bx - distance * nx, by - distance * ny, bx, by, nx, ny, feature_a, feature_b
    k = fb + after(j, nb)
    hx, hy = vb[fb + j, 1] - vb[k, 1], vb[k, 0] - vb[fb + j, 0]  # from B's edge into B
    length = math.sqrt(hx * hx + hy * hy)
    nx, ny = (c * hx - s * hy) / length, (s * hx + c * hy) / length
    return distance, ax, ay, ax + distance * nx, ay + distance * ny, nx, ny, feature_a, feature_b


@inner_kernel
def measure_touching(va, fa, na, vb, fb, nb, c, s, tx, ty, deep, feature_a, feature_b):
    """As `measure_overlap`; if not ``deep``, only that they overlap: distance 0, no normal."""
    if deep:
        return measure_overlap(va, fa, na, vb, fb, nb, c, s, tx, ty)
    i, j = feature_a >> 1, feature_b >> 1
    bx, by = c * vb[fb + j, 0] - s * vb[fb + j, 1] + tx, s * vb[fb + j, 0] + c * vb[fb + j, 1] + ty
    return 0.0, va[fa + i, 0], va[fa + i, 1], bx, by, 0.0, 0.0, feature_a, feature_b
