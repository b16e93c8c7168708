"""V-Clip: the closest features of two convex polygons, by walking from feature to neighbouring feature.

The plane around a polygon is divided into the Voronoi regions of its vertices and edges. Two features are
the closest ones when each has the point of the other that is nearest to it in its own region. If that is not
so, the region's border that is crossed names the neighbour to go to, and the distance has become less.

`clip_vertex` says where to go for a vertex against a vertex or an edge, `clip_edge` for an edge. Where the
walk can be caught behind an edge, Mirtich's repair goes to the edge that the vertex is farthest in front of.
Inside all of them there is overlap. Ties can send the rounded walk in a circle: Brent's test finds it after
at most three turns, and then all features are looked at. So it always ends, without any tolerance. Sources:
Mirtich 1998; Ericson 2005, 9.2.1; Brent 1980.
"""

from __future__ import annotations

import math

import numpy as np

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.narrowphase.features import (
    after,
    before,
    known_feature,
    measure,
    measure_to_edge,
    pair_of,
    turned_back,
    turned_round,
    vertex,
    vertex_in,
)
from game.physics.narrowphase.separating_axis import measure_overlap, measure_touching

BEHIND = -1  # what `clip_vertex` and `clip_edge` say of what is beside an edge, but not in front
CROSSING = -2  # what `clip_edge` says of an edge that crosses or meets another
CLOSEST, OVERLAPPING, REPAIRED_A, REPAIRED_B, MOVED_A, MOVED_B = 0, 1, 2, 3, 4, 5
CIRCLED = 6  # the walk came back to where it had been: all features were looked at
TRACE_WIDTH = 3  # feature of A, feature of B, what was decided there
NO_TRACE = np.empty((0, TRACE_WIDTH))


@lean_kernel
def clip_vertex(polygon, feature, x, y):
    """Where a vertex (x, y) of the other polygon lies as a feature's Voronoi region sees it.

    Returns the feature itself if within (borders included), the neighbour beyond the border that is crossed,
    or BEHIND an edge (or on it). Cases vertex-vertex and vertex-edge.
    """
    count = polygon.size
    if count == 1:
        return feature
    i = feature >> 1
    ox, oy = vertex(polygon, i)
    n = after(i, count)
    px, py = vertex(polygon, n)
    ex, ey = px - ox, py - oy
    dx, dy = x - ox, y - oy
    along = ex * dx + ey * dy
    if feature & 1:
        if along < 0.0:
            return 2 * i
        if ex * (x - px) + ey * (y - py) > 0.0:
            return 2 * n
        return BEHIND if ex * dy - ey * dx >= 0.0 else feature
    if along > 0.0:
        return feature + 1
    n = before(i, count)
    px, py = vertex(polygon, n)
    if (ox - px) * dx + (oy - py) * dy < 0.0:
        return 2 * n + 1
    return feature


@lean_kernel
def clip_edge(polygon, feature, px, py, qx, qy):
    """Where the nearest point of the edge p to q of the other polygon lies, as a feature's region sees it.

    The other polygon is on the left of the direction from p to q.

    Of a vertex: the edge is clipped by the region's two borders. If the distance to the vertex still falls
    where it leaves the region, the answer is the edge on that side, else the vertex itself. The distance
    falls beyond a border exactly if the foot on the line p q is beyond it, which the two directions alone
    decide.

    Of an edge: the answer is the vertex whose border the part beside the edge must cross to come nearer. Or
    the edge itself if an end of p q is nearest (or both are parallel), CROSSING, or BEHIND.
    """
    count = polygon.size
    if count == 1:
        return feature
    i = feature >> 1
    n = after(i, count)
    ox, oy = vertex(polygon, i)
    ux, uy = vertex(polygon, n)
    ex, ey = ux - ox, uy - oy
    gx, gy = qx - px, qy - py
    if not feature & 1:
        if ex * gy - ey * gx < 0.0:
            return feature + 1
        n = before(i, count)
        ux, uy = vertex(polygon, n)
        if (ox - ux) * gy - (oy - uy) * gx > 0.0:
            return 2 * n + 1
        return feature
    start, end = ex * (px - ox) + ey * (py - oy), ex * (qx - ox) + ey * (qy - oy)
    squared = ex * ex + ey * ey
    if start < 0.0 and end < 0.0:
        return 2 * i
    if start > squared and end > squared:
        return 2 * n
    near, far = ey * (px - ox) - ex * (py - oy), ey * (qx - ox) - ex * (qy - oy)
    if near > far:
        start, end, near, far = end, start, far, near
    # where the strip cuts off what is beyond it, from the nearer end and from the farther
    low, high = near, far
    if start < 0.0:
        low += (far - near) * start / (start - end)
    elif start > squared:
        low += (far - near) * (start - squared) / (start - end)
    if end < 0.0:
        high += (near - far) * end / (end - start)
    elif end > squared:
        high += (near - far) * (end - squared) / (end - start)
    if low <= 0.0:
        return CROSSING if high > 0.0 or low == 0.0 else BEHIND
    if near < far and start < 0.0:
        return 2 * i
    if near < far and start > squared:
        return 2 * n
    return feature


@inner_kernel
def edge_in_front(polygon, x, y):
    """The edge that a point is farthest in front of, and how far; not above 0 if it is inside."""
    best, edge = -math.inf, 0
    for i in range(polygon.size):
        ox, oy = vertex(polygon, i)
        px, py = vertex(polygon, after(i, polygon.size))
        ex, ey = px - ox, py - oy
        distance = (ey * (x - ox) - ex * (y - oy)) / math.sqrt(ex * ex + ey * ey)
        if distance > best:
            best, edge = distance, i
    return edge, best


@inner_kernel
def clip_vertex_to_edge(a, b, frame, feature_a, feature_b):
    """One step from a vertex of A and an edge of B: (new vertex or edge of A, of B, verdict).

    ``frame`` takes points of A into the frame of B.
    """
    x, y = vertex_in(frame, a, feature_a >> 1)
    seen = clip_vertex(b, feature_b, x, y)
    if seen == BEHIND:
        best, distance = edge_in_front(b, x, y)
        return feature_a, 2 * best + 1, OVERLAPPING if distance <= 0.0 else REPAIRED_B
    if seen != feature_b:
        return feature_a, seen, MOVED_B
    ox, oy = vertex(b, feature_b >> 1)
    px, py = vertex(b, after(feature_b >> 1, b.size))
    # of a vertex's region only the direction of the edge matters, turned into the frame of A
    ex, ey = turned_back(frame, px - ox, py - oy)
    seen = clip_edge(a, feature_a, 0.0, 0.0, ex, ey)
    return seen, feature_b, CLOSEST if seen == feature_a else MOVED_A


@inner_kernel(forceinline=True)  # a call would pass two polygons and a frame on the stack, for every step
def step(pair, feature_a, feature_b):
    """One step of the walk: (feature of A, feature of B, verdict)."""
    a, b, frame = pair
    if feature_a & 1 and feature_b & 1:
        return step_of_edges(pair, feature_a, feature_b)
    if feature_a & 1:
        new_b, new_a, verdict = clip_vertex_to_edge(b, a, frame, feature_b, feature_a)
        if verdict == MOVED_A:
            verdict = MOVED_B
        elif verdict == MOVED_B:
            verdict = MOVED_A
        elif verdict == REPAIRED_B:
            verdict = REPAIRED_A
        return new_a, new_b, verdict
    back = turned_round(pair).frame
    if feature_b & 1:
        return clip_vertex_to_edge(a, b, back, feature_a, feature_b)
    x, y = vertex_in(frame, b, feature_b >> 1)
    seen = clip_vertex(a, feature_a, x, y)
    if seen != feature_a:
        return seen, feature_b, MOVED_A
    x, y = vertex_in(back, a, feature_a >> 1)
    seen = clip_vertex(b, feature_b, x, y)
    return feature_a, seen, CLOSEST if seen == feature_b else MOVED_B


@inner_kernel
def step_of_edges(pair, feature_a, feature_b):
    """`step` from two edges."""
    a, b, frame = pair
    next_b = after(feature_b >> 1, b.size)
    px, py = vertex_in(frame, b, feature_b >> 1)
    qx, qy = vertex_in(frame, b, next_b)
    seen = clip_edge(a, feature_a, px, py, qx, qy)
    if seen == CROSSING:
        return feature_a, feature_b, OVERLAPPING
    if seen == BEHIND:
        if clip_vertex(a, feature_a, px, py) != BEHIND:
            px, py, feature_b = qx, qy, 2 * next_b + 1
        best, distance = edge_in_front(a, px, py)
        return 2 * best + 1, feature_b - 1, OVERLAPPING if distance <= 0.0 else REPAIRED_A
    if seen != feature_a:
        return seen, feature_b, MOVED_A
    return end_of_edge(pair, feature_a, feature_b, px, py, qx, qy)


@inner_kernel
def end_of_edge(pair, feature_a, feature_b, px, py, qx, qy):
    """Of an edge of B (from p to q) beside one of A: its nearer end, or itself if they are face to face."""
    a, next_b = pair.a, after(feature_b >> 1, pair.b.size)
    ox, oy = vertex(a, feature_a >> 1)
    ex, ey = vertex(a, after(feature_a >> 1, a.size))
    ex, ey = ex - ox, ey - oy
    near = ey * (px - ox) - ex * (py - oy)
    falls = ey * (qx - px) - ex * (qy - py)
    if falls == 0.0 and near >= 0.0 and ex * (qx - px) + ey * (qy - py) < 0.0:
        return feature_a, feature_b, CLOSEST
    if falls == 0.0:  # the edge of A lies behind that of B: an end that is beside it goes on
        beside = ex * (px - ox) + ey * (py - oy)
        inside = 0.0 <= beside <= ex * ex + ey * ey
        return feature_a, feature_b - 1 if inside else 2 * next_b, MOVED_B
    return feature_a, 2 * next_b if falls < 0.0 else feature_b - 1, MOVED_B


@lean_kernel
def closest_features(pair):
    """The closest vertex and edge, or two vertices, by looking at all pairs of them."""
    a, b, frame = pair
    best, best_a, best_b = math.inf, 0, 0
    for i in range(a.size):
        ax, ay = vertex(a, i)
        for j in range(b.size):
            bx, by = vertex_in(frame, b, j)
            dx, dy = bx - ax, by - ay
            distance = math.sqrt(dx * dx + dy * dy)
            if distance < best:
                best, best_a, best_b = distance, 2 * i, 2 * j
    there = turned_round(pair).frame
    for i in range(a.size):
        x, y = vertex_in(there, a, i)
        edge, distance = nearest_edge(b, x, y)
        if distance < best:
            best, best_a, best_b = distance, 2 * i, edge
    for j in range(b.size):
        x, y = vertex_in(frame, b, j)
        edge, distance = nearest_edge(a, x, y)
        if distance < best:
            best, best_a, best_b = distance, edge, 2 * j
    return best_a, best_b


@inner_kernel
def nearest_edge(polygon, x, y):
    """Of the edges that a point lies beside and before, the nearest and its distance (inf if none)."""
    best, feature = math.inf, 0
    for i in range(polygon.size):
        if clip_vertex(polygon, 2 * i + 1, x, y) == 2 * i + 1 and polygon.size > 1:
            ox, oy = vertex(polygon, i)
            px, py = vertex(polygon, after(i, polygon.size))
            distance = measure_to_edge(x, y, ox, oy, px, py)[0]
            if distance < best:
                best, feature = distance, 2 * i + 1
    return feature, best


@lean_kernel
def vclip_query(pair, start_a, start_b, deep, trace):
    """The walk from two features to the closest ones: the nine numbers of `measure`, and the steps made.

    pair: `Pair`, or plain tuples of the same form.
    """
    pair = pair_of(pair)
    na, nb = pair.a.size, pair.b.size
    feature_a = start_a if known_feature(start_a, na) else 0
    feature_b = start_b if known_feature(start_b, nb) else 0
    seen_a, seen_b, renewed = feature_a, feature_b, 1
    limit = 4 * (na + nb) + 8
    steps, verdict = 0, MOVED_A
    while steps < limit:
        new_a, new_b, verdict = step(pair, feature_a, feature_b)
        if steps < trace.shape[0]:
            trace[steps, 0], trace[steps, 1], trace[steps, 2] = feature_a, feature_b, verdict
        steps += 1
        feature_a, feature_b = new_a, new_b
        if verdict in (CLOSEST, OVERLAPPING):
            break
        if feature_a == seen_a and feature_b == seen_b:
            verdict = CIRCLED
            break
        if steps == renewed:
            seen_a, seen_b, renewed = feature_a, feature_b, 2 * renewed
    if verdict not in (CLOSEST, OVERLAPPING):
        if steps < trace.shape[0]:
            trace[steps, 0], trace[steps, 1], trace[steps, 2] = feature_a, feature_b, CIRCLED
        found = measure_overlap(pair)
        if found[0] <= 0.0 and na + nb > 2 and deep:
            return found, steps
        if found[0] > 0.0 or na + nb == 2:
            feature_a, feature_b = closest_features(pair)
            verdict = CLOSEST
    if verdict == CLOSEST:
        found = measure(pair, feature_a, feature_b)
        if found[0] > 0.0:
            return found, steps
    return measure_touching(pair, deep, feature_a, feature_b), steps
