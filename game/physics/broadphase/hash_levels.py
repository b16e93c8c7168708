"""Levels of a hierarchical grid: which level a box stands on, and the hash tables that hold the cells.

Cells of level k are 2^(k - 32) m wide. A box stands on the finest level whose cells are not smaller than
itself, in the cell of its lower corner. One of size 2^k exactly stands on the level of that cell size. A box
reaches no further than into the next cell. What is larger than 2^30 m, floors without end among it, stands on
a last level that is one cell.

The hash ``(column + P row) mod size`` keeps a row's neighbours neighbours: three cells side by side are
three buckets in a run, read like a row of a dense grid. P is next to the golden section of the size, so
that rows spread evenly over the table (Knuth, TAOCP 3, 6.4, theorem S), and it is 3 mod 8. Then, with at
least 16 buckets, those of any 3 x 3 neighbouring cells are distinct: P is in 3 .. size - 5, and 2 P mod
size in 6 .. size - 10. So boxes of other cells that share a bucket cost a test, but no pair is met twice,
and no cell has to be compared.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.compiler.decorator import kernel
from game.physics.broadphase.runs import FOUR, HALF, ONE, UNSIGNED, copy_boxes

LEVELS = 64
TOP = LEVELS - 1  # the level that is one cell
LOWEST = -32  # cells of level 0 are 2^-32 m wide
FARTHEST = 2.0**62  # cells; coordinates beyond are clamped, which keeps their order
LEAST_SIZE = 16  # buckets
SPREAD = 2  # buckets a box, at least, when all boxes are sorted
LIST_SPREAD = 2  # and in the tables of lists, which are added to
GOLDEN = 0.6180339887498949
GUARD = 2  # buckets after the last, copies of the first: a run of three never wraps
# Columns of a layout: where a level's table begins, its size - 1, its boxes, and the factor of its hash.
OFFSET, MASK, COUNT, FACTOR = 0, 1, 2, 3


class Ladder(NamedTuple):
    """Which levels there are: every ``step``-th one, and ``scales`` (64,): cells per m, 0 for the last."""

    step: int
    scales: NDArray[np.float64]


class Placed(NamedTuple):
    """Where boxes stand. ``levels``, ``buckets``: (capacity,) of each; ``ranks``: (capacity,) how many of its
    bucket have smaller ids; ``layout``: (64, 4) of the tables; ``start``: (all buckets,) boxes per bucket,
    and once they are sorted the first place of each.
    """

    levels: NDArray[np.int8]
    layout: NDArray[np.int64]
    buckets: NDArray[np.int32]
    ranks: NDArray[np.int32]
    start: NDArray[np.int32]


class Table(NamedTuple):
    """Where a level's table begins, its size - 1, the factor of its hash, and its cells per m."""

    offset: int
    mask: int
    factor: int
    scale: float


@kernel(inline="always", _nrt=False)
def table_of(layout, scales, level):
    """The table of a level."""
    row = layout[level]
    return Table(row[OFFSET], row[MASK], row[FACTOR], scales[level])


@kernel(inline="always", _nrt=False)
def cell_at(x, scale):
    """Column (or row) of a coordinate, m, at ``scale`` cells per m; 0 on the level of one cell."""
    return math.floor(min(max(float(x) * float(scale), -FARTHEST), FARTHEST)) if scale > 0.0 else 0


@kernel(inline="always", _nrt=False)
def bucket_of(column, row, mask, factor):
    """Bucket of a cell in a table of ``mask`` + 1 buckets; any 64 bit column and row."""
    return (int(column) + int(row) * int(factor)) & int(mask)


@kernel(_nrt=False)
def reaches_next(x0, y0, x1, y1, scale):
    """Whether a box, m, reaches no further than into the next column and row, at ``scale`` cells per m."""
    return cell_at(x1, scale) - cell_at(x0, scale) <= 1 and cell_at(y1, scale) - cell_at(y0, scale) <= 1


@kernel(_nrt=False)
def level_of(x0, y0, x1, y1, step, scales):
    """Level of a box, m: the finest whose cells hold it, among every ``step``-th one.

    The size is rounded, the cells of the corners are not: so these have the last word.
    """
    size = max(float(x1) - float(x0), float(y1) - float(y0))
    if not size < math.inf:
        return TOP
    level = 0
    if size > 0.0:
        mantissa, exponent = math.frexp(size)
        level = max((exponent - 1 if mantissa == 0.5 else exponent) - LOWEST, 0)
        level += (-level) % step
    while level < TOP and not reaches_next(x0, y0, x1, y1, scales[level]):
        level += step
    return min(level, TOP)


@kernel(_nrt=False)
def find_levels(store, ladder, levels, layout):
    """Write every box's level, -1 for ids not in use, and the number of boxes of each into ``layout``.

    ``store``, ``ladder``: a `Store` and a `Ladder`, or plain tuples of the same form.
    """
    boxes, alive, top = store
    step, scales = ladder
    for level in range(LEVELS):
        layout[level, COUNT] = 0
    for box in range(top):
        if alive[box]:
            level = level_of(boxes[box, 0], boxes[box, 1], boxes[box, 2], boxes[box, 3], step, scales)
            levels[box] = level
            layout[level, COUNT] += 1
        else:
            levels[box] = -1


@kernel(_nrt=False)
def lay_out(layout, spread):
    """Give each level that has boxes a table of ``spread`` buckets a box or more; returns all buckets.

    ``layout``: (64, 4), counts read, the rest written. A level without boxes has mask -1.
    """
    total = 0
    for level in range(LEVELS):
        layout[level, OFFSET] = total
        layout[level, MASK] = -1
        if layout[level, COUNT] > 0:
            size = LEAST_SIZE
            while size < spread * layout[level, COUNT]:
                size *= 2
            layout[level, MASK] = size - 1
            layout[level, FACTOR] = (int(size * GOLDEN) & ~7) + 3
            total += size + GUARD + 1
    return total


@kernel(_nrt=False)
def place_boxes(store, ladder, placed):
    """Find every box's level and bucket, and count the boxes of each.

    ``store``, ``ladder``, ``placed``: a `Store`, a `Ladder` and a `Placed`, or plain tuples of the same form.
    Of the last, levels are read as a first guess, for few boxes change size, and written, -1 for ids not in
    use. Written are the layout's counts, buckets, ranks, and boxes per bucket. Returns False if a level has
    no table, or one that is much too small or large now: then only levels and counts are right.

    Cells are powers of two wide. So corners in cells are exact, and a box whose rounded size is below a cell
    reaches no further than into the next one: the cells of the upper corner are asked for at one cell alone.
    """
    boxes, alive, top = store
    step, scales = ladder
    levels, layout, buckets, ranks, start = placed
    corners = boxes.reshape(-1)
    for level in range(LEVELS):
        layout[level, COUNT] = 0
    for bucket in range(len(start)):
        start[bucket] = 0
    smallest = math.ldexp(1.0, -step)
    fits = True
    last, table = 0, table_of(layout, scales, 0)  # of the box before: most stand on the same level
    for i in range(top):
        box = UNSIGNED(i)
        if alive[box] == 0:
            levels[box] = -1
            continue
        x0, y0 = corners[FOUR * box], corners[FOUR * box + ONE]
        x1, y1 = corners[FOUR * box + UNSIGNED(2)], corners[FOUR * box + UNSIGNED(3)]
        level = max(int(levels[box]), 0)
        if level != last:
            last, table = level, table_of(layout, scales, level)
        share = max(x1 - x0, y1 - y0) * table.scale if table.scale > 0.0 else 0.0
        if not smallest < share < 1.0 and not (share == 1.0 and reaches_next(x0, y0, x1, y1, table.scale)):
            level = int(level_of(x0, y0, x1, y1, step, scales))
            last, table = level, table_of(layout, scales, level)
        levels[box] = level
        layout[level, COUNT] += 1
        if table.mask < 0:
            fits = False
        else:
            column, row = cell_at(x0, table.scale), cell_at(y0, table.scale)
            own = UNSIGNED(table.offset + bucket_of(column, row, table.mask, table.factor))
            buckets[box] = own
            rank = start[own]
            ranks[box] = rank
            start[own] = rank + 1
    for level in range(LEVELS):
        count = layout[level, COUNT]
        size = layout[level, MASK] + 1
        if size < SPREAD * count or size > max(8 * SPREAD * count, LEAST_SIZE):
            fits = False
    return fits


@kernel(_nrt=False)
def sort_by_bucket(store, placed, ordered):
    """Counting sort of the boxes by level and bucket; within a bucket by id.

    The boxes per bucket become the first place of each, and with a box's rank there that is its own place: so
    nothing is counted twice. ``ordered``: `Sorted` with twice the capacity, written. After a level's boxes
    come copies of those in its first two buckets.
    """
    boxes, _, top = store
    levels, layout, buckets, ranks, start = placed
    order = ordered.order
    total = 0
    for level in range(LEVELS):
        if layout[level, COUNT] == 0:
            continue
        first = layout[level, OFFSET]
        after = first + layout[level, MASK] + 1
        copies = start[first], start[first + 1]
        for bucket in range(UNSIGNED(first), UNSIGNED(after)):
            here = start[bucket]
            start[bucket] = total
            total += here
        start[after] = total
        start[after + 1] = total + copies[0]
        total += copies[0] + copies[1]
        start[after + 2] = total
    for i in range(top):
        box = UNSIGNED(i)
        if levels[box] >= 0:
            own = UNSIGNED(buckets[box])
            order[UNSIGNED(start[own] + ranks[box])] = (own << HALF) | box
    for level in range(LEVELS):
        if layout[level, COUNT] > 0:
            after = layout[level, OFFSET] + layout[level, MASK] + 1
            for i in range(start[after + 2] - start[after]):
                order[start[after] + i] = order[start[layout[level, OFFSET]] + i]
    copy_boxes(boxes, ordered, total)
