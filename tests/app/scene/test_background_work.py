"""Scenes so large that a change or a step takes longer than a frame: a thread does it, all is as ever."""

from threading import current_thread, main_thread

import pytest

from game.app.scene.playing import steps as steps_module
from game.levels import level_files
from game.scenes import CATALOGUE
from game.stage import Action, SetParameter, Stage

LONG_S = 600.0
STEPS = 24


def settled(driver) -> None:
    """Frames until nothing is under way."""
    play = driver.top.play
    while play.record.errands.busy:
        play.record.errands.wait(LONG_S)
        driver.frames(1)


@pytest.fixture
def opened(start):
    """A scene of the catalogue as a person has it: what takes long is done in the background."""

    def open_scene(name: str):
        driver = start(catalogue=CATALOGUE)
        driver.app.background = True
        driver.open(name)
        settled(driver)
        return driver

    return open_scene


@pytest.mark.parametrize("name", ("c05", "c06", "c07", "broad-phase-race"))
def test_many_boxes_are_made_in_a_thread_and_are_the_same(opened, name, monkeypatch):
    driver = opened(name)
    play = driver.top.play
    threads = []
    take = play.stage.let_in
    monkeypatch.setattr(play.stage, "let_in", lambda event: threads.append(current_thread()) or take(event))
    play.actions["pause"]()
    settled(driver)
    events = (
        SetParameter("count", 10_100),
        Action("fewer"),
        SetParameter("fill", 0.05),
        SetParameter("count", 60),
    )
    for event in events:
        play.post(event)
        assert play.record.errands.inside
        driver.frames(1)
        settled(driver)
    assert len(threads) == len(events) and main_thread() not in threads
    direct = Stage(type(play.stage.scene), level=play.stage.level)
    direct.run(play.stage.step_number)
    for event in events:
        direct.post(event)
    for stage in (play.stage, direct):
        stage.run(STEPS)
    assert play.stage.digest() == direct.digest()


def test_a_refusal_in_the_thread_is_told_in_the_window(opened):
    driver = opened("c06")
    play = driver.top.play
    play.post(SetParameter("count", 10_100))
    play.post(SetParameter("fill", 0.04))
    play.post(SetParameter("ratio", 1e9))
    settled(driver)
    parameters = play.stage.scene.parameters
    assert parameters.fill == 0.04 and parameters.ratio != 1e9
    assert any("ratio" in toast.consequence for toast in (driver.app.toasts.shown,) if toast)


def test_what_is_said_of_a_level_goes_with_its_scene(opened):
    driver = opened("c06")
    play = driver.top.play
    play.open_file(level_files("c06")[1])
    settled(driver)
    assert driver.app.toasts.shown.consequence == play.stage.level.about
    driver.open("c04")
    assert driver.app.toasts.shown is None


def test_slow_steps_are_made_in_a_thread_and_each_is_shown(opened, monkeypatch):
    driver = opened("c06")
    play = driver.top.play
    monkeypatch.setattr(steps_module, "STEPS_BUDGET_S", -1.0)  # no step is quick enough
    drawn = []
    draw = play.view.draw
    monkeypatch.setattr(
        play.view, "draw", lambda surface, *rest: drawn.append(play.stage.step_number) or draw(surface, *rest)
    )
    first = play.stage.step_number
    while play.stage.step_number < first + STEPS:
        driver.frames(1)
        settled(driver)
    assert drawn == sorted(drawn) and set(drawn) >= set(range(first + 1, play.stage.step_number))
    direct = Stage(type(play.stage.scene), level=play.stage.level)
    direct.run(play.stage.step_number)
    assert play.stage.digest() == direct.digest()


def test_step_back_goes_behind_the_window_as_well(opened):
    driver = opened("c06")
    play = driver.top.play
    play.post(SetParameter("count", 10_100))
    settled(driver)
    play.actions["step"]()
    assert play.record.errands.inside
    settled(driver)
    step, digest = play.stage.step_number, play.stage.digest()
    play.actions["step"]()
    play.actions["step-back"]()
    settled(driver)
    assert (play.stage.step_number, play.stage.digest()) == (step, digest)


def test_figures_go_on_while_steps_are_made_in_a_thread(opened, monkeypatch):
    driver = opened("c06")
    play = driver.top.play
    monkeypatch.setattr(steps_module, "STEPS_BUDGET_S", -1.0)
    elapsed = []
    update = play.shell.update
    monkeypatch.setattr(play.shell, "update", lambda s, *rest: elapsed.append(s) or update(s, *rest))
    frames = 0
    first = play.stage.step_number
    while play.stage.step_number < first + 5:
        driver.frames(1)
        frames += 1
        play.record.errands.wait(LONG_S)
    driver.frames(1)
    frames += 1
    settled(driver)
    assert sum(elapsed) == pytest.approx(frames / 60.0, abs=3.0 / 60.0)


@pytest.mark.parametrize(("name", "parameter"), (("c05", "count"), ("c04", "places")))
@pytest.mark.parametrize("value", (None, (1, 2), "many", float("nan"), -1.0))
def test_what_is_no_value_of_a_parameter_is_refused_at_once(opened, name, parameter, value):
    play = opened(name).top.play
    before = play.stage.scene.values[parameter]
    assert not play.post(SetParameter(parameter, value))
    assert not play.record.errands.busy
    assert play.stage.scene.values[parameter] == before
