"""Pair managers: which pairs overlap now, which began and which ended since one last asked.

``MatrixPairs``  finds a pair through a full triangular matrix over all ids
``HashedPairs``  finds it through a hash table

Both keep the pairs in a list beside that, see ``pair_table``; their answers and events are the same.

Events are net. A pair that begins and ends between two calls of ``take_events`` gives none; nor does one
that ends and begins again.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.arrays import Longs
from game.physics.broadphase import pair_table
from game.physics.broadphase.ordering import PairSorter
from game.physics.broadphase.pair_table import (
    PairTable,
    change_pairs,
    cut_box,
    cut_pair,
    cut_pairs,
    find_place,
    first_bad_pair,
    hash_pair,
    index_all,
    list_pairs,
    put_pair,
    put_pairs,
    settle,
    sum_of_probes,
    sweep_unkept,
    triangular_index,
)
from game.physics.broadphase.validation import grown

MAX_MATRIX_BYTES = 1 << 30  # 23 170 boxes
PROBED = 4096  # pairs


class PairEvents(NamedTuple):
    """Pairs that began and that ended, (k, 2) each, a < b, sorted."""

    begun: Longs
    ended: Longs


class PairManager:
    """Base of both managers: pairs in a dense list, found through an index.

    ``table`` holds the arrays, for kernels; ``where`` (slots,) is its empty index, ``rows`` the side of a
    matrix or 0. Ids run from ``least`` to ``greatest``.
    """

    def __init__(self, where: NDArray[np.int32], rows: int, least: int, greatest: int):
        numbers = np.array([rows, len(where) - 1, 0, 0, 0, 0], dtype=np.int64)
        self.table = PairTable(where, np.zeros((16, 4), dtype=np.int32), numbers)
        self.least = least
        self.greatest = greatest
        self._sorter = PairSorter()

    def __len__(self) -> int:
        return int(self.table.numbers[pair_table.PRESENT])

    def __contains__(self, pair: object) -> bool:
        try:
            a, b = self._pair(*pair)  # type: ignore[misc]
        except (TypeError, ValueError):
            return False
        slot = self.table.where[find_place(*self.table, a, b)] - 1
        return bool(slot >= 0 and self.table.slots[slot, pair_table.FLAGS] & pair_table.NOW)

    def add(self, a: int, b: int) -> bool:
        """Note that a and b overlap; True if that is new. ValueError if they are one box, or no ids."""
        low, high = self._pair(a, b)
        done = put_pair(*self.table, low, high)
        if done < 0:
            self.make_room()
            done = put_pair(*self.table, low, high)
        return done == 1

    def remove(self, a: int, b: int) -> bool:
        """Note that a and b overlap no more; True if they did. ValueError if they are one box, or no ids."""
        return cut_pair(*self.table, *self._pair(a, b)) == 1

    def add_pairs(self, pairs: ArrayLike) -> None:
        """Add many pairs, (m, 2), either order; none, and ValueError, if one of them is no pair."""
        self._put(self._pairs(pairs), 0)

    def remove_pairs(self, pairs: ArrayLike) -> None:
        """Remove many pairs, (m, 2), either order; none, and ValueError, if one of them is no pair."""
        cut_pairs(*self.table, self._pairs(pairs))

    def set_pairs(self, pairs: ArrayLike) -> None:
        """Make these the pairs that overlap, (m, 2), as a broad phase lists them once a step."""
        self._put(self._pairs(pairs), pair_table.KEEP)
        sweep_unkept(*self.table)

    def change_pairs(self, changes: NDArray[np.int64], count: int) -> None:
        """Add and remove the first ``count`` pairs of changes (k,), as the kernel ``change_pairs`` has them.

        The caller vouches for the ids.
        """
        done = 0
        while (done := change_pairs(*self.table, changes, count, done)) < count:
            self.make_room()

    def remove_box(self, box: int) -> None:
        """Remove all pairs of a box; costs the number of all pairs."""
        cut_box(*self.table, box)

    def clear(self) -> None:
        """Remove all pairs; costs their number, and not the size of the index."""
        self.set_pairs(np.empty((0, 2), dtype=np.int64))

    def pairs(self) -> Longs:
        """All pairs that overlap, (m, 2), a < b, sorted."""
        return self._listed(pair_table.NOW, 0)

    def take_events(self) -> PairEvents:
        """Pairs begun and ended since the last call."""
        events = PairEvents(
            self._listed(pair_table.NOW, pair_table.BEFORE), self._listed(pair_table.BEFORE, pair_table.NOW)
        )
        settle(*self.table)
        return events

    def memory(self) -> int:
        """Bytes in the arrays of index and list; of a matrix, what it takes once every part was touched."""
        return sum(array.nbytes for array in self.table)

    def check(self) -> None:
        """Check that list and index agree; AssertionError says how they do not."""
        where, slots, numbers = self.table
        used = slots[: int(numbers[pair_table.SLOTS])]
        assert (used[:, pair_table.FIRST] < used[:, pair_table.SECOND]).all(), (
            "in each pair the first id is the smaller"
        )
        assert np.count_nonzero(used[:, pair_table.FLAGS] & pair_table.NOW) == len(self), (
            "as many pairs are present as counted"
        )
        assert np.isin(
            used[:, pair_table.FLAGS], (pair_table.NOW, pair_table.BEFORE, pair_table.NOW | pair_table.BEFORE)
        ).all(), "no slot is marked or idle"
        assert np.count_nonzero(where) == len(used), "the index holds as many places as there are slots"
        for slot, (a, b, _, hashed) in enumerate(used.tolist()):
            assert where[find_place(where, slots, numbers, a, b)] == slot + 1, (
                "each pair is found where it is"
            )
            assert hashed == (0 if numbers[pair_table.ROWS] else hash_pair(a, b)), "each pair keeps its hash"

    def limit_pairs(self, most: int) -> None:
        """Make no space for more pairs, those that just ended included: LimitError beyond it."""
        self._sorter.most = most

    def make_room(self) -> None:
        """Double the list; a hash table is doubled with it."""
        self._sorter.check(len(self.table.slots) + 1)
        self.table = self.table._replace(slots=grown(self.table.slots, 2 * len(self.table.slots)))

    def _put(self, pairs: Longs, mark: int) -> None:
        done = 0
        while (done := put_pairs(*self.table, pairs, done, mark)) < len(pairs):
            self.make_room()

    def _listed(self, wanted: int, unwanted: int) -> Longs:
        self._sorter.reserve(int(self.table.numbers[pair_table.SLOTS]))
        count = list_pairs(self.table.slots, self.table.numbers, self._sorter.keys, wanted, unwanted)
        if (
            self.table.numbers[pair_table.LEAST] < 0
        ):  # keys of negative ids are not in the order of the digits
            keys = self._sorter.keys[:count]
            pairs = np.stack([keys >> 32, (keys & pair_table.ID_FIELD).astype(np.int32)], axis=1)
            return pairs[np.lexsort((pairs[:, 1], pairs[:, 0]))]
        return self._sorter.sorted(count, int(self.table.numbers[pair_table.GREATEST]) + 1).copy()

    def _pair(self, a: Any, b: Any) -> tuple[int, int]:
        for box in (a, b):
            if not isinstance(box, (int, np.integer)) or isinstance(box, bool):
                raise ValueError(f"pair ({a!r}, {b!r}): expected two integers")
            if not self.least <= box <= self.greatest:
                raise ValueError(f"pair ({a}, {b}): expected ids from {self.least} to {self.greatest}")
        if a == b:
            raise ValueError(f"pair ({a}, {b}): a box makes no pair with itself")
        return (int(a), int(b)) if a < b else (int(b), int(a))

    def _pairs(self, pairs: ArrayLike) -> Longs:
        given = pairs
        if not (type(given) is np.ndarray and given.dtype == np.int64 and given.flags.carray):
            given = np.array(given, order="C")
            if given.size == 0:
                return np.empty((0, 2), dtype=np.int64)
            if given.dtype.kind not in "iu":
                raise ValueError(f"pairs: expected integers, not {given.dtype}")
            given = given.astype(np.int64)
        if given.ndim != 2 or given.shape[1] != 2:
            raise ValueError(f"pairs: expected shape (m, 2), not {given.shape}")
        bad = first_bad_pair(given, self.least, self.greatest)
        if bad >= 0:
            self._pair(*given[bad].tolist())
        return given


class MatrixPairs(PairManager):
    """Pairs indexed by a full triangular matrix over ids 0 to ``capacity`` - 1.

    ValueError if ``capacity`` is below 2 or the matrix would take more than 1 GiB (23 170 boxes). The
    memory is taken from the system as it is touched.
    """

    def __init__(self, capacity: int):
        if not isinstance(capacity, (int, np.integer)) or capacity < 2:
            raise ValueError(f"capacity = {capacity!r}: expected an integer of at least 2")
        size = int(capacity) * (int(capacity) - 1) // 2
        if 4 * size > MAX_MATRIX_BYTES:
            raise ValueError(
                f"capacity = {capacity}: the matrix would take {4 * size / 2**30:.1f} GiB, at most 1"
            )
        super().__init__(np.zeros(size, dtype=np.int32), int(capacity), 0, int(capacity) - 1)

    @property
    def capacity(self) -> int:
        """Number of ids that the matrix has rows for."""
        return int(self.table.numbers[pair_table.ROWS])

    def place(self, a: int, b: int) -> int:
        """Place of a pair in the triangle, row by row; ValueError if a and b are no ids of it."""
        return int(triangular_index(*self._pair(a, b), self.capacity))


class HashedPairs(PairManager):
    """Pairs indexed by a hash table, at most half full; any 32 bit ids, negative ones too."""

    def __init__(self) -> None:
        super().__init__(np.zeros(32, dtype=np.int32), 0, -pair_table.MAX_ID, pair_table.MAX_ID)

    def probes(self) -> float:
        """Mean number of places looked at to find a pair: 1 at best, 1.5 for random keys at half load.

        A mean over the pairs in the first slots, at most 4096.
        """
        count = min(int(self.table.numbers[pair_table.SLOTS]), PROBED)
        return sum_of_probes(*self.table, count) / count if count else 0.0

    def chain(self, a: int, b: int) -> tuple[int, ...]:
        """The places looked at, in order, to find a pair, or to find that it is not there.

        ValueError if a and b make no pair.
        """
        low, high = self._pair(a, b)
        mask = int(self.table.numbers[pair_table.MASK])
        home = int(hash_pair(low, high)) & mask
        last = int(find_place(*self.table, low, high))
        return tuple((home + i) & mask for i in range(((last - home) & mask) + 1))

    def make_room(self) -> None:
        """Double list and table, and enter every pair again."""
        super().make_room()
        size = 2 * len(self.table.where)
        self.table.numbers[pair_table.MASK] = size - 1
        self.table = self.table._replace(where=np.zeros(size, dtype=np.int32))
        index_all(*self.table)
