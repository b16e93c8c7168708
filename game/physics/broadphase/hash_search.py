"""Search for pairs in the sorted boxes of hashed levels: within a level, and between two.

Within a level a box looks at half of its neighbourhood, as in a uniform grid. Between two levels, either
each finer box looks up the few coarse cells around it, or, where that is cheaper, each coarse box runs over
the fine rows that it covers. Each pair is found once.
"""

from __future__ import annotations

from game.physics.broadphase.grid_search import ID_MASK, name_pairs
from game.physics.broadphase.hash_levels import (
    COUNT,
    FACTOR,
    LEVELS,
    MASK,
    OFFSET,
    TOP,
    bucket_of,
    cell_at,
    place_boxes,
    sort_by_bucket,
)
from game.physics.kernels.jit import kernel

# Costs of looking between levels, measured, in tests: a run of fine cells, a look at the coarse cells around.
RUN_COST, LOOK_COST = 6, 16


@kernel(_nrt=False)
def search_level(sorted_boxes, order, start, offset, mask, factor, keys, found, tests):
    """All pairs within one level, as `grid_search.search_near`: the same half of the neighbourhood.

    Adds pairs of places to ``keys`` from ``found`` on; returns how many there are then, or -1 if ``keys``
    is too short. ``tests``: (1,) added to.
    """
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
def look_up(sorted_boxes, start, fine_begin, fine_end, offset, mask, factor, scale, keys, found, tests):
    """All pairs of two levels: each finer box looks up the coarse cells that may hold a partner.

    Those are the cells it touches and the ones before them, 3 x 3 at most. As ``search_level`` else.
    """
    tested = 0
    for place in range(fine_begin, fine_end):
        x0 = sorted_boxes[place, 0]
        y0 = sorted_boxes[place, 1]
        x1 = sorted_boxes[place, 2]
        y1 = sorted_boxes[place, 3]
        before = cell_at(x0, scale) - 1
        run = cell_at(x1, scale) - before + 1
        tag = place << 32
        for row in range(cell_at(y0, scale) - 1, cell_at(y1, scale) + 1):
            bucket = offset + bucket_of(before, row, mask, factor)
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
def run_over(sorted_boxes, start, coarse_begin, coarse_end, offset, mask, factor, scale, keys, found, tests):
    """All pairs of two levels: each coarse box runs over the rows of finer cells that may hold a partner.

    Rows may share buckets here, so the row of a box that is hit is compared. A row is shorter than the
    table, or the caller would have chosen ``look_up``. As ``search_level`` else.
    """
    tested = 0
    size = mask + 1
    for place in range(coarse_begin, coarse_end):
        x0 = sorted_boxes[place, 0]
        y0 = sorted_boxes[place, 1]
        x1 = sorted_boxes[place, 2]
        y1 = sorted_boxes[place, 3]
        before = cell_at(x0, scale) - 1
        run = cell_at(x1, scale) - before + 1
        tag = place << 32
        for row in range(cell_at(y0, scale) - 1, cell_at(y1, scale) + 1):
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
                for hit in range(found, hits):
                    keys[found] = keys[hit]
                    found += cell_at(sorted_boxes[keys[hit] & ID_MASK, 1], scale) == row
                left -= part
                bucket = 0
    tests[0] += tested
    return found


@kernel(_nrt=False)
def runs_over(layout, fine, coarse):
    """Whether the boxes of a coarse level run over the cells of a fine one, as that is cheaper than that the
    fine boxes look up the coarse cells. ``layout``: of the tables, with counts and masks.
    """
    across = 2.0 ** (coarse - fine) + 2.0
    looking = LOOK_COST * float(layout[fine, COUNT])
    load = layout[fine, COUNT] / (layout[fine, MASK] + 1.0)
    running = layout[coarse, COUNT] * across * (RUN_COST + across * load)
    return coarse < TOP and across < layout[fine, MASK] and running < looking


@kernel(_nrt=False)
def find_pairs(
    boxes, alive, top, step, scales, levels, layout, buckets, start, order, sorted_boxes, keys, tests
):
    """All overlapping pairs of ids as keys, unsorted; returns their number.

    ``tests``: (1,) box tests, written. Returns -1 if ``keys`` is too short, -2 if ``layout`` does not fit.
    """
    if not place_boxes(boxes, alive, top, step, scales, levels, layout, buckets, start):
        return -2
    sort_by_bucket(boxes, top, levels, layout, buckets, start, order, sorted_boxes)
    found = 0
    tests[0] = 0
    for fine in range(LEVELS):
        fine_count = layout[fine, COUNT]
        if fine_count == 0:
            continue
        fine_offset, fine_mask, fine_factor = layout[fine, OFFSET], layout[fine, MASK], layout[fine, FACTOR]
        found = search_level(
            sorted_boxes, order, start, fine_offset, fine_mask, fine_factor, keys, found, tests
        )
        if found < 0:
            return -1
        for coarse in range(fine + 1, LEVELS):
            if layout[coarse, COUNT] == 0:
                continue
            offset, mask = layout[coarse, OFFSET], layout[coarse, MASK]
            if runs_over(layout, fine, coarse):
                found = run_over(
                    sorted_boxes, start, start[offset], start[offset + mask + 1],
                    fine_offset, fine_mask, fine_factor, scales[fine], keys, found, tests,
                )  # fmt: skip
            else:
                found = look_up(
                    sorted_boxes, start, start[fine_offset], start[fine_offset + fine_mask + 1],
                    offset, mask, layout[coarse, FACTOR], scales[coarse], keys, found, tests,
                )  # fmt: skip
            if found < 0:
                return -1
    if found > 0:
        name_pairs(keys, found, order)
    return found
