"""Doubly linked lists of boxes, one for each cell: how single boxes enter, leave and change cells at once.

Bulk calls do not keep the lists: they mark them stale, and the grid makes them again when next it needs them.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from game.arrays import Longs
from game.compiler.decorator import kernel
from game.physics.broadphase.validation import grown


@kernel(_nrt=False)
def link_box(box, cell, cells, heads, nexts, previous):
    """Put a box first into the list of a cell. -1 ends a list; all arrays are written."""
    head = heads[cell]
    cells[box] = cell
    nexts[box] = head
    previous[box] = -1
    if head >= 0:
        previous[head] = box
    heads[cell] = box


@kernel(_nrt=False)
def unlink_box(box, cells, heads, nexts, previous):
    """Take a box out of the list of its cell."""
    before, after = previous[box], nexts[box]
    if before >= 0:
        nexts[before] = after
    else:
        heads[cells[box]] = after
    if after >= 0:
        previous[after] = before
    cells[box] = -1


@kernel(_nrt=False)
def link_all(top, cells, heads, nexts, previous):
    """Make all lists again from ``cells``, -1 for ids not in use; within a cell ids ascend."""
    heads[:] = -1
    for box in range(top - 1, -1, -1):
        cell = cells[box]
        if cell >= 0:
            head = heads[cell]
            nexts[box] = head
            previous[box] = -1
            if head >= 0:
                previous[head] = box
            heads[cell] = box


class CellLists:
    """Lists of the boxes of each cell.

    ``fresh``: the lists mirror the boxes. ``cells``: (capacity,) the cell of each box, -1 for none.
    ``heads``: (cells,) and ``nexts``: (capacity,) walk the lists; -1 ends them.
    """

    def __init__(self, cell_count: int, capacity: int):
        self.fresh = True
        self.heads: NDArray[np.int32] = np.full(cell_count, -1, dtype=np.int32)
        self.cells: NDArray[np.int32] = np.full(capacity, -1, dtype=np.int32)
        self.nexts: NDArray[np.int32] = np.full(capacity, -1, dtype=np.int32)
        self._previous: NDArray[np.int32] = np.full(capacity, -1, dtype=np.int32)

    def grow(self, capacity: int) -> None:
        """Make space for so many ids."""
        self.cells = grown(self.cells, capacity, -1)
        self.nexts = grown(self.nexts, capacity, -1)
        self._previous = grown(self._previous, capacity, -1)

    def put(self, box: int, cell: int) -> None:
        """Put a box into a cell, out of another if it was in one."""
        if self.cells[box] != cell:
            self.take_out(box)
            link_box(box, cell, self.cells, self.heads, self.nexts, self._previous)

    def take_out(self, box: int) -> None:
        """Take a box out of its cell, if it is in one."""
        if self.cells[box] >= 0:
            unlink_box(box, self.cells, self.heads, self.nexts, self._previous)

    def make(self, cell_count: int, top: int) -> None:
        """Make all lists again from ``cells``, for ids below ``top``."""
        if cell_count > len(self.heads):
            self.heads = np.full(2 * cell_count, -1, dtype=np.int32)
        link_all(top, self.cells, self.heads, self.nexts, self._previous)
        self.fresh = True

    def memory(self) -> int:
        """Bytes in its arrays."""
        return self.heads.nbytes + self.cells.nbytes + self.nexts.nbytes + self._previous.nbytes

    def check(self, ids: Longs, cell_of: Callable[[int], int]) -> None:
        """Check every list, and that just ``ids`` stand in them, each in its cell's."""
        seen = set()
        for cell in np.flatnonzero(self.heads >= 0).tolist():
            before, box = -1, int(self.heads[cell])
            while box >= 0:
                assert box not in seen, "no box stands in two lists, nor twice in one"
                assert self._previous[box] == before, "the lists read backwards as forwards"
                assert self.cells[box] == cell == cell_of(box), "a box stands in the list of its cell"
                seen.add(box)
                before, box = box, int(self.nexts[box])
        assert seen == set(ids.tolist()), "all boxes in use, and no others, stand in a list"
