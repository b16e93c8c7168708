"""What a uniform grid does for one box, retold: the cells it looks in, and the boxes it is tested against.

The searches in ``grid_search`` and ``covering_grid`` do the same for all boxes at once and keep no record.
These functions read the arrays that the last search left, so that what is told is what was done: the
candidates of all boxes together are as many as its box tests. They are twice as many in a covering grid,
where each test is told by both boxes.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.physics.broadphase.grid_search import GUARD, NEAR
from game.physics.broadphase.runs import ID_MASK

Cell = tuple[int, int]  # column, row


class Visit(NamedTuple):
    """A look into cells: columns and rows, and the ids of the boxes tested there, in order."""

    cells: tuple[Cell, ...]
    candidates: tuple[int, ...]


class CellRuns(NamedTuple):
    """The arrays of a grid's last search, see ``grid_search.sort_by_cell``; ``reach``: (2,) cells."""

    start: NDArray[np.int32]
    order: NDArray[np.int64]
    columns: int
    rows: int
    reach: tuple[int, int]

    def candidates(self, first: int, last: int) -> tuple[int, ...]:
        """Ids of the boxes at these places of the order."""
        return tuple((self.order[first : max(last, first)] & ID_MASK).tolist())

    def row_of(self, row: int, first: int, last: int) -> tuple[Cell, ...]:
        """The cells of a row from one column to another, guard columns left out."""
        return tuple((i, row) for i in range(max(first, 0), min(last, self.columns - 1) + 1))


def corner_visits(runs: CellRuns, place: int, lower: Cell, upper: Cell) -> list[Visit]:
    """Where a box that stands in one cell looks. ``place``: in the order; ``lower``, ``upper``: its cells."""
    if max(runs.reach) <= NEAR:
        return _near(runs, place, lower)
    stride, (column, row) = runs.columns + GUARD, lower
    before, after = max(column - runs.reach[0], 0), upper[0]
    own = runs.candidates(place + 1, int(runs.start[row * stride + after + 1]))
    visits = [Visit(runs.row_of(row, column, after), own)]
    for other in range(row + 1, upper[1] + 1):
        first, last = (int(runs.start[other * stride + i]) for i in (before, after + 1))
        visits.append(Visit(runs.row_of(other, before, after), runs.candidates(first, last)))
    return visits


def _near(runs: CellRuns, place: int, lower: Cell) -> list[Visit]:
    """Half of the neighbourhood: the rest of its own cell and the next, three cells of the row after."""
    stride, (column, row) = runs.columns + GUARD, lower
    cell = row * stride + column
    visits = [
        Visit(runs.row_of(row, column, column + 1), runs.candidates(place + 1, int(runs.start[cell + 2])))
    ]
    if row + 1 < runs.rows:
        first, last = int(runs.start[cell + stride - 1]), int(runs.start[cell + stride + 2])
        visits.append(Visit(runs.row_of(row + 1, column - 1, column + 1), runs.candidates(first, last)))
    return visits
