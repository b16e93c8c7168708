"""Boxes of a formula: glyphs and strokes with their measures, moved about and at last painted."""

from __future__ import annotations

from typing import NamedTuple

import pygame

from game.ui.look.fonts import FontBook
from game.ui.look.shapes import draw_line


class Glyphs(NamedTuple):
    x: float
    y: float  # of the baseline, down from the box's
    text: str
    size: float
    face: str


class Stroke(NamedTuple):
    ax: float
    ay: float
    bx: float
    by: float
    width: float


class Box(NamedTuple):
    """Measures in window px, and what is drawn relative to the left end of the baseline."""

    width: float
    height: float
    depth: float
    marks: tuple[Glyphs | Stroke, ...] = ()
    kind: str = "ordinary"
    slant: float = 0.0  # how far a superscript must move right


def moved(marks: tuple[Glyphs | Stroke, ...], dx: float, dy: float) -> tuple[Glyphs | Stroke, ...]:
    return tuple(
        m._replace(x=m.x + dx, y=m.y + dy)
        if isinstance(m, Glyphs)
        else Stroke(m.ax + dx, m.ay + dy, m.bx + dx, m.by + dy, m.width)
        for m in marks
    )


def paint_box(box: Box, fonts: FontBook, color: pygame.Color) -> pygame.Surface:
    margin = max(2, round(2 * fonts.k))
    size = (round(box.width) + 4 * margin, round(box.height + box.depth) + 2 * margin)
    surface = pygame.Surface(size, pygame.SRCALPHA, 32)
    surface.fill((color.r, color.g, color.b, 0))
    baseline = margin + round(box.height)
    for mark in box.marks:
        if isinstance(mark, Glyphs):
            letters = fonts.render(mark.text, mark.size, mark.face, color)
            top = baseline + mark.y - fonts.ascent(mark.size, mark.face)
            surface.blit(letters, (round(margin + mark.x), round(top)))
        else:
            _draw_stroke(surface, mark, margin, baseline, color)
    return surface


def _draw_stroke(surface: pygame.Surface, s: Stroke, left: int, baseline: int, color: pygame.Color) -> None:
    if s.ay == s.by or s.ax == s.bx:  # along the grid: whole pixels
        x, y = min(s.ax, s.bx), min(s.ay, s.by)
        w, h = abs(s.bx - s.ax), abs(s.by - s.ay)
        if w == 0.0:
            rect = (round(left + x - 0.5 * s.width), round(baseline + y), round(s.width), round(h))
        else:
            rect = (round(left + x), round(baseline + y - 0.5 * s.width), round(w), round(s.width))
        surface.fill(color, rect)
    else:
        draw_line(surface, color, (left + s.ax, baseline + s.ay), (left + s.bx, baseline + s.by), s.width)
