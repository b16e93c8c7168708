"""How the hierarchical grids are drawn: cells of all levels upon each other, or a tilted stack of them."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.broadphase.hash_levels import TOP
from game.scenes.boxes.model.arrays import BoxesState
from game.scenes.boxes.model.hierarchical_grids import HierarchicalGridModel
from game.scenes.boxes.numbers import grouped
from game.scenes.boxes.sheets import LEVEL_COLORS, color_index, sheets_of
from game.scenes.boxes.view.column import TALL, Column
from game.scenes.boxes.view.comparison import draw_comparison
from game.scenes.boxes.view.levels_look import draw_look, look_into, write_look
from game.scenes.boxes.view.look import draw_names
from game.scenes.boxes.view.stack import draw_stack
from game.scenes.boxes.view.world import BoxesView, draw_ground, places_between
from game.ui.canvas.canvas import Canvas
from game.ui.look.numerals import format_si
from game.ui.painters.boxes import BoxPainter

MOST_CELLS = 4_000
MOST_ROWS = 7  # levels listed
_cells = BoxPainter(tuple((color, 0.07, color, 0.4) for color in LEVEL_COLORS))
Levels = NDArray[np.integer[Any]]


class HierarchicalGridView(BoxesView):
    """The view of C06."""

    model: HierarchicalGridModel

    def draw(self, canvas: Canvas, before: BoxesState | None, alpha: float) -> None:
        model, boxes, looked = self.model, self.model.boxes, self.hand.looked
        levels, corners = model.grid.cells()
        counts = np.bincount(levels[levels >= 0], minlength=1)
        present = np.flatnonzero(counts)
        places = places_between(model, before, alpha)
        seen = look_into(model, looked) if looked >= 0 else None
        if model.stacked:
            draw_stack(model, canvas, places, sheets_of(model), seen)
        else:
            if model.parameters.cells and len(boxes) <= MOST_CELLS:
                self._draw_cells(canvas, levels, corners, present)
            draw_ground(canvas)
            self.draw_boxes(canvas, before, alpha)
            draw_names(boxes, canvas, places)
            if seen is not None:
                draw_look(model, canvas, places, seen)
        with canvas.at_home() as moved:
            column = Column(canvas, boxes, self.frame().bottom, 5.75, over=moved)
            if seen is None or column.room_px > TALL:
                words = f"Hierarchical, {grouped(model.grid.tests)} tests"
                draw_comparison(model, column, "hierarchical", words)
                column.space(6)
            self._draw_levels(column, counts, present)
            if seen is not None:
                column.space(6)
                write_look(model, column, seen)

    def _draw_cells(self, canvas: Canvas, levels: Levels, corners: Floats, present: Levels) -> None:
        """The cells that hold boxes, coarse ones first; the level that is one cell has no outline."""
        for level in present[::-1].tolist():
            if level == TOP:
                continue
            lower = np.unique(corners[levels == level], axis=0)
            kinds = np.full(len(lower), color_index(present, level), dtype=np.uint8)
            _cells.paint(canvas, lower, lower + self.model.grid.cell_size(level), kinds)

    def _draw_levels(self, column: Column, counts: Levels, present: Levels) -> None:
        """A row for each level that holds boxes, from the finest: size of its cells, boxes in them."""
        column.head("Levels", "boxes")
        most = max(int(counts.max(initial=1)), 1)
        for level in present[:MOST_ROWS].tolist():
            size = self.model.grid.cell_size(level)
            words = f"Cells of {format_si(size, 'm')}" if math.isfinite(size) else "One cell for the rest"
            length = math.log1p(int(counts[level])) / math.log1p(most)
            column.bar(words, grouped(int(counts[level])), length, LEVEL_COLORS[color_index(present, level)])
        if len(present) > MOST_ROWS:
            column.row(f"and {len(present) - MOST_ROWS} levels more", "")
