"""The column beside the table as it is drawn: its ground, its heading, and rows of one make."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import pygame

from game.scenes.shared.tables.beside.column import Column
from game.scenes.shared.tables.boxes import rect_of
from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look
from game.ui.look.shapes import draw_box

LEAST = 12.0  # px; smaller letters are not read at 1280 x 720
LEAD = 48.0  # design px of a row before its words


class Row(NamedTuple):
    """A row. lead: at its left end; words, under: its two lines; color: of the words. lit: it is chosen;
    faint: it is not of the line in play; head: it is a heading over others. share: 0 to 1, drawn as a bar.
    """

    lead: str
    words: str
    under: str = ""
    color: str = "text1"
    lit: bool = False
    faint: bool = False
    head: bool = False
    share: float | None = None


def draw_ground(canvas: Canvas, look: Look, column: Column, title: str, under: str) -> pygame.Rect:
    """The column's ground with its heading; its place, px."""
    rect, px = rect_of(canvas, column.box), look.px
    draw_box(canvas.surface, rect, px(8), look.theme.panel, look.theme.line, look.border)
    x, space = rect.x + px(14), rect.w - px(28)
    look.text(
        canvas.surface, look.fonts.fit(title, 15, "semibold", space), (x, rect.y + px(18)), 15, "semibold"
    )
    size = legible(look)
    for row, said in enumerate(look.fonts.wrap(under, size, "medium", max(space, 1))[:2]):
        look.text(canvas.surface, said, (x, rect.y + px(38 + 16 * row)), size, "medium", "text2")
    return rect


def draw_rows(canvas: Canvas, look: Look, column: Column, rows: Sequence[Row], first: int = 0) -> None:
    """Rows below each other, from that place on, as many as there is space for."""
    for place, row in enumerate(rows[: max(column.rows - first, 0)], first):
        _draw_row(canvas, look, rect_of(canvas, column.row_box(place)), row)


def legible(look: Look) -> int:
    """The size of the column's words, design px: 12, and more where the picture is small."""
    return max(12, math.ceil(LEAST / look.k))


def _draw_row(canvas: Canvas, look: Look, rect: pygame.Rect, row: Row) -> None:
    px, theme, surface = look.px, look.theme, canvas.surface
    if rect.w < px(LEAD) + px(20):
        return
    size = legible(look)
    if row.head:
        words = look.fonts.fit(row.words, size, "semibold", rect.w)
        look.text(surface, words, (rect.x + px(4), rect.centery), size, "semibold", "text2")
        return
    fill, line = (theme.accent_soft, theme.accent) if row.lit else (theme.inset, None)
    draw_box(surface, rect, px(6), fill, line, max(1, px(1.5)))
    quiet = "text3" if row.faint else None
    up = px(4) if row.share is not None else 0
    at = (rect.x + px(LEAD / 2), rect.centery - up)
    look.text(surface, row.lead, at, 13, "semibold", quiet or "text1", "center")
    if row.share is not None:
        bar = pygame.Rect(rect.x + px(8), rect.bottom - px(9), px(LEAD - 16), max(2, px(4)))
        draw_box(surface, bar, px(2), theme.hover)
        full = pygame.Rect(bar.x, bar.y, max(1, round(bar.w * row.share)), bar.h)
        draw_box(surface, full, px(2), look.color("green"))
    x, space = rect.x + px(LEAD), rect.w - px(LEAD + 8)
    y = rect.centery if not row.under else rect.centery - px(9)
    words = look.fonts.fit(row.words, size, "semibold", space)
    look.text(surface, words, (x, y), size, "semibold", quiet or row.color)
    if row.under:
        under = look.fonts.fit(row.under, size, "medium", space)
        look.text(surface, under, (x, rect.centery + px(9)), size, "medium", quiet or "text2")
