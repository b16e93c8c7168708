"""The capsule of least area, found everywhere at once: branch and bound, with a proof of how good it is.

Unlike the least box it need not lie along a side of the hull, nor have the least radius: a rectangle's has
corners on its round ends. With a core along θ and a radius r the shortest core has the length L(θ, r), the
least of a convex function of where the core lies. If a capsule along θ' with r' fits, then so does one along
θ with the same core, turned, and r' + L sin(δ / 2), δ = |θ - θ'|. So in a cell |θ' - θ| <= δ, r1 <= r' <= r2

    area >= 2 r1 L(θ, r2 + D sin(δ / 2)) + π r1²,        D the diameter of the points

and cells that cannot beat the best capsule so far by more than the tolerance are dropped. In place of D
stands the longest core that could still win, and between r1 and r2 the length lies above a line: see
`least_in_cell`.
"""

from __future__ import annotations

import math

from game.compiler.decorator import lean_kernel
from game.physics.bounds.boxes import calipers, extents_along
from game.physics.bounds.capsules import (
    area_of_capsule,
    core_between,
    search_capsule,
    write_capsule,
    write_core,
)
from game.physics.kernels import elementary

GOLDEN = 0.5 * (math.sqrt(5.0) - 1.0)
ROUNDS = 40  # at most, of any search in one dimension
CLOSE = 1e-11  # of the radius, to which the shortest core is found
STEEP = 1e300  # stands for an infinite slope
FIRST_CELLS = 32  # each over so much of half a turn, and over all radii
CELLS = 256  # most cells that wait at once: the halves of one are looked at before the others
MOST_LOOKED_AT = 1 << 15  # cells; shapes of a few corners take some thousands at most
SHARE = 0.5  # a cell is halved by direction as long as D δ is above so much of r2 - r1: measured
TOLERANCE = 1e-3  # of the area, to which the capsules of a tree are the least
MANY = 400  # corners; above that the diameter is taken from the box


@lean_kernel
def span_at(hull, h, c, s, middle, radius):
    """Length of the core at height ``middle``, m, below 0 where one centre would do; and its slope there.

    The length is convex in the height. Its slope may be infinite where a corner is just within the radius.
    """
    low, high, low_slope, high_slope = math.inf, -math.inf, 0.0, 0.0
    for i in range(h):
        v = c * hull[i, 1] - s * hull[i, 0] - middle
        q = math.sqrt(max((radius - v) * (radius + v), 0.0))
        u = c * hull[i, 0] + s * hull[i, 1]
        if u + q < low:
            low, low_slope = u + q, v / q if q > 0.0 else math.copysign(STEEP, v)
        if u - q > high:
            high, high_slope = u - q, -v / q if q > 0.0 else -math.copysign(STEEP, v)
    return high - low, high_slope - low_slope


@lean_kernel
def shortest_core(hull, h, c, s, radius):
    """Length of the shortest core along (c, s) for a radius, and its height; inf if the hull is broader.

    The least of a convex function of the height: where the tangents at two heights on both sides of it cross,
    now and then half way. The crossing lies below the least, and so says when it is found.
    """
    _, _, v0, v1 = extents_along(hull, h, c, s)
    low, high = v1 - radius, v0 + radius
    best, height = math.inf, 0.5 * (low + high)
    if low > high:
        return best, height
    at_low = at_high = math.inf  # not known yet
    low_slope = high_slope = 0.0
    middle = height
    for i in range(ROUNDS):
        length, slope = span_at(hull, h, c, s, middle, radius)
        if length < best:
            best, height = length, middle
        if length <= 0.0 or slope == 0.0:
            break
        if slope > 0.0:
            high, at_high, high_slope = middle, length, slope
        else:
            low, at_low, low_slope = middle, length, slope
        middle = 0.5 * (low + high)
        if at_low < math.inf and at_high < math.inf:
            cross = (at_high - at_low + low_slope * low - high_slope * high) / (low_slope - high_slope)
            if best - (at_low + low_slope * (cross - low)) <= CLOSE * radius:
                break
            if i % 4 != 3 and low < cross < high:
                middle = cross
    return max(best, 0.0), height


@lean_kernel
def radius_within(extent, area):
    """The greatest radius of a capsule of that area that is as long as an extent, its ends included, m."""
    radius = math.sqrt(area / math.pi)
    if 2.0 * radius >= extent:
        return radius
    # 2 r (extent - 2 r) + π r² = area, the smaller root; it is real, as the area is that of a shorter circle
    room = max(extent * extent - (4.0 - math.pi) * area, 0.0)
    return area / (extent + math.sqrt(room))


@lean_kernel
def least_in_cell(hull, h, cell, most, enough, diameter):
    """What no capsule of a cell with an area of at most ``most`` is below, m²; and one found on the way.

    cell: angle, half width, radius from, radius to; radii that need an area of ``enough`` or more are cut
    off. Returns the bound, at most ``enough``, and the area and the radius of a capsule along the angle.

    A core is no longer than ``most`` allows for its radius. The shortest core is a convex function of the
    radius. So below ``far`` it lies above the line through two greater radii. The area on that line is least
    at one of its ends.
    """
    half, near, far = cell[1], cell[2], cell[3]
    c, s = elementary.cos(cell[0]), elementary.sin(cell[0])
    longest = min(diameter, (most - math.pi * near * near) / (2.0 * near))
    turned = max(longest, 0.0) * elementary.sin(0.5 * half)
    u0, u1, v0, v1 = extents_along(hull, h, c, s)
    near = max(near, 0.5 * (v1 - v0) - turned)
    far = min(far, radius_within(u1 - u0 - 2.0 * turned, enough))
    if near > far:
        return enough, math.inf, 0.0
    cell[2], cell[3] = near, far
    radius = far + turned
    length, _ = shortest_core(hull, h, c, s, radius)
    if length == math.inf:
        return enough, math.inf, 0.0
    width = far - near
    rise = 0.0
    if width > 0.0 and length > 0.0 and area_of_capsule(length, near) < enough:
        beyond, _ = shortest_core(hull, h, c, s, radius + width)
        rise = length - beyond
    least = min(enough, area_of_capsule(length + rise, near), area_of_capsule(length, far))
    return least, area_of_capsule(length, radius), radius


@lean_kernel
def prove_least(hull, h, least_radius, diameter, tolerance, cells, best):
    """Branch and bound over direction and radius; returns the lower bound of the area, m².

    cells (CELLS, 4): overwritten; angle, half width, radius from, radius to. best (3,): area, angle and
    radius of the best capsule so far; improved. The bound is 0 if there were too many cells.
    """
    top = looked_at = 0
    most = math.sqrt(best[0] / math.pi)
    for i in range(FIRST_CELLS):
        cells[top, 0], cells[top, 1] = (i + 0.5) * math.pi / FIRST_CELLS, 0.5 * math.pi / FIRST_CELLS
        cells[top, 2], cells[top, 3] = least_radius, most
        top += 1
    bound = best[0]
    while top > 0:
        top -= 1
        enough = best[0] * (1.0 - tolerance)
        least, area, radius = least_in_cell(hull, h, cells[top], best[0], enough, diameter)
        if least >= enough:
            bound = min(bound, least)
            continue
        angle, half, near, far = cells[top, 0], cells[top, 1], cells[top, 2], cells[top, 3]
        if area < best[0]:
            best[0], best[1], best[2] = area, angle, radius
        looked_at += 1
        if top + 2 > len(cells) or looked_at > MOST_LOOKED_AT:
            return 0.0
        by_angle = diameter * half > SHARE * (far - near)
        for side in range(2):
            cells[top, 0], cells[top, 1], cells[top, 2], cells[top, 3] = angle, half, near, far
            if by_angle:
                cells[top, 0], cells[top, 1] = angle + (side - 0.5) * half, 0.5 * half
            else:
                cells[top, 2 + (1 - side)] = 0.5 * (near + far)
            top += 1
    return min(bound, best[0])


@lean_kernel
def best_radius(hull, h, angle, near, far, best):
    """Least area on one angle for radii from ``near`` to ``far``, m²; ``best`` is improved."""
    c, s = elementary.cos(angle), elementary.sin(angle)
    _, _, v0, v1 = extents_along(hull, h, c, s)
    near = max(near, 0.5 * (v1 - v0))
    far = max(far, near)
    least = at_left = math.inf
    for k in range(ROUNDS):
        radius = far - GOLDEN * (far - near) if k % 2 == 0 else near + GOLDEN * (far - near)
        if k == 0:
            radius = near
        length, _ = shortest_core(hull, h, c, s, radius)
        area = area_of_capsule(length, radius)
        if area < best[0]:
            best[0], best[1], best[2] = area, angle, radius
        least = min(least, area)
        if k % 2 == 0:
            at_left = area
        elif k > 1 and at_left <= area:
            far = near + GOLDEN * (far - near)
        elif k > 1:
            near = far - GOLDEN * (far - near)
    return least


@lean_kernel
def polish(hull, h, angle_room, radius_room, least_radius, best):
    """Improve ``best`` (area, angle, radius) by golden section over angles, and over radii for each."""
    near, far = max(best[2] - radius_room, least_radius), best[2] + radius_room
    low, high = best[1] - angle_room, best[1] + angle_room
    at_left = at_right = -1.0
    for _ in range(ROUNDS):
        left, right = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
        for side in range(2):
            if (at_left if side == 0 else at_right) >= 0.0:
                continue
            area = best_radius(hull, h, left if side == 0 else right, near, far, best)
            if side == 0:
                at_left = area
            else:
                at_right = area
        if at_left <= at_right:
            high, at_right, at_left = right, at_left, -1.0
        else:
            low, at_left, at_right = left, at_right, -1.0


@lean_kernel
def diameter_bound(hull, h):
    """The greatest distance of two corners (h, 2), m, or a little more where there are very many."""
    if h > MANY:
        u0, u1, v0, v1 = extents_along(hull, h, 1.0, 0.0)
        return math.sqrt((u1 - u0) * (u1 - u0) + (v1 - v0) * (v1 - v0))
    farthest = 0.0
    for i in range(h):
        for j in range(i):
            dx, dy = hull[i, 0] - hull[j, 0], hull[i, 1] - hull[j, 1]
            farthest = max(farthest, dx * dx + dy * dy)
    return math.sqrt(farthest)


@lean_kernel
def try_axis(hull, h, c, s, best):
    """Improve ``best`` (area, angle, radius) by the capsule amid the projection; returns its radius, m."""
    _, _, v0, v1 = extents_along(hull, h, c, s)
    radius = 0.5 * (v1 - v0)
    low, high = core_between(hull, h, c, s, 0.5 * (v0 + v1), radius)
    area = area_of_capsule(high - low, radius)
    if area < best[0]:
        best[0], best[1], best[2] = area, elementary.atan2(s, c), radius
    return radius


@lean_kernel
def write_shortest(hull, h, angle, radius, origin_x, origin_y, volumes, node):
    """Write the capsule with the shortest core for a direction (rad) and a radius into row ``node``."""
    c, s = elementary.cos(angle), elementary.sin(angle)
    _, middle = shortest_core(hull, h, c, s, radius)
    low, high = core_between(hull, h, c, s, middle, radius)
    write_core(hull, h, c, s, (middle, low, high), origin_x, origin_y, volumes, node)


@lean_kernel
def write_least_capsule(hull, h, turns, scratch, origin_x, origin_y, volumes, node):
    """Write a capsule whose area is within TOLERANCE of the least into row ``node``.

    It begins with the best direction of the search by steps and with the least radius. scratch: a
    `building.FitScratch`, overwritten.
    """
    best = scratch.best
    c, s = calipers(hull, h, True)
    best[0], best[1], best[2] = math.inf, 0.0, 0.0
    thinnest = try_axis(hull, h, c, s, best)
    if h <= 2 or thinnest <= 0.0:
        write_capsule(hull, h, c, s, origin_x, origin_y, volumes, node)
        return
    found = search_capsule(hull, h, turns, scratch.supports, scratch.bounds)
    count = len(turns)
    c, s = turns[found % count, 0], turns[found % count, 1]
    if found >= count:
        c, s = -s, c
    try_axis(hull, h, c, s, best)
    prove_least(hull, h, thinnest, diameter_bound(hull, h), TOLERANCE, scratch.cells, best)
    write_shortest(hull, h, best[1], best[2], origin_x, origin_y, volumes, node)
