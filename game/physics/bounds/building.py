"""The top-down building of a bounding-volume tree: one kernel, a fit for every node.

A node holds the segments ``order[begin:end]``. It is halved across its longer side, in the middle of its
volume, and each half gets a volume of its own (Gottschalk, Lin and Manocha 1996). The end points are sorted
once by x; their order is handed down by stable partition, so that no node has to sort for its hull.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from game.compiler.decorator import lean_kernel
from game.physics.bounds.boxes import calipers, extents_along, search_box, write_box
from game.physics.bounds.capsules import area_of_capsule, core_between, search_capsule, write_capsule
from game.physics.bounds.hull import sorted_hull
from game.physics.bounds.least_capsule import CELLS, GOLDEN, write_least_capsule
from game.physics.kernels import elementary

OBB, CAPSULE, AABB = 0, 1, 2
SEARCH, REFINED, THINNEST, EXACT = 0, 1, 2, 3
HALF, MEDIAN, PERIMETER = 0, 1, 2
GOLDEN_ROUNDS = 44  # shrink a degree to 1e-11 rad
CHILD, BEGIN, END, PARENT, DEPTH = 0, 1, 2, 3, 4  # columns of links; child: the first of two, or -1


class Fit(NamedTuple):
    """Which volume is fitted, and how."""

    kind: int  # OBB, CAPSULE or AABB
    fit: int  # SEARCH, REFINED, THINNEST or EXACT
    turns: Any  # (k, 2) directions of a search
    step: float  # rad between them


class FitScratch(NamedTuple):
    """What a fit overwrites."""

    supports: Any  # (4,) whole numbers
    bounds: Any  # (2 k, 3)
    cells: Any  # (CELLS, 4)
    best: Any  # (3,)


def fit_scratch(directions: int) -> FitScratch:
    """Scratch for fits with so many directions of a search."""
    supports, bounds = np.zeros(4, dtype=np.int64), np.zeros((2 * directions, 3))
    return FitScratch(supports, bounds, np.empty((CELLS, 4)), np.zeros(3))


class Nodes(NamedTuple):
    """The arrays of a tree; see `BoundingTree`."""

    kind: int  # OBB, CAPSULE or AABB
    volumes: Any  # (m, 6)
    links: Any  # (m, 5)
    sizes: Any  # (m,) m
    ends: Any  # (n, 4) m
    order: Any  # (n,)


class GrowScratch(NamedTuple):
    """What the building of a tree over n segments overwrites."""

    hull: Any  # (4 n + 2, 2)
    sides: Any  # (n,) whole numbers
    keys: Any  # (n,)
    ids: Any  # (n,) whole numbers
    later: Any  # (2 n,) whole numbers


@lean_kernel
def area_on_axis(kind, hull, h, c, s):
    """Area of the box or the capsule of a hull on the axis (c, s), m²."""
    u0, u1, v0, v1 = extents_along(hull, h, c, s)
    if kind == OBB:
        return (u1 - u0) * (v1 - v0)
    radius = 0.5 * (v1 - v0)
    low, high = core_between(hull, h, c, s, 0.5 * (v0 + v1), radius)
    return area_of_capsule(high - low, radius)


@lean_kernel
def golden_angle(kind, hull, h, angle, step):
    """An angle (rad) within ``step`` of ``angle`` whose volume is no larger, by golden section (Kiefer 1953).

    Finds the least where the area has one dip there. Between two flush sides a box has none, so it is a flush
    side that is found.
    """
    low, high = angle - step, angle + step
    best, least = angle, area_on_axis(kind, hull, h, elementary.cos(angle), elementary.sin(angle))
    left, at_left, right, at_right = low, math.inf, high, math.inf
    for i in range(GOLDEN_ROUNDS):
        leftward = i == 0 or at_left <= at_right
        if i == 1:
            trial = low + GOLDEN * (high - low)
            right = trial
        elif leftward:
            if i > 0:
                high, right, at_right = right, left, at_left
            trial = high - GOLDEN * (high - low)
            left = trial
        else:
            low, left, at_left = left, right, at_right
            trial = low + GOLDEN * (high - low)
            right = trial
        area = area_on_axis(kind, hull, h, elementary.cos(trial), elementary.sin(trial))
        if trial == right and i > 0 and not (leftward and i > 1):
            at_right = area
        else:
            at_left = area
        if area < least:
            best, least = trial, area
    return best


@lean_kernel(inline="always")
def best_axis(method, hull, h, scratch):
    """Direction (c, s) of the core, or of a side of the box, of a hull (h, 2)."""
    kind, fit, turns, step = method
    if kind == AABB or h < 2:
        return 1.0, 0.0
    if fit in (THINNEST, EXACT):
        return calipers(hull, h, fit == THINNEST)
    if kind == OBB:
        best = search_box(hull, h, turns, scratch.supports)
    else:
        best = search_capsule(hull, h, turns, scratch.supports, scratch.bounds)
    count = len(turns)
    c, s = turns[best % count, 0], turns[best % count, 1]
    if best >= count:
        c, s = -s, c
    if fit == REFINED:
        angle = golden_angle(kind, hull, h, elementary.atan2(s, c), step)
        c, s = elementary.cos(angle), elementary.sin(angle)
    return c, s


@lean_kernel
def fit_volume(method, hull, h, origin_x, origin_y, volumes, node, scratch):
    """Write the volume of a hull (h, 2) about its origin into row ``node`` of ``volumes`` (m, 6).

    method: `Fit`; scratch: `FitScratch`.
    """
    if method.kind == CAPSULE and method.fit == EXACT:
        write_least_capsule(hull, h, method.turns, scratch, origin_x, origin_y, volumes, node)
        return
    c, s = best_axis(method, hull, h, scratch)
    if method.kind == CAPSULE:
        write_capsule(hull, h, c, s, origin_x, origin_y, volumes, node)
    else:
        write_box(hull, h, c, s, origin_x, origin_y, volumes, node)


@lean_kernel
def middle_of(kind, volumes, node):
    """Centre of a volume and unit vector along its longer side: x, y, c, s."""
    if kind != CAPSULE:
        return volumes[node, 0], volumes[node, 1], volumes[node, 2], volumes[node, 3]
    x, y = 0.5 * (volumes[node, 0] + volumes[node, 2]), 0.5 * (volumes[node, 1] + volumes[node, 3])
    dx, dy = volumes[node, 2] - volumes[node, 0], volumes[node, 3] - volumes[node, 1]
    length = math.sqrt(dx * dx + dy * dy)
    if length > 0.0:
        return x, y, dx / length, dy / length
    return x, y, 1.0, 0.0


@lean_kernel(inline="always")
def write_size(kind, volumes, node, sizes):
    """Write the greatest extent of a volume, m: the larger of two volumes is opened first."""
    if kind != CAPSULE:
        sizes[node] = 2.0 * math.sqrt(
            volumes[node, 4] * volumes[node, 4] + volumes[node, 5] * volumes[node, 5]
        )
    else:
        dx, dy = volumes[node, 2] - volumes[node, 0], volumes[node, 3] - volumes[node, 1]
        sizes[node] = math.sqrt(dx * dx + dy * dy) + 2.0 * volumes[node, 4]


@lean_kernel
def sort_by_key(keys, ids, count):
    """Sort ``ids[:count]`` by ``keys[:count]``, both in place and stable for what few equal keys there are.

    Insertion with falling gaps (Shell 1959, gaps of Ciura 2001); equal keys are told apart by id.
    """
    for gap in (701, 301, 132, 57, 23, 10, 4, 1):
        for i in range(gap, count):
            key, number = keys[i], ids[i]
            j = i
            while j >= gap and (keys[j - gap] > key or (keys[j - gap] == key and ids[j - gap] > number)):
                keys[j] = keys[j - gap]
                ids[j] = ids[j - gap]
                j -= gap
            keys[j] = key
            ids[j] = number


@lean_kernel
def cheapest_cut(ends, ids, count, c, s, widths):
    """How many of the sorted segments go to the first half: least sum of half perimeter times segments.

    ``widths`` (n,): overwritten. The surface-area heuristic (MacDonald and Booth 1990) in the plane, with
    boxes on the node's own axes.
    """
    for turn in range(2):
        u0 = v0 = math.inf
        u1 = v1 = -math.inf
        best, least = 1, math.inf
        for k in range(count - 1):
            i = ids[count - 1 - k] if turn == 0 else ids[k]
            for end in (0, 2):
                u = c * ends[i, end] + s * ends[i, end + 1]
                v = c * ends[i, end + 1] - s * ends[i, end]
                u0, u1, v0, v1 = min(u0, u), max(u1, u), min(v0, v), max(v1, v)
            width = (u1 - u0) + (v1 - v0)
            if turn == 0:
                widths[count - 1 - k] = width
            else:
                cost = width * (k + 1) + widths[k + 1] * (count - 1 - k)
                if cost < least:
                    best, least = k + 1, cost
    return best


@lean_kernel
def choose_sides(tree, node, split, too_deep, scratch):
    """Write 1 into ``sides`` for the segments of a node that go to its second half; returns their number."""
    ends, order = tree.ends, tree.order
    sides, keys, ids = scratch.sides, scratch.keys, scratch.ids
    begin, end = tree.links[node, BEGIN], tree.links[node, END]
    x, y, c, s = middle_of(tree.kind, tree.volumes, node)
    count = end - begin
    second = 0
    for k in range(count):
        i = order[begin + k]
        along = c * (0.5 * (ends[i, 0] + ends[i, 2]) - x) + s * (0.5 * (ends[i, 1] + ends[i, 3]) - y)
        keys[k] = along
        ids[k] = i
        sides[i] = 1 if along >= 0.0 else 0
        second += sides[i]
    if too_deep or second == 0 or second == count:  # clustered, or all in one place: halves by number
        for k in range(count):
            sides[order[begin + k]] = 1 if k >= count // 2 else 0
        return count - count // 2
    if split != HALF:
        sort_by_key(keys, ids, count)
        first = count // 2
        if split == PERIMETER:
            first = cheapest_cut(ends, ids, count, c, s, keys)
        for k in range(count):
            sides[ids[k]] = 1 if k >= first else 0
        return count - first
    return second


@lean_kernel(inline="always")
def part(row, begin, end, sides, shift, others):
    """Stable partition of ``row[begin:end]`` by ``sides`` of entries over 2**shift; ``others``: scratch."""
    first = begin
    later = 0
    for k in range(begin, end):
        if sides[row[k] >> shift] == 0:
            row[first] = row[k]
            first += 1
        else:
            others[later] = row[k]
            later += 1
    for k in range(later):
        row[first + k] = others[k]


@lean_kernel
def grow_tree(method, split, leaf_size, deepest, tree, points, sorted_ids, scratch, fitting):
    """Build all nodes, breadth first; returns their number.

    tree: `Nodes` with space for 2 n volumes: ends given, order (n,) permuted, the rest written. points (2 n,
    2): the ends once more, as points 2 i and 2 i + 1; sorted_ids (2 n,): sorts them by x, permuted. Nodes at
    depth ``deepest`` are halved by number. method: `Fit`, scratch: `GrowScratch`, fitting: `FitScratch`, and
    tree as plain tuples.
    """
    method, tree = Fit(*method), Nodes(*tree)
    scratch, fitting = GrowScratch(*scratch), FitScratch(*fitting)
    kind, volumes, links, sizes, ends, order = tree
    hull, sides, later = scratch.hull, scratch.sides, scratch.later
    links[0, BEGIN], links[0, END], links[0, PARENT], links[0, DEPTH] = 0, len(ends), -1, 0
    count = np.int64(1)
    node = np.int64(0)
    while node < count:
        begin, end = links[node, BEGIN], links[node, END]
        h = sorted_hull(points, sorted_ids, 2 * begin, 2 * end, hull)
        first = sorted_ids[2 * begin]
        fit_volume(method, hull, h, points[first, 0], points[first, 1], volumes, node, fitting)
        write_size(kind, volumes, node, sizes)
        if end - begin <= leaf_size:
            links[node, CHILD] = -1
        else:
            too_deep = links[node, DEPTH] >= deepest
            second = choose_sides(tree, node, split, too_deep, scratch)
            part(order, begin, end, sides, 0, later)
            part(sorted_ids, 2 * begin, 2 * end, sides, 1, later)
            links[node, CHILD] = count
            middle = end - second
            for side in range(2):
                child = count + side
                links[child, BEGIN] = begin if side == 0 else middle
                links[child, END] = middle if side == 0 else end
                links[child, PARENT] = node
                links[child, DEPTH] = links[node, DEPTH] + 1
            count += 2
        node += 1
    return count
