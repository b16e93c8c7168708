"""How deep vertices lie in meshes, and which way is out: consistent penetration depth.

Heidelberger and others 2004, in the plane.

Where an edge leaves the mesh that its end p lies in, at x with the rim's normal n, the way out is (x - p)·n
long along n. A border vertex takes the mean of its edges' by the weights 1/|x - p|². From there it spreads
inwards along edges, ring by ring:

    d(p) = Σ μ ((q - p)·r(q) + d(q)) / Σ μ,   r(p) = Σ μ r(q) / |...|,   μ = 1 / |q - p|²

Neighbours so agree about the way out, also deep inside, where the nearest rim would be on some other side.
The normal of a rim edge points away from its triangle's third vertex as it is now.
"""

from __future__ import annotations

import math

from game.compiler.decorator import lean_kernel
from game.physics.deformables.predicates import turn_of

DEPTH, OUT_X, OUT_Y, WEIGHT, RING = range(5)  # rows of a vertex's numbers: m, unit vector, sum, ring from 1
DEPTH_ROWS = 5
MOST_RINGS = 64
NEAREST = 1e-24  # m²; of a weight's 1/|x - p|²


@lean_kernel
def add_border(points, store, p, e, f, rows):
    """What edge e adds for its end p, which may lie inside of rim edge f."""
    c = points[store.edges[f, 0]]
    d = points[store.edges[f, 1]]
    third = points[store.beyond[f]]
    nx = d[1] - c[1]
    ny = c[0] - d[0]
    length = math.sqrt(nx * nx + ny * ny)
    if length == 0.0:
        return
    if (third[0] - c[0]) * nx + (third[1] - c[1]) * ny > 0.0:
        length = -length
    nx /= length
    ny /= length
    other = store.edges[e, 0] if store.edges[e, 1] == p else store.edges[e, 1]
    here = turn_of(c, d, points[p])
    there = turn_of(c, d, points[other])
    part = here / (here - there)
    wx = part * (points[other, 0] - points[p, 0])
    wy = part * (points[other, 1] - points[p, 1])
    out = wx * nx + wy * ny
    if out <= 0.0:
        return  # p is on the outer side: it lies in some other mesh
    weight = 1.0 / max(wx * wx + wy * wy, NEAREST)
    rows[DEPTH, p] += weight * out
    rows[OUT_X, p] += weight * nx
    rows[OUT_Y, p] += weight * ny
    rows[WEIGHT, p] += weight


@lean_kernel
def settle(rows, p, ring):
    """Make means of the sums of a vertex; without a direction it gets no depth."""
    weight = rows[WEIGHT, p]
    length = math.sqrt(rows[OUT_X, p] * rows[OUT_X, p] + rows[OUT_Y, p] * rows[OUT_Y, p])
    if weight > 0.0 and length > 0.0:
        rows[DEPTH, p] = max(rows[DEPTH, p] / weight, 0.0)
        rows[OUT_X, p] /= length
        rows[OUT_Y, p] /= length
    else:
        rows[DEPTH, p] = 0.0
    rows[RING, p] = ring


@lean_kernel
def add_neighbours(points, store, p, ring, rows):
    """Sum up for p what its neighbours of earlier rings say."""
    for k in range(store.first[p], store.first[p + 1]):
        q = store.others[k]
        if 0.0 < rows[RING, q] < ring:
            dx = points[q, 0] - points[p, 0]
            dy = points[q, 1] - points[p, 1]
            weight = 1.0 / max(dx * dx + dy * dy, NEAREST)
            rows[DEPTH, p] += weight * (dx * rows[OUT_X, q] + dy * rows[OUT_Y, q] + rows[DEPTH, q])
            rows[OUT_X, p] += weight * rows[OUT_X, q]
            rows[OUT_Y, p] += weight * rows[OUT_Y, q]
            rows[WEIGHT, p] += weight


@lean_kernel
def measure_depths(points, inside, store, crossings, hits, rows):
    """Depth and way out of all vertices inside, rows (DEPTH_ROWS, n) written. Returns the number of rings.

    inside (n,): 1 for vertices in a triangle; crossings: keys, the first ``hits`` of them count.
    """
    rows[:, :] = 0.0
    for k in range(hits):
        e = crossings[k] >> 32
        f = crossings[k] & 0xFFFF_FFFF
        for end in range(2):
            p = int(store.edges[e, end])
            if inside[p]:
                add_border(points, store, p, e, f, rows)
            if store.beyond[e] >= 0:
                q = int(store.edges[f, end])
                if inside[q]:
                    add_border(points, store, q, f, e, rows)
    n = points.shape[0]
    for p in range(n):
        if rows[WEIGHT, p] > 0.0:
            settle(rows, p, 1.0)
    for ring in range(2, MOST_RINGS):
        grown = False
        for p in range(n):
            if inside[p] and rows[RING, p] == 0.0:
                add_neighbours(points, store, p, float(ring), rows)
                if rows[WEIGHT, p] > 0.0:
                    settle(rows, p, float(ring))
                    grown = True
        if not grown:
            return ring - 1
    return MOST_RINGS
