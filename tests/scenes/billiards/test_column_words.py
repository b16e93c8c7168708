"""The words of the column beside the table are large enough to be read, whatever the size of its picture."""

from __future__ import annotations

import pygame
import pytest

from game.app.stagehand.headless import prepare
from game.app.stagehand.view import StageView
from game.scenes.shared.tables.beside.rows import LEAST
from game.ui.look.layout import auto_scale
from game.ui.look.look import Look
from game.ui.look.theme import theme_named
from tests.scenes.billiards.billiards_stages import straight_pot


@pytest.mark.parametrize("size", [(1280, 720), (1920, 1080)])
def test_the_coach_speaks_in_letters_of_twelve_pixels_at_least(size, monkeypatch):
    prepare()
    stage = straight_pot()
    stage.scene.parameters.beside = "coach"
    stage.run(2)
    said: dict[str, int] = {}
    plain = Look.text

    def text(self, surface, words, at, size=13, *more, **named):
        said[words] = max(round(size * self.k), self.fonts.least)
        return plain(self, surface, words, at, size, *more, **named)

    monkeypatch.setattr(Look, "text", text)
    look, surface = Look(theme_named("dark"), auto_scale(*size)), pygame.Surface(size, 0, 32)
    view = StageView(stage, look)
    view.place(surface.get_rect(), look)
    view.draw(surface)
    own = {
        words: px
        for words, px in said.items()
        if words.startswith(("Ask before", "the score then", "Play a"))
    }
    assert len(own) == 3
    assert min(own.values()) >= LEAST
