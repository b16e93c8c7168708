"""Kernels that fit a box to a convex hull: by degrees, and exactly.

A box is a row (6,): centre x, y; unit vector x, y along its longer side; half its length, half its breadth.
"""

from __future__ import annotations

import math

from game.compiler.decorator import lean_kernel

FEW = 5  # corners up to which all of them are looked at in every direction


@lean_kernel
def extents_along(hull, h, c, s):
    """Least and greatest coordinate of hull (h, 2) on the axes (c, s) and (-s, c): u0, u1, v0, v1."""
    x, y = hull[0, 0], hull[0, 1]
    u0 = u1 = c * x + s * y
    v0 = v1 = c * y - s * x
    for i in range(1, h):
        x, y = hull[i, 0], hull[i, 1]
        u = c * x + s * y
        v = c * y - s * x
        u0 = min(u0, u)
        u1 = max(u1, u)
        v0 = min(v0, v)
        v1 = max(v1, v)
    return u0, u1, v0, v1


@lean_kernel
def supports_at(hull, h, c, s, supports):
    """Write the corners farthest along (c, s), (-s, c), (-c, -s) and (s, -c) into ``supports`` (4,)."""
    for side in range(4):
        best, reach = 0, c * hull[0, 0] + s * hull[0, 1]
        for i in range(1, h):
            along = c * hull[i, 0] + s * hull[i, 1]
            if along > reach:
                best, reach = i, along
        supports[side] = best
        c, s = -s, c


@lean_kernel
def follow_supports(hull, h, c, s, supports):
    """Let ``supports`` walk on, counter-clockwise, to a direction a little further round."""
    for side in range(4):
        at = supports[side]
        for _ in range(h):
            following = at + 1 if at + 1 < h else 0
            if c * (hull[following, 0] - hull[at, 0]) + s * (hull[following, 1] - hull[at, 1]) <= 0.0:
                break
            at = following
        supports[side] = at
        c, s = -s, c


@lean_kernel(inline="always")
def extents_of_supports(hull, c, s, supports):
    """The same as `extents_along` from the four outermost corners."""
    far, top, back, low = supports[0], supports[1], supports[2], supports[3]
    return (
        c * hull[back, 0] + s * hull[back, 1],
        c * hull[far, 0] + s * hull[far, 1],
        c * hull[low, 1] - s * hull[low, 0],
        c * hull[top, 1] - s * hull[top, 0],
    )


@lean_kernel
def search_box(hull, h, turns, supports):
    """Index of the direction in ``turns`` (k, 2) whose box has the least area; the first of equal ones.

    Where there are many corners the four outermost ones walk round with the axes, so each direction takes a
    handful of steps. ``supports`` (4,) int64: overwritten.
    """
    best, least = 0, math.inf
    if h == 2:
        dx, dy = hull[1, 0] - hull[0, 0], hull[1, 1] - hull[0, 1]
        for i in range(len(turns)):
            c, s = turns[i, 0], turns[i, 1]
            area = abs((c * dx + s * dy) * (c * dy - s * dx))
            if area < least:
                best, least = i, area
        return best
    if h > FEW:
        supports_at(hull, h, turns[0, 0], turns[0, 1], supports)
    for i in range(len(turns)):
        c, s = turns[i, 0], turns[i, 1]
        if h > FEW:
            follow_supports(hull, h, c, s, supports)
            u0, u1, v0, v1 = extents_of_supports(hull, c, s, supports)
        else:
            u0, u1, v0, v1 = extents_along(hull, h, c, s)
        area = (u1 - u0) * (v1 - v0)
        if area < least:
            best, least = i, area
    return best


@lean_kernel
def calipers(hull, h, by_width):
    """Direction (c, s) of the hull side on which the box has the least area (or, ``by_width``, breadth).

    The least box has a side flush with the hull (Freeman and Shapira 1975), and so has the least breadth.
    Three callipers walk once round the hull, which is counter-clockwise (Toussaint 1983). O(h).
    """
    if h < 2:
        return 1.0, 0.0
    best_c, best_s, least = 1.0, 0.0, math.inf
    far, top, back = 1, 1, 1
    for i in range(h):
        j = (i + 1) % h
        dx, dy = hull[j, 0] - hull[i, 0], hull[j, 1] - hull[i, 1]
        length = math.sqrt(dx * dx + dy * dy)
        if length == 0.0:
            continue
        c, s = dx / length, dy / length
        far = climb(hull, h, far if i else j, c, s)
        top = climb(hull, h, top if i else far, -s, c)
        back = climb(hull, h, back if i else top, -c, -s)
        breadth = c * (hull[top, 1] - hull[i, 1]) - s * (hull[top, 0] - hull[i, 0])
        measure = breadth
        if not by_width:
            measure *= c * (hull[far, 0] - hull[back, 0]) + s * (hull[far, 1] - hull[back, 1])
        if measure < least:
            best_c, best_s, least = c, s, measure
    return best_c, best_s


@lean_kernel
def climb(hull, h, start, c, s):
    """From a corner on, counter-clockwise, as long as the next one is not less far along (c, s)."""
    at = start
    reach = c * hull[at, 0] + s * hull[at, 1]
    for _ in range(h):
        following = at + 1 if at + 1 < h else 0
        there = c * hull[following, 0] + s * hull[following, 1]
        if there < reach:
            break
        at, reach = following, there
    return at


@lean_kernel
def write_box(hull, h, c, s, origin_x, origin_y, volumes, node):
    """Write the box of a hull on the axis (c, s) into row ``node``: centre amid the projections."""
    u0, u1, v0, v1 = extents_along(hull, h, c, s)
    u, v = 0.5 * (u0 + u1), 0.5 * (v0 + v1)
    volumes[node, 0] = origin_x + (c * u - s * v)
    volumes[node, 1] = origin_y + (s * u + c * v)
    half_u, half_v = 0.5 * (u1 - u0), 0.5 * (v1 - v0)
    if half_u >= half_v:
        volumes[node, 2], volumes[node, 3] = c, s
        volumes[node, 4], volumes[node, 5] = half_u, half_v
    else:
        volumes[node, 2], volumes[node, 3] = -s, c
        volumes[node, 4], volumes[node, 5] = half_v, half_u
