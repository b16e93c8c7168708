"""Buttons round a table say all of their words, however small the window."""

from __future__ import annotations

import pygame
import pytest

from game.scenes.shared.tables import buttons
from game.scenes.shared.tables.boxes import Box
from game.scenes.shared.tables.choices import GUIDE_BUTTONS
from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look
from game.ui.look.theme import theme_named

SMALL = (51, 18)  # px, of a button in a window of 900 x 600


@pytest.mark.parametrize("words", sorted(GUIDE_BUTTONS.values()))
def test_a_small_button_is_not_cut(words: str, monkeypatch: pytest.MonkeyPatch):
    pygame.font.init()
    said = []
    monkeypatch.setattr(Look, "text", lambda _, picture, line, place, size, *rest: said.append((line, size)))
    monkeypatch.setattr(buttons, "rect_of", lambda *_: pygame.Rect((0, 0), SMALL))
    look = Look(theme_named("dark"), 1.0)
    canvas = Canvas(look)
    canvas.surface = pygame.Surface(SMALL, 0, 32)
    buttons.draw_button(canvas, look, Box(0.0, 0.0, 1.0, 1.0), words)
    ((line, size),) = said
    assert line == words and 10 <= size <= 12
