"""Features of a polygon, by number: vertex i is 2 i, the edge from vertex i to the next is 2 i + 1.

Kernels take a `Polygon` as rows of an array of vertices in a frame of its own, so that many can lie in one
array. A `Pair` of them comes with the `Frame` that takes points of B into the frame of A.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, NamedTuple

from game.compiler.decorator import inner_kernel


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
        """For people: counted from 1."""
        return f"{self.kind} {self.index + 1}"


class Polygon(NamedTuple):
    """As kernels have it: rows first to first + size of vertices (N, 2), m, in the polygon's own frame."""

    vertices: Any
    first: int
    size: int


class Frame(NamedTuple):
    """Takes a point of one polygon's frame into another's: (c x - s y + x0, s x + c y + y0)."""

    c: float
    s: float
    x: float
    y: float


class Pair(NamedTuple):
    """Two polygons, and the frame that takes points of B into the frame of A."""

    a: Polygon
    b: Polygon
    frame: Frame


@inner_kernel
def pair_of(given):
    """The pair of plain tuples of the same form, or of a pair.

    From Python a plain tuple is handed to a kernel in a tenth of the time, which a single query would feel.
    """
    a, b, frame = given
    return Pair(Polygon(*a), Polygon(*b), Frame(*frame))


@inner_kernel
def vertex(polygon, i):
    """Vertex i, in the polygon's own frame."""
    row = polygon.first + i
    return polygon.vertices[row, 0], polygon.vertices[row, 1]


@inner_kernel
def point_in(frame, x, y):
    """A point, taken into the frame."""
    return frame.c * x - frame.s * y + frame.x, frame.s * x + frame.c * y + frame.y


@inner_kernel
def vertex_in(frame, polygon, i):
    """Vertex i, taken into the frame."""
    x, y = vertex(polygon, i)
    return point_in(frame, x, y)


@inner_kernel
def turned(frame, x, y):
    """A direction, taken into the frame."""
    return frame.c * x - frame.s * y, frame.s * x + frame.c * y


@inner_kernel
def turned_back(frame, x, y):
    """A direction in the frame, taken back."""
    return frame.c * x + frame.s * y, frame.c * y - frame.s * x


@inner_kernel
def after(i, count):
    """The vertex after vertex i."""
    return i + 1 if i + 1 < count else 0


@inner_kernel
def before(i, count):
    """The vertex before vertex i."""
    return i - 1 if i > 0 else count - 1


@inner_kernel
def turned_round(pair):
    """The pair with A and B exchanged."""
    c, s, x, y = pair.frame
    return Pair(pair.b, pair.a, Frame(c, -s, -(c * x + s * y), s * x - c * y))


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
def opposite_edge(polygon, i, ex, ey):
    """The edge at vertex i that runs exactly against (ex, ey), or -1."""
    if polygon.size == 1:
        return -1
    x, y = vertex(polygon, i)
    n = after(i, polygon.size)
    nx, ny = vertex(polygon, n)
    gx, gy = nx - x, ny - y
    if gx * ey - gy * ex == 0.0 and gx * ex + gy * ey < 0.0:
        return i
    n = before(i, polygon.size)
    nx, ny = vertex(polygon, n)
    gx, gy = x - nx, y - ny
    if gx * ey - gy * ex == 0.0 and gx * ex + gy * ey < 0.0:
        return n
    return -1


@inner_kernel
def measure_edges(pair, i, j):
    """Distance, witness points (frame of A) and unit vector from A to B of parallel edges i and j.

    The points are in the middle of what the edges have in common.
    """
    a, b, frame = pair
    ox, oy = vertex(a, i)
    px, py = vertex(a, after(i, a.size))
    kx, ky = vertex_in(frame, b, j)
    mx, my = vertex_in(frame, b, after(j, b.size))
    ex, ey = px - ox, py - oy
    kx, ky, mx, my = kx - ox, ky - oy, mx - ox, my - oy
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
def measure(pair, feature_a, feature_b):
    """What two closest features say: (distance, x, y of A's point, of B's, normal, feature_a, feature_b).

    In the frame of A; the unit normal leads from A to B. A vertex before an edge that is parallel to one of
    its own becomes two edges. So the answer does not depend on the path by which it was found.
    """
    a, b, frame = pair
    i, j = feature_a >> 1, feature_b >> 1
    if feature_a & 1 and feature_b & 1:
        d, ax, ay, bx, by, nx, ny = measure_edges(pair, i, j)
        return d, ax, ay, bx, by, nx, ny, feature_a, feature_b
    ax, ay = vertex(a, i)
    bx, by = vertex_in(frame, b, j)
    if feature_a & 1:
        kx, ky = vertex(a, after(i, a.size))
        ex, ey = turned_back(frame, kx - ax, ky - ay)  # in B's frame, for B's own edges
        edge = opposite_edge(b, j, ex, ey)
        if edge >= 0:
            d, ax, ay, bx, by, nx, ny = measure_edges(pair, i, edge)
            return d, ax, ay, bx, by, nx, ny, feature_a, 2 * edge + 1
        d, fx, fy, nx, ny = measure_to_edge(bx, by, ax, ay, kx, ky)
        return d, fx, fy, bx, by, -nx, -ny, feature_a, feature_b
    if feature_b & 1:
        jx, jy = vertex(b, j)
        kx, ky = vertex(b, after(j, b.size))
        ex, ey = turned(frame, kx - jx, ky - jy)
        edge = opposite_edge(a, i, ex, ey)
        if edge >= 0:
            d, ax, ay, bx, by, nx, ny = measure_edges(pair, edge, j)
            return d, ax, ay, bx, by, nx, ny, 2 * edge + 1, feature_b
        kx, ky = point_in(frame, kx, ky)
        d, fx, fy, nx, ny = measure_to_edge(ax, ay, bx, by, kx, ky)
        return d, ax, ay, fx, fy, nx, ny, feature_a, feature_b
    d, nx, ny = measure_vertices(ax, ay, bx, by)
    return d, ax, ay, bx, by, nx, ny, feature_a, feature_b
