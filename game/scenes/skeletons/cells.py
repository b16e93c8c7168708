"""Where a figure is drawn: the whole picture, or a cell of it beside the figures of other methods."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.scenes.skeletons.level import View
from game.stage import Frame

COLUMNS, ROWS = 3, 2


class Cell(NamedTuple):
    """Where a figure is drawn: its own coordinates times ``scale``, plus an origin."""

    x: float = 0.0
    y: float = 0.0
    scale: float = 1.0

    def out(self, points: Floats) -> Floats:
        """Places in the picture of points (m, 2) of the figure."""
        if self is WHOLE:
            return points
        origin = np.array((self.x, self.y))
        return points + origin if self.scale == 1.0 else points * self.scale + origin

    def into(self, x: float, y: float) -> tuple[float, float]:
        """The point of the figure at a place in the picture."""
        return (x - self.x) / self.scale, (y - self.y) / self.scale


WHOLE = Cell()


def frame_of_cells(view: View) -> Frame:
    """The picture that holds all cells, for figures with this view."""
    return Frame(0.0, 0.0, COLUMNS * (view.right - view.left), ROWS * (view.top - view.bottom))


def cells_of(view: View, compare: bool) -> list[Cell]:
    """Where each method's figure stands; without comparison the chosen one, twice as large, in the middle."""
    wide, high = view.right - view.left, view.top - view.bottom
    if not compare:
        return [Cell(0.5 * wide - 2.0 * view.left, -2.0 * view.bottom, 2.0)] * (COLUMNS * ROWS)
    return [
        Cell(column * wide - view.left, (ROWS - 1 - row) * high - view.bottom)
        for row in range(ROWS)
        for column in range(COLUMNS)
    ]


def cell_at(x: float, y: float, frame: Frame) -> int:
    """Which method's figure is at a place of the picture."""
    column = math.floor(COLUMNS * x / frame.right)
    row = ROWS - 1 - math.floor(ROWS * y / frame.top)
    return min(max(row, 0), ROWS - 1) * COLUMNS + min(max(column, 0), COLUMNS - 1)
