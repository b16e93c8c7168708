"""The legend at the top left of the stage: what the marks of the picture mean, with live counts.

A row is (mark, words, count). A mark is "shape:colour" or "shape:colour:colour2"; the shapes are
``disc ring box dashed-box line dash arrow diamond square triangle-up triangle-down plus cross``, and
``scale:from:to`` for a bar of colours whose count reads "0 9 m/s": its ends and their unit.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import pygame

from game.ui.look.look import Look
from game.ui.look.shapes import draw_box, draw_disc, draw_gradient, draw_line, draw_polygon

Row = tuple[str, str, str]
PADDING, NARROWEST, OPACITY = 12, 168, 0.96
TALL_MARKS = frozenset(("box", "dashed-box"))


class Legend:
    """Draws rows; its picture is made again only when they change, for a count alone only if it is fresh."""

    def __init__(self, look: Look) -> None:
        self.look = look
        self.rect = pygame.Rect(0, 0, 0, 0)
        self._rows: tuple[Row, ...] = ()
        self._picture: pygame.Surface | None = None
        self._width = 0

    def place(self, look: Look) -> None:
        """Take another appearance."""
        self.look = look
        self._picture = None
        self._width = 0

    def draw(
        self, surface: pygame.Surface, stage: pygame.Rect, rows: Sequence[Row], fresh: bool = True
    ) -> None:
        """Show the rows at the top left of the stage; nothing without rows or without space.

        Counts change if they are ``fresh``, marks and words at once.
        """
        rows = tuple(rows)
        others = [row[:2] for row in rows] != [row[:2] for row in self._rows]
        if others or self._picture is None or (fresh and rows != self._rows):
            if [row[1] for row in rows] != [row[1] for row in self._rows]:
                self._width = 0
            self._rows = rows
            self._picture = self._paint() if rows else None
        margin = self.look.px(16)
        self.rect = pygame.Rect(stage.x + margin, stage.y + margin, 0, 0)
        if self._picture is None:
            return
        self.rect.size = self._picture.get_size()
        if self.rect.right <= stage.right - margin and self.rect.bottom <= stage.bottom - margin:
            surface.blit(self._picture, self.rect)
        else:
            self.rect.size = (0, 0)

    def _paint(self) -> pygame.Surface:
        look, px = self.look, self.look.px
        wide = any(row[2] and not row[0].startswith("scale") for row in self._rows)
        wide = wide or any(row[0].split(":")[0] in TALL_MARKS for row in self._rows)
        pitch, words_x = px(24 if wide else 18), px(42 if wide else 36)
        heights = [px(52) if row[0].startswith("scale") else pitch for row in self._rows]
        # A count that grows may widen the legend, but it never shrinks again: no jitter.
        self._width = max(self._width, px(NARROWEST), *(self._row_width(row, words_x) for row in self._rows))
        size = (self._width, sum(heights) + 2 * px(6 if wide else 9))
        picture = pygame.Surface(size, pygame.SRCALPHA, 32)
        draw_box(picture, picture.get_rect(), px(10), look.theme.panel, look.theme.line, look.border)
        y = px(6 if wide else 9)
        for row, height in zip(self._rows, heights, strict=True):
            if row[0].startswith("scale"):
                self._paint_scale(picture, row, y)
            else:
                self._paint_row(picture, row, y + height // 2, words_x)
            y += height
        picture.set_alpha(round(255 * OPACITY))
        return picture

    def _row_width(self, row: Row, words_x: int) -> int:
        fonts, px = self.look.fonts, self.look.px
        width = words_x + fonts.size(row[1], 12)[0] + px(PADDING)
        if row[2]:
            width += px(24) + fonts.size(row[2], 12, "semibold")[0]
        return width

    def _paint_row(self, picture: pygame.Surface, row: Row, y: int, words_x: int) -> None:
        look, px = self.look, self.look.px
        draw_mark(picture, look, row[0], (px(22) if words_x > px(36) else px(18), y))
        look.text(picture, row[1], (words_x, y), 12, "medium", "text2")
        if row[2]:
            look.text(
                picture, row[2], (picture.get_width() - px(PADDING), y), 12, "semibold", "text1", "right"
            )

    def _paint_scale(self, picture: pygame.Surface, row: Row, y: int) -> None:
        """A colour scale: title and unit, the bar, four numbers."""
        look, px = self.look, self.look.px
        _, first, last = row[0].split(":")
        low, high, *unit = row[2].split(" ")
        left, right = px(PADDING), picture.get_width() - px(PADDING)
        look.text(picture, row[1], (left, y + px(9)), 12, "medium", "text2")
        look.text(picture, " ".join(unit), (right, y + px(9)), 11, "medium", "text3", "right")
        bar = pygame.Rect(left, y + px(23), right - left, px(6))
        draw_gradient(picture, bar, px(3), look.color(first), look.color(last))
        for i in range(4):
            value = float(low) + (float(high) - float(low)) * i / 3.0
            align = ("left", "center", "center", "right")[i]
            at = (left + (right - left) * i / 3.0, y + px(40))
            look.text(picture, f"{value:.3g}", at, 11, "medium", "text3", align)


def draw_mark(
    surface: pygame.Surface, look: Look, mark: str, center: tuple[float, float], size: float = 1.0
) -> None:
    """One mark of a legend or table ("shape:colour"), centred; ``size`` 1 is the size in the legend."""
    shape, _, rest = mark.partition(":")
    color = look.color(rest.split(":")[0] or "text1")
    unit = look.k * size
    x, y = center
    if shape == "disc":
        draw_disc(surface, center, 4.0 * unit, color)
    elif shape == "ring":
        draw_disc(surface, center, 5.0 * unit, None, color, 1.5 * unit)
    elif shape == "body":
        draw_disc(surface, center, 6.0 * unit, look.theme.body, color, 2.0 * unit)
    elif shape in TALL_MARKS:
        rect = pygame.Rect(0, 0, round(20 * unit), round(14 * unit))
        rect.center = (round(x), round(y))
        if shape == "box":
            fill = look.theme.panel.lerp(color, 0.28) if rest != "ghost" else look.theme.panel
            pygame.draw.rect(surface, fill, rect)
            pygame.draw.rect(surface, color, rect, max(1, round((1.0 if rest == "ghost" else 2.0) * unit)))
        else:
            _dashed_box(surface, color, rect, max(1, round(1.6 * unit)))
    elif shape in ("line", "dash", "arrow"):
        _line_mark(surface, look, shape, color, x, y, unit)
    elif shape in ("plus", "cross"):
        d = 4.5 * unit
        ends = ((d, 0.0), (0.0, d)) if shape == "plus" else ((0.8 * d, 0.8 * d), (0.8 * d, -0.8 * d))
        for dx, dy in ends:
            draw_line(surface, color, (x - dx, y - dy), (x + dx, y + dy), 1.8 * unit)
    else:
        draw_polygon(surface, [(x + dx * unit, y + dy * unit) for dx, dy in _corners(shape)], color)


def _corners(shape: str) -> Sequence[tuple[float, float]]:
    """Corners of the polygonal marks about their middle, design px."""
    if shape == "square":
        return ((-4.5, -4.5), (4.5, -4.5), (4.5, 4.5), (-4.5, 4.5))
    if shape == "diamond":
        return ((0.0, -6.0), (6.0, 0.0), (0.0, 6.0), (-6.0, 0.0))
    if shape in ("triangle-up", "triangle-down"):
        down = 1.0 if shape == "triangle-up" else -1.0
        return ((0.0, -5.2 * down), (5.6, 4.4 * down), (-5.6, 4.4 * down))
    raise ValueError(f"mark {shape!r}: no such shape")


def _line_mark(
    surface: pygame.Surface, look: Look, shape: str, color: pygame.Color, x: float, y: float, unit: float
) -> None:
    half, width = 11.0 * unit, max(1.0, 2.0 * unit)
    if shape == "dash":
        for i in range(3):
            start = x - half + i * 8.5 * unit
            draw_line(surface, color, (start, y), (min(start + 5.5 * unit, x + half), y), width)
        return
    end = half - (6.0 * unit if shape == "arrow" else 0.0)
    draw_line(surface, color, (x - half, y), (x + end, y), width)
    if shape == "arrow":
        tip = [(x + half, y), (x + half - 7 * unit, y - 3.5 * unit), (x + half - 7 * unit, y + 3.5 * unit)]
        draw_polygon(surface, tip, color)


def _dashed_box(surface: pygame.Surface, color: pygame.Color, rect: pygame.Rect, width: int) -> None:
    """The outline of a box in dashes, each side beginning and ending with a half one."""
    for horizontal in (True, False):
        length = rect.w if horizontal else rect.h
        count = max(1, round(length / (9 * width / 1.6)))
        pitch = length / count
        for i in range(count + 1):
            start, end = max(0.0, (i - 0.32) * pitch), min(float(length), (i + 0.32) * pitch)
            for far in (False, True):
                at = (rect.h if horizontal else rect.w) - width if far else 0
                a, n = math.floor(start), max(1, math.ceil(end) - math.floor(start))
                dash = (
                    (rect.x + a, rect.y + at, n, width) if horizontal else (rect.x + at, rect.y + a, width, n)
                )
                surface.fill(color, dash)
