"""Boxes that lie out of the picture: how many, on which side, how far, and the pairs among them."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.scenes.boxes.level import HEIGHT, WIDTH
from game.scenes.boxes.model.arrays import LOWER, UPPER
from game.scenes.boxes.model.base import BoxesModel
from game.scenes.boxes.numbers import grouped
from game.ui.canvas.canvas import Canvas
from game.ui.look.numerals import quantity

INSET_PX, BELOW_CAPTION = 14.0, 40.0  # design px from the world's boundary to the words, and from its top
ANCHORS = {
    (-1, -1): "bottomleft", (-1, 0): "left", (-1, 1): "topleft", (0, -1): "bottom", (0, 1): "top",
    (1, -1): "bottomright", (1, 0): "right", (1, 1): "topright",
}  # fmt: skip
ARROWS = {
    (-1, -1): "↙", (-1, 0): "←", (-1, 1): "↖", (0, -1): "↓", (0, 1): "↑",
    (1, -1): "↘", (1, 0): "→", (1, 1): "↗",
}  # fmt: skip


class Outside(NamedTuple):
    """Boxes beyond one side or corner of the world: which (-1, 0 or 1 on x and y), how many, pairs that have
    a box there, and how far the farthest is beyond, m."""

    side: tuple[int, int]
    boxes: int
    pairs: int
    farthest: float

    @property
    def words(self) -> str:
        """What is said of them."""
        boxes = "1 box" if self.boxes == 1 else f"{grouped(self.boxes)} boxes"
        pairs = {0: "no pair", 1: "1 pair"}.get(self.pairs, f"{grouped(self.pairs)} pairs")
        return f"{boxes}, {pairs}, up to {' '.join(quantity(self.farthest, 'm'))} away {ARROWS[self.side]}"


def boxes_outside(model: BoxesModel) -> list[Outside]:
    """What lies wholly beyond the world, side by side; boxes without end are at none."""
    boxes = model.boxes
    low, high = boxes.lowers, boxes.uppers
    finite = np.isfinite(low).all(axis=1) & np.isfinite(high).all(axis=1) & (boxes.alive == 1)
    side = (low > UPPER).astype(np.int64) - (high < LOWER).astype(np.int64)
    side[~finite] = 0
    found = []
    for x, y in sorted({(int(x), int(y)) for x, y in side[side.any(axis=1)].tolist()}):
        there = (side == (x, y)).all(axis=1)
        gap = np.maximum(np.maximum(low[there] - UPPER, LOWER - high[there]), 0.0)
        with np.errstate(over="ignore"):  # of 1e300 m the squares are too large
            farthest = float(np.hypot(gap[:, 0], gap[:, 1]).max())
        pairs = int(np.count_nonzero(there[model.pairs].any(axis=1))) if len(model.pairs) else 0
        found.append(Outside((x, y), int(np.count_nonzero(there)), pairs, farthest))
    return found


def draw_outside(canvas: Canvas, model: BoxesModel) -> None:
    """Words within the world's boundary, where the boxes are beyond it."""
    for outside in boxes_outside(model):
        x, y = outside.side
        place = (0.5 * WIDTH * (1 + x), 0.5 * HEIGHT * (1 + y))
        if math.isfinite(outside.farthest):
            offset = (-INSET_PX * x, (BELOW_CAPTION if y > 0 else INSET_PX) * y)
            canvas.label(
                place, outside.words, "amber", 12, "semibold", ANCHORS[outside.side], offset, clear=True
            )
