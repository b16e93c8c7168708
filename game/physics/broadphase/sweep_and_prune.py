"""Incremental sweep and prune on two axes: the order of end points is kept from step to step.

Boxes that moved a little are put in order by few swaps, and a pair can only begin or end where two end
points swap. So the cost follows the motion: nearly nothing for boxes at rest, n^2 for boxes that all jump.
When the swaps of a step grow dearer than sorting again, the rest is left: both axes are merge sorted and
one sweep along the axis with fewer overlaps finds all pairs. The step after such a one is sorted at once,
without swaps being tried, until the swaps that this spares are few again.

Sources: Baraff, Dynamic Simulation of Non-Penetrating Rigid Bodies (1992); Cohen, Lin, Manocha and
Ponamgi, I-COLLIDE (1995); Ericson, Real-Time Collision Detection (2005), 7.5.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.arrays import Longs
from game.compiler.decorator import kernel
from game.physics.broadphase import endpoints
from game.physics.broadphase.boxes import BroadPhase
from game.physics.broadphase.endpoints import (
    find_end_point,
    insertion_sort,
    keep_alive,
    merge_sort,
    open_gap,
    overlaps_on_axis,
    read_axis,
    scan_end_points,
    shift_end_point,
    sweep,
)
from game.physics.broadphase.pair_table import cut_gone
from game.physics.broadphase.pairs import HashedPairs, PairManager
from game.physics.broadphase.validation import first_bad_box, grown, id_array

FEW = 16  # fewer than one in so many boxes moved: they are moved one by one
MOST_SWAPS = 4_000_000  # tried in a step that is not to be sorted again: some 0.05 s
MOST_CHANGES = 1 << 20  # noted before they are handed to the pair manager
# Relative costs, measured: one swap of insertion, one comparison of merge sort, one test of a sweep.
SWAP_COST, MERGE_COST, TEST_COST = 8.0, 3.0, 1.0


@kernel(_nrt=False)
def sort_axes(boxes, values, codes, count, progress, limit, changes):
    """Read the boxes' new coordinates and sort both axes by insertion, noting the pairs that change.

    ``values``: (2, capacity) m, ``codes``: (2, capacity), both written. ``progress``: (4,) axis, where on it,
    swaps so far, changes noted in ``changes``; written, zeros to begin with. Returns SORTED, or FULL or
    TOO_MANY: calling again goes on.
    """
    while progress[0] < 2:
        axis = progress[0]
        if progress[1] == 0:
            read_axis(boxes, axis, values[axis], codes[axis], count)
        ended, place, swaps, changed = insertion_sort(
            boxes, values[axis], codes[axis], count, progress[1], limit - progress[2], changes, progress[3]
        )
        progress[1] = place
        progress[2] += swaps
        progress[3] = changed
        if ended != endpoints.SORTED:
            return ended
        progress[0] = axis + 1
        progress[1] = 0
    return endpoints.SORTED


def comparisons(count: int) -> int:
    """What merge sort takes at most to put so many end points in order."""
    return count * max(count.bit_length(), 1)


class SweepAndPrune(BroadPhase):
    """Keeps the boxes' end points sorted on both axes, and the pairs in a pair manager.

    ``manager``: where pairs are kept and events are taken from; a new ``HashedPairs`` if none is given.
    ValueError unless it is empty. ``resort``: whether a step is finished by sorting again where that is
    cheaper. Without it that is done after MOST_SWAPS only, as n boxes that leap stand for n² swaps. ``swaps``
    counts all swaps so far (those that sorting again spared, too), ``resorts`` how often that was done.
    """

    def __init__(self, manager: PairManager | None = None, resort: bool = True):
        super().__init__()
        self.manager = HashedPairs() if manager is None else manager
        if len(self.manager):
            raise ValueError("manager: expected an empty pair manager")
        self.resort = resort
        self.swaps = 0
        self.resorts = 0
        self._leaping = False  # the last step would have been dearer by swaps: the next one is sorted at once
        self._values: NDArray[np.float64] = np.zeros((2, 2 * self.capacity))
        self._codes: NDArray[np.int32] = np.zeros((2, 2 * self.capacity), dtype=np.int32)
        self._progress = np.zeros(4, dtype=np.int64)
        self._changes: NDArray[np.int64] = np.empty(1024, dtype=np.int64)

    def use_manager(self, manager: PairManager) -> None:
        """Keep the pairs in another manager, to which they go without events; ValueError if it is in use."""
        if len(manager) or manager.greatest < self.top - 1:
            raise ValueError(f"manager: expected an empty pair manager for {self.top} ids")
        manager.set_pairs(self.manager.pairs())
        manager.take_events()
        self.manager = manager

    def end_points(self, axis: int) -> tuple[NDArray[np.float64], NDArray[np.int64], NDArray[np.bool_]]:
        """Sorted end points of an axis: coordinates in m, ids, and whether each is an upper end."""
        codes = self._codes[axis, : 2 * len(self)]
        return (
            self._values[axis, : 2 * len(self)].copy(),
            (codes & endpoints.ID).astype(np.int64),
            codes >= endpoints.UPPER,
        )

    def update_boxes(self, ids: ArrayLike, lowers: ArrayLike, uppers: ArrayLike) -> None:
        """As for every broad phase, ValueError included; where few move, each is moved by itself."""
        chosen = id_array(ids)
        if FEW * len(chosen) >= len(self):
            super().update_boxes(chosen, lowers, uppers)
            return
        low, high = self._many(lowers, uppers)
        if len(chosen) != len(low):
            raise ValueError(f"ids: {len(chosen)} ids for {len(low)} boxes")
        for box in chosen.tolist():
            self._known(box)
        bad = first_bad_box(low, high)
        if bad >= 0:
            raise ValueError(self._why(bad, low, high))
        self._found = None
        for box, lower, upper in zip(chosen.tolist(), low.tolist(), high.tolist(), strict=True):
            self._moved(box, *lower, *upper)

    def _make_room(self, needed: int) -> None:
        if needed > self.manager.greatest + 1:
            raise ValueError(f"boxes: the pair manager takes at most {self.manager.greatest + 1} ids")
        super()._make_room(needed)

    def _grow(self, capacity: int) -> None:
        super()._grow(capacity)
        self._values = np.stack([grown(row, 2 * capacity) for row in self._values])
        self._codes = np.stack([grown(row, 2 * capacity) for row in self._codes])

    def _added(self, box: int) -> None:
        count = 2 * (len(self) - 1)
        for axis in range(2):
            values, codes = self._values[axis], self._codes[axis]
            for code, place in ((box, axis), (box | endpoints.UPPER, axis + 2)):
                value = float(self.boxes[box, place])
                open_gap(values, codes, count, find_end_point(values, codes, count, value, code), value, code)
                count += 1
            count -= 2
        others = self.partners(box)
        self.manager.add_pairs(np.stack([np.full(len(others), box), others], axis=1))

    def limit_pairs(self, most: int) -> None:
        super().limit_pairs(most)
        self.manager.limit_pairs(2 * most)  # those that ended are in its list, too, until they are asked for

    def _added_many(self, ids: Longs) -> None:
        count = 2 * (len(self) - len(ids))
        for axis in range(2):
            self._codes[axis, count : count + len(ids)] = ids
            self._codes[axis, count + len(ids) : count + 2 * len(ids)] = ids | endpoints.UPPER
        self._sort_again()

    def _removed(self, box: int) -> None:
        self._removed_many(np.array([box]))

    def _removed_many(self, ids: Longs) -> None:
        self.alive[ids] = 0
        for axis in range(2):
            keep_alive(self._values[axis], self._codes[axis], 2 * len(self), self.alive)
        cut_gone(*self.manager.table, self.alive)

    def _moved(self, box: int, x0: float, y0: float, x1: float, y1: float) -> None:
        before, after = self.boxes[box].tolist(), (x0, y0, x1, y1)
        super()._moved(box, x0, y0, x1, y1)
        count = 2 * len(self)
        if len(self._changes) < 4 * count:
            self._changes = np.empty(8 * count, dtype=np.int64)
        changed = 0
        for axis in range(2):
            values, codes = self._values[axis], self._codes[axis]
            ends = [(axis, box), (axis + 2, box | endpoints.UPPER)]
            if after[axis + 2] > before[axis + 2]:
                ends.reverse()  # the end that leads goes first, so the two never pass each other
            for place, code in ends:
                i = find_end_point(values, codes, count, before[place], code)
                swaps, changed = shift_end_point(
                    self.boxes, values, codes, count, i, after[place], self._changes, changed
                )
                self.swaps += swaps
        self.manager.change_pairs(self._changes, changed)

    def _moved_many(self, ids: Longs) -> None:
        before = self.swaps
        if self._leaping or not self._sort_by_swaps():
            self.resorts += 1
            self.swaps += self._sort_again()
            enough = self._dear(self.tests) if self.resort else MOST_SWAPS
            self._leaping = self.swaps - before > enough

    def _sort_by_swaps(self) -> bool:
        """Put both axes in order by swaps while they are cheaper than sorting again; whether they were.

        Without ``resort`` that is never asked, but MOST_SWAPS end it all the same.
        """
        self._progress[:] = 0
        count = 2 * len(self)
        limit = comparisons(count) if self.resort else MOST_SWAPS
        estimated = not self.resort
        while True:
            ended = sort_axes(
                self.boxes, self._values, self._codes, count, self._progress, limit, self._changes
            )
            self.manager.change_pairs(self._changes, int(self._progress[3]))
            self._progress[3] = 0
            if ended == endpoints.FULL:
                self._reserve(2 * len(self._changes))
            elif ended == endpoints.TOO_MANY and not estimated:
                limit = self._dear(min(overlaps_on_axis(codes, count) for codes in self._codes))
                estimated = True
            else:
                break
        self.swaps += int(self._progress[2])
        return bool(ended == endpoints.SORTED)

    def _dear(self, tests: int) -> int:
        """Swaps that cost as much as sorting again and a sweep with so many tests."""
        merging = 2 * MERGE_COST * comparisons(2 * len(self))
        return int((merging + TEST_COST * max(tests, 0)) / SWAP_COST)

    def _reserve(self, room: int) -> None:
        """Make space to note changes; beyond MOST_CHANGES they are rather handed on more often."""
        if len(self._changes) < min(room, MOST_CHANGES):
            self._changes = np.empty(room, dtype=np.int64)

    def _sort_again(self) -> int:
        """Sort both axes and find all pairs by one sweep; returns the swaps that this stands for."""
        count = 2 * len(self)
        spare_values, spare_codes = np.empty(count), np.empty(count, dtype=np.int32)
        inversions = 0
        for axis in range(2):
            read_axis(self.boxes, axis, self._values[axis], self._codes[axis], count)
            inversions += merge_sort(self._values[axis], self._codes[axis], count, spare_values, spare_codes)
        tests = [overlaps_on_axis(codes, count) for codes in self._codes]
        axis = 0 if tests[0] <= tests[1] else 1
        active, places = np.empty(len(self), dtype=np.int64), np.empty(self.capacity, dtype=np.int64)
        extents = spare_values.reshape(-1, 2)
        while (
            found := sweep(
                self.boxes, axis, self._codes[axis], count, active, places, extents, self._sorter.keys
            )
        ) < 0:
            self._sorter.grow(4 * len(self))
        self.tests = min(tests)
        self.manager.set_pairs(self._sorter.sorted(found, self.top))
        return inversions

    def _find_pairs(self) -> Longs:
        return self.manager.pairs()

    def _find_in_box(self, x0: float, y0: float, x1: float, y1: float) -> Longs:
        count = 2 * len(self)
        runs = []
        for axis, low, high in ((0, x0, x1), (1, y0, y1)):
            values, codes = self._values[axis], self._codes[axis]
            runs.append((find_end_point(values, codes, count, high, endpoints.UPPER), axis, False))
            runs.append((count - find_end_point(values, codes, count, low, endpoints.UPPER), axis, True))
        length, axis, upper = min(runs)
        begin, end = (count - length, count) if upper else (0, length)
        ids = np.empty(length, dtype=np.int64)
        found = scan_end_points(self.boxes, self._codes[axis], begin, end, upper, (x0, y0, x1, y1), ids)
        return np.sort(ids[:found], kind="stable")

    def memory(self) -> int:
        """Bytes in the arrays of end points, boxes and pairs."""
        return super().memory() + self.manager.memory()

    def check(self) -> None:
        """Check store, order of end points on both axes, and that the pairs kept do overlap."""
        super().check()
        self.manager.check()
        for axis in range(2):
            values, ids, upper = self.end_points(axis)
            codes = self._codes[axis, : len(values)]
            later = (values[1:] > values[:-1]) | ((values[1:] == values[:-1]) & (codes[1:] > codes[:-1]))
            assert later.all(), "each axis is sorted"
            assert (self.boxes[ids, axis + 2 * upper] == values).all(), "end points are where the boxes end"
            assert (np.bincount(ids, minlength=self.top) == 2 * self.alive[: self.top]).all(), (
                "two ends a box"
            )
            first = np.full(self.top, -1)
            first[ids[~upper]] = np.flatnonzero(~upper)
            assert (first[ids[upper]] < np.flatnonzero(upper)).all(), (
                "each lower end comes before its upper one"
            )
        a, b = self.manager.pairs().T
        apart = (self.boxes[a, :2] > self.boxes[b, 2:]) | (self.boxes[b, :2] > self.boxes[a, 2:])
        assert not apart.any(), "the pairs kept overlap"
