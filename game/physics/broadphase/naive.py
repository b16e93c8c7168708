"""The naive broad phase: every box against every other, n(n - 1)/2 tests.

It needs no structure and no tuning, it is right by its looks, and so it judges all the others. Below some
thirty boxes it is also the fastest of them.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats, Longs
from game.compiler.decorator import kernel
from game.physics.broadphase.boxes import BroadPhase

BLOCK = 16  # boxes that are tested at once


@kernel(_nrt=False)
def pack_boxes(boxes, alive, top, packed, ids):
    """Copy the boxes in use, in the order of their ids. Returns their number.

    ``boxes``: (capacity, 4) m. ``alive``: (capacity,). ``packed``: (4, capacity) m, a row for each of x0 y0
    x1 y1, and ``ids``: (capacity,), both written.
    """
    count = 0
    for box in range(top):
        if alive[box]:
            packed[0, count] = boxes[box, 0]
            packed[1, count] = boxes[box, 1]
            packed[2, count] = boxes[box, 2]
            packed[3, count] = boxes[box, 3]
            ids[count] = box
            count += 1
    return count


@kernel(_nrt=False)
def find_all_pairs(packed, ids, count, pairs):
    """Test every box against all later ones; returns the number of pairs, or -1 if ``pairs`` is too short.

    ``packed``: (4, >= count) m. ``ids``: (>= count,), ascending. ``pairs``: (capacity, 2), written, sorted.
    Blocks of boxes are tested at once, by vector instructions; only where one hit is there a second look.
    """
    low_x, low_y, high_x, high_y = packed[0], packed[1], packed[2], packed[3]
    found = 0
    for i in range(count):
        if found + count - i > len(pairs):
            return -1
        x0, y0, x1, y1 = low_x[i], low_y[i], high_x[i], high_y[i]
        begin = i + 1
        while begin < count:
            hits = 1
            size = count - begin
            if size >= BLOCK:
                size = BLOCK
                hits = 0
                for k in range(BLOCK):
                    j = begin + k
                    hits += (low_x[j] <= x1) & (x0 <= high_x[j]) & (low_y[j] <= y1) & (y0 <= high_y[j])
            if hits > 0:
                for j in range(begin, begin + size):
                    if (low_x[j] <= x1) & (x0 <= high_x[j]) & (low_y[j] <= y1) & (y0 <= high_y[j]):
                        pairs[found, 0] = ids[i]
                        pairs[found, 1] = ids[j]
                        found += 1
            begin += size
    return found


@kernel(_nrt=False)
def scan_boxes(boxes, alive, top, x0, y0, x1, y1, ids):
    """Find the boxes that overlap the box given, m; returns their number. ``ids``: written, ascending."""
    found = 0
    for box in range(top):
        if (
            alive[box]
            and boxes[box, 0] <= x1
            and x0 <= boxes[box, 2]
            and boxes[box, 1] <= y1
            and y0 <= boxes[box, 3]
        ):
            ids[found] = box
            found += 1
    return found


class NaiveBroadPhase(BroadPhase):
    """Tests every box against every other one."""

    def __init__(self) -> None:
        super().__init__()
        self._packed: Floats = np.empty((4, 16))
        self._ids: NDArray[np.int64] = np.empty(16, dtype=np.int64)
        self._pairs: Longs = np.empty((64, 2), dtype=np.int64)

    def _grow(self, capacity: int) -> None:
        super()._grow(capacity)
        self._packed = np.empty((4, capacity))
        self._ids = np.empty(capacity, dtype=np.int64)

    def _find_pairs(self) -> Longs:
        count = pack_boxes(self.boxes, self.alive, self.top, self._packed, self._ids)
        self.tests = count * (count - 1) // 2
        found = find_all_pairs(self._packed, self._ids, count, self._pairs)
        while found < 0:
            self._pairs = np.empty((max(2 * len(self._pairs), 2 * count), 2), dtype=np.int64)
            found = find_all_pairs(self._packed, self._ids, count, self._pairs)
        return self._pairs[:found].copy()

    def _find_in_box(self, x0: float, y0: float, x1: float, y1: float) -> Longs:
        found = scan_boxes(self.boxes, self.alive, self.top, x0, y0, x1, y1, self._ids)
        return self._ids[:found].copy()
