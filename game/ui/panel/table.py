"""Rows of the panel that show a scene's legend and its table: marks with words, and lines of figures."""

from __future__ import annotations

import pygame

from game.ui.panel.rows import Context, Row, Source
from game.ui.widgets.legend import draw_mark

FIRST = 56  # design px, width of a table's first column
HEADER = -1  # number of the line that names the columns


class LegendRow(Row):
    """A mark of the picture, what it means, and a live count."""

    height = 20

    def __init__(self, context: Context, top: int, source: Source, index: int) -> None:
        self._source, self._index = source, index
        super().__init__(context, top)

    def shows(self) -> tuple[object, ...]:
        rows = tuple(self._source.scene.legend())
        return rows[self._index] if self._index < len(rows) else ()

    def paint(self, surface: pygame.Surface) -> None:
        found = self.shows()
        if not found:
            return
        y = self.rect.h // 2
        mark, words, count = (str(part) for part in found)
        draw_mark(surface, self.look, mark, (self.left + self.look.px(11), y))
        self.look.text(surface, words, (self.left + self.look.px(34), y), 12, "medium", "text2")
        self.look.text(surface, count, (self.right, y), 12, "semibold", "text1", "right")


class TableLine(Row):
    """One line of a scene's table, or its header; the one under the pointer is lit, here and on the stage."""

    height = 18

    def __init__(self, context: Context, top: int, index: int) -> None:
        self.index = index
        self.cells: tuple[str, ...] = ()
        self.row_key: int | None = None  # by which the scene knows it
        super().__init__(context, top)

    def shows(self) -> tuple[object, ...]:
        return (self.cells, self.hovered)

    def paint(self, surface: pygame.Surface) -> None:
        look, (first, *others) = self.look, self.cells or ("",)
        y, left = self.rect.h // 2, self.left + look.px(FIRST)
        if self.hovered and self.row_key is not None:
            surface.fill(look.theme.hover)
        head = self.index == HEADER
        tone, weight = ("text3", "medium") if head else ("text1" if self.hovered else "text2", "medium")
        look.text(surface, first, (self.left, y), 11, weight, tone)
        width = (self.right - left) / max(len(others), 1)
        for i, words in enumerate(others, start=1):
            words = look.fonts.fit(words, 11, weight, round(width) - look.px(2))
            look.text(surface, words, (round(left + i * width), y), 11, weight, tone, "right")
