"""The sheets of a tilted stack: where each level of the hierarchical grids lies in the picture."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from game.physics.broadphase.hash_levels import TOP
from game.scenes.boxes.level import HEIGHT, WIDTH
from game.scenes.boxes.model.hierarchical_grids import HierarchicalGridModel

LEVEL_COLORS = ("violet", "pink", "yellow", "chalk")  # green is the naive method's
MOST_SHEETS = 5
LEFT, BREADTH, SHEAR = 0.15, 0.52, 1.5  # m, of the sheets: left edge, breadth of a metre, slope to the right
SHARE = 0.74  # of its slot that a sheet takes


class Sheet(NamedTuple):
    """A level's sheet: ``base`` and ``height``, m, where it lies in the picture."""

    level: int
    base: float
    height: float
    color: str

    def place(self, x: Any, y: Any) -> Any:
        """Where points of the world, m, lie in the picture, (n, 2) m."""
        y = np.clip(np.asarray(y, dtype=np.float64) / HEIGHT, -0.2, 1.2)
        x = np.clip(x, -2.0, WIDTH + 2.0)
        return np.stack([LEFT + BREADTH * x + SHEAR * y, self.base + self.height * y], axis=-1)

    def back(self, u: float, v: float) -> tuple[float, float]:
        """The point of the world that lies at a place of the picture."""
        y = (v - self.base) / self.height
        return (u - LEFT - SHEAR * y) / BREADTH, HEIGHT * y

    def box(self, lower: Any, upper: Any) -> Any:
        """The corners of a box in the picture, (4, 2) m."""
        (x0, y0), (x1, y1) = lower, upper
        return self.place(np.array([x0, x1, x1, x0]), np.array([y0, y0, y1, y1]))


def color_index(present: Any, level: int) -> int:
    """Which of LEVEL_COLORS a level has among those present, which are in order."""
    return int(np.searchsorted(present, level)) % len(LEVEL_COLORS)


def sheets_of(model: HierarchicalGridModel) -> list[Sheet]:
    """The sheets of the levels that have boxes, finest lowest."""
    present = [level for level, _ in model.grid.levels()]
    levels = [level for level in present if level != TOP][-MOST_SHEETS:]
    slot = HEIGHT / max(len(levels), 1)
    height = min(SHARE * slot, 2.6)
    return [
        Sheet(level, i * slot + 0.1, height, LEVEL_COLORS[color_index(present, level)])
        for i, level in enumerate(levels)
    ]


def sheet_at(sheets: list[Sheet], u: float, v: float) -> Sheet | None:
    """The sheet at a place of the picture, if there is one."""
    for sheet in sheets:
        x, y = sheet.back(u, v)
        if 0.0 <= x <= WIDTH and 0.0 <= y <= HEIGHT:
            return sheet
    return None
