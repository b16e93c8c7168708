"""Live pictures of the menu's cards: what each scene's card.py brings close, and when."""

import numpy as np
import pygame
import pytest

from game.app.menu.live import LiveScene
from game.levels import level_files
from game.scenes import CATALOGUE
from game.stage.catalogue import CloseUp, Entry
from game.ui.look.look import Look
from game.ui.look.theme import DARK

SIZE = (160, 104)
BALL = CATALOGUE["bouncing-ball"]


def test_every_close_up_is_of_a_scene_of_its_folder_and_of_a_level_that_there_is():
    told = {}
    for entry in CATALOGUE:
        shown = entry.close_up()
        told[entry.name] = shown
        assert 0.0 <= shown.across <= 1.0 and 0.0 <= shown.down <= 1.0 and shown.zoom >= 1.0
        assert not shown.level or shown.level in {file.stem for file in level_files(entry.name)}
    assert all(shown != CloseUp() for shown in told.values()), "a card shows all of its scene, too small"


def test_a_scene_without_a_card_of_its_own_is_shown_whole():
    assert Entry("x", "", "", "", "", "no_such_module", "X").close_up() == CloseUp()


@pytest.mark.compiled
@pytest.mark.parametrize("closer", [CloseUp(0.5, 2.0, 0.25, 0.7), CloseUp(1.0, 3.0, 1.0, 0.0)])
def test_the_point_that_is_named_stands_in_the_middle_so_many_times_nearer(monkeypatch, closer):
    monkeypatch.setattr(Entry, "close_up", lambda entry: CloseUp())
    whole = LiveScene(BALL)
    first = whole.draw(SIZE, Look(DARK, 1.0))
    frame, before = whole.stage.scene.frame(), whole.camera
    monkeypatch.setattr(Entry, "close_up", lambda entry: closer)
    near = LiveScene(BALL)
    second = near.draw(SIZE, Look(DARK, 1.0))
    point = (
        frame.left + closer.across * (frame.right - frame.left),
        frame.top + closer.down * (frame.bottom - frame.top),
    )
    assert near.camera.to_screen(*point) == pytest.approx(near.camera.rect.center)
    assert near.camera.scale == pytest.approx(closer.zoom * before.scale)
    assert near.stage.time_s == pytest.approx(closer.shown_s, abs=near.stage.dt)
    pictures = [pygame.surfarray.array3d(picture) for picture in (first, second)]
    assert not np.array_equal(*pictures)


@pytest.mark.compiled
def test_a_card_shows_the_level_that_it_names(monkeypatch):
    monkeypatch.setattr(Entry, "close_up", lambda entry: CloseUp(level="hard-01-without-end"))
    assert LiveScene(BALL).stage.level.path.stem == "hard-01-without-end"
