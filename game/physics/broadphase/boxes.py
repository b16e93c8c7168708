"""Boxes with ids, and what every broad phase does with them: the store and the calls.

A box is axis-aligned and closed, ``[x0, x1] x [y0, y1]``: boxes that only touch overlap. Corners may be
infinite outwards (a floor without end) and a box may have no size; what is not a number is refused.

Ids are small integers. A new box gets the smallest free one, so which ids a sequence of calls gives depends
on nothing but the calls. An id of a removed box is used again.
"""

from __future__ import annotations

import heapq
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.arrays import Floats, Longs
from game.physics.broadphase.ordering import PairSorter
from game.physics.broadphase.validation import (
    MAX_BOXES,
    all_differ,
    corner,
    corners,
    first_bad_box,
    grown,
    id_array,
    store_boxes,
)


class BroadPhase:
    """Base of all broad phases: keeps boxes by id, checks what comes in, answers pairs and queries.

    A subclass overrides the methods that begin with an underscore. ``tests`` counts the box-box tests
    of the last ``pairs()``. ``boxes``: (capacity, 4) m, rows x0 y0 x1 y1, read only for others.
    """

    def __init__(self) -> None:
        self.boxes: Floats = np.zeros((16, 4))
        self.alive: NDArray[np.uint8] = np.zeros(16, dtype=np.uint8)
        self.top = 0  # all ids are below
        self.tests = 0
        self._count = 0
        self._free: list[int] = []  # heap of ids below top that are not in use
        self._sorter = PairSorter()
        self._found: Longs | None = None  # the answer of pairs() while nothing has changed

    def __len__(self) -> int:
        return self._count

    def __contains__(self, box: object) -> bool:
        return isinstance(box, (int, np.integer)) and bool(0 <= box < self.top and self.alive[box])

    def limit_pairs(self, most: int) -> None:
        """Make no space for more pairs, lest an answer take all memory: LimitError near it or beyond it.

        Afterwards the structure is of no more use.
        """
        self._sorter.most = most

    @property
    def capacity(self) -> int:
        """Number of ids for which arrays are kept."""
        return len(self.alive)

    def ids(self) -> Longs:
        """Ids in use, ascending."""
        return np.flatnonzero(self.alive[: self.top])

    def box(self, box: int) -> tuple[Floats, Floats]:
        """Lower and upper corner of a box, m; ValueError if there is none of that id."""
        self._known(box)
        return self.boxes[box, :2].copy(), self.boxes[box, 2:].copy()

    # -- single calls -------------------------------------------------------------------------------

    def add_box(self, lower: ArrayLike, upper: ArrayLike) -> int:
        """Add a box, corners (2,) m; returns its id. ValueError if lower is above upper or not a number."""
        x0, y0, x1, y1 = self._corners(lower, upper)
        box = self._take_ids(1)[0]
        self.boxes[box] = x0, y0, x1, y1
        self.alive[box] = 1
        self._count += 1
        self._found = None
        self._added(box)
        return box

    def remove_box(self, box: int) -> None:
        """Remove a box and its pairs; ValueError if there is none of that id."""
        self._known(box)
        self._found = None
        self._removed(int(box))
        self._release(int(box))

    def update_box(self, box: int, lower: ArrayLike, upper: ArrayLike) -> None:
        """Give a box other corners (2,) m; ValueError if there is none of that id or the corners are bad."""
        self._known(box)
        x0, y0, x1, y1 = self._corners(lower, upper)
        self._found = None
        self._moved(int(box), x0, y0, x1, y1)

    # -- bulk calls ---------------------------------------------------------------------------------

    def add_boxes(self, lowers: ArrayLike, uppers: ArrayLike, ids: ArrayLike | None = None) -> Longs:
        """Add many boxes, (n, 2) m each; returns their ids. All or none are added.

        ``ids``: the ids to give, distinct and free; without it the smallest free ones in order. ValueError,
        naming the first, for boxes or ids that make no sense.
        """
        low, high = self._many(lowers, uppers)
        bad = first_bad_box(low, high)
        if bad >= 0:
            raise ValueError(self._why(bad, low, high))
        chosen = np.array(
            self._take_ids(len(low)) if ids is None else self._claim(ids, len(low)), dtype=np.int64
        )
        self.boxes[chosen, :2] = low
        self.boxes[chosen, 2:] = high
        self.alive[chosen] = 1
        self._count += len(chosen)
        self._found = None
        self._added_many(chosen)
        return chosen

    def remove_boxes(self, ids: ArrayLike) -> None:
        """Remove many boxes, ids (n,), and their pairs; ValueError if an id is unknown or comes twice."""
        chosen = id_array(ids)
        for box in chosen.tolist():
            self._known(box)
        if not all_differ(chosen):
            raise ValueError("ids: a box cannot be removed twice")
        self._found = None
        self._removed_many(chosen)
        for box in chosen.tolist():
            self._release(box)

    def update_boxes(self, ids: ArrayLike, lowers: ArrayLike, uppers: ArrayLike) -> None:
        """Move or resize many boxes, (n, 2) m each, all or none; of a repeated id the last counts.

        ValueError if an id is unknown or corners are bad.
        """
        chosen = id_array(ids)
        low, high = self._many(lowers, uppers)
        if len(chosen) != len(low):
            raise ValueError(f"ids: {len(chosen)} ids for {len(low)} boxes")
        bad = store_boxes(self.boxes, self.alive, chosen, low, high)
        if bad >= 0:
            self._known(chosen[bad])
            raise ValueError(self._why(bad, low, high))
        self._found = None
        self._moved_many(chosen)

    # -- answers ------------------------------------------------------------------------------------

    def pairs(self) -> Longs:
        """All overlapping pairs, (m, 2), a < b in each row, rows sorted. The array is the caller's own."""
        if self._found is None:
            self._found = self._find_pairs()
        return self._found.copy()

    def query_box(self, lower: ArrayLike, upper: ArrayLike) -> Longs:
        """Ids (k,) of the boxes that overlap a closed box, ascending; its corners (2,) m.

        ValueError if the corners are bad.
        """
        return self._find_in_box(*self._corners(lower, upper))

    def query_point(self, point: ArrayLike) -> Longs:
        """Ids (k,) of the boxes that hold a point (2,) m, ascending; ValueError if it is no finite point."""
        x, y = corner(point, "point")
        if not (np.isfinite(x) and np.isfinite(y)):
            raise ValueError(f"point: expected finite numbers, not ({x}, {y})")
        return self._find_in_box(x, y, x, y)

    def partners(self, box: int) -> Longs:
        """Ids (k,) of the boxes that overlap this one, ascending; ValueError if there is none of that id."""
        self._known(box)
        x0, y0, x1, y1 = self.boxes[box].tolist()
        found = self._find_in_box(x0, y0, x1, y1)
        return found[found != box]

    def memory(self) -> int:
        """Bytes in the arrays of this structure, boxes included."""
        arrays = [value for value in vars(self).values() if isinstance(value, np.ndarray)]
        return sum(array.nbytes for array in arrays) + self._sorter.memory()

    def check(self) -> None:
        """Check the structure's own invariants; AssertionError says which one is broken."""
        live = self.alive[: self.top]
        assert int(live.sum()) == self._count, "as many ids are in use as boxes are counted"
        assert not self.alive[self.top :].any(), "no id at or above top is in use"
        assert sorted(self._free) == np.flatnonzero(live == 0).tolist(), (
            "the free list holds just the unused ids"
        )
        held = self.boxes[: self.top][live == 1]
        assert first_bad_box(held[:, :2].copy(), held[:, 2:].copy()) == -1, "every box in use is a box"

    # -- for subclasses -----------------------------------------------------------------------------

    def _store(self) -> tuple[Floats, NDArray[np.uint8], int]:
        """The plain tuple of a ``Store``."""
        return self.boxes, self.alive, self.top

    def _grow(self, capacity: int) -> None:
        """Make space for so many ids; subclasses grow their own arrays too."""
        self.boxes = grown(self.boxes, capacity)
        self.alive = grown(self.alive, capacity)

    def _added(self, box: int) -> None:
        """A box has been stored."""

    def _removed(self, box: int) -> None:
        """A box is about to go."""

    def _moved(self, box: int, x0: float, y0: float, x1: float, y1: float) -> None:
        """A box gets new corners; storing them is part of it."""
        self.boxes[box] = x0, y0, x1, y1

    def _added_many(self, ids: Longs) -> None:
        for box in ids.tolist():
            self._added(box)

    def _removed_many(self, ids: Longs) -> None:
        for box in ids.tolist():
            self._removed(box)

    def _moved_many(self, ids: Longs) -> None:
        """Boxes have been stored with new corners."""

    def _find_pairs(self) -> Longs:
        raise NotImplementedError

    def _find_in_box(self, x0: float, y0: float, x1: float, y1: float) -> Longs:
        raise NotImplementedError

    # -- what comes in ------------------------------------------------------------------------------

    def _known(self, box: Any) -> None:
        if box not in self:
            raise ValueError(f"id = {box!r}: there is no box of that id")

    @staticmethod
    def _corners(lower: ArrayLike, upper: ArrayLike) -> tuple[float, float, float, float]:
        x0, y0 = corner(lower, "lower")
        x1, y1 = corner(upper, "upper")
        if not (x0 <= x1 and y0 <= y1 and max(x0, y0) < np.inf and min(x1, y1) > -np.inf):
            raise ValueError(f"box: expected numbers, and lower ({x0}, {y0}) not above upper ({x1}, {y1})")
        return x0, y0, x1, y1

    @staticmethod
    def _many(lowers: ArrayLike, uppers: ArrayLike) -> tuple[Floats, Floats]:
        low, high = corners(lowers, "lowers"), corners(uppers, "uppers")
        if len(low) != len(high):
            raise ValueError(f"lowers, uppers: {len(low)} lower corners for {len(high)} upper ones")
        return low, high

    @staticmethod
    def _why(index: int, low: Floats, high: Floats) -> str:
        a, b = tuple(low[index].tolist()), tuple(high[index].tolist())
        return f"box {index}: expected numbers, and lower {a} not above upper {b}"

    def _take_ids(self, count: int) -> list[int]:
        """The smallest free ids, ascending; arrays grow as needed."""
        fresh = max(count - len(self._free), 0)
        self._make_room(self.top + fresh)
        taken = [heapq.heappop(self._free) for _ in range(count - fresh)]
        taken += range(self.top, self.top + fresh)
        self.top += fresh
        return taken

    def _claim(self, ids: ArrayLike, count: int) -> Longs:
        """Take ids that the caller names."""
        chosen = id_array(ids)
        if len(chosen) != count:
            raise ValueError(f"ids: {len(chosen)} ids for {count} boxes")
        if count == 0:
            return chosen
        if chosen.min() < 0 or chosen.max() >= MAX_BOXES or not all_differ(chosen):
            raise ValueError(f"ids: expected distinct ids from 0 to {MAX_BOXES - 1}")
        known = chosen[chosen < self.top]
        used = known[self.alive[known] == 1]
        if len(used):
            raise ValueError(f"ids: {used[0]} is in use")
        self._make_room(int(chosen.max()) + 1)
        self.top = max(self.top, int(chosen.max()) + 1)
        unused = self.alive[: self.top] == 0
        unused[chosen] = False
        self._free = np.flatnonzero(unused).tolist()  # ascending, so it is a heap
        return chosen

    def _make_room(self, needed: int) -> None:
        if needed > MAX_BOXES:
            raise ValueError(f"boxes: more than {MAX_BOXES} are not to be had")
        if needed > self.capacity:
            self._grow(max(needed, 2 * self.capacity))

    def _release(self, box: int) -> None:
        self.alive[box] = 0
        self._count -= 1
        heapq.heappush(self._free, box)
