"""How the uniform grid and the pair managers are drawn."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from game.physics.broadphase import CoveringGrid
from game.physics.broadphase.effects import HASHED_PAIRS, MATRIX_PAIRS
from game.scenes.boxes.model.arrays import BoxesState
from game.scenes.boxes.model.uniform_grid import UniformGridModel
from game.scenes.boxes.numbers import bytes_text, grouped, seconds_text
from game.scenes.boxes.view.column import TALL, Column
from game.scenes.boxes.view.grid_look import (
    Look,
    draw_look,
    look_into,
    mark_matrix,
    mark_table,
    write_look,
)
from game.scenes.boxes.view.loads import draw_loads
from game.scenes.boxes.view.look import draw_names
from game.scenes.boxes.view.world import BoxesView, draw_ground, places_between
from game.ui.canvas.canvas import Canvas
from game.ui.painters.boxes import shades

MATRIX_PICTURE = 128  # blocks across
FEW_IDS = 64  # the matrix is drawn with a block for each place, the table in one row
HASH_ROWS, HASH_COLUMNS = 16, 64


class UniformGridView(BoxesView):
    """The view of C05."""

    model: UniformGridModel

    def legend(self) -> list[tuple[str, str, str]]:
        rows = super().legend()
        if self.model.parameters.heat:
            full, most = self._full(), int(self.model.grid.loads().max())
            beyond = f" most {grouped(most)}" if most > full else ""
            rows.append(("scale:stage:chalk", "Boxes in a cell", f"0 {full:.3g}{beyond}"))
        return rows

    def _full(self) -> float:
        """Load that is shaded fully: three times that of a cell if boxes were spread evenly, at least 3."""
        even = len(self.model.boxes) / (self.model.grid.columns * self.model.grid.rows)
        if isinstance(self.model.grid, CoveringGrid):
            even *= (1.0 + self.model.size / self.model.grid.cell) ** 2
        return max(3.0 * math.ceil(even), 3.0)

    def draw(self, canvas: Canvas, before: BoxesState | None, alpha: float) -> None:
        model = self.model
        if model.parameters.heat:
            draw_loads(canvas, model.grid.loads(), model.grid.cell, self._full())
        draw_ground(canvas)
        self.draw_boxes(canvas, before, alpha)
        places = places_between(model, before, alpha)
        draw_names(model.boxes, canvas, places)
        looked = self.hand.looked
        seen = look_into(model, looked) if looked >= 0 else None
        if seen is not None:
            draw_look(model, canvas, places, seen)
        with canvas.at_home() as moved:
            self._draw_managers(canvas, seen, moved)

    def _draw_managers(self, canvas: Canvas, seen: Look | None, moved: bool) -> None:
        """Matrix and hash table as they are filled, and what each costs."""
        column = Column(canvas, self.model.boxes, self.frame().bottom, over=moved)
        if seen is None or column.room_px > TALL:
            self._draw_times(column)
        self._draw_matrix(column, canvas, seen)
        self._draw_table(column, canvas, seen)
        if seen is not None:
            write_look(self.model, column, seen)

    def _draw_times(self, column: Column) -> None:
        """What each manager takes, and whether they agree."""
        model = self.model
        times = [model.manager_s(name) for name in ("matrix", "hash")]
        longest = max((time for time in times if math.isfinite(time)), default=1.0)
        same = "same answers" if model.same else "answers differ"
        column.head("Pair managers", same if model.compared else "not compared")
        for words, manager, time, color in (
            ("Full matrix", model.matrix if MATRIX_PAIRS in model.active else None, times[0], "chalk"),
            ("Hash table", model.hashed if HASHED_PAIRS in model.active else None, times[1], "green"),
        ):
            pairs = "left out"
            if manager is not None:
                pairs = f"{grouped(len(manager))} {'pair' if len(manager) == 1 else 'pairs'}"
            share = time / longest if time > 0.0 else 0.0
            column.bar(f"{words}, {pairs}", seconds_text(time), share, color)
        column.space(8)

    def _draw_matrix(self, column: Column, canvas: Canvas, seen: Look | None) -> None:
        """Which places of the matrix hold a pair, in blocks."""
        if self.model.matrix is None or not self.model.keeps_matrix:
            size = 4.0 * len(self.model.boxes.alive) * (len(self.model.boxes.alive) - 1) / 2
            column.head("Full matrix", f"would take {bytes_text(size)}")
            return
        n = max(len(self.model.boxes.alive), 2)
        blocks = min(MATRIX_PICTURE, n)
        high = blocks if n <= FEW_IDS else blocks // 2
        filled = np.zeros((high, blocks))
        if len(self.model.pairs):
            rows = (high - 1) - self.model.pairs[:, 0] * high // n
            np.add.at(filled, (rows, self.model.pairs[:, 1] * blocks // n), 1.0)
        beyond = _beyond(*filled.shape)
        colors = shades(
            canvas, np.where(filled > 0, 0.35 + 0.65 * filled / max(filled.max(), 1), 0.0), "chalk", "inset"
        )
        colors[beyond & (filled == 0)] = canvas.ink("stage")
        column.head("Full matrix", bytes_text(self.model.matrix.memory()))
        frame = column.picture(colors, 92)
        if seen is not None:
            mark_matrix(canvas, seen, n, frame)

    def _draw_table(self, column: Column, canvas: Canvas, seen: Look | None) -> None:
        """Which places of the hash table are taken, in blocks."""
        if not self.model.keeps_table:
            return
        taken = self.model.hashed.table.where > 0
        blocks = min(HASH_ROWS * HASH_COLUMNS, len(taken))
        columns = min(HASH_COLUMNS, blocks)
        filled = taken.reshape(blocks, -1).mean(axis=1).reshape(-1, columns)
        column.head(
            "Hash table", f"{bytes_text(self.model.hashed.memory())}, {self.model.hashed.probes():.2f} looks"
        )
        frame = column.picture(shades(canvas, filled, "green", "inset"), 56 if blocks > FEW_IDS else 28)
        if seen is not None:
            mark_table(canvas, self.model.hashed, seen, filled.shape, frame)


@lru_cache(maxsize=4)
def _beyond(rows: int, columns: int) -> NDArray[np.bool_]:
    """Which blocks of the picture of the matrix hold nothing: those below its diagonal."""
    row, place = np.indices((rows, columns))
    return place / columns < 1.0 - (row + 1) / rows
