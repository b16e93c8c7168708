"""Features of a polygon, by number: vertex i is 2 i, the edge from vertex i to the next is 2 i + 1.

Kernels take polygons as rows ``first`` to ``first + count`` of an array (N, 2) of vertices, each polygon
in its own frame, so that many can lie in one array. A pair of them comes with (c, s, tx, ty), which takes
a point of B into the frame of A: (c x - s y + tx, s x + c y + ty).
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from game.physics.kernels.lean import inner_kernel


@dataclass(frozen=True, slots=True)
class Feature:
    """A vertex, or the edge from a vertex to the next. kind: "vertex" or "edge"."""

    kind: str
    index: int

    @property
    def code(self) -> int:
        """Its number, as the kernels have it."""
        return 2 * self.index + (self.kind == "edge")

    @classmethod
    def of(cls, code: int) -> Feature:
        """The feature of a number."""
        return cls("edge" if code & 1 else "vertex", int(code) >> 1)

    def __str__(self) -> str:
        return f"{self.kind} {self.index}"


@inner_kernel
def after(i, count):
    """The vertex after vertex i."""
    return i + 1 if i + 1 < count else 0


@inner_kernel
def before(i, count):
    """The vertex before vertex i."""
    return i - 1 if i > 0 else count - 1


@inner_kernel
def inverse_frame(c, s, tx, ty):
    """(c, s, tx, ty) that takes a point of A into the frame of B."""
    return c, -s, -(c * tx + s * ty), s * tx - c * ty


@inner_kernel
def known_feature(code, count):
    """True if a polygon of so many vertices has a feature of this number."""
    return 0 <= code < 2 * count and (count > 1 or code == 0)


@inner_kernel
def measure_vertices(ax, ay, bx, by):
    """Distance, and unit vector from a to b (0, 0 where they coincide)."""
    dx, dy = bx - ax, by - ay
    distance = math.sqrt(dx * dx + dy * dy)
    if distance == 0.0:
        return 0.0, 0.0, 0.0
    return distance, dx / distance, dy / distance


@inner_kernel
def measure_to_edge(x, y, ox, oy, px, py):
    """Distance of (x, y) from the line o to p, foot (fx, fy), and unit vector from the point to the foot.

    Reckoned from the end that is nearer, so that it comes out the same when the edge runs the other way.
    """
    ex, ey = px - ox, py - oy
    ux, uy = x - ox, y - oy
    vx, vy = x - px, y - py
    squared = ex * ex + ey * ey
    if ux * ux + uy * uy <= vx * vx + vy * vy:
        cross = ex * uy - ey * ux
        part = (ex * ux + ey * uy) / squared
        fx, fy = ox + part * ex, oy + part * ey
    else:
        cross = ex * vy - ey * vx
        part = (ex * vx + ey * vy) / squared
        fx, fy = px + part * ex, py + part * ey
    length = math.sqrt(squared)
    nx, ny = ey / length, -ex / length
    if cross > 0.0:
        return cross / length, fx, fy, nx, ny
    return -cross / length, fx, fy, -nx, -ny


@inner_kernel
def opposite_edge(va, fa, na, vertex, ex, ey):
    """The edge at a vertex that runs exactly against (ex, ey), or -1."""
    if na == 1:
        return -1
    x, y = va[fa + vertex, 0], va[fa + vertex, 1]
    n = after(vertex, na)
    gx, gy = va[fa + n, 0] - x, va[fa + n, 1] - y
    if gx * ey - gy * ex == 0.0 and gx * ex + gy * ey < 0.0:
        return vertex
    n = before(vertex, na)
    gx, gy = x - va[fa + n, 0], y - va[fa + n, 1]
    if gx * ey - gy * ex == 0.0 and gx * ex + gy * ey < 0.0:
        return n
    return -1


@inner_kernel
def measure_edges(va, fa, na, vb, fb, nb, c, s, tx, ty, i, j):
    """Distance, witness points (frame of A) and unit vector from A to B of parallel edges i and j.

    The points are in the middle of what the edges have in common.
    """
    o, p = fa + i, fa + after(i, na)
    k, m = fb + j, fb + after(j, nb)
    ox, oy = va[o, 0], va[o, 1]
    ex, ey = va[p, 0] - ox, va[p, 1] - oy
    kx, ky = c * vb[k, 0] - s * vb[k, 1] + tx - ox, s * vb[k, 0] + c * vb[k, 1] + ty - oy
    mx, my = c * vb[m, 0] - s * vb[m, 1] + tx - ox, s * vb[m, 0] + c * vb[m, 1] + ty - oy
    squared = ex * ex + ey * ey
    t, u = kx * ex + ky * ey, mx * ex + my * ey
    low, high = max(min(t, u), 0.0), min(max(t, u), squared)
    part = 0.5 * (low + high) / squared
    length = math.sqrt(squared)
    distance = (kx * ey - ky * ex) / length
    nx, ny = ey / length, -ex / length
    x, y = ox + part * ex, oy + part * ey
    return distance, x, y, x + distance * nx, y + distance * ny, nx, ny


@inner_kernel
def measure(va, fa, na, vb, fb, nb, c, s, tx, ty, feature_a, feature_b):
    """What two closest features say: (distance, x, y of A's point, of B's, normal, feature_a, feature_b).

    In the frame of A; the unit normal leads from A to B. A vertex before an edge that is parallel to one of
    its own becomes two edges, so that the answer does not depend on the way by which it was found.
    """
    i, j = feature_a >> 1, feature_b >> 1
    if feature_a & 1 and feature_b & 1:
        d, ax, ay, bx, by, nx, ny = measure_edges(va, fa, na, vb, fb, nb, c, s, tx, ty, i, j)
        return d, ax, ay, bx, by, nx, ny, feature_a, feature_b
    ax, ay = va[fa + i, 0], va[fa + i, 1]
    bx, by = c * vb[fb + j, 0] - s * vb[fb + j, 1] + tx, s * vb[fb + j, 0] + c * vb[fb + j, 1] + ty
    if feature_a & 1:
        k = fa + after(i, na)
        ex, ey = va[k, 0] - ax, va[k, 1] - ay
        # the edge in B's frame, for B's own edges
        edge = opposite_edge(vb, fb, nb, j, c * ex + s * ey, c * ey - s * ex)
        if edge >= 0:
            d, ax, ay, bx, by, nx, ny = measure_edges(va, fa, na, vb, fb, nb, c, s, tx, ty, i, edge)
            return d, ax, ay, bx, by, nx, ny, feature_a, 2 * edge + 1
        d, fx, fy, nx, ny = measure_to_edge(bx, by, ax, ay, va[k, 0], va[k, 1])
        return d, fx, fy, bx, by, -nx, -ny, feature_a, feature_b
    if feature_b & 1:
        k = fb + after(j, nb)
        hx, hy = vb[k, 0] - vb[fb + j, 0], vb[k, 1] - vb[fb + j, 1]
        ex, ey = c * hx - s * hy, s * hx + c * hy
        edge = opposite_edge(va, fa, na, i, ex, ey)
        if edge >= 0:
            d, ax, ay, bx, by, nx, ny = measure_edges(va, fa, na, vb, fb, nb, c, s, tx, ty, edge, j)
            return d, ax, ay, bx, by, nx, ny, 2 * edge + 1, feature_b
        kx, ky = c * vb[k, 0] - s * vb[k, 1] + tx, s * vb[k, 0] + c * vb[k, 1] + ty
        d, fx, fy, nx, ny = measure_to_edge(ax, ay, bx, by, kx, ky)
        return d, ax, ay, fx, fy, nx, ny, feature_a, feature_b
    d, nx, ny = measure_vertices(ax, ay, bx, by)
    return d, ax, ay, bx, by, nx, ny, feature_a, feature_b
