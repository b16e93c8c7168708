"""Buttons round a table."""

from __future__ import annotations

from functools import lru_cache

import pygame

from game.scenes.shared.tables.boxes import Box, rect_of
from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look
from game.ui.look.shapes import draw_box

LEAST = 10  # design px of letters


def draw_button(
    canvas: Canvas, look: Look, box: Box, words: str, on: bool = False, pressed: bool = False
) -> None:
    """A button with words, filled when it is on."""
    rect = rect_of(canvas, box)
    if rect.w > 0 and rect.h > 0:
        canvas.surface.blit(_button_picture(rect.size, look, words, on, pressed), rect)


@lru_cache(maxsize=64)
def _button_picture(size: tuple[int, int], look: Look, words: str, on: bool, pressed: bool) -> pygame.Surface:
    """A button, made again only when it looks otherwise."""
    picture = pygame.Surface(size, pygame.SRCALPHA, 32)
    rect, theme = picture.get_rect(), look.theme
    fill = theme.accent if on else theme.hover if pressed else theme.inset
    draw_box(picture, rect, look.px(8), fill, None if on else theme.line2, look.border)
    color = theme.on_accent if on else theme.text1
    letters, space = 12, rect.w - look.px(4)
    lines = [words]
    if look.fonts.size(words, 12, "semibold")[0] > space:
        letters = 11
        if rect.h >= look.px(32):
            lines = look.fonts.wrap(words, 11, "semibold", space)[:2]
        elif look.fonts.size(words, 11, "semibold")[0] > space:
            letters = LEAST
    for row, line in enumerate(lines):
        y = rect.centery + (row - 0.5 * (len(lines) - 1)) * look.px(14)
        fitted = look.fonts.fit(line, letters, "semibold", space)
        look.text(picture, fitted, (rect.centerx, y), letters, "semibold", color, "center")
    return picture
