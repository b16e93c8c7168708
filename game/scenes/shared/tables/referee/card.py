"""The card at the end of a frame: who won it, and what was counted of both players."""

from __future__ import annotations

from typing import NamedTuple

import pygame

from game.scenes.shared.tables.boxes import Box, rect_of
from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look
from game.ui.look.numerals import NOTHING
from game.ui.look.shapes import draw_box

WIDTH, ROW, HEAD, FOOT = 380.0, 28.0, 84.0, 44.0  # design px


class Counted(NamedTuple):
    """What the card says. rows: head, and the figure of each player; foot: what can be done next."""

    title: str
    names: tuple[str, str]
    rows: tuple[tuple[str, str, str], ...]
    foot: str


def share_words(scoring: int, tries: int) -> str:
    """A share of tries, in per cent."""
    return f"{100.0 * scoring / tries:.0f} % of {tries}" if tries else NOTHING


def time_words(seconds: float) -> str:
    """Minutes and seconds."""
    whole = int(seconds)
    return f"{whole // 60}:{whole % 60:02d} min"


def draw_card(canvas: Canvas, look: Look, bed: Box, counted: Counted) -> None:
    """The card in the middle of the table."""
    table, px = rect_of(canvas, bed), look.px
    rect = pygame.Rect(0, 0, px(WIDTH), px(HEAD + ROW * len(counted.rows) + FOOT))
    rect.center = table.center
    surface = canvas.surface
    draw_box(surface, rect, px(12), look.theme.panel, look.theme.line, look.border)
    left, right, space = rect.x + px(24), rect.right - px(24), rect.w - px(48)
    title = look.fonts.fit(counted.title, 20, "display", space)
    look.text(surface, title, (left, rect.y + px(30)), 20, "display", "text1")
    columns = right - px(112), right
    for column, name in zip(columns, counted.names, strict=True):
        fitted = look.fonts.fit(name, 13, "semibold", px(100))
        look.text(surface, fitted, (column, rect.y + px(64)), 13, "semibold", "text1", "right")
    for row, (head, *figures) in enumerate(counted.rows):
        y = rect.y + px(HEAD + ROW * (row + 0.25))
        look.text(surface, head, (left, y), 13, "medium", "text2")
        for column, words in zip(columns, figures, strict=True):
            look.text(surface, words, (column, y), 13, "semibold", "text1", "right")
    look.text(surface, counted.foot, (left, rect.bottom - px(22)), 12, "medium", "text3")
