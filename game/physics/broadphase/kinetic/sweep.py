"""The order of bounds along an axis, kept from step to step, and the candidates: pairs whose bounds overlap.

The order is by lower end, in lanes: by width, so that one wide bound does not make all searches long, and
by strips across the axis. Bounds that begin anew are taken out and merged in again; only they are swept
against the others. A candidate stays until one of its two bounds is replaced; in each step only candidates
are tested.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.compiler.decorator import inner_kernel, kernel
from game.physics.broadphase.kinetic import bounds as bo
from game.physics.broadphase.kinetic.bounds import apart_along, strip_of
from game.physics.broadphase.ordering import LOW_HALF

MOST_KEY = 1 << 62
FROM, TO, LOW, HIGH = range(4)  # rows of the order's extents: along the axis, and across it


class Order(NamedTuple):
    """The bounds in order, all written: lane by lane, by lower end in each; a lane is a strip of a level."""

    ids: NDArray[np.int64]  # (capacity,)
    ends: NDArray[np.float64]  # (4, capacity) m
    begins: NDArray[np.int64]  # (LEVELS * MOST_STRIPS + 1,)
    widest: NDArray[np.float64]  # (LEVELS * MOST_STRIPS,) m, of a lane
    tallest: NDArray[np.float64]  # (LEVELS,) m, of a level


@kernel(_nrt=False)
def merge_order(bounds: Any, order: Any, events, axis, strips, merged: Any):
    """Merge boxes with new bounds, sorted by lane and lower end, into the order, without their old places.

    ``merged``: the order after it, written. Returns how many stand in it.
    """
    marks, spans, lanes = bounds.marks, bounds.spans, bounds.lanes
    froms, tos, lows, highs = order.ends[FROM], order.ends[TO], order.ends[LOW], order.ends[HIGH]
    new_froms, new_tos = merged.ends[FROM], merged.ends[TO]
    new_lows, new_highs = merged.ends[LOW], merged.ends[HIGH]
    placed, come, old = 0, 0, 0
    for level in range(bo.LEVELS):
        tall = 0.0
        for lane in range(level * strips, (level + 1) * strips):
            end, wide = order.begins[lane + 1], 0.0
            merged.begins[lane] = placed
            while True:
                more = come < len(events) and lanes[events[come]] == lane
                least = spans[events[come], axis] if more else np.inf
                while old < end and (froms[old] <= least or not more):
                    box = order.ids[old]
                    if marks[box, bo.WHY] == bo.HELD:
                        merged.ids[placed] = box
                        new_froms[placed], new_tos[placed] = froms[old], tos[old]
                        new_lows[placed], new_highs[placed] = lows[old], highs[old]
                        wide = max(wide, tos[old] - froms[old])
                        tall = max(tall, highs[old] - lows[old])
                        placed += 1
                    old += 1
                if not more:
                    break
                box = events[come]
                merged.ids[placed] = box
                new_froms[placed], new_tos[placed] = spans[box, axis], spans[box, axis + 2]
                new_lows[placed], new_highs[placed] = spans[box, 1 - axis], spans[box, 3 - axis]
                wide = max(wide, spans[box, axis + 2] - spans[box, axis])
                tall = max(tall, spans[box, 3 - axis] - spans[box, 1 - axis])
                placed += 1
                come += 1
            merged.widest[lane] = wide
        merged.tallest[level] = tall
    merged.begins[bo.LEVELS * strips] = placed
    return placed


@inner_kernel
def _first_from(values, begin, end, least):
    """The first place of sorted values that is not below ``least``."""
    while begin < end:
        middle = (begin + end) // 2
        if values[middle] < least:
            begin = middle + 1
        else:
            end = middle
    return begin


@inner_kernel
def _apart(bounds, a, b, directions):
    """Whether the slab across the motion of either box parts their bounds."""
    mine, other = bounds.aligned[a], bounds.aligned[b]
    apart = False
    if mine != bo.NOBODY:
        apart = apart_along(bounds, a, b, directions[mine, 0], directions[mine, 1])
    if not apart and other != bo.NOBODY and other != mine:
        apart = apart_along(bounds, a, b, directions[other, 0], directions[other, 1])
    return apart


@inner_kernel
def _near(bounds, order, begin, lane, box, axis, near, count):
    """Write the places in a lane, from ``begin`` on, of bounds that overlap a box's.

    ``near``: places, of which ``count`` are written. Returns how many are then, and the tests.
    """
    spans, end, froms = bounds.spans, order.begins[lane + 1], order.ends[FROM]
    left, right, low, high = (
        spans[box, axis],
        spans[box, axis + 2],
        spans[box, 1 - axis],
        spans[box, 3 - axis],
    )
    tos, lows, highs = order.ends[TO], order.ends[LOW], order.ends[HIGH]
    place = begin
    while place < end and froms[place] <= right:
        near[count] = place
        count += (tos[place] >= left) & (lows[place] <= high) & (highs[place] >= low)
        place += 1
    return count, place - begin


@inner_kernel
def _near_in_level(bounds, order, level, first_strip, last_strip, box, scales, near, count):
    """``_near``, in some strips of a level, as far as bounds there can reach the box's."""
    axis, strips, tests = int(scales[bo.AXIS]), int(scales[bo.STRIPS]), 0
    for lane in range(level * strips + first_strip, level * strips + last_strip + 1):
        if order.begins[lane] < order.begins[lane + 1]:
            least = bounds.spans[box, axis] - order.widest[lane]
            begin = _first_from(order.ends[FROM], order.begins[lane], order.begins[lane + 1], least)
            count, more = _near(bounds, order, begin, lane, box, axis, near, count)
            tests += more
    return count, tests


@inner_kernel
def _keep_near(bounds, order, near, count, box, everything, directions, keys, found):
    """Write keys of those near whose slabs do not part them; of two new ones the smaller id finds the pair.

    ``everything``: all are taken. The caller has seen that ``keys`` has space for all.
    """
    for i in range(count):
        other = order.ids[near[i]]
        if not (everything or bounds.marks[other, bo.WHY] == bo.HELD or box < other):
            continue
        if not _apart(bounds, box, other, directions):
            keys[found] = (min(box, other) << 32) | max(box, other)
            found += 1
    return found


@kernel(_nrt=False)
def sweep_events(bounds: Any, order: Any, events, scales, directions, keys, near):
    """Find the candidates of boxes with new bounds: keys a << 32 | b. Returns number and tests, or -1."""
    found, tests, strips = 0, 0, int(scales[bo.STRIPS])
    low, high = 1 - int(scales[bo.AXIS]), 3 - int(scales[bo.AXIS])
    for box in events:
        count = 0
        last = strip_of(bounds.spans[box, high], scales)
        for level in range(bo.LEVELS):
            if order.begins[level * strips] < order.begins[(level + 1) * strips]:
                first = strip_of(bounds.spans[box, low] - order.tallest[level], scales)
                count, more = _near_in_level(bounds, order, level, first, last, box, scales, near, count)
                tests += more
        if found + count > len(keys):
            return -1, tests
        found = _keep_near(bounds, order, near, count, box, False, directions, keys, found)
    return found, tests


@kernel(_nrt=False)
def sweep_all(bounds: Any, order: Any, scales, directions, keys, near):
    """Find all candidates, each once: to the right in its lane, in strips above, and in all wider levels."""
    found, tests = 0, 0
    axis, strips = int(scales[bo.AXIS]), int(scales[bo.STRIPS])
    for lane in range(bo.LEVELS * strips):
        for place in range(order.begins[lane], order.begins[lane + 1]):
            box = order.ids[place]
            last = strip_of(bounds.spans[box, 3 - axis], scales)
            count, more = _near(bounds, order, place + 1, lane, box, axis, near, 0)
            tests += more
            for level in range(lane // strips, bo.LEVELS):
                if order.begins[level * strips] < order.begins[(level + 1) * strips]:
                    first = lane % strips + 1
                    if level > lane // strips:
                        first = strip_of(bounds.spans[box, 1 - axis] - order.tallest[level], scales)
                    count, more = _near_in_level(bounds, order, level, first, last, box, scales, near, count)
                    tests += more
            if found + count > len(keys):
                return -1, tests
            found = _keep_near(bounds, order, near, count, box, True, directions, keys, found)
    return found, tests


@inner_kernel
def meet(boxes, a, b):
    """Whether two boxes overlap, without a jump."""
    return (
        (boxes[a, 0] <= boxes[b, 2]) & (boxes[b, 0] <= boxes[a, 2])
        & (boxes[a, 1] <= boxes[b, 3]) & (boxes[b, 1] <= boxes[a, 3])
    )  # fmt: skip


@kernel(_nrt=False)
def keep_candidates(marks, boxes, keys, count, come, kept, pairs):
    """Drop candidates whose bounds are new, merge those in that come, and test all on the boxes themselves.

    ``keys``: (>= count,) sorted, and ``come``: (m, 2) sorted pairs. ``kept``: (>= count + m,) the sorted keys
    that stay and ``pairs``: (>= count + m, 2) those that overlap, both written. Returns the numbers of both.
    """
    old, stay, found = 0, 0, 0
    for new in range(len(come) + 1):
        arriving = MOST_KEY if new == len(come) else (come[new, 0] << 32) | come[new, 1]
        while old < count and keys[old] < arriving:
            key = keys[old]
            a, b = key >> 32, key & LOW_HALF
            old += 1
            if (marks[a, bo.WHY] | marks[b, bo.WHY]) == bo.HELD:
                kept[stay] = key
                stay += 1
                pairs[found, 0], pairs[found, 1] = a, b
                found += meet(boxes, a, b)
        if new < len(come):
            a, b = come[new, 0], come[new, 1]
            kept[stay] = arriving
            stay += 1
            pairs[found, 0], pairs[found, 1] = a, b
            found += meet(boxes, a, b)
    return stay, found
