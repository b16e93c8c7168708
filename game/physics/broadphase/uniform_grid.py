"""A uniform grid in a dense matrix: every box stands in the cell of its lower corner.

Two boxes that overlap have their lower corners at most one box apart, so a box looks for partners among
the cells up to its own upper corner, and back by the widest box of all (its ``reach``, in cells). Cells
are numbered row by row and the boxes sorted by cell (counting sort), so the cells of one row that a box
looks at are one run of consecutive boxes: no lists are walked, and no pair is met twice.

Cells come from ``floor((x - x_lower) * (1 / cell))``, clamped to the matrix. That is a monotone function
of x, rounding and all, so it may put a border into the wrong cell but can never lose a pair: of two
overlapping boxes, the greater lower edge is not above the smaller upper one, and neither are their cells.

For single calls each cell also has a linked list of its boxes. Lists follow single calls at once, and are
made anew after a bulk call, when they are next needed.

Source: Ericson, Real-Time Collision Detection (2005), 7.1; the sort as in Green, Particle Simulation
using CUDA (2008).
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.physics.broadphase.boxes import BroadPhase, Corners, Ids, Pairs, corner
from game.physics.broadphase.cell_lists import CellLists
from game.physics.jit import kernel

MAX_CELLS = 1 << 24  # 64 MB for each of the two arrays over cells
GUARD = 2  # empty columns to the right: the run of cells x - 1 .. x + 1 never leaves the matrix
PADDING = 8  # places after the sorted boxes that may be read but are never counted
NEAR = 1  # cells: up to this reach the short search does
ID_MASK = 0x7FFFFFFF


@kernel(inline="always", _nrt=False)
def cell_coordinate(x, origin, inverse, last):
    """Column (or row) of a coordinate, clamped to 0 .. ``last`` (a float). Infinities are clamped too."""
    return int(min(max((float(x) - float(origin)) * float(inverse), 0.0), last))


@kernel(_nrt=False)
def place_boxes(boxes, alive, top, geometry, columns, rows, cells, start, reach):
    """Find every box's cell and count the boxes of each.

    ``boxes``: (capacity, 4) m. ``geometry``: (3,) origin x, origin y in m, cells per m. ``cells``:
    (capacity,) written, -1 for ids not in use. ``start``: ((rows + 1) stride + 1,) written: boxes per cell.
    ``reach``: (2,) written: the greatest number of columns and rows between a box's two corners.
    """
    origin_x, origin_y, inverse = geometry[0], geometry[1], geometry[2]
    last_column, last_row = columns - 1.0, rows - 1.0
    stride = columns + GUARD
    reach_x = 0
    reach_y = 0
    for cell in range(len(start)):
        start[cell] = 0
    for box in range(top):
        if alive[box] == 0:
            cells[box] = -1
            continue
        column = cell_coordinate(boxes[box, 0], origin_x, inverse, last_column)
        row = cell_coordinate(boxes[box, 1], origin_y, inverse, last_row)
        reach_x = max(reach_x, cell_coordinate(boxes[box, 2], origin_x, inverse, last_column) - column)
        reach_y = max(reach_y, cell_coordinate(boxes[box, 3], origin_y, inverse, last_row) - row)
        cell = row * stride + column
        cells[box] = cell
        start[cell] += 1
    reach[0] = reach_x
    reach[1] = reach_y


@kernel(_nrt=False)
def sort_by_cell(boxes, top, cells, start, order, sorted_boxes):
    """Counting sort of the boxes by cell; within a cell by id. Returns their number.

    ``start``: boxes per cell; becomes the first place of each cell in ``order``. ``order``: (capacity +
    padding,) written: ``cell << 32 | id``. ``sorted_boxes``: (capacity + padding, 4) m, written.
    """
    total = 0
    for cell in range(len(start)):
        total += start[cell]
        start[cell] = total
    for box in range(top - 1, -1, -1):
        cell = cells[box]
        if cell >= 0:
            place = start[cell] - 1
            start[cell] = place
            order[place] = (int(cell) << 32) | box
    for place in range(total):
        box = order[place] & ID_MASK
        sorted_boxes[place, 0] = boxes[box, 0]
        sorted_boxes[place, 1] = boxes[box, 1]
        sorted_boxes[place, 2] = boxes[box, 2]
        sorted_boxes[place, 3] = boxes[box, 3]
    return total


@kernel(_nrt=False)
def search_near(sorted_boxes, order, count, start, stride, keys, tests):
    """All pairs, where no box reaches beyond the next cell: two runs of cells for each box.

    Half of a box's neighbourhood is enough: the rest of its own cell and the next in the row, and three
    cells of the row after. Writes pairs of places, ``p << 32 | q``; returns their number, or -1 if ``keys``
    is too short. The first candidates of each run are tested without asking whether there are any: a
    pair is kept by adding 0 or 1, so that there is no branch to mispredict.
    """
    found = 0
    tested = 0
    for place in range(count):
        x0 = sorted_boxes[place, 0]
        y0 = sorted_boxes[place, 1]
        x1 = sorted_boxes[place, 2]
        y1 = sorted_boxes[place, 3]
        cell = order[place] >> 32
        end = int(start[cell + 2])
        first = int(start[cell + stride - 1])
        last = int(start[cell + stride + 2])
        tested += end - place - 1 + last - first
        if found + end - place + last - first + 4 > len(keys):
            return -1
        tag = place << 32
        other = (place + 1) & ID_MASK
        keys[found] = tag | other
        found += (
            (other < end)
            & (sorted_boxes[other, 0] <= x1)
            & (y0 <= sorted_boxes[other, 3])
            & (sorted_boxes[other, 1] <= y1)
            & (x0 <= sorted_boxes[other, 2])
        )
        for candidate in range(place + 2, end):
            other = candidate & ID_MASK
            keys[found] = tag | other
            found += (
                (sorted_boxes[other, 0] <= x1)
                & (y0 <= sorted_boxes[other, 3])
                & (sorted_boxes[other, 1] <= y1)
                & (x0 <= sorted_boxes[other, 2])
            )
        for step in range(2):
            other = (first + step) & ID_MASK
            keys[found] = tag | other
            found += (
                (other < last)
                & (sorted_boxes[other, 0] <= x1)
                & (x0 <= sorted_boxes[other, 2])
                & (sorted_boxes[other, 1] <= y1)
            )
        for candidate in range(first + 2, last):
            other = candidate & ID_MASK
            keys[found] = tag | other
            found += (
                (sorted_boxes[other, 0] <= x1)
                & (x0 <= sorted_boxes[other, 2])
                & (sorted_boxes[other, 1] <= y1)
            )
    tests[0] = tested
    return found


@kernel(_nrt=False)
def search_far(sorted_boxes, order, count, start, geometry, columns, rows, reach_x, keys, tests):
    """All pairs, for boxes that reach over any number of cells. As ``search_near`` else.

    A row's run begins ``reach_x`` columns before the box's own, where the widest box that could still
    touch it would have its lower corner.
    """
    origin_x, origin_y, inverse = geometry[0], geometry[1], geometry[2]
    last_column, last_row = columns - 1.0, rows - 1.0
    stride = columns + GUARD
    found = 0
    tested = 0
    for place in range(count):
        x0 = sorted_boxes[place, 0]
        y0 = sorted_boxes[place, 1]
        x1 = sorted_boxes[place, 2]
        y1 = sorted_boxes[place, 3]
        before = max(cell_coordinate(x0, origin_x, inverse, last_column) - reach_x, 0)
        after = cell_coordinate(x1, origin_x, inverse, last_column) + 1
        row = cell_coordinate(y0, origin_y, inverse, last_row)
        last_of_box = cell_coordinate(y1, origin_y, inverse, last_row)
        tag = place << 32
        first = place + 1
        while True:
            last = int(start[row * stride + after])
            tested += max(last - first, 0)
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
            row += 1
            if row > last_of_box:
                break
            first = int(start[row * stride + before])
    tests[0] = tested
    return found


@kernel(_nrt=False)
def name_pairs(keys, count, order):
    """Turn pairs of places into pairs of ids, the smaller first: ``a << 32 | b``. ``keys``: written."""
    for i in range(count):
        a = order[keys[i] >> 32] & ID_MASK
        b = order[keys[i] & ID_MASK] & ID_MASK
        keys[i] = (min(a, b) << 32) | max(a, b)


@kernel(_nrt=False)
def find_pairs(boxes, alive, top, geometry, columns, rows, cells, start, order, sorted_boxes, keys, reach):
    """All overlapping pairs of ids as keys, unsorted; returns their number, or -1 if ``keys`` is too short.

    ``reach``: (3,) written: reach in columns and rows, and the number of box tests.
    """
    place_boxes(boxes, alive, top, geometry, columns, rows, cells, start, reach)
    count = sort_by_cell(boxes, top, cells, start, order, sorted_boxes)
    if reach[0] <= NEAR and reach[1] <= NEAR:
        found = search_near(sorted_boxes, order, count, start, columns + GUARD, keys, reach[2:])
    else:
        found = search_far(
            sorted_boxes, order, count, start, geometry, columns, rows, reach[0], keys, reach[2:]
        )
    if found > 0:
        name_pairs(keys, found, order)
    return found


@kernel(_nrt=False)
def walk_lists(boxes, geometry, columns, rows, heads, nexts, reach, x0, y0, x1, y1, ids):
    """Find the boxes that overlap the closed box given, m; returns their number. ``ids``: written."""
    origin_x, origin_y, inverse = geometry[0], geometry[1], geometry[2]
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
    the size of most boxes. Boxes may be larger than a cell, and may lie outside: border cells stand for all
    that is beyond them. ValueError if the matrix is no rectangle or has more than 2^24 cells.
    """

    def __init__(self, lower: ArrayLike, upper: ArrayLike, cell: float):
        super().__init__()
        x0, y0 = corner(lower, "lower")
        x1, y1 = corner(upper, "upper")
        if not (x0 < x1 and y0 < y1 and math.isfinite(x1 - x0) and math.isfinite(y1 - y0)):
            raise ValueError(f"lower ({x0}, {y0}) must be below upper ({x1}, {y1}), both finite")
        if not (isinstance(cell, (int, float)) and math.isfinite(cell) and cell > 0.0):
            raise ValueError(f"cell = {cell!r}: a finite number above 0 m is wanted")
        across, up = math.ceil(min((x1 - x0) / cell, 2.0**31)), math.ceil(min((y1 - y0) / cell, 2.0**31))
        if across * up > MAX_CELLS:
            raise ValueError(
                f"cell = {cell!r}: a matrix of {across} x {up} cells is too large, at most {MAX_CELLS}"
            )
        self.cell = float(cell)
        self.columns = max(across, 1)
        self.rows = max(up, 1)
        self.lower = (x0, y0)
        self._geometry = np.array([x0, y0, 1.0 / self.cell])
        self._reach = np.zeros(3, dtype=np.int64)
        cells = (self.rows + 1) * (self.columns + GUARD) + 1
        self._start: NDArray[np.int32] = np.zeros(cells, dtype=np.int32)
        self._lists = CellLists(cells, self.capacity)
        self._make_room_to_sort(self.capacity)

    def _make_room_to_sort(self, capacity: int) -> None:
        self._cells: NDArray[np.int32] = np.full(capacity, -1, dtype=np.int32)
        self._order: NDArray[np.int64] = np.zeros(capacity + PADDING, dtype=np.int64)
        self._sorted: Corners = np.zeros((capacity + PADDING, 4))

    def _grow(self, capacity: int) -> None:
        super()._grow(capacity)
        self._make_room_to_sort(capacity)
        self._lists.grow(capacity)

    def cell_of(self, x: float, y: float) -> tuple[int, int]:
        """Column and row of the cell of a point, m; border cells stand for all that is beyond them."""
        origin_x, origin_y, inverse = self._geometry.tolist()
        return (
            cell_coordinate(x, origin_x, inverse, self.columns - 1.0),
            cell_coordinate(y, origin_y, inverse, self.rows - 1.0),
        )

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

    def _added_many(self, ids: Ids) -> None:
        self._lists.fresh = False

    def _removed_many(self, ids: Ids) -> None:
        self._lists.fresh = False

    def _moved_many(self, ids: Ids) -> None:
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
        place_boxes(
            self.boxes, self.alive, self.top, self._geometry, self.columns, self.rows,
            self._lists.cells, self._start, self._reach,
        )  # fmt: skip
        self._lists.make(len(self._start), self.top)

    def _find_pairs(self) -> Pairs:
        found = -1
        while found < 0:
            found = find_pairs(
                self.boxes, self.alive, self.top, self._geometry, self.columns, self.rows,
                self._cells, self._start, self._order, self._sorted, self._sorter.keys, self._reach,
            )  # fmt: skip
            if found < 0:
                self._sorter.reserve(max(2 * len(self._sorter.keys), 8 * self._count))
        self.tests = int(self._reach[2])
        return self._sorter.sorted(found, self.top)

    def _find_in_box(self, x0: float, y0: float, x1: float, y1: float) -> Ids:
        if not self._lists.fresh:
            self._make_lists()
        ids = np.empty(self._count, dtype=np.int64)
        found = walk_lists(
            self.boxes, self._geometry, self.columns, self.rows, self._lists.heads, self._lists.nexts,
            self._reach, x0, y0, x1, y1, ids,
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
