"""The nodes of a semi-adjusting BSP tree: boxes put in and taken out, leaves split, subtrees collapsed.

Lines parallel to the axes cut the plane; a leaf refers to every box that reaches into its part. A box of
lower corner x0 and upper corner x1 lies left of a cut c if x0 < c, and right of it if x1 >= c, or both. For
each corner is kept between which cuts it may move before the box reaches other leaves: a box that stays
within needs nothing to be done.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.compiler.decorator import inner_kernel, kernel

NOBODY = -1
# Columns of a node. A leaf has AXIS = LEAF; a node that is not in use FREE, and the next free one in LEFT.
AXIS, LEFT, RIGHT, PARENT, HEAD, COUNT, STUBBORN, TOTAL = range(8)
LEAF, FREE = -1, -2
CUT, DEBT = range(2)
# Columns of a reference of a leaf to a box; one that is not in use has the next free one in NEXT.
BOX, OWNER, NEXT, BEFORE, ALSO = range(5)
# What is counted, and where the free ones begin.
NODES, FREE_NODE, REFS, FREE_REF, STAMP, REPAIRS, SPLITS, MERGES, MOVED, TESTS = range(10)
NUMBERS = 10
DEEPEST = 512  # entries of a stack of nodes


class Tree(NamedTuple):
    """The arrays of a tree, all written."""

    nodes: NDArray[np.int32]  # (m, 8)
    cuts: NDArray[np.float64]  # (m, 2) coordinate of the cut, m, and the debt of an inner node
    refs: NDArray[np.int32]  # (r, 5)
    first: NDArray[np.int32]  # (capacity,) the first reference to a box
    safe: NDArray[np.float64]  # (capacity, 8) for x0, y0, x1, y1: at least, and below
    stamps: NDArray[np.int64]  # (capacity,)
    numbers: NDArray[np.int64]  # (NUMBERS,)


@inner_kernel
def new_node(tree, parent):
    """An empty leaf; there must be space."""
    numbers = tree.numbers
    node = numbers[FREE_NODE]
    if node >= 0:
        numbers[FREE_NODE] = tree.nodes[node, LEFT]
    else:
        node = numbers[NODES]
        numbers[NODES] += 1
    row = tree.nodes[node]
    row[AXIS], row[LEFT], row[RIGHT], row[PARENT] = LEAF, NOBODY, NOBODY, parent
    row[HEAD], row[COUNT], row[STUBBORN], row[TOTAL] = NOBODY, 0, 0, 0
    tree.cuts[node, DEBT] = 0.0
    return node


@inner_kernel
def refer(tree, leaf, box):
    """Let a leaf refer to a box; there must be space."""
    numbers, refs = tree.numbers, tree.refs
    ref = numbers[FREE_REF]
    if ref >= 0:
        numbers[FREE_REF] = refs[ref, NEXT]
    else:
        ref = numbers[REFS]
        numbers[REFS] += 1
    refs[ref, BOX], refs[ref, ALSO] = box, tree.first[box]
    tree.first[box] = ref
    hang(tree, leaf, ref)


@inner_kernel
def hang(tree, leaf, ref):
    """Put a reference into the list of a leaf."""
    head = tree.nodes[leaf, HEAD]
    tree.refs[ref, OWNER], tree.refs[ref, NEXT], tree.refs[ref, BEFORE] = leaf, head, NOBODY
    if head >= 0:
        tree.refs[head, BEFORE] = ref
    tree.nodes[leaf, HEAD] = ref
    tree.nodes[leaf, COUNT] += 1


@inner_kernel
def unhang(tree, ref):
    """Take a reference out of the list of its leaf."""
    leaf, after, before = tree.refs[ref, OWNER], tree.refs[ref, NEXT], tree.refs[ref, BEFORE]
    if before >= 0:
        tree.refs[before, NEXT] = after
    else:
        tree.nodes[leaf, HEAD] = after
    if after >= 0:
        tree.refs[after, BEFORE] = before
    tree.nodes[leaf, COUNT] -= 1


@inner_kernel
def drop(tree, ref):
    """Give a reference back that is in no leaf's list any more: out of its box's list, to the free ones."""
    box = tree.refs[ref, BOX]
    at = tree.first[box]
    if at == ref:
        tree.first[box] = tree.refs[ref, ALSO]
    else:
        while tree.refs[at, ALSO] != ref:
            at = tree.refs[at, ALSO]
        tree.refs[at, ALSO] = tree.refs[ref, ALSO]
    tree.refs[ref, NEXT] = tree.numbers[FREE_REF]
    tree.numbers[FREE_REF] = ref


@inner_kernel
def narrow(safe, box, corners, axis, cut):
    """Keep that the corners of a box lie as they do beside a cut."""
    for end in range(2):
        place = axis + 2 * end
        if cut <= corners[box, place]:
            safe[box, 2 * place] = max(safe[box, 2 * place], cut)
        else:
            safe[box, 2 * place + 1] = min(safe[box, 2 * place + 1], cut)


@inner_kernel
def forget_safe(safe, box):
    """Before any cut is known the corners may be anywhere."""
    for place in range(4):
        safe[box, 2 * place], safe[box, 2 * place + 1] = -np.inf, np.inf


@inner_kernel
def is_safe(safe, box, corners):
    """Whether all corners of a box still lie between the same cuts."""
    inside = True
    for place in range(4):
        value = corners[box, place]
        inside &= (safe[box, 2 * place] <= value) & (value < safe[box, 2 * place + 1])
    return inside


@inner_kernel
def walk(tree, boxes, box, stack, put, note):
    """Go to all leaves that a box reaches, from the root; returns their number.

    ``put``: let them refer to it. ``note``: keep between which cuts its corners lie.
    """
    if note:
        forget_safe(tree.safe, box)
    found, height = 0, 1
    stack[0] = 0
    while height > 0:
        height -= 1
        node = stack[height]
        axis = tree.nodes[node, AXIS]
        if axis == LEAF:
            found += 1
            if put:
                refer(tree, node, box)
            continue
        cut = tree.cuts[node, CUT]
        if note:
            narrow(tree.safe, box, boxes, axis, cut)
        if boxes[box, axis] < cut:
            stack[height] = tree.nodes[node, LEFT]
            height += 1
        if boxes[box, axis + 2] >= cut:
            stack[height] = tree.nodes[node, RIGHT]
            height += 1
    return found


@inner_kernel
def take_out(tree, box):
    """Let no leaf refer to a box."""
    while tree.first[box] >= 0:
        ref = tree.first[box]
        unhang(tree, ref)
        drop(tree, ref)


@kernel(_nrt=False)
def put_boxes(tree: Any, boxes, ids, done, stack, moved):
    """Put boxes in, from the ``done``-th of ``ids`` on; returns how many are in, fewer if space ran out.

    ``moved``: they are in the tree already, and only those that reach other leaves are taken out and put in.
    ``stack``: (DEEPEST,) to work in.
    """
    for i in range(done, len(ids)):
        box = ids[i]
        if moved and is_safe(tree.safe, box, boxes):
            continue
        needed = walk(tree, boxes, box, stack, False, False)
        if len(tree.refs) - tree.numbers[REFS] < needed:
            return i
        if moved:
            take_out(tree, box)
            tree.numbers[REPAIRS] += 1
        walk(tree, boxes, box, stack, True, True)
    return len(ids)


@kernel(_nrt=False)
def put_in_order(tree: Any, refs, stack):
    """Copy all references to ``refs`` (r, 5), leaf by leaf, so that each leaf's lie side by side."""
    placed, height = 0, 1
    stack[0] = 0
    for box in range(len(tree.first)):
        tree.first[box] = NOBODY
    while height > 0:
        height -= 1
        node = stack[height]
        if tree.nodes[node, AXIS] != LEAF:
            stack[height], stack[height + 1] = tree.nodes[node, RIGHT], tree.nodes[node, LEFT]
            height += 2
            continue
        ref, before = tree.nodes[node, HEAD], NOBODY
        if ref >= 0:
            tree.nodes[node, HEAD] = placed
        while ref >= 0:
            box, after = tree.refs[ref, BOX], tree.refs[ref, NEXT]
            refs[placed, BOX], refs[placed, OWNER], refs[placed, BEFORE] = box, node, before
            refs[placed, NEXT] = placed + 1 if after >= 0 else NOBODY
            refs[placed, ALSO] = tree.first[box]
            tree.first[box] = placed
            ref, before = after, placed
            placed += 1
    tree.numbers[REFS], tree.numbers[FREE_REF] = placed, NOBODY


@kernel(_nrt=False)
def take_boxes(tree: Any, ids):
    """Take boxes out."""
    for box in ids:
        take_out(tree, box)


@inner_kernel
def collapse(tree, node, stack):
    """Make a leaf of a node, which refers to all boxes below it once; its nodes below become free."""
    tree.numbers[STAMP] += 1
    stamp = tree.numbers[STAMP]
    left, right = tree.nodes[node, LEFT], tree.nodes[node, RIGHT]
    row = tree.nodes[node]
    row[AXIS], row[LEFT], row[RIGHT] = LEAF, NOBODY, NOBODY
    row[HEAD], row[COUNT], row[STUBBORN] = NOBODY, 0, 0
    tree.cuts[node, DEBT] = 0.0
    stack[0], stack[1] = left, right
    height = 2
    while height > 0:
        height -= 1
        below = stack[height]
        if tree.nodes[below, AXIS] != LEAF:
            stack[height], stack[height + 1] = tree.nodes[below, LEFT], tree.nodes[below, RIGHT]
            height += 2
        else:
            ref = tree.nodes[below, HEAD]
            while ref >= 0:
                after = tree.refs[ref, NEXT]
                box = tree.refs[ref, BOX]
                if tree.stamps[box] == stamp:
                    drop(tree, ref)
                else:
                    tree.stamps[box] = stamp
                    hang(tree, node, ref)
                ref = after
        tree.nodes[below, AXIS] = FREE
        tree.nodes[below, LEFT] = tree.numbers[FREE_NODE]
        tree.numbers[FREE_NODE] = below


@inner_kernel
def split(tree, boxes, leaf, axis, cut):
    """Cut a leaf in two; there must be space for two nodes and as many references as it has."""
    left, right = new_node(tree, leaf), new_node(tree, leaf)
    ref = tree.nodes[leaf, HEAD]
    tree.nodes[leaf, AXIS], tree.nodes[leaf, LEFT], tree.nodes[leaf, RIGHT] = axis, left, right
    tree.nodes[leaf, HEAD], tree.nodes[leaf, COUNT] = NOBODY, 0
    tree.cuts[leaf, CUT], tree.cuts[leaf, DEBT] = cut, 0.0
    while ref >= 0:
        after = tree.refs[ref, NEXT]
        box = tree.refs[ref, BOX]
        narrow(tree.safe, box, boxes, axis, cut)
        if boxes[box, axis] < cut:
            hang(tree, left, ref)
            if boxes[box, axis + 2] >= cut:
                refer(tree, right, box)
        else:
            hang(tree, right, ref)
        ref = after
