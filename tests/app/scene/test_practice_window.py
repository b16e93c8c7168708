"""Practice in the window: every view drawn at each size and theme, drills saved and opened, sets kept."""

import time

import numpy as np
import pygame
import pytest

from game.levels import user_level_files
from game.scenes import CATALOGUE
from game.scenes.billiards.practice import columns
from game.scenes.shared.tables import grip
from game.stage import Action, Decision, SetParameter
from game.stage.records.history import read_history
from tests.app.tests_app import Driver

NO_CALL = (-1.0, -1.0, 0.0, 0.0)


@pytest.fixture
def driver(tmp_path, monkeypatch):
    monkeypatch.setenv("CAROM_HOME", str(tmp_path))
    driver = Driver(tmp_path, catalogue=CATALOGUE)
    driver.open("billiards")
    yield driver
    driver.close()


def strike(driver: Driver, *stroke: float) -> None:
    """A stroke, skipped to its end."""
    driver.stage.post(Decision("stroke", (*stroke, *NO_CALL)))
    driver.frames(60, 0.1)
    if driver.stage.scene.play.phase == "rolling":
        driver.key(pygame.K_RETURN)
    driver.frames(3)
    assert driver.stage.scene.play.phase == "aiming"


def drawn(driver: Driver) -> np.ndarray:
    driver.frames(2)
    assert driver.top.play.trouble == ""
    return pygame.surfarray.array3d(driver.window.surface)


def column_rect(driver: Driver) -> pygame.Rect:
    camera = driver.top.play.view.camera
    left, top = camera.to_screen(columns.COLUMN.box.top, columns.COLUMN.box.left)
    right, foot = camera.to_screen(columns.COLUMN.box.bottom, columns.COLUMN.box.right)
    return pygame.Rect(round(left), round(top), round(right - left), round(foot - top))


@pytest.mark.parametrize("size", [(1920, 1080), (700, 500)])
def test_each_view_comes_and_goes_by_its_key(driver, size):
    driver.stage.post(SetParameter("game", "ghost-nine-ball"))
    driver.resize(*size)
    strike(driver, 7.0, 1.58, 0.0, 0.0, 0.0)
    camera = driver.top.play.view.camera
    for key in (pygame.K_m, pygame.K_g, pygame.K_t, pygame.K_j):
        before, scale = drawn(driver), camera.scale
        driver.key(key)
        driver.frames(4)
        with_it = drawn(driver)
        assert (with_it != before).any()
        if key != pygame.K_j:
            assert camera.scale < scale
            assert driver.window.surface.get_rect().contains(column_rect(driver))
            assert not column_rect(driver).colliderect(driver.top.shell.layout.hint_bar)
        driver.app.toggle_theme()
        assert (drawn(driver) != with_it).any()
        driver.app.toggle_theme()
        driver.key(key)
        driver.frames(4)
        assert camera.scale == scale


def test_the_map_comes_while_one_looks_on_and_a_click_plays(driver):
    driver.stage.post(SetParameter("game", "practice"))
    strike(driver, 7.0, 1.58, 0.0, 0.0, 0.0)
    driver.key(pygame.K_m)
    scene = driver.stage.scene
    until = time.monotonic() + 600.0
    while not scene.advisor.fresh and time.monotonic() < until:
        driver.frames(1)
    px, py = driver.top.play.view.camera.to_screen(*columns.COLUMN.row_box(0).middle)
    for phase in ("aiming", "striking"):
        driver.click(round(px), round(py))
        driver.frames(2)
        assert scene.play.phase == phase


def test_a_drill_is_saved_from_the_window_and_opened_from_the_list(driver):
    scene = driver.stage.scene
    driver.stage.post(SetParameter("game", "practice"))
    scene = driver.stage.scene
    driver.stage.post(Action("set-up"))
    scene.set_up.fill(False)
    scene.set_up.drag(2, 0.3, 1.0)
    scene.buttons.press(grip.button("drill"))
    scene.maker.ball, scene.maker.pocket = 2, 4
    drawn(driver)
    scene.buttons.press(grip.button("drill-play"))
    driver.app.perform("save")
    driver.frames(20)
    driver.key(pygame.K_RETURN)  # without a title of one's own
    driver.frames(20)
    (path,) = [path for path in user_level_files("billiards") if path.stem != "autosave"]
    rows = {row.value: row.title for row in driver.top.play.shelf.saved()}
    assert rows[path] == "Drill: pot the 2, upper right pocket"
    driver.top.play.open_file(path)
    driver.frames(5)
    assert driver.stage.scene.model.frame.game.tries == 10
    strike(driver, 1.0, 0.3, 0.0, 0.0, 0.0)
    (one,) = read_history()
    assert (one.title, one.made, one.tried, one.of) == ("Drill: pot the 2, upper right pocket", 0, 1, 10)
    driver.key(pygame.K_t)
    drawn(driver)


def test_what_a_replay_shows_is_not_counted(driver):
    driver.stage.post(SetParameter("game", "ghost-nine-ball"))
    strike(driver, 7.0, 1.58, 0.0, 0.0, 0.0)
    strike(driver, 1.0, -1.0, 0.0, 0.0, 0.0)
    assert [one.tried for one in read_history()] == [1]
    driver.app.perform("save")
    driver.frames(20)
    driver.key(pygame.K_RETURN)  # without a title of one's own
    driver.frames(20)
    recording = next(row.value for row in driver.top.play.shelf.saved() if row.value.suffix == ".json")
    driver.top.play.open_file(recording)
    driver.frames(300, 0.1)
    assert driver.stage.scene.practised[2:] == (0, 1, 10)
    assert [one.tried for one in read_history()] == [1]
