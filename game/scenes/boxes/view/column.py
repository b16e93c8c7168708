"""The column of readouts beside the world of the broad-phase scenes."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from game.scenes.boxes.model.arrays import BoxArrays
from game.ui.canvas.canvas import Canvas
from game.ui.painters.boxes import paint_raster

COLUMN_LEFT, COLUMN_RIGHT = -4.45, -0.5  # m, where it stands beside the world
COLUMN_TOP = 5.3  # m, below the legend
TALL = 400  # design px of a column that has space for times beside what is said of few boxes


class Column:
    """Writes readouts down a column beside the world, from ``top`` to ``bottom``, m; heights in design px."""

    def __init__(
        self,
        canvas: Canvas,
        boxes: BoxArrays,
        bottom: float,
        top: float = COLUMN_TOP,
        right: float = COLUMN_RIGHT,
        over: bool = False,
    ):
        """``over``: whether anything may lie under it, as the picture has been moved."""
        self.canvas = canvas
        self._written = 0
        edge = right + canvas.px(10)
        if over or boxes.lowers[:, 0].min(initial=0.0) < edge:  # boxes that come so far are hardly seen
            ground = np.array([(-99.0, -99.0), (edge, -99.0), (edge, 99.0), (-99.0, 99.0)])
            canvas.polygon(ground, fill="stage", fill_alpha=0.9)
        self.y = top
        self.left, self.right = COLUMN_LEFT, right
        self._bottom = bottom

    @property
    def room_px(self) -> float:
        """Design px that are left above the foot of the picture."""
        return (self.y - self._bottom) / self.canvas.px(1.0)

    def space(self, height_px: float) -> None:
        """Leave space."""
        self.y -= self.canvas.px(height_px)

    def _figure(self, words: str) -> str:
        """Words whose number changes together with all other numbers in the window."""
        self._written += 1
        return self.canvas.figure((self._written, "".join(filter(str.isalpha, words))), words)

    def head(self, words: str, remark: str = "") -> None:
        """A section's head, with a remark at its right."""
        words, remark = self._figure(words), self._figure(remark)
        self.canvas.label((self.left, self.y), words, "text1", 12, "semibold", "left", halo=False)
        if remark:
            self.canvas.label((self.right, self.y), remark, "text3", 11, "medium", "right", halo=False)
        self.space(18)

    def row(self, words: str, value: str, color: str = "text2") -> None:
        """Words on the left, a value on the right."""
        words, value = self._figure(words), self._figure(value)
        self.canvas.label((self.left, self.y), words, color, 12, "medium", "left", halo=False)
        self.canvas.label((self.right, self.y), value, "text1", 12, "semibold", "right", halo=False)
        self.space(19)

    def bar(self, words: str, value: str, share: float, color: str, hollow: bool = False) -> None:
        """A row with a bar below it, ``share`` of the column long."""
        canvas = self.canvas
        self.row(words, value)
        y = self.y + canvas.px(6)
        canvas.line((self.left, y), (self.right, y), "inset", 4.0)
        if share > 0.0:
            end = self.left + min(share, 1.0) * (self.right - self.left)
            canvas.line((self.left, y), (end, y), color, 4.0, alpha=0.4 if hollow else 1.0)
        self.space(10)

    def words(self, text: str, color: str = "text2") -> None:
        """A sentence, in as many lines as it takes."""
        canvas = self.canvas
        width = int((self.right - self.left) * canvas.pixels_per_unit)
        for line in canvas.fonts.wrap(text, 12, "medium", width):
            canvas.label((self.left, self.y), line, color, 12, "medium", "left", halo=False)
            self.space(17)

    def picture(self, colors: NDArray[np.uint32], height_px: float) -> tuple[float, float, float, float]:
        """A raster over the width of the column; returns its left, bottom, right and top, m."""
        canvas = self.canvas
        lower = (self.left, self.y - canvas.px(height_px))
        paint_raster(canvas, colors, lower, (self.right, self.y))
        corners = np.array([lower, (self.right, lower[1]), (self.right, self.y), (self.left, self.y)])
        canvas.polygon(corners, outline="line2", width=1.0)
        top = self.y
        self.space(height_px + 14)
        return self.left, lower[1], self.right, top
