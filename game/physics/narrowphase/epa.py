"""EPA: the depth of an overlap, by expanding a polygon within A - B to the border of A - B.

The origin lies inside, from the triangle on that GJK ends with. Of the polygon's edges the one nearest to the
origin is taken. If A - B has a corner farther out along its normal, the edge is broken there. Else it lies on
the border and is the shortest way out. Where GJK began with given features, its triangle may have corners
within A - B: those that the new corner leaves within the polygon are dropped. So each polygon is convex,
holds the one before it, and the origin. Source: van den Bergen 2001.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.kernels import elementary
from game.physics.narrowphase.features import pair_of, turned_back
from game.physics.narrowphase.gjk import (
    AT_ORIGIN,
    INSIDE_SIMPLEX,
    Search,
    Start,
    corner,
    local_edge,
    measure_chord,
    measure_simplex,
    walk,
)
from game.physics.narrowphase.separating_axis import measure_touching
from game.physics.narrowphase.simplex import support_cold, support_hc

# place of the edge in the polygon, its distance, new corner i j, 1 if inserted after the edge, how many
# corners were dropped before and behind it
TRACE_WIDTH = 7
NO_TRACE = np.empty((0, TRACE_WIDTH))
NO_CORNERS = np.empty((0, 2), dtype=np.int64)


class Polytope(NamedTuple):
    """Scratch for the polygon that is expanded: three places more than A and B have vertices."""

    corners: Any  # (n, 2) vertex of A, vertex of B
    heights: Any  # (n,) distance of the origin from the edge that begins there, m


class Traces(NamedTuple):
    """What is written of a search: steps of GJK and of EPA, and the corners that EPA begins with."""

    gjk: Any  # (n, 16)
    epa: Any  # (n, 7)
    first: Any  # (3, 2) or (0, 2) vertex of A, vertex of B


@inner_kernel
def turn_at(pair, corners, k, m, n):
    """Above 0 if the path over the corners k, m and n of A - B turns left at m, m²."""
    ex, ey = local_edge(pair, corners[k, 0], corners[k, 1], corners[m, 0], corners[m, 1])
    gx, gy = local_edge(pair, corners[m, 0], corners[m, 1], corners[n, 0], corners[n, 1])
    return ex * gy - ey * gx


@inner_kernel
def swap(corners, k, m):
    """Let two corners change places."""
    i, j = corners[k, 0], corners[k, 1]
    corners[k, 0], corners[k, 1] = corners[m, 0], corners[m, 1]
    corners[m, 0], corners[m, 1] = i, j


@lean_kernel
def first_polygon(pair, simplex, corners):
    """Write one to three corners (i, j) of A - B to begin with, counterclockwise; return how many.

    They are GJK's last simplex (i0, j0, i1, j1, i2, j2), which holds the origin. Of three on a line the two
    farthest apart are taken, to be gone round there and back. A single one, which is the origin, is joined by
    a support vertex.
    """
    i0, j0, i1, j1, i2, j2 = simplex
    corners[0, 0], corners[0, 1] = i0, j0
    corners[1, 0], corners[1, 1] = i1, j1
    corners[2, 0], corners[2, 1] = i2, j2
    turn = turn_at(pair, corners, 0, 1, 2)
    if turn != 0.0:
        if turn < 0.0:
            swap(corners, 1, 2)
        return 3
    first, second, longest = 0, 0, 0.0
    for k in range(3):
        m = k + 1 if k < 2 else 0
        ex, ey = local_edge(pair, corners[k, 0], corners[k, 1], corners[m, 0], corners[m, 1])
        if math.sqrt(ex * ex + ey * ey) > longest:
            first, second, longest = k, m, math.sqrt(ex * ex + ey * ey)
    if longest > 0.0:
        third = 3 - first - second
        if third < 2:
            swap(corners, third, 2)
        return 2
    for turn in range(4):
        dx, dy = elementary.cos(0.5 * math.pi * turn), elementary.sin(0.5 * math.pi * turn)
        gx, gy = turned_back(pair.frame, -dx, -dy)
        corners[1, 0], corners[1, 1] = support_cold(pair.a, dx, dy), support_cold(pair.b, gx, gy)
        ex, ey = local_edge(pair, i0, j0, corners[1, 0], corners[1, 1])
        if ex != 0.0 or ey != 0.0:
            return 2
    return 1


@inner_kernel
def edge_height(pair, corners, k, m):
    """Outward distance of the edge from corner k to corner m, and its normal, not of unit length."""
    i, j = corners[k, 0], corners[k, 1]
    ex, ey = local_edge(pair, i, j, corners[m, 0], corners[m, 1])
    x, y = corner(pair, i, j)
    length = math.sqrt(ex * ex + ey * ey)
    if length == 0.0:
        return math.inf, ey, -ex
    return (ey * x - ex * y) / length, ey, -ex


@inner_kernel
def drop(polytope, count, k):
    """Take a corner out."""
    corners, heights = polytope
    for m in range(k, count - 1):
        corners[m, 0], corners[m, 1], heights[m] = corners[m + 1, 0], corners[m + 1, 1], heights[m + 1]


@inner_kernel
def break_edge(pair, polytope, count, edge, i, j):
    """Break an edge at a new corner beyond it, and drop the corners that are no longer corners of the hull.

    Returns the count, and how many corners were dropped before and behind the new one.
    """
    corners, heights = polytope
    for k in range(count, edge + 1, -1):
        corners[k, 0], corners[k, 1], heights[k] = corners[k - 1, 0], corners[k - 1, 1], heights[k - 1]
    new = edge + 1
    corners[new, 0], corners[new, 1] = i, j
    count += 1
    dropped_before = dropped_behind = 0
    while count > 3:
        m, n = (new + 1) % count, (new + 2) % count
        if turn_at(pair, corners, new, m, n) > 0.0:
            break
        drop(polytope, count, m)
        new -= m < new
        count -= 1
        dropped_behind += 1
    while count > 3:
        m, n = (new - 1 + count) % count, (new - 2 + count) % count
        if turn_at(pair, corners, n, m, new) > 0.0:
            break
        drop(polytope, count, m)
        new -= m < new
        count -= 1
        dropped_before += 1
    for k in ((new - 1 + count) % count, new):
        heights[k] = edge_height(pair, corners, k, (k + 1) % count)[0]
    return count, dropped_before, dropped_behind


@inner_kernel
def expand(pair, polytope, count, trace):
    """Expand the polygon until its nearest edge is on the border: (place of the edge, count, steps)."""
    corners, heights = polytope
    for k in range(count):
        m = k + 1 if k + 1 < count else 0
        heights[k] = edge_height(pair, corners, k, m)[0]
    best, steps = 0, 0
    while True:
        best = 0
        for k in range(1, count):
            if heights[k] < heights[best]:
                best = k
        m = best + 1 if best + 1 < count else 0
        height, nx, ny = edge_height(pair, corners, best, m)
        gx, gy = turned_back(pair.frame, -nx, -ny)
        i = support_hc(pair.a, corners[best, 0], nx, ny)
        j = support_hc(pair.b, corners[best, 1], gx, gy)
        ax, ay = local_edge(pair, corners[best, 0], corners[best, 1], i, j)
        farther = nx * ax + ny * ay > 0.0  # exactly 0 for the edge's own ends
        done = not farther or count >= corners.shape[0] or steps >= 2 * corners.shape[0]
        edge, before, behind = best, 0, 0
        if not done:
            count, before, behind = break_edge(pair, polytope, count, best, i, j)
        if steps < trace.shape[0]:
            trace[steps, 0], trace[steps, 1] = edge, height
            trace[steps, 2], trace[steps, 3], trace[steps, 4] = i, j, not done
            trace[steps, 5], trace[steps, 6] = before, behind
        steps += 1
        if done:
            return best, count, steps


@lean_kernel
def epa_query(pair, start, search, deep, polytope, traces):
    """GJK, and EPA where it finds an overlap: the nine numbers of `measure`, steps of GJK and of EPA.

    pair, start, search: as for `walk`; polytope: `Polytope`; traces: `Traces`; all as plain tuples.
    """
    pair, polytope, traces = pair_of(pair), Polytope(*polytope), Traces(*traces)
    status, steps, i0, j0, i1, j1, i, j = walk(pair, Start(*start), Search(*search), traces.gjk)
    if status != INSIDE_SIMPLEX and status != AT_ORIGIN:
        return measure_simplex(pair, i0, j0, i1, j1), steps, 0
    corners, first = polytope.corners, traces.first
    count = first_polygon(pair, (i0, j0, i1, j1, i, j), corners)
    if count == 1 or not deep:
        return measure_touching(pair, deep, 2 * i0, 2 * j0), steps, 0
    for k in range(min(count, first.shape[0])):
        first[k, 0], first[k, 1] = corners[k, 0], corners[k, 1]
    best, count, more = expand(pair, polytope, count, traces.epa)
    m = best + 1 if best + 1 < count else 0
    _, ax, ay, _, _, _, _, feature_a, feature_b = measure_chord(
        pair, corners[best, 0], corners[best, 1], corners[m, 0], corners[m, 1]
    )
    height, nx, ny = edge_height(pair, corners, best, m)
    length = math.sqrt(nx * nx + ny * ny)
    nx, ny = nx / length, ny / length
    found = 0.0 - height, ax, ay, ax - height * nx, ay - height * ny, nx, ny, feature_a, feature_b
    return found, steps, more
