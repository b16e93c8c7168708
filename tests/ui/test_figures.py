"""Figures of the help pages: every scene has one, it stays in its frame, and draws in both themes."""

import numpy as np
import pygame
import pytest

from game.scenes import CATALOGUE
from game.ui.canvas.pen import FIGURE, Pen
from game.ui.look.look import Look
from game.ui.look.theme import THEMES

SIZE = (592, 416)


@pytest.mark.parametrize("name", [entry.name for entry in CATALOGUE])
@pytest.mark.parametrize("theme", list(THEMES))
def test_the_figure_of_a_scene_is_drawn_and_its_words_are_inside(name: str, theme: str):
    figure = CATALOGUE[name].load().figure
    assert figure is not None
    pen = Pen(SIZE, Look(THEMES[theme], 2.0), FIGURE)
    pen.fill("stage")
    ground = pygame.surfarray.array3d(pen.finished())
    figure(pen)
    drawn = np.any(pygame.surfarray.array3d(pen.finished()) != ground, axis=2)
    assert 0.02 < drawn.mean() < 0.98
    frame = pygame.Rect((0, 0), SIZE)
    places = pen.word_places()
    assert places and all(frame.contains(place) for place in places)
    for i, place in enumerate(places):
        assert all(not place.inflate(-6, -10).colliderect(other.inflate(-6, -10)) for other in places[:i])
