"""One play: Space and the bar play and pause the motion; steps, and with them the charts, go on."""

from __future__ import annotations

import pygame
import pytest

from game.app.fuzz.driver import Driver
from game.levels import level_files, parse_level
from game.scenes import CATALOGUE
from game.scenes.key_frames.level import Motion
from game.scenes.key_frames.scene import KeyFraming
from game.stage import Action, SetParameter, Stage
from tests.scenes.particle_stages import open_level


@pytest.fixture
def driver(tmp_path, monkeypatch):
    monkeypatch.setenv("CAROM_HOME", str(tmp_path))
    made = Driver(tmp_path, (1280, 720), CATALOGUE)
    made.open("c01")
    made.frames(10)
    yield made
    made.close()


def shown_time(driver):
    return driver.stage.scene.model.player.present()


def test_space_pauses_the_motion_and_plays_it_again(driver):
    driver.key(pygame.K_SPACE)
    assert not driver.stage.scene.parameters.playing and not driver.stage.paused
    assert driver.top.shell.bar.state.paused
    time, step = shown_time(driver), driver.stage.step_number
    driver.frames(10)
    assert shown_time(driver) == time and driver.stage.step_number > step
    driver.key(pygame.K_SPACE)
    driver.frames(10)
    assert shown_time(driver) > time
    assert not driver.top.shell.bar.state.paused
    events = [stamped.event for stamped in driver.stage.recording.events]
    assert events == [Action("play"), Action("play")]


def test_space_plays_from_where_the_slider_was_put(driver):
    driver.top.play.post(SetParameter("time", 0.4))
    driver.frames(3)
    assert driver.top.shell.bar.state.paused and shown_time(driver) == 0.4
    driver.key(pygame.K_SPACE)
    driver.frames(6)
    assert 0.4 < shown_time(driver) < 0.5


def test_a_step_pauses_all_and_space_goes_on(driver):
    time, step = shown_time(driver), driver.stage.step_number
    driver.key(pygame.K_PERIOD)
    assert driver.stage.step_number == step + 1 and shown_time(driver) > time
    driver.frames(5)
    assert driver.stage.step_number == step + 1 and driver.stage.paused
    driver.key(pygame.K_SPACE)
    driver.frames(5)
    assert driver.stage.step_number > step + 1 and not driver.top.shell.bar.state.paused
    driver.key(pygame.K_SPACE)
    driver.key(pygame.K_PERIOD)
    driver.key(pygame.K_SPACE)  # once for both
    driver.frames(5)
    assert not driver.stage.still


def test_a_step_back_and_then_space_goes_on(driver):
    driver.key(pygame.K_SPACE)
    driver.frames(4)
    driver.key(pygame.K_COMMA)
    assert driver.stage.paused
    time = shown_time(driver)
    driver.key(pygame.K_SPACE)
    driver.frames(5)
    assert not driver.stage.paused and shown_time(driver) > time


def test_what_was_stepped_back_is_repeated_while_the_motion_is_paused(driver):
    driver.key(pygame.K_SPACE)
    driver.top.play.post(SetParameter("time", 0.2))
    driver.frames(5)
    driver.top.play.post(SetParameter("time", 0.9))
    driver.frames(5)
    step, digest = driver.stage.step_number, driver.stage.digest()
    for key in (pygame.K_COMMA, pygame.K_PERIOD):
        for _ in range(20):
            driver.key(key)
    assert (driver.stage.step_number, driver.stage.digest()) == (step, digest)


@pytest.mark.parametrize("stepped", [False, True])
def test_the_charts_follow_a_scrub_of_the_paused_motion(driver, stepped):
    driver.key(pygame.K_SPACE)
    if stepped:
        driver.key(pygame.K_PERIOD)  # then no step follows
    for time in (0.3, 0.7):
        driver.top.play.post(SetParameter("time", time))
        driver.frames(3)
        x, y, _ = driver.stage.scene.model.pose.tolist()
        assert driver.stage.series.values("x")[-1] == x
        assert driver.stage.series.values("y")[-1] == y


def test_a_recording_is_paused_not_changed(driver):
    """While it plays, Space lets the stage stand: an event would end it."""
    driver.key(pygame.K_SPACE)
    driver.frames(30)
    driver.key(pygame.K_SPACE)
    driver.frames(30)
    recording = driver.stage.recording
    play = driver.top.play
    play.record.show(Stage(KeyFraming), recording)
    driver.frames(4)
    driver.key(pygame.K_SPACE)
    assert driver.stage.paused and driver.stage.recording.events == []
    driver.key(pygame.K_SPACE)
    driver.frames(60)
    assert not driver.stage.paused
    assert [stamped.event for stamped in driver.stage.recording.events] == [Action("play")] * 2


def test_levels_with_the_former_switch_open_and_are_saved():
    text = 'scene = "c01"\n[parameters]\nplaying = false\n[content]\nkeys = [{ time = 0.0 }]\n'
    stage = Stage(KeyFraming, level=parse_level(text, "c01", Motion))
    stage.run(50)
    assert stage.scene.resting and stage.scene.model.player.present() == 0.0
    assert any("playing" in path.read_text(encoding="utf-8") for path in level_files("c01"))
    assert not KeyFraming.parameter("playing").in_panel
    stage.post(SetParameter("playing", True))
    stage.run(50)
    assert not stage.scene.resting and stage.scene.model.player.present() > 0.0


def test_sliders_of_the_chosen_key_span_the_view():
    stage = open_level(KeyFraming, "default")
    view = stage.scene.frame()
    assert stage.scene.slider_range("key_x") == (view.left, view.right)
    assert stage.scene.slider_range("key_y") == (view.bottom, view.top)
    assert stage.scene.slider_range("key_angle") == (-360.0, 360.0)
    assert stage.scene.slider_range("duration") is None
    empty = parse_level('scene = "c01"\n[content]\nview = { left = 2.0, right = 2.0 }\n', "c01", Motion)
    assert KeyFraming(empty).slider_range("key_x") is None
