"""Nothing that an overlay, a card, a study, a thumbnail or a scene raises ends the program."""

from __future__ import annotations

import dataclasses
import errno
from collections.abc import Callable
from pathlib import Path

import example_scene
import pygame
import pytest

from game.app.menu import deck
from game.app.menu.live import LiveScene
from game.app.menu.screen import MenuScreen
from game.app.scene import accuracy_card
from game.app.scene.accuracy_card import AccuracyCard
from game.app.scene.help_card import HelpCard
from game.app.scene.screen import SceneScreen
from game.app.window import guard
from game.app.window.guard import Guard
from game.lab import Knob, Method, Outcome, Setting, Study
from game.ui.charts.accuracy import AccuracyPage
from game.ui.widgets.helppage import HelpPage
from tests.app.tests_app import Driver


class OddError(Exception):
    """What the tests have raised."""


def fail(*_args, **_options):
    raise OddError("as the test has it")


def failing(name: str) -> Callable[..., None]:
    """A method of that name that raises."""

    def method(self, *_args, **_options):
        raise OddError("as the test has it")

    method.__code__ = method.__code__.replace(co_name=name)
    return method


@pytest.fixture
def driver(start: Callable[..., Driver]) -> Driver:
    """A program that goes on without what fails, as a window does."""
    return start(forgiving=True)


@pytest.fixture
def scene(driver: Driver) -> Driver:
    driver.open()
    driver.frames(4)
    return driver


@pytest.fixture
def tracebacks(tmp_path: Path) -> Callable[[], int]:
    """How many of the tests' exceptions lie in the file."""

    def count() -> int:
        path = tmp_path / "home" / guard.NAME
        return path.read_text().count("OddError: as the test has it") if path.exists() else 0

    return count


def message_of(driver: Driver) -> str:
    toast = driver.app.toasts.shown
    return f"{toast.cause} {toast.consequence}" if toast is not None else ""


def make_study(**changes) -> Study:
    class Trial:
        simulated_s = 1.0

        def reset(self) -> None:
            pass

        def run(self) -> None:
            pass

        def outcome(self) -> Outcome:
            return Outcome(0.5, 1)

    whole = Study(
        name="odd", title="Odd", error="error", error_unit="m", counter="steps", knob=Knob("gravity", "g"),
        methods=(Method("only", "only"),), settings=lambda: [Setting("only", 1.0)],
        trial=lambda setting: Trial(), reference="none",
    )  # fmt: skip
    return dataclasses.replace(whole, **changes)


# -- overlays and cards


@pytest.mark.parametrize("method", ["draw", "update", "handle"])
def test_an_overlay_that_fails_is_closed(scene: Driver, monkeypatch, tracebacks, method: str):
    scene.key(pygame.K_F1)
    assert isinstance(scene.top, HelpCard)
    monkeypatch.setattr(HelpPage, method, fail)
    scene.move(300, 300)
    scene.frames(2)
    assert isinstance(scene.top, SceneScreen) and scene.app.running
    assert message_of(scene).startswith("Help was closed. Details in ") and guard.NAME in message_of(scene)
    assert tracebacks() == 1
    step = scene.stage.step_number
    scene.frames(20)
    assert scene.stage.step_number > step and scene.stage.fault is None


def test_a_card_that_cannot_be_made_is_not_opened(scene: Driver, monkeypatch, tracebacks):
    monkeypatch.setattr(HelpPage, "__init__", fail)
    scene.key(pygame.K_F1)
    assert isinstance(scene.top, SceneScreen) and scene.stage.fault is None
    assert message_of(scene).startswith("Help cannot be opened.") and tracebacks() == 1
    step = scene.stage.step_number
    scene.frames(20)
    assert scene.stage.step_number > step


def test_a_card_that_cannot_be_closed_is_gone_all_the_same(scene: Driver, monkeypatch, tracebacks):
    monkeypatch.setattr(HelpCard, "closed", fail)
    scene.key(pygame.K_F1)
    scene.frames(30)
    scene.key(pygame.K_ESCAPE)
    scene.frames(30)
    assert isinstance(scene.top, SceneScreen) and tracebacks() == 1
    assert message_of(scene).startswith("Help was closed.")


@pytest.mark.parametrize(
    "broken",
    [
        pytest.param({"settings": fail}, id="settings"),
        pytest.param({"trial": fail}, id="trial"),
        pytest.param({"present": fail}, id="present"),
    ],
)
def test_a_study_that_fails_is_told_of(scene: Driver, monkeypatch, tracebacks, broken):
    monkeypatch.setattr(accuracy_card, "_tables", {})
    monkeypatch.setattr(accuracy_card, "_latest", [])
    monkeypatch.setattr(example_scene.BouncingBall, "study", make_study(**broken))
    scene.key(pygame.K_a)
    if isinstance(scene.top, AccuracyCard):
        scene.top.run.wait(600.0)
        scene.frames(30)
        assert guard.NAME in scene.top.page.data.notes[0]
        scene.key(pygame.K_ESCAPE)
        scene.frames(30)
    else:
        assert message_of(scene).startswith("What accuracy costs cannot be opened.")
    assert isinstance(scene.top, SceneScreen) and scene.stage.fault is None
    assert tracebacks() == 1


def test_a_study_page_that_cannot_be_drawn_is_closed(scene: Driver, monkeypatch, tracebacks):
    monkeypatch.setattr(accuracy_card, "_tables", {})
    monkeypatch.setattr(accuracy_card, "_latest", [])
    monkeypatch.setattr(example_scene.BouncingBall, "study", make_study())
    monkeypatch.setattr(AccuracyPage, "draw", fail)
    scene.key(pygame.K_a)
    scene.frames(2)
    assert isinstance(scene.top, SceneScreen) and tracebacks() == 1
    assert message_of(scene).startswith("What accuracy costs was closed.")


# -- scenes


CALLBACKS = [
    "draw", "readouts", "legend", "messages", "hearing", "advance", "state", "takes_long", "decisions",
]  # fmt: skip


@pytest.mark.parametrize("name", CALLBACKS)
def test_a_scene_whose_callback_fails_is_stopped_and_can_begin_anew(
    scene: Driver, monkeypatch, tracebacks, name: str
):
    scene.top.play.record.errands.in_background = True  # as in a window
    scene.top.play.record.try_steps()  # asks whether they take long
    monkeypatch.setattr(example_scene.BouncingBall, name, failing(name))
    scene.frames(60)
    play = scene.top.play
    assert scene.app.running and scene.stage.fault is not None
    assert "OddError: as the test has it" in play.banner.text
    if name != "advance":  # the stage itself deals with that, and keeps no file
        assert guard.NAME in play.banner.text and tracebacks() == 1
        assert {"draw": "picture"}.get(name, name) in play.banner.text
    monkeypatch.undo()
    play.record.errands.behind = False
    scene.click(*play.banner.spots.find("reset").rect.center)
    scene.frames(20)
    assert scene.stage.fault is None and scene.stage.step_number > 0 and play.banner.text == ""


@pytest.mark.parametrize("name", ["readouts", "draw"])
def test_a_step_back_asks_the_scene_again(scene: Driver, monkeypatch, name: str):
    monkeypatch.setattr(example_scene.BouncingBall, name, failing(name))
    scene.frames(60)
    step = scene.stage.step_number
    monkeypatch.undo()
    scene.key(pygame.K_COMMA)
    scene.frames(2)
    assert scene.stage.fault is None and scene.stage.step_number == step - 1


@pytest.mark.parametrize("name", ["pointer", "action"])
def test_an_event_that_fails_stops_the_scene(scene: Driver, monkeypatch, name: str):
    monkeypatch.setattr(example_scene.BouncingBall, name, failing(name))
    middle = scene.top.shell.layout.free_stage.center
    scene.click(*middle)
    if name == "action":
        scene.top.play.act(example_scene.BouncingBall.actions[0].name)
    scene.frames(2)
    assert scene.app.running and scene.stage.fault is not None
    assert "OddError" in scene.top.play.banner.text


def test_a_stopped_scene_can_be_left_and_its_events_change_nothing(scene: Driver, monkeypatch):
    monkeypatch.setattr(example_scene.BouncingBall, "readouts", fail)
    monkeypatch.setattr(example_scene.BouncingBall, "way_out", property(fail))
    scene.frames(60)
    fault = scene.stage.fault
    scene.click(*scene.top.shell.layout.free_stage.center)
    scene.wheel(1)
    scene.resize(800, 600)
    scene.frames(3)
    assert scene.stage.fault is fault
    scene.key(pygame.K_ESCAPE)
    scene.frames(3)
    assert isinstance(scene.top, MenuScreen)


def test_what_is_round_a_stopped_scene_and_fails_leads_to_the_menu(scene: Driver, monkeypatch):
    monkeypatch.setattr(scene.top.shell, "draw", fail)
    scene.frames(60)
    assert isinstance(scene.top, MenuScreen) and message_of(scene).startswith("The scene was closed.")


def test_a_scene_that_fails_under_a_card_is_stopped(scene: Driver, monkeypatch):
    scene.key(pygame.K_F1)
    monkeypatch.setattr(example_scene.BouncingBall, "draw", failing("draw"))
    scene.resize(1000, 700)
    scene.frames(3)
    assert isinstance(scene.top, HelpCard) and scene.app.running
    stage = next(screen for screen in scene.app.screens if isinstance(screen, SceneScreen)).play.stage
    assert stage.fault.quantity == "the picture"


# -- the menu


def test_a_scene_that_cannot_move_in_its_card_is_dropped(driver: Driver, monkeypatch, tracebacks):
    entry = driver.app.catalogue["example"]
    for name in ("draw", "advance"):
        thumbnails = driver.top.thumbnails
        thumbnails._live["example"] = LiveScene(entry)
        with monkeypatch.context() as patch:
            patch.setattr(LiveScene, name, fail)
            driver.frames(3)
        assert "example" not in thumbnails._live and isinstance(driver.top, MenuScreen)
        assert message_of(driver).startswith("The picture of Bouncing ball cannot be shown.")
        driver.app.toasts.clear()
    assert tracebacks() == 1  # both came out of the same line


def test_a_drawing_that_fails_leaves_its_card_empty(driver: Driver, monkeypatch, tracebacks):
    monkeypatch.setattr(deck, "sketch", fail)
    driver.resize(1100, 720)
    driver.frames(3)
    assert isinstance(driver.top, MenuScreen) and driver.app.running
    assert message_of(driver).endswith("OddError: as the test has it")
    assert tracebacks() == len(driver.app.catalogue)  # one for each


# -- the guard


def test_what_fails_again_and_again_is_written_once(scene: Driver, monkeypatch, tracebacks, tmp_path: Path):
    monkeypatch.setattr(MenuScreen, "update", fail)
    scene.app.open_menu()
    scene.frames(200)
    assert scene.app.running and tracebacks() == 1
    assert (tmp_path / "home" / guard.NAME).stat().st_size < 5_000


def test_no_more_than_so_many_are_written_and_the_file_begins_anew_when_full(tmp_path: Path, monkeypatch):
    monkeypatch.setenv("CAROM_HOME", str(tmp_path))
    path, kept = tmp_path / guard.NAME, Guard()
    for i in range(3 * guard.MOST_KEPT):
        with kept.over(f"number {i}", lambda failure: None):
            fail()
    assert path.read_text().count("Traceback") == guard.MOST_KEPT
    path.write_text("x" * (guard.MOST_BYTES + 1))
    with Guard().over("again", lambda failure: None):
        raise OddError("y" * 2 * guard.MOST_BYTES)
    assert path.stat().st_size <= guard.MOST_BYTES and "x" not in path.read_text()[-1000:]


def test_where_no_file_can_be_written_it_goes_to_standard_error(tmp_path: Path, monkeypatch, capsys):
    blocked = tmp_path / "file"
    blocked.write_text("")
    monkeypatch.setenv("CAROM_HOME", str(blocked))
    seen = []
    with Guard().over("Help", seen.append):
        raise OSError(errno.ENOSPC, "naïve")
    assert seen[0].file is None and seen[0].where == "" and "OSError" in seen[0].message
    assert "na\\xefve" in capsys.readouterr().err


@pytest.mark.parametrize("kind", [KeyboardInterrupt, SystemExit])
def test_who_wants_the_program_to_end_is_let_through(scene: Driver, monkeypatch, kind):
    def end(*_args):
        raise kind

    monkeypatch.setattr(example_scene.BouncingBall, "readouts", end)
    with pytest.raises(kind):
        scene.frames(60)


def test_tests_and_the_fuzzer_see_what_fails(start: Callable[..., Driver], monkeypatch):
    driver = start()
    driver.open()
    monkeypatch.setattr(example_scene.BouncingBall, "readouts", fail)
    with pytest.raises(OddError):
        driver.frames(60)


def test_the_program_ends_even_if_a_screen_cannot_be_closed(scene: Driver, monkeypatch, tracebacks):
    closed = []
    monkeypatch.setattr(SceneScreen, "closed", fail)
    scene.key(pygame.K_F1)
    monkeypatch.setattr(HelpCard, "closed", lambda self: closed.append(self))
    scene.app.running = False
    scene.loop.run()
    assert closed and not len(scene.app.screens) and tracebacks() == 1
