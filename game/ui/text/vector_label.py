"""Names of vectors in the picture: bold italic, on a halo of the background."""

from __future__ import annotations

import pygame

from game.ui.look.fonts import FontBook
from game.ui.look.shapes import SurfaceStore
from game.ui.text.formula import FormulaError, render_formula

SIZE, HALO = 18.0, 2.0  # design px
_store = SurfaceStore(1_000_000)


def vector_label(fonts: FontBook, label: str, ink: pygame.Color, halo: pygame.Color) -> pygame.Surface:
    """A label such as ``v_1`` (or any formula) on a halo; kept, so do not draw on it."""
    key = (label, fonts.k, tuple(ink), tuple(halo))
    return _store.get(key, lambda: _make(fonts, label, ink, halo))


def _make(fonts: FontBook, label: str, ink: pygame.Color, halo: pygame.Color) -> pygame.Surface:
    front, back = (_letters(fonts, label, color) for color in (ink, halo))
    reach = max(1, round(HALO * fonts.k))
    size = (front.get_width() + 2 * reach, front.get_height() + 2 * reach)
    picture = pygame.Surface(size, pygame.SRCALPHA, 32)
    picture.fill((halo.r, halo.g, halo.b, 0))
    for i in range(-reach, reach + 1):
        for j in range(-reach, reach + 1):
            if i * i + j * j <= reach * reach + 1:
                picture.blit(back, (reach + i, reach + j))
    picture.blit(front, (reach, reach))
    return picture


def _letters(fonts: FontBook, label: str, color: pygame.Color) -> pygame.Surface:
    """The label as a formula whose first letter is bold; plain words if it cannot be read as one."""
    head = label[:1]
    markup = label if "\\" in label or not head.isalpha() else rf"\v{{{head}}}{label[1:]}"
    try:
        return render_formula(fonts, markup, color, SIZE)
    except FormulaError:
        return fonts.render(label, 13, "semibold", color)
