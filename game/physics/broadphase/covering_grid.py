"""The uniform grid as textbooks have it: every box stands in every cell that it covers.

Two boxes that overlap share a cell, mostly several, and would be met in each. The pair is taken in its
owner alone: the cell of the greater of the two lower corners, which both boxes cover. So no pair manager is
needed to find doubles.

Against ``UniformGrid`` a box has (1 + s / c)^2 entries on average, for boxes of size s in cells of size c,
instead of one. That makes cells smaller than a box dear, and the best ones 2 to 6 sizes wide.

Source: Ericson, Real-Time Collision Detection (2005), 7.1.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.arrays import Longs
from game.compiler.decorator import kernel
from game.physics.broadphase.grid_search import GUARD, cell_coordinate
from game.physics.broadphase.uniform_grid import UniformGrid
from game.physics.broadphase.walks.grid import Visit


@kernel(_nrt=False)
def enter_cells(store, matrix, start, entries):
    """Enter every box into all cells that it covers, by a counting sort. Returns the number of entries.

    ``store``, ``matrix``: plain tuples of a `Store` and a `Matrix`. ``start``: (>= rows stride + 1,) written:
    first entry of each cell. ``entries``: (capacity,) ids, written if there is space for all of them.
    """
    boxes, alive, top = store
    origin_x, origin_y, inverse, columns, rows = matrix
    last_column, last_row = columns - 1.0, rows - 1.0
    stride = columns + GUARD
    for cell in range(len(start)):
        start[cell] = 0
    for turn in range(2):
        for box in range(top - 1, -1, -1):
            if alive[box] == 0:
                continue
            before = cell_coordinate(boxes[box, 0], origin_x, inverse, last_column)
            after = cell_coordinate(boxes[box, 2], origin_x, inverse, last_column)
            above = cell_coordinate(boxes[box, 3], origin_y, inverse, last_row)
            for row in range(cell_coordinate(boxes[box, 1], origin_y, inverse, last_row), above + 1):
                for cell in range(row * stride + before, row * stride + after + 1):
                    if turn == 0:
                        start[cell] += 1
                    else:
                        start[cell] -= 1
                        entries[start[cell]] = box
        if turn == 0:
            total = 0
            for cell in range(len(start)):
                total += start[cell]
                start[cell] = total
            if total > len(entries):
                return total
    return total


@kernel(_nrt=False)
def search_cells(boxes, matrix, start, entries, packed, keys, tests):
    """All pairs, each in its owner cell, as keys ``a << 32 | b``; returns their number.

    ``packed``: (boxes, 4) m, overwritten. ``tests``: (1,) box tests, written. Returns -1 if ``keys`` is too
    short.
    """
    origin_x, origin_y, inverse, columns, rows = matrix
    last_column, last_row = columns - 1.0, rows - 1.0
    stride = columns + GUARD
    found = 0
    tested = 0
    for row in range(rows):
        for column in range(columns):
            first = start[row * stride + column]
            load = start[row * stride + column + 1] - first
            if found + load * (load - 1) // 2 > len(keys):
                return -1
            tested += load * (load - 1) // 2
            for i in range(load):
                box = entries[first + i]
                x0, y0, x1, y1 = boxes[box, 0], boxes[box, 1], boxes[box, 2], boxes[box, 3]
                for j in range(i):
                    x_meets = (packed[j, 0] <= x1) & (x0 <= packed[j, 2])
                    if x_meets & (packed[j, 1] <= y1) & (y0 <= packed[j, 3]):
                        owner_x = cell_coordinate(max(x0, packed[j, 0]), origin_x, inverse, last_column)
                        owner_y = cell_coordinate(max(y0, packed[j, 1]), origin_y, inverse, last_row)
                        if owner_x == column and owner_y == row:
                            other = entries[first + j]
                            keys[found] = (int(min(box, other)) << 32) | int(max(box, other))
                            found += 1
                packed[i, 0] = x0
                packed[i, 1] = y0
                packed[i, 2] = x1
                packed[i, 3] = y1
    tests[0] = tested
    return found


class CoveringGrid(UniformGrid):
    """A ``UniformGrid`` whose boxes stand in every cell they cover; same answers, same calls.

    ``entries`` counts them over all cells. Best is a cell of 2 to 6 times the size of most boxes.
    """

    def __init__(self, lower: ArrayLike, upper: ArrayLike, cell: float):
        super().__init__(lower, upper, cell)
        self.entries = 0
        self._entries: NDArray[np.int32] = np.empty(64, dtype=np.int32)
        self._packed = np.empty((self.capacity, 4))

    def _grow(self, capacity: int) -> None:
        super()._grow(capacity)
        self._packed = np.empty((capacity, 4))

    def _find_pairs(self) -> Longs:
        grid = self._matrix, self._start
        self.entries = enter_cells(self._store(), *grid, self._entries)
        if self.entries > len(self._entries):
            self._entries = np.empty(2 * self.entries, dtype=np.int32)
            enter_cells(self._store(), *grid, self._entries)
        found = -1
        while found < 0:
            found = search_cells(
                self.boxes, *grid, self._entries, self._packed, self._sorter.keys, self._reach[2:]
            )
            if found < 0:
                self._sorter.grow(8 * self._count)
        self.tests = int(self._reach[2])
        return self._sorter.sorted(found, self.top)

    def cells_of(self, box: int) -> list[tuple[int, int]]:
        """Columns and rows of the cells that a box covers; ValueError if there is none of that id."""
        self._known(box)
        before, below = self.cell_of(*self.boxes[box, :2].tolist())
        after, above = self.cell_of(*self.boxes[box, 2:].tolist())
        return [(column, row) for row in range(below, above + 1) for column in range(before, after + 1)]

    def visits(self, box: int) -> list[Visit]:
        """Cell by cell, the boxes that a box is tested against there: all that stand in it."""
        self._known(box)
        if self._found is None:
            self._found = self._find_pairs()
        visits = []
        for column, row in self.cells_of(box):
            cell = row * (self.columns + GUARD) + column
            entries = self._entries[self._start[cell] : self._start[cell + 1]].tolist()
            visits.append(Visit(((column, row),), tuple(other for other in entries if other != box)))
        return visits

    def check(self) -> None:
        """As for the uniform grid; and cells hold just the boxes that cover them."""
        super().check()
        self._found = self._find_pairs()
        held: dict[tuple[int, int], list[int]] = {}
        for box in self.ids().tolist():
            for cell in self.cells_of(box):
                held.setdefault(cell, []).append(box)
        assert self.entries == sum(map(len, held.values())), "as many entries as cells covered"
        loads = self.loads()
        for (column, row), boxes in held.items():
            first = self._start[row * (self.columns + GUARD) + column]
            assert self._entries[first : first + loads[row, column]].tolist() == boxes, (
                "a cell holds its boxes"
            )
