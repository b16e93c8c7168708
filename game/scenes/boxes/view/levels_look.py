"""Looking into a box of the hierarchical grids: level by level, its cells, buckets and tests."""

from __future__ import annotations

from typing import NamedTuple

from game.physics.broadphase.hash_levels import MASK, TOP
from game.physics.broadphase.walks.hash import DOWN, OWN, LevelVisit
from game.scenes.boxes.model.hierarchical_grids import HierarchicalGridModel
from game.scenes.boxes.model.names import listed_names, name_of, outcomes, result_of
from game.scenes.boxes.view import look
from game.scenes.boxes.view.column import Column
from game.scenes.boxes.view.world import Places
from game.ui.canvas.canvas import Canvas
from game.ui.look.numerals import format_si

MOST_SHADED = 600  # cells of a level
MOST_SHOWN = 4  # levels


class Look(NamedTuple):
    """What the grids do for one box: its level and bucket there, its looks, and the boxes it overlaps."""

    box: int
    level: int
    bucket: int
    size: int  # of that level's table, buckets
    visits: list[LevelVisit]
    candidates: list[int]
    partners: list[int]


def look_into(model: HierarchicalGridModel, box: int) -> Look:
    """Ask the grids what they did for a box in the last search."""
    grid = model.grid
    tables, level = grid.tables(), grid.level(box)
    visits = grid.visits(box)
    bucket = tables.bucket(level, *tables.cell(level, *grid.boxes[box, :2].tolist()))
    mine = model.pairs[(model.pairs == box).any(axis=1)]
    candidates = [other for visit in visits for other in visit.candidates]
    partners = (mine.sum(axis=1) - box).tolist()
    return Look(box, level, bucket, int(tables.layout[level, MASK]) + 1, visits, candidates, partners)


def draw_look(model: HierarchicalGridModel, canvas: Canvas, places: Places, seen: Look) -> None:
    """The cells looked in, coarse ones first, and the tests."""
    for visit in seen.visits[::-1]:
        if visit.level != TOP and len(visit.cells) <= MOST_SHADED:
            veil = 0.2 if visit.way == OWN else 0.1
            look.shade_cells(canvas, visit.cells, model.grid.cell_size(visit.level), "amber", veil)
    look.draw_tests(model.boxes, canvas, places, seen.box, seen.candidates)


def write_look(model: HierarchicalGridModel, column: Column, seen: Look) -> None:
    """Rows: bucket, looks level by level, and pairs that others find."""
    pairs, rejected = outcomes(model.boxes, seen.box, seen.candidates)
    column.head(f"Box {name_of(model.boxes, seen.box)}", result_of(pairs, rejected))
    column.row("In bucket", f"{seen.bucket} of {seen.size}")
    for visit in seen.visits[:MOST_SHOWN]:
        tests = f"{len(visit.candidates)} test" + ("" if len(visit.candidates) == 1 else "s")
        column.row(_words(model, visit), tests)
    others = [other for other in seen.partners if other not in seen.candidates]
    if (
        others and column.room_px > 10
    ):  # they are on a level that looks here, or in the other half of the cells
        column.row("Found from the other side", listed_names(model.boxes, others))


def _words(model: HierarchicalGridModel, visit: LevelVisit) -> str:
    """A look into a level, in a few words."""
    if visit.level == TOP:
        return "Own level, one cell" if visit.way == OWN else "Looks up the one cell"
    cells, size = len(visit.cells), format_si(model.grid.cell_size(visit.level), "m")
    if visit.way == OWN:
        return f"Own level, {cells} cells of {size}"
    return f"{'Runs over' if visit.way == DOWN else 'Looks up'} {cells} cells of {size}"
