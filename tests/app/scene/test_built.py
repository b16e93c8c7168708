"""What was built by hand: there again when its scene is opened, and undone press by press."""

from __future__ import annotations

import pygame
import pytest

from game.app.menu.screen import MenuScreen
from game.app.scene import keeping
from game.app.scene.keeping import kept_path
from game.scenes import CATALOGUE
from game.stage import Pointer, SetParameter
from tests.app.tests_app import Driver


@pytest.fixture
def tracks(start) -> Driver:
    driver = start(catalogue=CATALOGUE)
    driver.open("tracks")
    driver.frames(5)
    return driver


def draw(driver: Driver, height: float) -> None:
    """A track by hand, and some steps."""
    driver.stage.post(SetParameter("tool", "draw"))
    for kind, x in (("down", -3.0), *(("move", -3.0 + 0.3 * k) for k in range(8)), ("up", 0.0)):
        driver.stage.post(Pointer(kind, x, height, button=1))
    driver.frames(3)


def count(driver: Driver) -> int:
    return len(driver.stage.scene.model.tracks.riders.curves)


def open_as_a_card_does(driver: Driver, name: str) -> None:
    driver.app.open_scene(name)
    driver.top.loader.wait(600.0)
    driver.frames(3)


def undo(driver: Driver) -> None:
    driver.key(pygame.K_z, mod=pygame.KMOD_CTRL)
    driver.frames(1)


def test_what_was_built_is_there_when_the_scene_is_opened_again(tracks: Driver):
    began = count(tracks)
    draw(tracks, 3.0)
    assert count(tracks) == began + 1
    tracks.key(pygame.K_ESCAPE)
    assert isinstance(tracks.top, MenuScreen) and kept_path("tracks").is_file()
    open_as_a_card_does(tracks, "tracks")
    assert tracks.top.goes_on and count(tracks) == began + 1


def test_who_has_built_nothing_finds_the_scene_as_ever(tracks: Driver):
    tracks.frames(30)
    tracks.key(pygame.K_ESCAPE)
    assert isinstance(tracks.top, MenuScreen) and not kept_path("tracks").exists()


def test_what_cannot_be_kept_is_said(tracks: Driver, monkeypatch):
    said = []
    monkeypatch.setattr(tracks.app, "tell", lambda *words: said.append(" ".join(words)))

    def full(level, path):
        raise OSError("no space left on device")

    draw(tracks, 3.0)
    monkeypatch.setattr(keeping, "save_level", full)
    tracks.key(pygame.K_ESCAPE)
    assert isinstance(tracks.top, MenuScreen)
    assert any("not kept" in words and "no space left" in words for words in said)


def test_undo_takes_back_one_press_after_the_other(tracks: Driver):
    began, digests = count(tracks), []
    for height in (3.0, 3.5):
        digests.append((tracks.stage.step_number, count(tracks)))
        draw(tracks, height)
    assert count(tracks) == began + 2
    for left in (1, 0):
        tracks.app.perform("pause")
        undo(tracks)
        assert count(tracks) == began + left
        tracks.app.perform("pause")
    tracks.frames(5)
    assert tracks.stage.fault is None and count(tracks) == began


def test_undo_says_when_there_is_nothing(tracks: Driver, monkeypatch):
    said = []
    monkeypatch.setattr(tracks.app, "tell", lambda *words: said.append(" ".join(words)))
    undo(tracks)
    assert any("Nothing to undo" in words for words in said)


def test_undo_of_a_drag_that_goes_on_takes_that_drag_back(tracks: Driver):
    began = count(tracks)
    tracks.stage.post(SetParameter("tool", "draw"))
    tracks.stage.post(Pointer("down", -3.0, 3.0, button=1))
    tracks.stage.post(Pointer("move", -1.0, 3.0, button=1))
    undo(tracks)
    tracks.frames(2)
    assert count(tracks) == began and tracks.stage.scene.hand.point is None


def test_where_nothing_is_built_undo_goes_nowhere(driver: Driver, monkeypatch):
    said = []
    monkeypatch.setattr(driver.app, "tell", lambda *words: said.append(" ".join(words)))
    driver.open("example")
    driver.frames(5)
    step = driver.stage.step_number
    driver.stage.post(Pointer("down", 0.5, 1.5, 1))
    undo(driver)
    assert driver.stage.step_number >= step and any("step by step" in words for words in said)


def test_a_scene_that_undoes_by_itself_is_asked(start, monkeypatch):
    driver = start(catalogue=CATALOGUE)
    driver.open("c12")
    driver.frames(3)
    done = []
    monkeypatch.setattr(driver.stage.scene, "action", done.append)
    driver.key(pygame.K_z, mod=pygame.KMOD_LCTRL)
    driver.frames(3)
    assert done == ["undo"]


@pytest.mark.parametrize(
    ("scene", "press", "release"),
    [("solids", (0.0, 6.0), (0.6, 6.6)), ("wind-tunnel", (-0.3, 0.0), (0.3, 0.2))],
)
def test_other_playgrounds_keep_what_was_built_as_well(start, scene, press, release):
    driver = start(catalogue=CATALOGUE)
    open_as_a_card_does(driver, scene)
    if scene == "solids":
        driver.stage.post(SetParameter("tool", "disc"))
    driver.stage.post(Pointer("down", *press, button=1))
    driver.stage.post(Pointer("move", *release, button=1))
    driver.stage.post(Pointer("up", *release, button=1))
    driver.app.perform("pause")
    driver.frames(2)
    built = driver.stage.scene.save_content()
    driver.key(pygame.K_ESCAPE)
    assert kept_path(scene).is_file()
    open_as_a_card_does(driver, scene)
    assert driver.top.goes_on and driver.stage.level is not None
    if scene == "solids":
        assert len(driver.stage.scene.save_content().bodies) == len(built.bodies)
