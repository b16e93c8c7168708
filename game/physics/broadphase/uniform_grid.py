"""A uniform grid in a dense matrix: every box stands in the cell of its lower corner.

Two boxes that overlap have their lower corners at most one box apart. So a box looks for partners in the
cells up to its own upper corner, and back by the widest of all (its ``reach``, in cells). Cells are numbered
row by row and the boxes sorted by cell (counting sort). So the cells of one row that a box looks at are one
run of consecutive boxes: no lists are walked, and no pair is met twice.

Cells come from ``floor((x - x_lower) * (1 / cell))``, clamped to the matrix. That is a monotone function
of x, rounding and all, so it may put a border into the wrong cell but can never lose a pair: of two
overlapping boxes, the greater lower edge is not above the smaller upper one, and neither are their cells.

For single calls each cell also has a linked list of its boxes. Lists follow single calls at once, and are
made again after a bulk call, when they are next needed.

Source: Ericson, Real-Time Collision Detection (2005), 7.1; the sort as in Green, Particle Simulation
using CUDA (2008).
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.arrays import Floats, Longs
from game.compiler.decorator import kernel
from game.physics.broadphase.boxes import BroadPhase
from game.physics.broadphase.cell_lists import CellLists
from game.physics.broadphase.grid_search import (
    GUARD,
    Matrix,
    cell_coordinate,
    find_pairs,
    place_boxes,
)
from game.physics.broadphase.runs import ID_MASK, ROOM
from game.physics.broadphase.validation import corner
from game.physics.broadphase.walks.grid import CellRuns, Visit, corner_visits

MAX_CELLS = 1 << 24  # 64 MB for each of the two arrays over cells


@kernel(_nrt=False)
def walk_lists(boxes, matrix, heads, nexts, reach, wanted, ids):
    """Find the boxes that overlap a closed one, x0 y0 x1 y1 m; returns their number. ``ids``: written."""
    origin_x, origin_y, inverse, columns, rows = matrix
    x0, y0, x1, y1 = wanted
    before = max(cell_coordinate(x0, origin_x, inverse, columns - 1.0) - reach[0], 0)
    after = cell_coordinate(x1, origin_x, inverse, columns - 1.0)
    below = max(cell_coordinate(y0, origin_y, inverse, rows - 1.0) - reach[1], 0)
    above = cell_coordinate(y1, origin_y, inverse, rows - 1.0)
    found = 0
    for row in range(below, above + 1):
        for column in range(before, after + 1):
            box = heads[row * (columns + GUARD) + column]
            while box >= 0:
                if (
                    boxes[box, 0] <= x1
                    and x0 <= boxes[box, 2]
                    and boxes[box, 1] <= y1
                    and y0 <= boxes[box, 3]
                ):
                    ids[found] = box
                    found += 1
                box = nexts[box]
    return found


class UniformGrid(BroadPhase):
    """Boxes in the cells of a dense matrix, each in the cell of its lower corner.

    ``lower``, ``upper``: the corners of the matrix, m. ``cell``: edge of a cell, m; best is 1 to 1.5 times
    the size of most boxes. Boxes may be larger than a cell, and may lie outside: border cells stand for
    everything beyond them. ValueError if the matrix is no rectangle or has more than 2^24 cells.
    """

    def __init__(self, lower: ArrayLike, upper: ArrayLike, cell: float):
        super().__init__()
        x0, y0 = corner(lower, "lower")
        x1, y1 = corner(upper, "upper")
        if not (x0 < x1 and y0 < y1 and math.isfinite(x1 - x0) and math.isfinite(y1 - y0)):
            raise ValueError(f"lower ({x0}, {y0}) must be below upper ({x1}, {y1}), both finite")
        if not (isinstance(cell, (int, float)) and math.isfinite(cell) and cell > 0.0):
            raise ValueError(f"cell = {cell!r}: expected a finite number above 0 m")
        across, up = math.ceil(min((x1 - x0) / cell, 2.0**31)), math.ceil(min((y1 - y0) / cell, 2.0**31))
        if across * up > MAX_CELLS:
            raise ValueError(
                f"cell = {cell!r}: a matrix of {across} x {up} cells is too large, at most {MAX_CELLS}"
            )
        self.cell = float(cell)
        self.columns = max(across, 1)
        self.rows = max(up, 1)
        self.lower = (x0, y0)
        self._matrix = tuple(Matrix(x0, y0, 1.0 / self.cell, self.columns, self.rows))
        self._reach = np.zeros(3, dtype=np.int64)
        cells = (self.rows + 1) * (self.columns + GUARD) + 1
        self._start: NDArray[np.int32] = np.zeros(cells, dtype=np.int32)
        self._lists = CellLists(cells, self.capacity)
        self._noted: NDArray[np.int64] = np.zeros(ROOM, dtype=np.int64)
        self._make_room_to_sort(self.capacity)

    def _make_room_to_sort(self, capacity: int) -> None:
        self._cells: NDArray[np.int32] = np.full(capacity, -1, dtype=np.int32)
        self._order: NDArray[np.int64] = np.zeros(capacity, dtype=np.int64)
        self._sorted: Floats = np.zeros((capacity, 4))

    def _grow(self, capacity: int) -> None:
        super()._grow(capacity)
        self._make_room_to_sort(capacity)
        self._lists.grow(capacity)

    def cell_of(self, x: float, y: float) -> tuple[int, int]:
        """Column and row of the cell of a point, m; border cells stand for everything beyond them."""
        origin_x, origin_y, inverse, columns, rows = self._matrix
        return (
            cell_coordinate(x, origin_x, inverse, columns - 1.0),
            cell_coordinate(y, origin_y, inverse, rows - 1.0),
        )

    def visits(self, box: int) -> list[Visit]:
        """Where a box looks for partners, and what it is tested against; ValueError for another id."""
        self._known(box)
        if self._found is None:
            self._found = self._find_pairs()
        places = np.flatnonzero((self._order[: self._count] & ID_MASK) == box)
        reach = int(self._reach[0]), int(self._reach[1])
        runs = CellRuns(self._start, self._order, self.columns, self.rows, reach)
        x0, y0, x1, y1 = self.boxes[box].tolist()
        return corner_visits(runs, int(places[0]), self.cell_of(x0, y0), self.cell_of(x1, y1))

    def loads(self) -> NDArray[np.int32]:
        """Number of boxes in each cell, (rows, columns)."""
        if self._found is None:
            self._found = self._find_pairs()
        stride = self.columns + GUARD
        return np.diff(self._start[: self.rows * stride + 1]).reshape(self.rows, stride)[:, : self.columns]

    def _added(self, box: int) -> None:
        if self._lists.fresh:
            self._put(box)

    def _removed(self, box: int) -> None:
        if self._lists.fresh:
            self._lists.take_out(box)

    def _moved(self, box: int, x0: float, y0: float, x1: float, y1: float) -> None:
        super()._moved(box, x0, y0, x1, y1)
        if self._lists.fresh:
            self._put(box)

    def _added_many(self, ids: Longs) -> None:
        self._lists.fresh = False

    def _removed_many(self, ids: Longs) -> None:
        self._lists.fresh = False

    def _moved_many(self, ids: Longs) -> None:
        self._lists.fresh = False

    def _put(self, box: int) -> None:
        """Put a stored box into the list of its cell; the greatest reach may grow by it."""
        x0, y0, x1, y1 = self.boxes[box].tolist()
        column, row = self.cell_of(x0, y0)
        after, above = self.cell_of(x1, y1)
        self._reach[0] = max(int(self._reach[0]), after - column)
        self._reach[1] = max(int(self._reach[1]), above - row)
        self._lists.put(box, row * (self.columns + GUARD) + column)

    def _make_lists(self) -> None:
        place_boxes(self._store(), self._matrix, self._lists.cells, self._start, self._reach)
        self._lists.make(len(self._start), self.top)

    def _find_pairs(self) -> Longs:
        found = -1
        while found < 0:
            found = find_pairs(
                self._store(), self._matrix, self._cells, self._start,
                (self._order, self._sorted, self._noted),
                self._sorter.keys, self._reach,
            )  # fmt: skip
            if found < 0:
                self._sorter.grow(8 * self._count)
        self.tests = int(self._reach[2])
        return self._sorter.sorted(found, self.top)

    def _find_in_box(self, x0: float, y0: float, x1: float, y1: float) -> Longs:
        if not self._lists.fresh:
            self._make_lists()
        ids = np.empty(self._count, dtype=np.int64)
        found = walk_lists(
            self.boxes, self._matrix, self._lists.heads, self._lists.nexts, self._reach, (x0, y0, x1, y1), ids
        )  # fmt: skip
        return np.sort(ids[:found], kind="stable")

    def memory(self) -> int:
        """Bytes in the arrays of matrix, lists and boxes."""
        return super().memory() + self._lists.memory()

    def check(self) -> None:
        """Check the store, the reach, and that every list holds the boxes of its cell."""
        super().check()
        if not self._lists.fresh:
            return
        for box in self.ids().tolist():
            column, row = self.cell_of(*self.boxes[box, :2].tolist())
            after, above = self.cell_of(*self.boxes[box, 2:].tolist())
            assert after - column <= self._reach[0] and above - row <= self._reach[1], (
                "none exceeds the reach"
            )
        self._lists.check(self.ids(), self._cell_number)

    def _cell_number(self, box: int) -> int:
        column, row = self.cell_of(*self.boxes[box, :2].tolist())
        return row * (self.columns + GUARD) + column
