"""What hierarchical grids do for one box, retold level by level: cells, buckets, and the boxes tested.

``hash_search`` does the same for all boxes at once and keeps no record. These functions read the arrays that
the last search left: the candidates of all boxes together are as many as its box tests.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.physics.broadphase import hash_levels
from game.physics.broadphase.hash_levels import bucket_of, cell_at
from game.physics.broadphase.hash_search import runs_over
from game.physics.broadphase.runs import ID_MASK

OWN, UP, DOWN = "own", "up", "down"  # ways: on its own level, up to coarser cells, down over finer ones


class LevelVisit(NamedTuple):
    """A look into one level's table.

    ``way``: OWN, UP or DOWN. ``cells``: columns and rows. ``buckets``: of these cells, in the same order,
    counted from the table's first. ``candidates``: ids tested, those of other cells in a bucket among them.
    """

    level: int
    way: str
    cells: tuple[tuple[int, int], ...]
    buckets: tuple[int, ...]
    candidates: tuple[int, ...]


class Tables(NamedTuple):
    """The arrays of the last search, see ``hash_levels.sort_by_bucket``."""

    layout: NDArray[np.int64]
    start: NDArray[np.int32]
    order: NDArray[np.int64]
    scales: NDArray[np.float64]

    def cell(self, level: int, x: float, y: float) -> tuple[int, int]:
        """Column and row of a point, m, on a level."""
        scale = float(self.scales[level])
        return int(cell_at(x, scale)), int(cell_at(y, scale))

    def bucket(self, level: int, column: int, row: int) -> int:
        """Bucket of a cell in its level's table."""
        return int(
            bucket_of(
                column, row, self.layout[level, hash_levels.MASK], self.layout[level, hash_levels.FACTOR]
            )
        )

    def chain(self, level: int, bucket: int) -> tuple[int, ...]:
        """Ids of the boxes in a bucket."""
        first = int(self.layout[level, hash_levels.OFFSET]) + bucket
        begin, end = int(self.start[first]), int(self.start[first + 1])
        return tuple((self.order[begin:end] & ID_MASK).tolist())

    def chains(self, level: int) -> list[tuple[int, ...]]:
        """Ids of the boxes in every bucket of a level's table, none if it has no boxes."""
        return [self.chain(level, bucket) for bucket in range(int(self.layout[level, hash_levels.MASK]) + 1)]

    def visit(self, level: int, way: str, cells: list[tuple[int, int]]) -> LevelVisit:
        """A look into whole buckets."""
        buckets = tuple(self.bucket(level, *cell) for cell in cells)
        found = tuple(box for bucket in buckets for box in self.chain(level, bucket))
        return LevelVisit(level, way, tuple(cells), buckets, found)


def level_visits(tables: Tables, box: int, level: int, corners: list[float]) -> list[LevelVisit]:
    """Where a box of a level looks, from the finest level up. ``corners``: x0 y0 x1 y1, m."""
    visits = []
    for other in range(hash_levels.LEVELS):
        if tables.layout[other, hash_levels.COUNT] == 0:
            continue
        if other == level:
            visits.append(_on_its_own(tables, box, level, corners))
        elif other > level and not runs_over(tables.layout, level, other):
            visits.append(tables.visit(other, UP, _around(tables, other, corners)))
        elif other < level and runs_over(tables.layout, other, level):
            visits.append(tables.visit(other, DOWN, _around(tables, other, corners)))
    return visits


def _around(tables: Tables, level: int, corners: list[float]) -> list[tuple[int, int]]:
    """The cells of another level that may hold a partner: all it touches, and the ones before them."""
    before, below = tables.cell(level, *corners[:2])
    after, above = tables.cell(level, *corners[2:])
    return [(i, j) for j in range(below - 1, above + 1) for i in range(before - 1, after + 1)]


def _on_its_own(tables: Tables, box: int, level: int, corners: list[float]) -> LevelVisit:
    """Half of the neighbourhood: the rest of its own cell, the next, and three of the row after."""
    column, row = tables.cell(level, *corners[:2])
    first = tables.visit(level, OWN, [(column, row)])
    others = [(column + 1, row), *((column + i, row + 1) for i in (-1, 0, 1))]
    rest = tables.visit(level, OWN, others)
    later = first.candidates[first.candidates.index(box) + 1 :]
    return LevelVisit(
        level, OWN, first.cells + rest.cells, first.buckets + rest.buckets, later + rest.candidates
    )
