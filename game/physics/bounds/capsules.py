"""Kernels that fit a capsule, the points within a radius of a core segment, to a convex hull.

On a given axis the radius is half the breadth of the hull, so that the axis lies in the middle of the
projection. The core is then as short as its two round ends allow. A capsule is a row (6,): core from x, y to
x, y; radius; 0.
"""

from __future__ import annotations

import math

from game.compiler.decorator import lean_kernel
from game.physics.bounds.boxes import FEW, extents_along, extents_of_supports, follow_supports, supports_at


@lean_kernel
def core_between(hull, h, c, s, middle, radius):
    """Ends u0 <= u1 of the shortest core along (c, s) at height ``middle`` that reaches the hull.

    A corner at (u, v) is reached from u - q to u + q, q² = r² - (v - middle)². Where one centre reaches all,
    the core is that point.
    """
    low, high = math.inf, -math.inf
    for i in range(h):
        x, y = hull[i, 0], hull[i, 1]
        v = abs(c * y - s * x - middle)
        q = math.sqrt(max((radius - v) * (radius + v), 0.0))
        u = c * x + s * y
        low = min(low, u + q)
        high = max(high, u - q)
    if low >= high:
        low = high = 0.5 * (low + high)
    return low, high


@lean_kernel(inline="always")
def area_of_capsule(length, radius):
    """Area of a capsule with a core of that length, m²."""
    return 2.0 * radius * length + math.pi * radius * radius


@lean_kernel
def bound_directions(hull, h, turns, supports, bounds):
    """Write what the capsule on each direction has at least; returns the index of the least of these areas.

    Rows k of ``bounds`` (2 count, 3) for ``turns`` (count, 2), then for those turned by a right angle: area,
    the core being at least as long as the projection less both ends; middle; radius. The four outermost
    corners walk round with the axes. ``supports`` (4,) int64: overwritten.
    """
    count = len(turns)
    if h > FEW:
        supports_at(hull, h, turns[0, 0], turns[0, 1], supports)
    promising, lowest = 0, math.inf
    for i in range(count):
        c, s = turns[i, 0], turns[i, 1]
        if h > FEW:
            follow_supports(hull, h, c, s, supports)
            u0, u1, v0, v1 = extents_of_supports(hull, c, s, supports)
        else:
            u0, u1, v0, v1 = extents_along(hull, h, c, s)
        for side in range(2):
            k = i + count * side
            radius, length = 0.5 * (v1 - v0), u1 - u0
            bounds[k, 0] = area_of_capsule(max(length - 2.0 * radius, 0.0), radius)
            bounds[k, 1], bounds[k, 2] = 0.5 * (v0 + v1), radius
            if bounds[k, 0] < lowest:
                promising, lowest = k, bounds[k, 0]
            u0, u1, v0, v1 = v0, v1, -u1, -u0
    return promising


@lean_kernel
def search_capsule(hull, h, turns, supports, bounds):
    """Index of the best direction: i for ``turns`` (k, 2), k + i for those turned by a right angle.

    The first of equal ones, those less turned first. The most promising one is tried first, which spares
    most of the others their square roots. ``supports`` (4,), ``bounds`` (2 k, 3): overwritten.
    """
    count = len(turns)
    if h == 2:
        dx, dy = hull[1, 0] - hull[0, 0], hull[1, 1] - hull[0, 1]
        best, least = 0, math.inf
        for i in range(count):
            across, along = abs(turns[i, 0] * dy - turns[i, 1] * dx), abs(turns[i, 0] * dx + turns[i, 1] * dy)
            if across < least:
                best, least = i, across
            if along < least:
                best, least = i + count, along
        return best
    promising = bound_directions(hull, h, turns, supports, bounds)
    best, least = promising, math.inf
    for turn in range(-1, 2 * count):
        k = promising if turn < 0 else turn
        if bounds[k, 0] > least:
            continue
        c, s = turns[k % count, 0], turns[k % count, 1]
        if k >= count:
            c, s = -s, c
        middle, radius = bounds[k, 1], bounds[k, 2]
        enough = (least - math.pi * radius * radius) / (2.0 * radius) if radius > 0.0 else math.inf
        low, high = math.inf, -math.inf
        for i in range(h):
            x, y = hull[i, 0], hull[i, 1]
            v = c * y - s * x - middle
            q = math.sqrt(max((radius - v) * (radius + v), 0.0))
            u = c * x + s * y
            low = min(low, u + q)
            high = max(high, u - q)
            if high - low > enough:
                break
        area = area_of_capsule(max(high - low, 0.0), radius)
        if area < least or (area == least and k < best):
            best, least = k, area
    return best


@lean_kernel
def write_capsule(hull, h, c, s, origin_x, origin_y, volumes, node):
    """Write the capsule of a hull on the axis (c, s) into row ``node``."""
    _, _, v0, v1 = extents_along(hull, h, c, s)
    middle, radius = 0.5 * (v0 + v1), 0.5 * (v1 - v0)
    low, high = core_between(hull, h, c, s, middle, radius)
    write_core(hull, h, c, s, (middle, low, high), origin_x, origin_y, volumes, node)


@lean_kernel
def write_core(hull, h, c, s, core, origin_x, origin_y, volumes, node):
    """Write the capsule with this core; its radius is the distance of the farthest corner from it.

    core: its coordinate across the axis (c, s), and the least and greatest one along it, m.
    """
    middle, low, high = core
    ax, ay = c * low - s * middle, s * low + c * middle
    bx, by = c * high - s * middle, s * high + c * middle
    farthest = 0.0
    for i in range(h):
        u = c * hull[i, 0] + s * hull[i, 1]
        beyond = max(max(low - u, u - high), 0.0)
        v = c * hull[i, 1] - s * hull[i, 0] - middle
        farthest = max(farthest, v * v + beyond * beyond)
    volumes[node, 0], volumes[node, 1] = origin_x + ax, origin_y + ay
    volumes[node, 2], volumes[node, 3] = origin_x + bx, origin_y + by
    volumes[node, 4] = math.sqrt(farthest)
    volumes[node, 5] = 0.0
