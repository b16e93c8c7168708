"""How a BSP tree adjusts itself: leaves are split and merged, and what leans is cut anew once that pays.

A subtree that has become uneven costs a little more in every step. That is written down as its debt. That is
done only when the debt exceeds what cutting the subtree anew would cost. So a tree in unrest is not torn up
all the time, and most of it stays as it is.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from game.compiler.decorator import inner_kernel, kernel
from game.physics.broadphase.bsp import nodes
from game.physics.broadphase.bsp.nodes import collapse, split, walk
from game.physics.kernels import elementary

FULL_LEAF = 10  # references; a leaf with more is split
FEW = 5  # references of two leaves that are merged
EVEN = 0.65  # the share of the larger side up to which a node owes nothing
USEFUL = 0.8  # of a leaf's references the larger side of a cut has at most, or the cut is not made
GROWN = 1.5  # a leaf that could not be cut is tried again when it has grown by that


@inner_kernel
def middle_of(low, high):
    """The middle of an extent, of which either end may be infinite."""
    if low == -np.inf:
        return high if high < np.inf else 0.0
    return low + 0.5 * (high - low) if high < np.inf else low


@inner_kernel
def select(values, count, rank):
    """The value with ``rank`` values before it in order; values (>= count,) are reordered (Hoare 1961)."""
    low, high = 0, count - 1
    while low < high:
        pivot = values[(low + high) // 2]
        i, j = low, high
        while i <= j:
            while values[i] < pivot:
                i += 1
            while values[j] > pivot:
                j -= 1
            if i <= j:
                values[i], values[j] = values[j], values[i]
                i += 1
                j -= 1
        if rank <= j:
            high = j
        elif rank >= i:
            low = i
        else:
            break
    return values[rank]


@inner_kernel
def best_cut(tree, boxes, leaf, scratch):
    """Axis and place of the cut through the middle box that leaves least; LEAF if none is worth it."""
    count = tree.nodes[leaf, nodes.COUNT]
    best, best_axis, best_cut = np.inf, nodes.LEAF, 0.0
    for axis in range(2):
        size, ref = 0, tree.nodes[leaf, nodes.HEAD]
        while ref >= 0:
            box = tree.refs[ref, nodes.BOX]
            scratch[size] = middle_of(boxes[box, axis], boxes[box, axis + 2])
            size += 1
            ref = tree.refs[ref, nodes.NEXT]
        cut = select(scratch, size, size // 2)
        left, right, ref = 0, 0, tree.nodes[leaf, nodes.HEAD]
        while ref >= 0:
            box = tree.refs[ref, nodes.BOX]
            left += boxes[box, axis] < cut
            right += boxes[box, axis + 2] >= cut
            ref = tree.refs[ref, nodes.NEXT]
        cost = 1.0 * (left + right) + abs(left - right)
        if cost < best and max(left, right) <= USEFUL * count:
            best, best_axis, best_cut = cost, axis, cut
    return best_axis, best_cut


@inner_kernel
def split_below(tree, boxes, node, stack, scratch):
    """Split a leaf, and the parts it falls into, as long as they are too full; False if space ran out."""
    height = 1
    stack[0] = node
    while height > 0:
        height -= 1
        leaf = stack[height]
        count = tree.nodes[leaf, nodes.COUNT]
        if count <= FULL_LEAF or count <= GROWN * tree.nodes[leaf, nodes.STUBBORN]:
            continue
        axis, cut = best_cut(tree, boxes, leaf, scratch)
        if axis == nodes.LEAF:
            tree.nodes[leaf, nodes.STUBBORN] = count
            continue
        if (
            len(tree.refs) - tree.numbers[nodes.REFS] < count
            or len(tree.nodes) - tree.numbers[nodes.NODES] < 2
        ):
            return False
        split(tree, boxes, leaf, axis, cut)
        tree.numbers[nodes.SPLITS] += 1
        stack[height], stack[height + 1] = tree.nodes[leaf, nodes.LEFT], tree.nodes[leaf, nodes.RIGHT]
        height += 2
    return True


@inner_kernel
def _owes(tree, node, total, larger, price):
    """Add to a node's debt; whether it has become larger than what cutting anew costs.

    ``price``: of that, for each reference and level, in references that are too many.
    """
    too_many = larger - EVEN * total
    if total <= 2 * FULL_LEAF or too_many <= 0.0:
        tree.cuts[node, nodes.DEBT] = 0.0
        return False
    tree.cuts[node, nodes.DEBT] += too_many
    return tree.cuts[node, nodes.DEBT] > price * total * elementary.log2(1.0 * total)


@inner_kernel
def _cut_anew(tree, boxes, node, stack, scratch, ids):
    """Collapse a node and split it afresh; the old cuts bind its boxes no more. False if space ran out."""
    collapse(tree, node, stack)
    count, ref = 0, tree.nodes[node, nodes.HEAD]
    while ref >= 0:
        ids[count] = tree.refs[ref, nodes.BOX]
        count += 1
        ref = tree.refs[ref, nodes.NEXT]
    tree.numbers[nodes.MOVED] += count
    done = split_below(tree, boxes, node, stack, scratch)
    for i in range(count):
        walk(tree, boxes, ids[i], stack, False, True)
    return done


@kernel(_nrt=False)
def adjust(tree: Any, boxes, stack, scratch, ids, price):
    """Split what is too full, merge what is nearly empty, cut anew what has owed too much.

    ``price``: of cutting anew, see `_owes`. ``stack``: (3, DEEPEST), ``scratch`` and ``ids``: (capacity,) to
    work in. False if space ran out: with more of it, calling again goes on.
    """
    way, begun = stack[0], stack[1]
    height = 1
    way[0], begun[0] = 0, 0
    while height > 0:
        node = way[height - 1]
        if tree.nodes[node, nodes.AXIS] == nodes.LEAF:
            height -= 1
            if not split_below(tree, boxes, node, stack[2], scratch):
                return False
            tree.nodes[node, nodes.TOTAL] = tree.nodes[node, nodes.COUNT]
            if tree.nodes[node, nodes.AXIS] != nodes.LEAF:
                tree.nodes[node, nodes.TOTAL] = (
                    tree.nodes[tree.nodes[node, nodes.LEFT], nodes.COUNT]
                    + tree.nodes[tree.nodes[node, nodes.RIGHT], nodes.COUNT]
                )
            continue
        if begun[height - 1] == 0:
            begun[height - 1] = 1
            for side in (nodes.LEFT, nodes.RIGHT):
                way[height], begun[height] = tree.nodes[node, side], 0
                height += 1
            continue
        height -= 1
        left, right = tree.nodes[node, nodes.LEFT], tree.nodes[node, nodes.RIGHT]
        total = tree.nodes[left, nodes.TOTAL] + tree.nodes[right, nodes.TOTAL]
        tree.nodes[node, nodes.TOTAL] = total
        leaves = tree.nodes[left, nodes.AXIS] == nodes.LEAF and tree.nodes[right, nodes.AXIS] == nodes.LEAF
        if leaves and total <= FEW:
            collapse(tree, node, stack[2])
            tree.numbers[nodes.MERGES] += 1
            tree.nodes[node, nodes.TOTAL] = tree.nodes[node, nodes.COUNT]
            continue
        owing = _owes(
            tree, node, total, max(tree.nodes[left, nodes.TOTAL], tree.nodes[right, nodes.TOTAL]), price
        )
        if owing and not _cut_anew(tree, boxes, node, stack[2], scratch, ids):
            return False
    return True
