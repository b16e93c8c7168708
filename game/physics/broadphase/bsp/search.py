"""What a BSP tree is asked: all overlapping pairs, and the boxes that overlap a box."""

from __future__ import annotations

from typing import Any

import numpy as np

from game.compiler.decorator import inner_kernel, kernel
from game.physics.broadphase.bsp import nodes

SORTED = 24  # boxes of a leaf from which on they are sorted by x before they are compared


@inner_kernel
def _gather(tree, boxes, leaf, ids, near):
    """The boxes of a leaf side by side: ids (>= count,), corners (4, >= count); sorted by x0 if many."""
    count, ref = 0, tree.nodes[leaf, nodes.HEAD]
    while ref >= 0:
        ids[count] = tree.refs[ref, nodes.BOX]
        count += 1
        ref = tree.refs[ref, nodes.NEXT]
    if count > SORTED:
        _sort_by_left(boxes, ids, count)
    for i in range(count):
        for place in range(4):
            near[place, i] = boxes[ids[i], place]
    return count


@inner_kernel
def _sort_by_left(boxes, ids, count):
    """Heap sort of ids by the left end of their boxes (Williams 1964)."""
    for end in range(2 * count - 1, 0, -1):
        # the first half of the turns makes the heap, the second takes its top away
        root = end - count if end >= count else 0
        size = count if end >= count else end
        if end < count:
            ids[0], ids[end] = ids[end], ids[0]
        while True:
            child = 2 * root + 1
            if child >= size:
                break
            if child + 1 < size and boxes[ids[child], 0] < boxes[ids[child + 1], 0]:
                child += 1
            if boxes[ids[root], 0] >= boxes[ids[child], 0]:
                break
            ids[root], ids[child] = ids[child], ids[root]
            root = child


@inner_kernel
def _end_of_row(lefts, right, begin, count):
    """Where the boxes end that begin left of ``right``; all of them where there are too few to be sorted."""
    if count <= SORTED:
        return count
    low, high = begin, count
    while low < high:
        middle = (low + high) // 2
        if lefts[middle] <= right:
            low = middle + 1
        else:
            high = middle
    return low


@kernel(_nrt=False)
def find_pairs(tree: Any, boxes, keys, stack, parts, ids, near):
    """Write a key a << 32 | b (a < b) for each pair; returns their number, or -1 if ``keys`` is too short.

    A pair that meets in several leaves counts in the one that holds the lower corner of what both cover.
    ``stack``: (DEEPEST,), ``parts``: (DEEPEST, 4), ``ids``: (capacity,), ``near``: (4, capacity), to work in.
    """
    found, tests, height = 0, 0, 1
    lefts, lows, rights, highs = near[0], near[1], near[2], near[3]
    stack[0] = 0
    parts[0, 0], parts[0, 1], parts[0, 2], parts[0, 3] = -np.inf, -np.inf, np.inf, np.inf
    while height > 0:
        height -= 1
        node = stack[height]
        x0, y0, x1, y1 = parts[height, 0], parts[height, 1], parts[height, 2], parts[height, 3]
        axis = tree.nodes[node, nodes.AXIS]
        if axis != nodes.LEAF:
            cut = tree.cuts[node, nodes.CUT]
            for side in range(2):
                stack[height] = tree.nodes[node, nodes.LEFT if side == 0 else nodes.RIGHT]
                parts[height, 0], parts[height, 1] = x0, y0
                parts[height, 2], parts[height, 3] = x1, y1
                parts[height, axis + 2 if side == 0 else axis] = cut
                height += 1
            continue
        count = _gather(tree, boxes, node, ids, near)
        for i in range(count):
            if found + count > len(keys):
                return -1
            end = _end_of_row(lefts, rights[i], i + 1, count)
            tests += end - i - 1
            left, low, right, high = lefts[i], lows[i], rights[i], highs[i]
            a = ids[i]
            for j in range(i + 1, end):  # a key is always written and seldom kept: no branch to foretell
                b = ids[j]
                meet = (lefts[j] <= right) & (left <= rights[j]) & (lows[j] <= high) & (low <= highs[j])
                # the greater of two is within a part if both are below its end and one not below its begin
                here = (left < x1) & (lefts[j] < x1) & ((x0 <= left) | (x0 <= lefts[j]))
                here &= (low < y1) & (lows[j] < y1) & ((y0 <= low) | (y0 <= lows[j]))
                keys[found] = (min(a, b) << 32) | max(a, b)
                found += meet & here
    tree.numbers[nodes.TESTS] = tests
    return found


@kernel(_nrt=False)
def find_in_box(tree: Any, boxes, wanted, stack, ids):
    """Find the boxes that overlap a box (x0, y0, x1, y1); returns their number. ``ids``: written."""
    tree.numbers[nodes.STAMP] += 1
    stamp = tree.numbers[nodes.STAMP]
    found, height = 0, 1
    stack[0] = 0
    while height > 0:
        height -= 1
        node = stack[height]
        axis = tree.nodes[node, nodes.AXIS]
        if axis != nodes.LEAF:
            if wanted[axis] < tree.cuts[node, nodes.CUT]:
                stack[height] = tree.nodes[node, nodes.LEFT]
                height += 1
            if wanted[axis + 2] >= tree.cuts[node, nodes.CUT]:
                stack[height] = tree.nodes[node, nodes.RIGHT]
                height += 1
            continue
        ref = tree.nodes[node, nodes.HEAD]
        while ref >= 0:
            box = tree.refs[ref, nodes.BOX]
            if (
                tree.stamps[box] != stamp
                and boxes[box, 0] <= wanted[2]
                and wanted[0] <= boxes[box, 2]
                and boxes[box, 1] <= wanted[3]
                and wanted[1] <= boxes[box, 3]
            ):
                tree.stamps[box] = stamp
                ids[found] = box
                found += 1
            ref = tree.refs[ref, nodes.NEXT]
    return found
