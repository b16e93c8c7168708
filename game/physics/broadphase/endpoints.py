"""End points of boxes along one axis, kept sorted: the work of sweep and prune.

An end point is its coordinate and a code, the box's id with one bit set if it is the upper end. End points
are ordered by coordinate, then code: at equal coordinates lower ends come before upper ones (closed boxes
that touch overlap). No two end points are equal, so there is one sorted order and one count of swaps.

A swap is an inversion of the order before, so the swaps of a step are the inversions (Kendall's tau). For
isotropic motion at speed v in a unit square their mean is 4 n^2 (8 / pi^2) v dt over both axes.
"""

from __future__ import annotations

from game.compiler.decorator import kernel
from game.physics.broadphase.validation import overlap

UPPER = 1 << 30  # bit of a code: upper end
ID = UPPER - 1

SORTED, FULL, TOO_MANY = 0, 1, 2  # how far insertion sort came
RUN = 8  # end points in a run that merge sort starts from, sorted by insertion


@kernel(inline="always", _nrt=False)
def comes_after(value, code, other_value, other_code):
    """Whether an end point stands after another one in the sorted order."""
    return value > other_value or (value == other_value and code > other_code)


@kernel(_nrt=False)
def read_axis(boxes, axis, values, codes, count):
    """Write the boxes' present coordinates over the end points, in their order of before."""
    for i in range(count):
        code = codes[i]
        values[i] = boxes[code & ID, axis + (2 if code & UPPER else 0)]


@kernel(inline="always", _nrt=False)
def pair_key(a, b):
    """Two ids, the smaller one first, in one integer: ``a << 32 | b``."""
    return (int(min(a, b)) << 32) | int(max(a, b))


@kernel(_nrt=False)
def insertion_sort(boxes, values, codes, count, start, limit, changes, changed):
    """Sort end points that are nearly in order, and note the pairs that begin and end on the way.

    A lower end that passes an upper one begins an overlap on this axis: the pair begins if the boxes overlap
    on both. An upper end that passes a lower one ends it; whether there was a pair is for the pair manager to
    know. ``values``: (>= count,) m, ``codes``: both sorted in place from ``start`` on. ``changes``:
    (capacity,) written from ``changed`` on: pair keys, complemented where a pair ends. Stops when ``changes``
    is full, or after ``limit`` swaps; calling again from where it stopped goes on. Returns (how it ended,
    where to go on, swaps, changes noted).
    """
    swaps = 0
    last = len(changes) - 1
    for i in range(start, count):
        value, code = values[i], codes[i]
        box = code & ID
        upper = code & UPPER
        x0, y0, x1, y1 = boxes[box, 0], boxes[box, 1], boxes[box, 2], boxes[box, 3]
        j = i
        while j > 0 and comes_after(values[j - 1], codes[j - 1], value, code) and changed < last:
            other = codes[j - 1] & ID
            if (codes[j - 1] & UPPER) != upper:
                key = pair_key(box, other)
                if upper:
                    changes[changed] = ~key
                    changed += 1
                else:
                    changes[changed] = key
                    changed += (
                        (boxes[other, 0] <= x1)
                        & (x0 <= boxes[other, 2])
                        & (boxes[other, 1] <= y1)
                        & (y0 <= boxes[other, 3])
                    )
            values[j] = values[j - 1]
            codes[j] = codes[j - 1]
            j -= 1
        values[j], codes[j] = value, code
        swaps += i - j
        if changed >= last:
            return FULL, j, swaps, changed
        if swaps > limit:
            return TOO_MANY, i + 1, swaps, changed
    return SORTED, count, swaps, changed


@kernel(_nrt=False)
def find_end_point(values, codes, count, value, code):
    """Index of the first end point that does not come before the one given (bisection)."""
    low, high = 0, count
    while low < high:
        middle = (low + high) // 2
        if comes_after(value, code, values[middle], codes[middle]):
            low = middle + 1
        else:
            high = middle
    return low


@kernel(_nrt=False)
def insert_runs(values, codes, count):
    """Sort every run of RUN end points by insertion; returns the inversions."""
    inversions = 0
    for begin in range(0, count, RUN):
        for i in range(begin + 1, min(begin + RUN, count)):
            value, code = values[i], codes[i]
            j = i
            while j > begin and comes_after(values[j - 1], codes[j - 1], value, code):
                values[j] = values[j - 1]
                codes[j] = codes[j - 1]
                j -= 1
            values[j], codes[j] = value, code
            inversions += i - j
    return inversions


@kernel(_nrt=False)
def merge_runs(values, codes, begin, middle, end, spare_values, spare_codes):
    """Merge two sorted neighbours in their place; returns the inversions between them.

    Of ``spare_values``, ``spare_codes`` as many are overwritten as stand before ``middle`` and must move:
    what is in order already is not touched, so runs of end points that moved a little cost little.
    """
    value, code = values[middle], codes[middle]
    if not comes_after(values[middle - 1], codes[middle - 1], value, code):
        return 0
    begin += find_end_point(values[begin:middle], codes[begin:middle], middle - begin, value, code)
    moving = middle - begin
    for i in range(moving):
        spare_values[i], spare_codes[i] = values[begin + i], codes[begin + i]
    inversions = 0
    i, j, k = 0, middle, begin
    while i < moving and j < end:
        if comes_after(spare_values[i], spare_codes[i], values[j], codes[j]):
            values[k], codes[k] = values[j], codes[j]
            inversions += moving - i
            j += 1
        else:
            values[k], codes[k] = spare_values[i], spare_codes[i]
            i += 1
        k += 1
    while i < moving:
        values[k], codes[k] = spare_values[i], spare_codes[i]
        i += 1
        k += 1
    return inversions


@kernel(_nrt=False)
def merge_sort(values, codes, count, spare_values, spare_codes):
    """Sort end points whatever their order; returns the inversions that insertion would swap.

    Costs n log n where the order is lost, and n times the logarithm of how far they moved where they moved
    a little. ``values``, ``codes``: (>= count,) sorted in place. ``spare_values``, ``spare_codes``:
    (>= count,) overwritten. Source: Knuth, TAOCP 3, 5.2.4.
    """
    inversions = insert_runs(values, codes, count)
    width = RUN
    while width < count:
        for begin in range(0, count - width, 2 * width):
            middle, end = begin + width, min(begin + 2 * width, count)
            inversions += merge_runs(values, codes, begin, middle, end, spare_values, spare_codes)
        width *= 2
    return inversions


@kernel(_nrt=False)
def shift_end_point(boxes, values, codes, count, i, value, changes, changed):
    """Give the end point at ``i`` another coordinate, m, and move it to its place.

    Notes pairs as ``insertion_sort`` does. The new coordinate must not lie beyond the box's other end as that
    stands now. ``changes`` has space for ``count`` more. Returns (swaps, changes noted).
    """
    code = codes[i]
    box = code & ID
    j = i
    while j > 0 and comes_after(values[j - 1], codes[j - 1], value, code):
        other = codes[j - 1] & ID
        if code & UPPER == 0 and codes[j - 1] & UPPER:
            changes[changed] = pair_key(box, other)
            changed += overlap(boxes, box, other)
        elif code & UPPER and codes[j - 1] & UPPER == 0:
            changes[changed] = ~pair_key(box, other)
            changed += 1
        values[j], codes[j] = values[j - 1], codes[j - 1]
        j -= 1
    while j < count - 1 and comes_after(value, code, values[j + 1], codes[j + 1]):
        other = codes[j + 1] & ID
        if code & UPPER and codes[j + 1] & UPPER == 0:
            changes[changed] = pair_key(box, other)
            changed += overlap(boxes, box, other)
        elif code & UPPER == 0 and codes[j + 1] & UPPER:
            changes[changed] = ~pair_key(box, other)
            changed += 1
        values[j], codes[j] = values[j + 1], codes[j + 1]
        j += 1
    values[j], codes[j] = value, code
    return abs(i - j), changed


@kernel(_nrt=False)
def open_gap(values, codes, count, i, value, code):
    """Insert an end point at ``i``, moving all later ones up."""
    for j in range(count, i, -1):
        values[j], codes[j] = values[j - 1], codes[j - 1]
    values[i], codes[i] = value, code


@kernel(_nrt=False)
def keep_alive(values, codes, count, alive):
    """Take out the end points of boxes that are gone, keeping the order; returns how many stay."""
    kept = 0
    for i in range(count):
        if alive[codes[i] & ID]:
            values[kept], codes[kept] = values[i], codes[i]
            kept += 1
    return kept


@kernel(_nrt=False)
def scan_end_points(boxes, codes, begin, end, last_is_upper, wanted, ids):
    """Boxes that overlap a closed one, x0 y0 x1 y1 m, among end points of one kind in a run; their number."""
    x0, y0, x1, y1 = wanted
    found = 0
    for i in range(begin, end):
        if (codes[i] & UPPER > 0) != last_is_upper:
            continue
        box = codes[i] & ID
        if boxes[box, 0] <= x1 and x0 <= boxes[box, 2] and boxes[box, 1] <= y1 and y0 <= boxes[box, 3]:
            ids[found] = box
            found += 1
    return found


@kernel(_nrt=False)
def overlaps_on_axis(codes, count):
    """Number of pairs of boxes whose intervals on this axis overlap: the tests that a sweep makes."""
    within = 0
    total = 0
    for i in range(count):
        if codes[i] & UPPER:
            within -= 1
        else:
            total += within
            within += 1
    return total


@kernel(_nrt=False)
def sweep(boxes, axis, codes, count, active, places, extents, keys):
    """All pairs by one sweep along sorted end points of ``axis`` (Shamos and Hoey 1976; Baraff 1992).

    Boxes that the sweep is within overlap on this axis, so the other one alone is tested. Their extents on it
    lie side by side, which is what the sweep's time hangs on. ``active``: (boxes,), ``places``: (capacity,)
    and ``extents``: (boxes, 2) m, overwritten. ``keys``: written, ``a << 32 | b``. Returns the number of
    pairs, or -1 if ``keys`` is too short.
    """
    within = 0
    found = 0
    for i in range(count):
        box = codes[i] & ID
        if codes[i] & UPPER:
            within -= 1
            place, last = places[box], active[within]
            active[place] = last
            places[last] = place
            extents[place, 0], extents[place, 1] = extents[within, 0], extents[within, 1]
            continue
        if found + within >= len(keys):
            return -1
        low, high = boxes[box, 1 - axis], boxes[box, 3 - axis]
        for k in range(within):
            if (extents[k, 0] <= high) & (low <= extents[k, 1]):
                keys[found] = pair_key(box, active[k])
                found += 1
        active[within] = box
        places[box] = within
        extents[within, 0], extents[within, 1] = low, high
        within += 1
    return found
