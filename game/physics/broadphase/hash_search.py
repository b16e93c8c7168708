"""Search for pairs in the sorted boxes of hashed levels: within a level, and between two.

Within a level a box looks at half of its neighbourhood, as in a uniform grid. Between two levels, either each
finer box looks up the few coarse cells around it. Or, where that is cheaper, each coarse box runs over the
fine rows that it covers. Each pair is found once.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, kernel
from game.physics.broadphase import hash_levels
from game.physics.broadphase.hash_levels import (
    Ladder,
    Placed,
    bucket_of,
    cell_at,
    place_boxes,
    sort_by_bucket,
    table_of,
)
from game.physics.broadphase.runs import (
    ID_MASK,
    MANY,
    NONE,
    ONE,
    SHORT,
    SIGNED,
    UNSIGNED,
    Sorted,
    name_pairs,
    note_run,
    test_noted,
    test_rest,
    test_run,
)
from game.physics.broadphase.validation import Store

# Costs of looking between levels, measured, in tests: a run of fine cells, a look at the coarse cells around.
RUN_COST, LOOK_COST = 6, 16


@inner_kernel
def search_level(ordered, start, table, keys, found, tests):
    """All pairs within one level, as `grid_search.search_near`: the same half of the neighbourhood.

    Adds pairs of places to ``keys`` from ``found`` on; returns how many there are then, or -1 if ``keys``
    is too short. ``tests``: (1,) added to.
    """
    order, noted = ordered.order, ordered.noted
    offset, mask, factor, _ = table
    tested = NONE
    many = NONE
    for box in range(int(start[offset]), int(start[offset + mask + 1])):
        place = UNSIGNED(box)
        bucket = order[place] >> 32
        above = UNSIGNED(offset + ((bucket - offset + factor - 1) & mask))
        own, end = place + ONE, UNSIGNED(start[UNSIGNED(bucket + 2)])
        first, last = UNSIGNED(start[above]), UNSIGNED(start[above + UNSIGNED(3)])
        tested += end - own + last - first
        many = note_run(noted, many, place, own, end)
        many = note_run(noted, many, place, first, last)
        if max(end - own, last - first) > UNSIGNED(SHORT):
            found = test_rest(ordered, place, own, end, keys, found)
            found = test_rest(ordered, place, first, last, keys, found)
            if found < 0:
                return -1
        if many > UNSIGNED(MANY):
            found = test_noted(ordered, many, keys, found)
            if found < 0:
                return -1
            many = NONE
    tests[0] += SIGNED(tested)
    return test_noted(ordered, many, keys, found)


@inner_kernel
def look_up(ordered, start, fine, coarse, keys, found, tests):
    """All pairs of two levels' tables: each finer box looks up the coarse cells that may hold a partner.

    Those are the cells it touches and the ones before them, 3 x 3 at most. As `search_level` else.
    """
    boxes, noted = ordered.boxes, ordered.noted
    scale = coarse.scale
    tested = NONE
    many = NONE
    for box in range(int(start[fine.offset]), int(start[fine.offset + fine.mask + 1])):
        place = UNSIGNED(box)
        before = cell_at(boxes[place, 0], scale) - 1
        run = cell_at(boxes[place, 2], scale) - before + 1
        for row in range(cell_at(boxes[place, 1], scale) - 1, cell_at(boxes[place, 3], scale) + 1):
            bucket = coarse.offset + bucket_of(before, row, coarse.mask, coarse.factor)
            first, last = UNSIGNED(start[UNSIGNED(bucket)]), UNSIGNED(start[UNSIGNED(bucket + run)])
            tested += last - first
            many = note_run(noted, many, place, first, last)
            found = test_rest(ordered, place, first, last, keys, found)
        if found < 0:
            return -1
        if many > UNSIGNED(MANY):
            found = test_noted(ordered, many, keys, found)
            if found < 0:
                return -1
            many = NONE
    tests[0] += SIGNED(tested)
    return test_noted(ordered, many, keys, found)


@inner_kernel
def rows_share_buckets(table, run, rows):
    """Whether among so many rows of ``run`` cells, one above the other, two have a bucket in common."""
    size = table.mask + 1
    shift = 0
    for _ in range(1, rows):
        shift = (shift + table.factor) & table.mask
        if shift < run or size - shift < run:
            return True
    return False


@inner_kernel
def run_over(ordered, start, fine, coarse, keys, found, tests):
    """All pairs of two levels' tables: each coarse box runs over the rows of finer cells around it.

    Where rows of one box share buckets, which is rare, the row of each box that is hit is compared. A row
    is shorter than the table, or the caller would have chosen `look_up`. As `search_level` else.
    """
    boxes, noted = ordered.boxes, ordered.noted
    offset, mask, factor, scale = fine
    tested = NONE
    many = NONE
    size = mask + 1
    for box in range(int(start[coarse.offset]), int(start[coarse.offset + coarse.mask + 1])):
        place = UNSIGNED(box)
        before = cell_at(boxes[place, 0], scale) - 1
        run = cell_at(boxes[place, 2], scale) - before + 1
        below, above = cell_at(boxes[place, 1], scale) - 1, cell_at(boxes[place, 3], scale)
        shared = rows_share_buckets(fine, run, above - below + 1)
        for row in range(below, above + 1):
            bucket = bucket_of(before, row, mask, factor)
            left = run
            while left > 0:
                part = min(left, size - bucket)
                first = UNSIGNED(start[UNSIGNED(offset + bucket)])
                last = UNSIGNED(start[UNSIGNED(offset + bucket + part)])
                tested += last - first
                if shared:
                    hits = test_run(ordered, place, first, last, keys, found)
                    found = of_row(boxes, keys, found, hits, row, scale)
                    first = last
                while first < last:  # mostly two or three times SHORT
                    many = note_run(noted, many, place, first, last)
                    first += UNSIGNED(SHORT)
                    if many > UNSIGNED(MANY):
                        found = test_noted(ordered, many, keys, found)
                        many = NONE
                if found < 0:
                    return -1
                left -= part
                bucket = 0
    tests[0] += SIGNED(tested)
    return test_noted(ordered, many, keys, found)


@inner_kernel
def of_row(boxes, keys, found, hits, row, scale):
    """Of the hits from ``found`` on, keep those whose lower corner lies in a row of cells.

    Their end, or -1 if there was no space for the hits.
    """
    if hits < 0:
        return -1
    for hit in range(found, hits):
        keys[found] = keys[hit]
        found += cell_at(boxes[keys[hit] & ID_MASK, 1], scale) == row
    return found


@kernel(_nrt=False)
def runs_over(layout, fine, coarse):
    """Whether the boxes of a coarse level run over the cells of a fine one. Else the fine boxes look up the
    coarse cells, where that is cheaper. ``layout``: of the tables, with counts and masks.
    """
    across = math.ldexp(1.0, coarse - fine) + 2.0
    looking = LOOK_COST * float(layout[fine, hash_levels.COUNT])
    load = layout[fine, hash_levels.COUNT] / (layout[fine, hash_levels.MASK] + 1.0)
    running = layout[coarse, hash_levels.COUNT] * across * (RUN_COST + across * load)
    return coarse < hash_levels.TOP and across < layout[fine, hash_levels.MASK] and running < looking


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
    for fine in range(hash_levels.LEVELS):
        if layout[fine, hash_levels.COUNT] == 0:
            continue
        finer = table_of(layout, ladder.scales, fine)
        found = search_level(ordered, start, finer, keys, found, tests)
        if found < 0:
            return -1
        for coarse in range(fine + 1, hash_levels.LEVELS):
            if layout[coarse, hash_levels.COUNT] == 0:
                continue
            coarser = table_of(layout, ladder.scales, coarse)
            if runs_over(layout, fine, coarse):
                found = run_over(ordered, start, finer, coarser, keys, found, tests)
            else:
                found = look_up(ordered, start, finer, coarser, keys, found, tests)
            if found < 0:
                return -1
    name_pairs(keys, found, ordered.order)
    return found
