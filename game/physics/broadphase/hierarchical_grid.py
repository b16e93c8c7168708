"""Hierarchical grids in hash tables: a grid for every size of box, each as large as space and none stored.

Boxes stand on levels by size (``hash_levels``), are sorted by bucket, and pairs are searched for within
levels and between them (``hash_search``). Single calls keep linked lists, as in the uniform grid.

Sources: Ericson, Real-Time Collision Detection (2005), 7.2; Mirtich, Impulse-based Dynamic Simulation of
Rigid Body Systems (1996), on hierarchical hash tables.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats, Longs
from game.compiler.decorator import kernel
from game.physics.broadphase import hash_levels
from game.physics.broadphase.boxes import BroadPhase
from game.physics.broadphase.cell_lists import CellLists
from game.physics.broadphase.hash_levels import (
    bucket_of,
    cell_at,
    find_levels,
    lay_out,
    level_of,
    place_boxes,
)
from game.physics.broadphase.hash_search import find_pairs
from game.physics.broadphase.runs import ROOM
from game.physics.broadphase.validation import grown
from game.physics.broadphase.walks.hash import LevelVisit, Tables, level_visits


@kernel(_nrt=False)
def walk_lists(boxes, scales, layout, heads, nexts, wanted, ids):
    """Find all boxes that overlap a closed one, x0 y0 x1 y1 m; returns their number.

    On each level either the cells are looked up, or, if there are fewer buckets than cells, all of them.
    ``ids``: written, unsorted.
    """
    x0, y0, x1, y1 = wanted
    found = 0
    for level in range(hash_levels.LEVELS):
        if layout[level, hash_levels.COUNT] == 0:
            continue
        scale = scales[level]
        before, after = cell_at(x0, scale) - 1, cell_at(x1, scale)
        below, above = cell_at(y0, scale) - 1, cell_at(y1, scale)
        size = layout[level, hash_levels.MASK] + 1
        cells = (float(after) - before + 1.0) * (float(above) - below + 1.0)
        if cells < size:
            for row in range(below, above + 1):
                for column in range(before, after + 1):
                    box = heads[
                        layout[level, hash_levels.OFFSET]
                        + bucket_of(column, row, size - 1, layout[level, hash_levels.FACTOR])
                    ]
                    while box >= 0:
                        x_meets = boxes[box, 0] <= x1 and x0 <= boxes[box, 2]
                        if (
                            x_meets
                            and boxes[box, 1] <= y1
                            and y0 <= boxes[box, 3]
                            and cell_at(boxes[box, 0], scale) == column
                            and cell_at(boxes[box, 1], scale) == row
                        ):
                            ids[found] = box
                            found += 1
                        box = nexts[box]
        else:
            for bucket in range(size):
                box = heads[layout[level, hash_levels.OFFSET] + bucket]
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


class HierarchicalGrid(BroadPhase):
    """Boxes of any sizes in hash tables, a table for every level of cell size.

    ``ratio``: of the cell sizes of neighbouring levels, 2, 4, 8 or 16. There is no extent and no cell size
    to choose; memory is in proportion to the boxes. ValueError for another ratio.
    """

    def __init__(self, ratio: int = 2):
        super().__init__()
        if ratio not in (2, 4, 8, 16):
            raise ValueError(f"ratio = {ratio!r}: expected 2, 4, 8 or 16")
        self.ratio = ratio
        self._step = int(ratio).bit_length() - 1
        self._scales = np.array(
            [math.ldexp(1.0, -(level + hash_levels.LOWEST)) for level in range(hash_levels.TOP)] + [0.0]
        )
        self._layout = np.zeros((hash_levels.LEVELS, 4), dtype=np.int64)  # of the sorted boxes
        self._list_layout = np.zeros((hash_levels.LEVELS, 4), dtype=np.int64)
        self._layout[:, hash_levels.MASK] = -1  # no tables yet
        self._start: NDArray[np.int32] = np.zeros(64, dtype=np.int32)
        self._tests = np.zeros(1, dtype=np.int64)
        self._lists = CellLists(64, self.capacity)
        self._lists.fresh = False
        self._list_levels: NDArray[np.int8] = np.full(self.capacity, -1, dtype=np.int8)
        self._noted: NDArray[np.int64] = np.zeros(ROOM, dtype=np.int64)
        self._make_room_to_sort(self.capacity)

    def _make_room_to_sort(self, capacity: int) -> None:
        self._sort_levels: NDArray[np.int8] = np.zeros(capacity, dtype=np.int8)
        self._buckets: NDArray[np.int32] = np.zeros(capacity, dtype=np.int32)
        self._ranks: NDArray[np.int32] = np.zeros(capacity, dtype=np.int32)
        self._order: NDArray[np.int64] = np.zeros(2 * capacity, dtype=np.int64)
        self._sorted: Floats = np.zeros((2 * capacity, 4))

    def _grow(self, capacity: int) -> None:
        super()._grow(capacity)
        self._make_room_to_sort(capacity)
        self._lists.grow(capacity)
        self._list_levels = grown(self._list_levels, capacity, -1)

    def level(self, box: int) -> int:
        """Level of a box; its cells are ``cell_size(level)`` wide."""
        self._known(box)
        return int(level_of(*self.boxes[box].tolist(), self._step, self._scales))

    @staticmethod
    def cell_size(level: int) -> float:
        """Edge of the cells of a level, m; infinity for the last."""
        return math.inf if level == hash_levels.TOP else math.ldexp(1.0, level + hash_levels.LOWEST)

    def levels(self) -> list[tuple[int, int]]:
        """Levels that have boxes, and how many, from the finest up."""
        levels, _ = self.cells()
        counts = np.bincount(levels[levels >= 0], minlength=1)
        return [(int(level), int(counts[level])) for level in np.flatnonzero(counts)]

    def tables(self) -> Tables:
        """The tables of all levels as the last search for pairs had them."""
        if self._found is None:
            self._found = self._find_pairs()
        return Tables(self._layout, self._start, self._order, self._scales)

    def visits(self, box: int) -> list[LevelVisit]:
        """Where a box looks for partners, level by level; ValueError if there is none of that id."""
        return level_visits(self.tables(), box, self.level(box), self.boxes[box].tolist())

    def cells(self) -> tuple[NDArray[np.int8], Floats]:
        """For every id below ``top``: level (-1 if not in use), and (top, 2) lower corner of its cell, m."""
        levels = np.empty(self.top, dtype=np.int8)
        layout = np.empty_like(self._layout)
        find_levels(self._store(), (self._step, self._scales), levels, layout)
        scales = self._scales[levels][:, None]
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            lower = np.floor(self.boxes[: self.top, :2] * scales) / scales
        return levels, lower

    def _added(self, box: int) -> None:
        if self._lists.fresh:
            self._put(box)

    def _removed(self, box: int) -> None:
        if self._lists.fresh:
            self._take_out(box)

    def _moved(self, box: int, x0: float, y0: float, x1: float, y1: float) -> None:
        super()._moved(box, x0, y0, x1, y1)
        if self._lists.fresh:
            self._take_out(box)
            self._put(box)

    def _added_many(self, ids: Longs) -> None:
        self._lists.fresh = False

    def _removed_many(self, ids: Longs) -> None:
        self._lists.fresh = False

    def _moved_many(self, ids: Longs) -> None:
        self._lists.fresh = False

    def _put(self, box: int) -> None:
        """Put a box into its list; where its table is full, all lists are left to be made again."""
        level = self.level(box)
        if self._list_layout[level, hash_levels.COUNT] > self._list_layout[level, hash_levels.MASK]:
            self._lists.fresh = False
            return
        self._list_layout[level, hash_levels.COUNT] += 1
        self._list_levels[box] = level
        self._lists.put(box, self._bucket(box))

    def _take_out(self, box: int) -> None:
        self._lists.take_out(box)
        self._list_layout[self._list_levels[box], hash_levels.COUNT] -= 1
        self._list_levels[box] = -1

    def _bucket(self, box: int) -> int:
        level = self._list_levels[box]
        offset, mask, _, factor = self._list_layout[level].tolist()
        scale = float(self._scales[level])
        x, y = self.boxes[box, :2].tolist()
        return offset + bucket_of(cell_at(x, scale), cell_at(y, scale), mask, factor)

    def _make_lists(self) -> None:
        layout, ladder = self._list_layout, (self._step, self._scales)
        find_levels(self._store(), ladder, self._list_levels, layout)
        buckets = lay_out(layout, hash_levels.LIST_SPREAD)
        start = np.empty(buckets, dtype=np.int32)
        placed = self._list_levels, layout, self._lists.cells, self._ranks, start
        place_boxes(self._store(), ladder, placed)
        self._lists.cells[: self.top][self.alive[: self.top] == 0] = -1
        self._lists.make(buckets, self.top)

    def _find_pairs(self) -> Longs:
        found = -1
        while found < 0:
            found = find_pairs(
                self._store(), (self._step, self._scales),
                (self._sort_levels, self._layout, self._buckets, self._ranks, self._start),
                (self._order, self._sorted, self._noted),
                self._sorter.keys, self._tests,
            )  # fmt: skip
            if found == -1:
                self._sorter.grow(8 * self._count)
            elif found < -1:
                self._start = np.zeros(lay_out(self._layout, hash_levels.SPREAD), dtype=np.int32)
        self.tests = int(self._tests[0])
        return self._sorter.sorted(found, self.top)

    def _find_in_box(self, x0: float, y0: float, x1: float, y1: float) -> Longs:
        if not self._lists.fresh:
            self._make_lists()
        ids = np.empty(self._count, dtype=np.int64)
        found = walk_lists(
            self.boxes, self._scales, self._list_layout, self._lists.heads, self._lists.nexts,
            (x0, y0, x1, y1), ids,
        )  # fmt: skip
        return np.sort(ids[:found], kind="stable")

    def memory(self) -> int:
        """Bytes in the arrays of tables, lists and boxes."""
        return super().memory() + self._lists.memory()

    def check(self) -> None:
        """Check the store, that each box fits into its level's cells, and every list."""
        super().check()
        for box in self.ids().tolist():
            level = self.level(box)
            scale = float(self._scales[level])
            x0, y0, x1, y1 = self.boxes[box].tolist()
            assert cell_at(x1, scale) - cell_at(x0, scale) <= 1, "no box reaches beyond the next column"
            assert cell_at(y1, scale) - cell_at(y0, scale) <= 1, "no box reaches beyond the next row"
            if self._lists.fresh:
                assert self._list_levels[box] == level, "each box is on its level"
        if self._lists.fresh:
            levels = self._list_levels[self.ids()]
            counts = np.bincount(levels, minlength=hash_levels.LEVELS)
            assert (self._list_layout[:, hash_levels.COUNT] == counts).all(), "each level counts its boxes"
            self._lists.check(self.ids(), self._bucket)
