"""What the picture of the dominoes shows: hills without walls, blocks with their friction and mass."""

from __future__ import annotations

import numpy as np
import pygame
import pytest

from game.scenes.domino.scene import Domino
from game.scenes.domino.view import GROUND
from game.stage.declarations import Frame
from game.ui.canvas.camera import Camera
from game.worlds.painting.landscape import _crests
from tests.scenes.labels import Labels
from tests.scenes.particle_stages import open_level

SIZE = (1280, 720)


def canvas_on(frame: Frame) -> Labels:
    """An empty picture of a part of the world."""
    pygame.font.init()
    surface, camera = pygame.Surface(SIZE, 0, 32), Camera()
    camera.fit(frame, surface.get_rect(), 0)
    canvas = Labels()
    canvas.begin(surface, surface.get_rect(), camera)
    return canvas


@pytest.mark.parametrize("x", [-20.0, 3.0, 17.5, 40.0, 66.0])
def test_hills_have_no_walls(x: float) -> None:
    """From one column to the next no crest leaps: forests end in clearings by and by."""
    canvas = canvas_on(Frame(x - 7.0, 2.0, x + 7.0, 10.0))
    leaps = np.abs(np.diff(_crests(canvas, *SIZE, GROUND)[:4], axis=1)).max(axis=1)
    assert np.all(leaps < 8.0), leaps


def test_each_block_is_named_by_its_friction_and_mass_where_it_is_seen() -> None:
    stage = open_level(Domino, "default")
    x, y = stage.scene.story_targets()["blocks"]
    near = canvas_on(Frame(x - 7.0, y - 4.0, x + 7.0, y + 4.0))
    stage.scene.draw(near, 1.0)
    words = [one for one in near.drawn if one.startswith("μ")]
    entries = stage.scene.model.content.sliders
    expected = [f"μ {one.friction:.2f}, {one.density * one.size[0] * one.size[1]:.3g} kg" for one in entries]
    assert sorted(words) == sorted(expected) and len(words) == 5
    for frame in (Frame(-10.0, y - 4.0, 4.0, y + 4.0), stage.scene.frame()):  # elsewhere, and from far away
        far = canvas_on(frame)
        stage.scene.draw(far, 1.0)
        assert not [one for one in far.drawn if one.startswith("μ")]
