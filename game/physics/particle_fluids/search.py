"""Which particles are nearer than a support: cells of its size, particles sorted by cell, each pair once.

Three ways to the same pairs:

- "grid": counting sort by the row-major number of the cell. The cells to the right and the three above are
  then two stretches of one list.
- "z-order": cells are numbered along Morton's curve, and keys are sorted by digits. The neighbours of a cell
  are looked up once for all particles in it, among the cells that are not empty (Onderik and Ďurikovič 2007).
- "hash": cells share slots of a table, and particles are sorted by slot (Teschner and others 2003, as in
  `game.physics.deformables.hashing`).
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats, Longs
from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.deformables.hashing import cell_at, slot_of

SEARCHES = ("grid", "z-order", "hash")
MOST_CELLS = 1 << 20
DIGIT, DIGITS = 11, 3  # bits of a digit of a key, digits
FARTHEST = 65_535  # cell of Morton's curve


class Pairs(NamedTuple):
    """Pairs by their first particle, in sorted order: those of i stand from start[i] to start[i + 1].

    start (n + 1,), other (m,): the second particle; gap (m,) m; unit (m, 2): direction from second to first.
    """

    start: Longs
    other: Longs
    gap: Floats
    unit: Floats


@inner_kernel
def keep(pairs, place, i, j, square, made):
    """Take a pair down if it is near enough and there is room; returns how many there are."""
    dx, dy = place[i, 0] - place[j, 0], place[i, 1] - place[j, 1]
    found = dx * dx + dy * dy
    if not found < square:
        return made
    if made < len(pairs.other):
        gap = math.sqrt(found)
        pairs.other[made] = j
        pairs.gap[made] = gap
        if gap > 1e-150:
            pairs.unit[made, 0], pairs.unit[made, 1] = dx / gap, dy / gap
        else:
            pairs.unit[made, 0], pairs.unit[made, 1] = 1.0, 0.0
    return made + 1


@inner_kernel
def column(x, low, scale, count):
    """Number of a cell along one axis; what lies outside counts to the last."""
    return np.int64(min(max(math.floor((x - low) * scale), 0.0), count - 1.0))


@lean_kernel
def sort_grid(place, grid, starts, order):
    """Counting sort. grid: (low x, low y, 1/cell, nx, ny); starts: (nx ny + 1,); order: (n,)."""
    low_x, low_y, scale, nx, ny = grid
    starts[:] = 0
    for i in range(len(place)):
        starts[column(place[i, 1], low_y, scale, ny) * nx + column(place[i, 0], low_x, scale, nx) + 1] += 1
    for c in range(1, len(starts)):
        starts[c] += starts[c - 1]
    for i in range(len(place) - 1, -1, -1):
        c = column(place[i, 1], low_y, scale, ny) * nx + column(place[i, 0], low_x, scale, nx)
        starts[c + 1] -= 1
        order[starts[c + 1]] = i


@lean_kernel
def pairs_of_grid(place, grid, starts, support, pairs):
    """Pairs of sorted places; starts[c + 1] is the first of cell c. Returns how many there are."""
    low_x, low_y, scale, nx, ny = grid
    square, made, count = support * support, 0, len(place)
    cells = nx * ny
    for i in range(count):
        pairs.start[i] = made
        x, y = column(place[i, 0], low_x, scale, nx), column(place[i, 1], low_y, scale, ny)
        c = y * nx + x
        last = c + min(1, nx - 1 - x)
        for j in range(i + 1, starts[last + 2] if last + 1 < cells else count):
            made = keep(pairs, place, i, j, square, made)
        if y + 1 < ny:
            first, last = c + nx - min(1, x), c + nx + min(1, nx - 1 - x)
            for j in range(starts[first + 1], starts[last + 2] if last + 1 < cells else count):
                made = keep(pairs, place, i, j, square, made)
    pairs.start[count] = made
    return made


@inner_kernel
def spread_bits(x):
    """A number of 16 bits with a zero before each."""
    x = (x | (x << 8)) & 0x00FF00FF
    x = (x | (x << 4)) & 0x0F0F0F0F
    x = (x | (x << 2)) & 0x33333333
    return (x | (x << 1)) & 0x55555555


@inner_kernel
def morton(x, y):
    """Number of a cell along the curve."""
    return spread_bits(x) | (spread_bits(y) << 1)


@lean_kernel
def sort_z(place, grid, keys, order, work, digits):
    """Sort by Morton's number, digit by digit. keys, order: (n,); work: (2, n); digits: (2 ** DIGIT + 1,)."""
    low_x, low_y, scale, nx, ny = grid
    count = len(place)
    for i in range(count):
        keys[i] = morton(column(place[i, 0], low_x, scale, nx), column(place[i, 1], low_y, scale, ny))
        order[i] = i
    for turn in range(DIGITS):
        shift, mask = DIGIT * turn, (1 << DIGIT) - 1
        digits[:] = 0
        for i in range(count):
            digits[((keys[i] >> shift) & mask) + 1] += 1
        for d in range(1, len(digits)):
            digits[d] += digits[d - 1]
        for i in range(count):
            digit = (keys[i] >> shift) & mask
            work[0, digits[digit]], work[1, digits[digit]] = keys[i], order[i]
            digits[digit] += 1
        for i in range(count):
            keys[i], order[i] = work[0, i], work[1, i]


@inner_kernel
def cell_of_key(cells, count, key):
    """Which of the sorted cells (columns: key, first particle) has a key; -1 for none."""
    low, high = 0, count
    while low < high:
        middle = (low + high) // 2
        if cells[middle, 0] < key:
            low = middle + 1
        else:
            high = middle
    return low if low < count and cells[low, 0] == key else -1


@lean_kernel
def pairs_of_keys(place, grid, keys, support, pairs, cells):
    """Pairs of places sorted by key; cells: (n + 1, 2) for those that are not empty. Returns how many."""
    low_x, low_y, scale, nx, ny = grid
    count, square, made, full = len(place), support * support, 0, 0
    for i in range(count):
        if i == 0 or keys[i] != keys[i - 1]:
            cells[full, 0], cells[full, 1] = keys[i], i
            full += 1
    cells[full, 1] = count
    for c in range(full):
        first, last = cells[c, 1], cells[c + 1, 1]
        x = column(place[first, 0], low_x, scale, nx)
        y = column(place[first, 1], low_y, scale, ny)
        near = (-1, -1, -1, -1)
        if x + 1 < nx:
            near = (cell_of_key(cells, full, morton(x + 1, y)), -1, -1, -1)
        if y + 1 < ny:
            left = cell_of_key(cells, full, morton(x - 1, y + 1)) if x > 0 else -1
            right = cell_of_key(cells, full, morton(x + 1, y + 1)) if x + 1 < nx else -1
            near = (near[0], left, cell_of_key(cells, full, morton(x, y + 1)), right)
        for i in range(first, last):
            pairs.start[i] = made
            for j in range(i + 1, last):
                made = keep(pairs, place, i, j, square, made)
            for k in range(4):
                if near[k] >= 0:
                    for j in range(cells[near[k], 1], cells[near[k] + 1, 1]):
                        made = keep(pairs, place, i, j, square, made)
    pairs.start[count] = made
    return made


@lean_kernel
def sort_hash(place, scale, starts, order):
    """Counting sort by the slot of each particle's cell; starts: (slots + 1,)."""
    size = len(starts) - 1
    starts[:] = 0
    for i in range(len(place)):
        starts[slot_of(cell_at(place[i, 0], scale), cell_at(place[i, 1], scale), size) + 1] += 1
    for c in range(1, len(starts)):
        starts[c] += starts[c - 1]
    for i in range(len(place) - 1, -1, -1):
        slot = slot_of(cell_at(place[i, 0], scale), cell_at(place[i, 1], scale), size)
        starts[slot + 1] -= 1
        order[starts[slot + 1]] = i


@lean_kernel
def pairs_of_slots(place, scale, starts, support, pairs):
    """Pairs of places sorted by slot; particles of other cells in a slot are passed over."""
    size, count = len(starts) - 1, len(place)
    square, made = support * support, 0
    for i in range(count):
        pairs.start[i] = made
        x, y = cell_at(place[i, 0], scale), cell_at(place[i, 1], scale)
        for k in range(5):
            cx = x + (0, 1, -1, 0, 1)[k]
            cy = y + (0, 0, 1, 1, 1)[k]
            slot = slot_of(cx, cy, size)
            for j in range(starts[slot + 1], starts[slot + 2] if slot + 1 < size else count):
                if k == 0 and j <= i:
                    continue
                if cell_at(place[j, 0], scale) == cx and cell_at(place[j, 1], scale) == cy:
                    made = keep(pairs, place, i, j, square, made)
    pairs.start[count] = made
    return made


@lean_kernel
def gather(order, source, target):
    """target[i] = source[order[i]], tables (n, 2)."""
    for i in range(len(order)):
        target[i, 0] = source[order[i], 0]
        target[i, 1] = source[order[i], 1]


class NeighbourSearch:
    """Finds the pairs of points nearer than ``support`` (m). It keeps its arrays from step to step."""

    def __init__(self, support: float, method: str = "grid"):
        """ValueError for a support that is no length above 0, or a method not in ``SEARCHES``."""
        if not 0.0 < support < math.inf or not 0.0 < 1.0 / support < math.inf:
            raise ValueError(f"support = {support!r}: expected a length above 0 m")
        if method not in SEARCHES:
            raise ValueError(f"method = {method!r}: expected one of {', '.join(SEARCHES)}")
        self.support, self.method = float(support), method
        self._starts: Longs = np.zeros(2, dtype=np.int64)
        self._digits: Longs = np.zeros((1 << DIGIT) + 1, dtype=np.int64)
        self._resize(0, 64)

    def _resize(self, count: int, room: int) -> None:
        self.order: Longs = np.zeros(count, dtype=np.int64)
        self.place: Floats = np.zeros((count, 2))
        self._keys: Longs = np.zeros(count, dtype=np.int64)
        self._work: Longs = np.zeros((2, count), dtype=np.int64)
        self._cells: Longs = np.zeros((count + 1, 2), dtype=np.int64)
        self._make_room(count, room)

    def _make_room(self, count: int, room: int) -> None:
        self.pairs = Pairs(
            np.zeros(count + 1, dtype=np.int64), np.zeros(room, dtype=np.int64), np.zeros(room),
            np.zeros((room, 2)),
        )  # fmt: skip

    def _grid(self, place: Floats) -> tuple[float, float, float, int, int]:
        low, high = place.min(axis=0), place.max(axis=0)
        scale = 1.0 / self.support
        most = (
            FARTHEST + 1
            if self.method == "z-order"
            else int(math.sqrt(min(64 * len(place) + 4096, MOST_CELLS)))
        )
        across = [int(min(max((high[k] - low[k]) * scale, 0.0) + 1.0, most)) for k in range(2)]
        return float(low[0]), float(low[1]), scale, across[0], across[1]

    def find(self, place: Floats) -> Pairs:
        """Pairs of places (n, 2) m; ``order`` (n,) tells which particle stands where, ``place`` is sorted.

        Particles far from all others share the last cells of the grid, so that its size stays bounded.
        ValueError for places that are not finite.
        """
        if not np.isfinite(place).all():
            bad = int(np.flatnonzero(~np.isfinite(place).all(axis=1))[0])
            raise ValueError(f"place: particle {bad} is at {place[bad].tolist()}, expected finite numbers")
        count = len(place)
        if count != len(self.order):
            self._resize(count, 10 * count + 64)
        if count == 0:
            self.pairs.start[:] = 0
            return self.pairs
        search = {"grid": self._by_grid, "z-order": self._by_keys, "hash": self._by_slots}[self.method]
        made = search(place, True)
        if made > len(self.pairs.other):
            self._make_room(count, made + made // 4)
            search(place, False)
        return self.pairs

    def _sized(self, length: int) -> Longs:
        if len(self._starts) != length:
            self._starts = np.zeros(length, dtype=np.int64)
        return self._starts

    def _by_grid(self, place: Floats, sort: bool) -> int:
        grid = self._grid(place)
        starts = self._sized(grid[3] * grid[4] + 1)
        if sort:
            sort_grid(place, grid, starts, self.order)
            gather(self.order, place, self.place)
        return int(pairs_of_grid(self.place, grid, starts, self.support, self.pairs))

    def _by_keys(self, place: Floats, sort: bool) -> int:
        grid = self._grid(place)
        if sort:
            sort_z(place, grid, self._keys, self.order, self._work, self._digits)
            gather(self.order, place, self.place)
        return int(pairs_of_keys(self.place, grid, self._keys, self.support, self.pairs, self._cells))

    def _by_slots(self, place: Floats, sort: bool) -> int:
        scale = 1.0 / self.support
        starts = self._sized(2 * len(place) + 2)
        if sort:
            sort_hash(place, scale, starts, self.order)
            gather(self.order, place, self.place)
        return int(pairs_of_slots(self.place, scale, starts, self.support, self.pairs))

    def sets(self) -> set[tuple[int, int]]:
        """Pairs of particles by their numbers, the smaller first."""
        first = np.repeat(np.arange(len(self.order)), np.diff(self.pairs.start))
        both = self.order[first], self.order[self.pairs.other[: len(first)]]
        return {(min(a, b), max(a, b)) for a, b in zip(both[0].tolist(), both[1].tolist(), strict=True)}
