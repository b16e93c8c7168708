"""Readouts beside the world stay where they are when the picture is moved."""

from __future__ import annotations

import numpy as np
import pygame
import pytest

from game.app.stagehand.opening import read_level
from game.app.stagehand.view import StageView
from game.levels import level_files
from game.scenes import CATALOGUE
from game.stage import Stage
from game.ui.look.look import Look
from game.ui.look.theme import DARK

PLACE = pygame.Rect(0, 0, 960, 520)


@pytest.mark.parametrize("name", ["c05", "c06", "c07"])
def test_the_column_is_the_same_wherever_one_looks(name: str):
    scene_type = CATALOGUE[name].load()
    path = next(path for path in level_files(name) if path.stem.startswith("hard-01"))
    stage = Stage(scene_type, level=read_level(scene_type, path))
    stage.pause()
    look = Look(DARK)
    view = StageView(stage, look)
    view.place(PLACE, look)
    pictures = []
    for turn in range(2):
        surface = pygame.Surface(PLACE.size, 0, 32)
        if turn:
            view.camera.zoom(3.0, (600, 200), smooth=False)
            view.camera.pan(150, 40)
        view.draw(surface, True)
        pictures.append(pygame.surfarray.array3d(surface))
    column = slice(20, 240), slice(180, 480)
    letters = [(picture[column].sum(axis=2) > 300) for picture in pictures]
    assert letters[0].sum() > 1000, "there is something to be read"
    assert np.count_nonzero(letters[0] ^ letters[1]) < 0.1 * letters[0].sum(), "but for what shines through"
