"""Search for pairs in the sorted boxes of hashed levels: within a level, and between two.

Within a level a box looks at half of its neighbourhood, as in a uniform grid. Between two levels, either
each finer box looks up the few coarse cells around it, or, where that is cheaper, each coarse box runs over
the fine rows that it covers. Each pair is found once.
"""

from __future__ import annotations

import math

from game.physics.broadphase.grid_search import ID_MASK, Sorted, name_pairs
from game.physics.broadphase.hash_levels import (
    COUNT,
    LEVELS,
    MASK,
    TOP,
    Ladder,
    Placed,
    bucket_of,
    cell_at,
    place_boxes,
    sort_by_bucket,
    table_of,
)
from game.physics.broadphase.validation import Store
from game.physics.kernels.jit import kernel

# Costs of looking between levels, measured, in tests: a run of fine cells, a look at the coarse cells around.
RUN_COST, LOOK_COST = 6, 16


@kernel(_nrt=False)
def search_level(ordered, start, table, keys, found, tests):
    """All pairs within one level, as `grid_search.search_near`: the same half of the neighbourhood.

    Adds pairs of places to ``keys`` from ``found`` on; returns how many there are then, or -1 if ``keys``
    is too short. ``tests``: (1,) added to.
    """
    order, sorted_boxes = ordered
    offset, mask, factor, _ = table
    tested = 0
    for place in range(int(start[offset]), int(start[offset + mask + 1])):
        x0 = sorted_boxes[place, 0]
        y0 = sorted_boxes[place, 1]
        x1 = sorted_boxes[place, 2]
        y1 = sorted_boxes[place, 3]
        bucket = (order[place] >> 32) & ID_MASK
        end = int(start[bucket + 2])
        above = (offset + ((bucket - offset + factor - 1) & mask)) & ID_MASK
        first = int(start[above])
        last = int(start[above + 3])
        tested += end - place - 1 + last - first
        if found + end - place + last - first + 4 > len(keys):
            return -1
        tag = place << 32
        other = (place + 1) & ID_MASK
        keys[found] = tag | other
        found += (
            (other < end)
            & (sorted_boxes[other, 0] <= x1)
            & (x0 <= sorted_boxes[other, 2])
            & (sorted_boxes[other, 1] <= y1)
            & (y0 <= sorted_boxes[other, 3])
        )
        for candidate in range(place + 2, end):
            other = candidate & ID_MASK
            keys[found] = tag | other
            found += (
                (sorted_boxes[other, 0] <= x1)
                & (x0 <= sorted_boxes[other, 2])
                & (sorted_boxes[other, 1] <= y1)
                & (y0 <= sorted_boxes[other, 3])
            )
        for step in range(2):
            other = (first + step) & ID_MASK
            keys[found] = tag | other
            found += (
                (other < last)
                & (sorted_boxes[other, 0] <= x1)
                & (x0 <= sorted_boxes[other, 2])
                & (sorted_boxes[other, 1] <= y1)
                & (y0 <= sorted_boxes[other, 3])
            )
        for candidate in range(first + 2, last):
            other = candidate & ID_MASK
            keys[found] = tag | other
            found += (
                (sorted_boxes[other, 0] <= x1)
                & (x0 <= sorted_boxes[other, 2])
                & (sorted_boxes[other, 1] <= y1)
                & (y0 <= sorted_boxes[other, 3])
            )
    tests[0] += tested
    return found


@kernel(_nrt=False)
def look_up(sorted_boxes, start, fine, coarse, keys, found, tests):
    """All pairs of two levels' tables: each finer box looks up the coarse cells that may hold a partner.

    Those are the cells it touches and the ones before them, 3 x 3 at most. As ``search_level`` else.
    """
    scale = coarse.scale
    tested = 0
    for place in range(int(start[fine.offset]), int(start[fine.offset + fine.mask + 1])):
        x0 = sorted_boxes[place, 0]
        y0 = sorted_boxes[place, 1]
        x1 = sorted_boxes[place, 2]
        y1 = sorted_boxes[place, 3]
        before = cell_at(x0, scale) - 1
        run = cell_at(x1, scale) - before + 1
        tag = place << 32
        for row in range(cell_at(y0, scale) - 1, cell_at(y1, scale) + 1):
            bucket = coarse.offset + bucket_of(before, row, coarse.mask, coarse.factor)
            first, last = int(start[bucket]), int(start[bucket + run])
            tested += last - first
            if found + last - first + 1 > len(keys):
                return -1
            for candidate in range(first, last):
                other = candidate & ID_MASK
                keys[found] = tag | other
                found += (
                    (sorted_boxes[other, 0] <= x1)
                    & (x0 <= sorted_boxes[other, 2])
                    & (sorted_boxes[other, 1] <= y1)
                    & (y0 <= sorted_boxes[other, 3])
                )
    tests[0] += tested
    return found


@kernel(_nrt=False)
def rows_share_buckets(table, run, rows):
    """Whether among so many rows of ``run`` cells, one above the other, two have a bucket in common."""
    size = table.mask + 1
    shift = 0
    for _ in range(1, rows):
        shift = (shift + table.factor) & table.mask
        if shift < run or size - shift < run:
            return True
    return False


@kernel(_nrt=False)
def run_over(sorted_boxes, start, fine, coarse, keys, found, tests):
    """All pairs of two levels' tables: each coarse box runs over the rows of finer cells around it.

    Where rows of one box share buckets, which is rare, the row of each box that is hit is compared. A row
    is shorter than the table, or the caller would have chosen ``look_up``. As ``search_level`` else.
    """
    offset, mask, factor, scale = fine
    tested = 0
    size = mask + 1
    for place in range(int(start[coarse.offset]), int(start[coarse.offset + coarse.mask + 1])):
        x0 = sorted_boxes[place, 0]
        y0 = sorted_boxes[place, 1]
        x1 = sorted_boxes[place, 2]
        y1 = sorted_boxes[place, 3]
        before = cell_at(x0, scale) - 1
        run = cell_at(x1, scale) - before + 1
        below, above = cell_at(y0, scale) - 1, cell_at(y1, scale)
        shared = rows_share_buckets(fine, run, above - below + 1)
        tag = place << 32
        for row in range(below, above + 1):
            bucket = bucket_of(before, row, mask, factor)
            left = run
            while left > 0:
                part = min(left, size - bucket)
                first, last = int(start[offset + bucket]), int(start[offset + bucket + part])
                tested += last - first
                if found + last - first + 1 > len(keys):
                    return -1
                hits = found
                for candidate in range(first, last):
                    other = candidate & ID_MASK
                    keys[hits] = tag | other
                    hits += (
                        (sorted_boxes[other, 0] <= x1)
                        & (x0 <= sorted_boxes[other, 2])
                        & (sorted_boxes[other, 1] <= y1)
                        & (y0 <= sorted_boxes[other, 3])
                    )
                found = of_row(sorted_boxes, keys, found, hits, row, scale) if shared else hits
                left -= part
                bucket = 0
    tests[0] += tested
    return found


@kernel(_nrt=False)
def of_row(sorted_boxes, keys, found, hits, row, scale):
    """Of the hits from ``found`` on, keep those whose lower corner lies in a row of cells; their end."""
    for hit in range(found, hits):
        keys[found] = keys[hit]
        found += cell_at(sorted_boxes[keys[hit] & ID_MASK, 1], scale) == row
    return found


@kernel(_nrt=False)
def runs_over(layout, fine, coarse):
    """Whether the boxes of a coarse level run over the cells of a fine one, as that is cheaper than that the
    fine boxes look up the coarse cells. ``layout``: of the tables, with counts and masks.
    """
    across = math.ldexp(1.0, coarse - fine) + 2.0
    looking = LOOK_COST * float(layout[fine, COUNT])
    load = layout[fine, COUNT] / (layout[fine, MASK] + 1.0)
    running = layout[coarse, COUNT] * across * (RUN_COST + across * load)
    return coarse < TOP and across < layout[fine, MASK] and running < looking


@kernel(_nrt=False)
def find_pairs(store, ladder, placed, ordered, keys, tests):
    """All overlapping pairs of ids as keys, unsorted; returns their number.

    ``store``, ``ladder``, ``placed``, ``ordered``: in plain tuples. ``tests``: (1,) box tests, written.
    Returns -1 if ``keys`` is too short, -2 if the layout does not fit.
    """
    store, ladder, placed, ordered = Store(*store), Ladder(*ladder), Placed(*placed), Sorted(*ordered)
    if not place_boxes(store, ladder, placed):
        return -2
    sort_by_bucket(store, placed, ordered)
    layout, start = placed.layout, placed.start
    found = 0
    tests[0] = 0
    for fine in range(LEVELS):
        if layout[fine, COUNT] == 0:
            continue
        finer = table_of(layout, ladder.scales, fine)
        found = search_level(ordered, start, finer, keys, found, tests)
        if found < 0:
            return -1
        for coarse in range(fine + 1, LEVELS):
            if layout[coarse, COUNT] == 0:
                continue
            coarser = table_of(layout, ladder.scales, coarse)
            if runs_over(layout, fine, coarse):
                found = run_over(ordered.boxes, start, finer, coarser, keys, found, tests)
            else:
                found = look_up(ordered.boxes, start, finer, coarser, keys, found, tests)
            if found < 0:
                return -1
    if found > 0:
        name_pairs(keys, found, ordered.order)
    return found
