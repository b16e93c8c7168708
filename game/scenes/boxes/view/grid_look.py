"""Looking into a box of the uniform grid: its cells, its tests, and the places of its pairs."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from game.physics.broadphase import CoveringGrid, HashedPairs, MatrixPairs
from game.scenes.boxes.model.names import listed_names, name_of, outcomes, result_of
from game.scenes.boxes.model.uniform_grid import UniformGridModel
from game.scenes.boxes.view import look
from game.scenes.boxes.view.column import Column
from game.scenes.boxes.view.world import Places
from game.ui.canvas.canvas import Canvas

MOST_SHADED = 600  # cells
MOST_PAIRS_SHOWN = 2


class Look(NamedTuple):
    """What the grid does for one box, and the pairs that it has."""

    box: int
    stands: list[tuple[int, int]]  # cells
    looks: list[tuple[int, int]]  # cells
    candidates: list[int]
    partners: list[int]


def look_into(model: UniformGridModel, box: int) -> Look:
    """Ask the grid what it did for a box in the last search."""
    grid = model.grid
    visits = grid.visits(box)
    looks = [cell for visit in visits for cell in visit.cells]
    if isinstance(grid, CoveringGrid):
        stands = grid.cells_of(box)
    else:
        stands = [grid.cell_of(*grid.boxes[box, :2].tolist())]
    mine = model.pairs[(model.pairs == box).any(axis=1)]
    partners = mine.sum(axis=1) - box
    candidates = [other for visit in visits for other in visit.candidates]
    return Look(box, stands, looks, candidates, partners.tolist())


def draw_look(model: UniformGridModel, canvas: Canvas, places: Places, seen: Look) -> None:
    """The cells looked in, those it stands in stronger, and the tests."""
    if len(seen.looks) <= MOST_SHADED:
        look.shade_cells(canvas, seen.looks, model.grid.cell, "amber", 0.16)
        look.shade_cells(canvas, seen.stands, model.grid.cell, "amber", 0.22)
    look.draw_tests(model.boxes, canvas, places, seen.box, seen.candidates)


def write_look(model: UniformGridModel, column: Column, seen: Look) -> None:
    """Rows: cells, tests, places."""
    pairs, rejected = outcomes(model.boxes, seen.box, seen.candidates)
    column.head(f"Box {name_of(model.boxes, seen.box)}", result_of(pairs, rejected))
    if len(seen.stands) == 1:
        column.row("Stands in column, row", "{}, {}".format(*seen.stands[0]))
    else:
        column.row("Stands in", f"{len(seen.stands)} cells")
    tests = f"{len(seen.candidates)} test" + ("" if len(seen.candidates) == 1 else "s")
    column.row("Looks in", f"{len(seen.looks)} cells, {tests}")
    others = [other for other in seen.partners if other not in seen.candidates]
    if others:  # half of the cells around are enough: the box in the other half looks here
        column.row("Found from the other side", listed_names(model.boxes, others))
    if not seen.partners:
        column.row("Pairs", "none")
    for other in seen.partners[:MOST_PAIRS_SHOWN]:
        name = "".join(name_of(model.boxes, i) for i in sorted((seen.box, other)))
        column.row(f"Pair {name} at", _places(model, seen.box, other))
    if len(seen.partners) > MOST_PAIRS_SHOWN:
        rest = seen.partners[MOST_PAIRS_SHOWN:]
        column.row("Pairs with", listed_names(model.boxes, rest))


def _places(model: UniformGridModel, a: int, b: int) -> str:
    """Place in the matrix, and the chain of places looked at in the hash table."""
    words = []
    if model.keeps_matrix:
        assert isinstance(model.matrix, MatrixPairs)
        words.append(f"k = {model.matrix.place(a, b)}")
    if model.keeps_table:
        words.append("h = " + " → ".join(map(str, model.hashed.chain(a, b))))
    return ", ".join(words)


def mark_matrix(canvas: Canvas, seen: Look, ids: int, frame: tuple[float, float, float, float]) -> None:
    """Outline the places of a box's pairs in the picture of the matrix, and shade its row and column."""
    left, bottom, right, top = frame
    wide, high = (right - left) / ids, (top - bottom) / ids
    box = seen.box
    for x0, y0, x1, y1 in (
        (left + (box + 1) * wide, top - (box + 1) * high, right, top - box * high),
        (left + box * wide, top - box * high, left + (box + 1) * wide, top),
    ):
        square = np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1)])
        canvas.polygon(square, fill="amber", fill_alpha=0.25)
    for other in seen.partners:
        i, j = min(box, other), max(box, other)
        x, y = left + (j + 0.5) * wide, top - (i + 0.5) * high
        _ring(canvas, x, y, wide, high)


def mark_table(
    canvas: Canvas, table: HashedPairs, seen: Look, shape: tuple[int, int],
    frame: tuple[float, float, float, float],
) -> None:  # fmt: skip
    """Outline the places looked at for a box's pairs, one after the other. ``shape``: rows and columns."""
    left, bottom, right, top = frame
    rows, columns = shape
    wide, high = (right - left) / columns, (top - bottom) / rows
    together = len(table.table.where) / (rows * columns)
    for other in seen.partners:
        for place in table.chain(seen.box, other):
            block = int(place / together)
            x = left + (block % columns + 0.5) * wide
            _ring(canvas, x, bottom + (block // columns + 0.5) * high, wide, high)


def _ring(canvas: Canvas, x: float, y: float, wide: float, high: float) -> None:
    """An outline about a place, never smaller than it can be seen."""
    across, up = max(0.5 * wide, canvas.px(3)), max(0.5 * high, canvas.px(3))
    look.outline(canvas, (x - across, y - up), (x + across, y + up), width=1.5)
