"""Sorting of pairs: by first id, then by second, in time proportional to their number.

A pair of ids below 2^31 is one integer, ``a << 32 | b``. Most boxes have few partners. So such keys are
sorted by their first id alone, in one pass (distribution counting: Knuth, The Art of Computer Programming 3,
5.2, algorithm D), and then each by straight insertion (5.2.1), which has only the few pairs of one box to put
right. A pass of exchanges of neighbours before it, which takes no branch, leaves it hardly any.

That would be long where some boxes have many partners or ids are sparse. There keys are sorted digit by digit
from the least one up (radix sort: 5.2.5), which does not care how many partners one box has.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from game.compiler.decorator import kernel
from game.physics.kernels.limits import LimitError

LOW_HALF = 0x7FFFFFFF  # the second id of a key
MAX_PAIRS = 1 << 26  # of one answer: keys and spare take 1 GB then
MOST_MOVES = 4  # of a key by insertion, in the mean: with more the radix sort is faster
MOST_IDS = 4  # for a pair: counting more of them costs more than the radix sort
PATIENCE = 32  # sorts by digits before it is tried again whether few have many partners now
WHOLE_DIGIT = 12  # bits; ids of more bits are sorted in two digits, so that the counters stay in the L1 cache


@kernel(_nrt=False)
def sort_pairs(keys, count, spare, counters, bits, pairs):
    """Sort pair keys and write them as rows of two ids.

    ``keys``, ``spare``: (>= count,) int64, overwritten. ``counters``: (4, >= 2^digit) int64, overwritten.
    ``bits``: bits of the greatest id. ``pairs``: (count, 2) int64, written, sorted.
    """
    digit = bits if bits <= WHOLE_DIGIT else (bits + 1) // 2
    size = 1 << digit
    mask = size - 1
    for place in range(4):
        if bits > WHOLE_DIGIT or place % 2 == 0:
            for i in range(size):
                counters[place, i] = 0
    if bits <= WHOLE_DIGIT:
        for i in range(count):
            key = keys[i]
            counters[0, key & mask] += 1
            counters[2, (key >> 32) & mask] += 1
    else:
        for i in range(count):
            key = keys[i]
            counters[0, key & mask] += 1
            counters[1, ((key & LOW_HALF) >> digit) & mask] += 1
            counters[2, (key >> 32) & mask] += 1
            counters[3, (key >> (32 + digit)) & mask] += 1
    source = keys
    target = spare
    for place in range(4):
        if bits <= WHOLE_DIGIT and (place == 1 or place == 3):
            continue
        total = 0
        for i in range(size):
            here = counters[place, i]
            counters[place, i] = total
            total += here
        shift = (place & 1) * digit + (place >> 1) * 32
        for i in range(count):
            key = source[i]
            value = (((key & LOW_HALF) if place < 2 else key) >> shift) & mask
            position = counters[place, value]
            counters[place, value] = position + 1
            target[position] = key
        source, target = target, source
    for i in range(count):
        key = source[i]
        pairs[i, 0] = key >> 32
        pairs[i, 1] = key & LOW_HALF


@kernel(_nrt=False)
def sort_by_first(keys, count, spare, places, pairs):
    """As `sort_pairs`, by first ids and insertion; False, and only counted, if some have many partners.

    ``keys``, ``spare``: (>= count,) int64, the second overwritten. ``places``: (greatest id + 1,) int32,
    overwritten. ``pairs``: (count, 2) int64, written, sorted.
    """
    for i in range(len(places)):
        places[i] = 0
    for i in range(count):
        places[keys[i] >> 32] += 1
    total = 0
    squares = 0
    for i in range(len(places)):
        here = int(places[i])
        squares += here * here
        total += here
        places[i] = total
    if squares - count > 4 * MOST_MOVES * count:  # k in any order take k (k - 1) / 4 moves in the mean
        return False
    for i in range(count - 1, -1, -1):
        key = keys[i]
        place = places[key >> 32] - 1
        places[key >> 32] = place
        spare[place] = key
    for i in range(1, count):
        before, key = spare[i - 1], spare[i]
        spare[i - 1] = min(before, key)
        spare[i] = max(before, key)
    for i in range(1, count):
        key = spare[i]
        if key < spare[i - 1]:
            place = i
            while place > 0 and spare[place - 1] > key:
                spare[place] = spare[place - 1]
                place -= 1
            spare[place] = key
    for i in range(count):
        pairs[i, 0] = spare[i] >> 32
        pairs[i, 1] = spare[i] & LOW_HALF
    return True


class PairSorter:
    """Sorts keys of pairs, keeping its buffers from one time to the next. ``most``: pairs it has space for.

    The sorted pairs are one of these buffers: memory that is fresh in every step comes page by page from the
    system, which takes half as long as to sort.
    """

    def __init__(self) -> None:
        self.most = MAX_PAIRS
        self.keys: NDArray[np.int64] = np.empty(64, dtype=np.int64)
        self._spare: NDArray[np.int64] = np.empty(64, dtype=np.int64)
        self._counters: NDArray[np.int64] = np.empty((4, 1 << WHOLE_DIGIT), dtype=np.int64)
        self._places: NDArray[np.int32] = np.empty(64, dtype=np.int32)
        self._pairs: NDArray[np.int64] = np.empty((64, 2), dtype=np.int64)
        self._patience = 0

    def check(self, count: int) -> None:
        """LimitError if there may not be so many pairs."""
        if count > self.most:
            raise LimitError(f"too many pairs: at most {self.most:,}".replace(",", "\u202f"))

    def reserve(self, count: int) -> None:
        """Make space for so many keys in ``keys``; what it held is lost. LimitError beyond ``most``."""
        self.check(count)
        if count > len(self.keys):
            size = min(max(count, 2 * len(self.keys)), self.most)
            self.keys = np.empty(size, dtype=np.int64)
            self._spare = np.empty(size, dtype=np.int64)

    def grow(self, least: int) -> None:
        """At least twice the capacity, as far as there may be any; LimitError if there may be no more."""
        self.reserve(max(len(self.keys) + 1, min(max(2 * len(self.keys), least), self.most)))

    def sorted(self, count: int, top: int) -> NDArray[np.int64]:
        """The first ``count`` of ``keys`` as (count, 2) sorted pairs of ids below ``top``.

        They stand in a buffer, until the next call.
        """
        if count > len(self._pairs):
            self._pairs = np.empty((max(count, min(2 * len(self._pairs), self.most)), 2), dtype=np.int64)
        pairs = self._pairs[:count]
        if self._sort_by_first(count, top, pairs):
            return pairs
        bits = max(int(top - 1).bit_length(), 1)
        digit = bits if bits <= WHOLE_DIGIT else (bits + 1) // 2
        if 1 << digit > self._counters.shape[1]:
            self._counters = np.empty((4, 1 << digit), dtype=np.int64)
        sort_pairs(self.keys, count, self._spare, self._counters, bits, pairs)
        return pairs

    def _sort_by_first(self, count: int, top: int, pairs: NDArray[np.int64]) -> bool:
        """Sort so if it is likely to be the faster way; whether it was."""
        self._patience -= 1
        if self._patience > 0 or top > MOST_IDS * count:
            return False
        if top > len(self._places):
            self._places = np.empty(max(top, 2 * len(self._places)), dtype=np.int32)
        done = bool(sort_by_first(self.keys, count, self._spare, self._places[:top], pairs))
        self._patience = 0 if done else PATIENCE
        return done

    def memory(self) -> int:
        """Bytes in its buffers."""
        buffers = self.keys, self._spare, self._counters, self._places, self._pairs
        return sum(buffer.nbytes for buffer in buffers)
