"""Runs of boxes side by side: how sorted boxes that may overlap become pairs.

In sorted boxes a box's candidates stand in a few runs of consecutive places, most of them short or empty. A
loop over each run ends at a turn that a processor cannot foresee, which costs it as much as several tests. So
the first SHORT places of a run are noted without asking how many there are. The next run is noted over those
that there were not, and one loop tests everything noted. Only what is left of a longer run is tested by a
loop of its own. No test branches either: a pair is kept by adding 0 or 1 to their number.

Places and numbers are unsigned here, as for signed ones numba asks at each access whether they count from
the end.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.compiler.decorator import inner_kernel

SHORT = 4  # places of a run that are noted, whether there are so many or not
MANY = 2048  # noted places that are tested together: they stay in the L1 cache
ROOM = MANY + 8 * SHORT  # more runs than that must not be noted at once
ID_MASK = 0x7FFFFFFF
SIGNED, UNSIGNED = np.int64, np.uint64
HALF, LOW = np.uint64(32), np.uint64(ID_MASK)
NONE, ONE, FOUR = np.uint64(0), np.uint64(1), np.uint64(4)


class Sorted(NamedTuple):
    """Boxes sorted by cell (or bucket): where each came from, and the boxes themselves.

    ``order``: (places,) ``cell << 32 | id``. ``boxes``: (places, 4) m. In a hash table both have space for
    copies. ``noted``: (ROOM,) pairs of places that are to be tested.
    """

    order: NDArray[np.int64]
    boxes: Floats
    noted: NDArray[np.int64]


@inner_kernel
def copy_boxes(boxes, ordered, count):
    """Copy boxes (capacity, 4) m into their order."""
    corners, copies = boxes.reshape(-1), ordered.boxes.reshape(-1)
    for i in range(count):
        place = UNSIGNED(i)
        box = UNSIGNED(ordered.order[place]) & LOW
        for side in range(4):
            copies[FOUR * place + UNSIGNED(side)] = corners[FOUR * box + UNSIGNED(side)]


@inner_kernel(forceinline=True)
def note_run(noted, count, place, first, last):
    """Note a box's first candidates of a run of places; returns how many are noted then.

    ``noted``: `Sorted.noted`, written from ``count`` on. All numbers are unsigned, and ``first`` is not
    above ``last``.
    """
    key = (place << HALF) | first
    for i in range(SHORT):
        noted[count + UNSIGNED(i)] = key + UNSIGNED(i)
    return count + min(last - first, UNSIGNED(SHORT))


@inner_kernel
def test_noted(ordered, count, keys, found):
    """Add those of the first ``count`` noted pairs of places that overlap to ``keys``, from ``found`` on.

    ``p << 32 | q`` each. Returns how many there are then, or -1 if ``keys`` is too short.
    """
    if found + SIGNED(count) > len(keys):
        return -1
    boxes = ordered.boxes.reshape(-1)
    at = UNSIGNED(found)
    for i in range(count):
        key = UNSIGNED(ordered.noted[i])
        a, b = FOUR * (key >> HALF), FOUR * (key & LOW)
        keys[at] = key
        at += UNSIGNED(
            (boxes[b] <= boxes[a + UNSIGNED(2)])
            & (boxes[a] <= boxes[b + UNSIGNED(2)])
            & (boxes[b + ONE] <= boxes[a + UNSIGNED(3)])
            & (boxes[a + ONE] <= boxes[b + UNSIGNED(3)])
        )
    return SIGNED(at)


@inner_kernel
def test_run(ordered, place, first, last, keys, found):
    """Add the pairs of a box with a run of places to ``keys``, as `test_noted`."""
    if found + SIGNED(last - first) > len(keys):
        return -1
    boxes = ordered.boxes.reshape(-1)
    a = FOUR * place
    x0, y0, x1, y1 = boxes[a], boxes[a + ONE], boxes[a + UNSIGNED(2)], boxes[a + UNSIGNED(3)]
    at = UNSIGNED(found)
    for other in range(first, last):
        b = FOUR * UNSIGNED(other)
        keys[at] = (place << HALF) | UNSIGNED(other)
        at += UNSIGNED(
            (boxes[b] <= x1)
            & (x0 <= boxes[b + UNSIGNED(2)])
            & (boxes[b + ONE] <= y1)
            & (y0 <= boxes[b + UNSIGNED(3)])
        )
    return SIGNED(at)


@inner_kernel
def test_rest(ordered, place, first, last, keys, found):
    """Add the pairs of a box with what `note_run` leaves of a run; a negative ``found`` stays as it is."""
    if found < 0 or last - first <= UNSIGNED(SHORT):
        return found
    return test_run(ordered, place, first + UNSIGNED(SHORT), last, keys, found)


@inner_kernel
def name_pairs(keys, count, order):
    """Turn pairs of places into pairs of ids, the smaller first: ``a << 32 | b``. ``keys``: written."""
    for i in range(count):
        key = UNSIGNED(keys[i])
        a, b = order[key >> HALF] & ID_MASK, order[key & LOW] & ID_MASK
        keys[i] = (min(a, b) << 32) | max(a, b)
