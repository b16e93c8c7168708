"""Runs as texts in the window: copied with Ctrl+Shift+C, opened with Ctrl+V, compared at their end."""

from __future__ import annotations

import pygame
import pytest

from game.app.menu.screen import MenuScreen
from game.app.scene.screen import SceneScreen
from game.app.window import clipboard
from game.stage import Pointer, SetEffect, SetParameter
from game.stage.records.run_text import recording_in
from game.stage.replaying import replay_scene
from tests.app.tests_app import Driver
from tests.stage.example_scene import KICK


@pytest.fixture(autouse=True)
def board(monkeypatch: pytest.MonkeyPatch) -> dict[str, str]:
    """A clipboard of the test's own."""
    kept = {"text": ""}
    monkeypatch.setattr(clipboard, "put", lambda text: kept.update(text=text) or "")
    monkeypatch.setattr(clipboard, "get", lambda: kept["text"])
    return kept


@pytest.fixture(autouse=True)
def said(driver: Driver, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """What messages have said."""
    lines: list[str] = []
    tell = driver.app.tell

    def heard(cause: str, consequence: str = "", kind: str = "info") -> None:
        lines.append(f"{cause} {consequence}")
        tell(cause, consequence, kind)

    monkeypatch.setattr(driver.app, "tell", heard)
    return lines


def test_a_session_is_copied_and_watched_again_to_its_digest(driver: Driver, said, board):
    driver.open("example")
    driver.frames(30)
    driver.stage.post(KICK)
    driver.frames(30)
    driver.app.perform("pause")
    digest, steps = driver.stage.digest(), driver.stage.step_number
    driver.key(pygame.K_c, mod=pygame.KMOD_CTRL | pygame.KMOD_SHIFT)
    driver.frames(5)
    assert "The session is copied as text." in " ".join(said)
    recording = recording_in(board["text"])
    assert (recording.digest, recording.steps) == (digest, steps)
    driver.app.open_menu()
    driver.frames(5)
    driver.key(pygame.K_v, mod=pygame.KMOD_CTRL)
    driver.frames(20)
    assert isinstance(driver.top, SceneScreen)
    while driver.stage.step_number <= steps:
        assert "came to the recorded digest" not in " ".join(said)
        driver.frames(1)
    driver.frames(2)
    assert "The replay came to the recorded digest." in " ".join(said)


def test_a_wrong_digest_is_told_at_the_end(driver: Driver, said, board):
    driver.open("example")
    driver.frames(20)
    driver.app.perform("copy")
    driver.frames(5)
    text = board["text"]
    board["text"] = text.replace(recording_in(text).digest, "0" * 32)
    driver.app.perform("paste")
    driver.frames(60)
    assert "The replay ended otherwise" in " ".join(said)


@pytest.mark.parametrize(
    ("text", "why"),
    [("", "expected carom1"), ("Good morning", "expected carom1"), ("carom9.a.00.AA", "later one is needed"),
     ("carom1.elsewhere." + "0" * 32 + ".AAAA", "damaged")],
)  # fmt: skip
def test_what_is_no_run_leaves_everything_as_it_is(driver: Driver, said, board, text: str, why: str):
    board["text"] = text
    assert driver.app.perform("paste")
    driver.frames(2)
    assert isinstance(driver.top, MenuScreen) and why in " ".join(said)


@pytest.fixture
def watched(driver: Driver, board) -> Driver:
    """A run of a hundred steps and more is watched; it has come a quarter of the way."""
    driver.open("example")
    driver.frames(20)
    driver.stage.post(Pointer("down", 0.5, 1.5, 1))
    driver.frames(20)
    driver.stage.post(Pointer("up", 0.5, 1.5, 1))
    driver.frames(30)
    driver.stage.post(KICK)
    driver.frames(30)
    driver.app.perform("copy")
    driver.frames(5)
    driver.app.perform("paste")
    driver.frames(30)
    return driver


def sign(driver: Driver) -> str:
    """What is said of the recording over the picture."""
    return driver.top.play.record.watched


def test_the_first_touch_takes_a_run_over_at_its_step_and_says_so(watched: Driver, said, board):
    assert sign(watched).startswith("Replay, step ")
    watched.key(pygame.K_SPACE)
    step, events = watched.stage.step_number, len(watched.stage.recording.events)
    watched.key(pygame.K_SPACE)
    watched.key(pygame.K_k)  # the scene's own key
    taken = watched.stage.recording.events[-1]
    assert taken.event == KICK and step <= taken.step <= step + 4
    assert f"The run is yours from step {taken.step} on." in " ".join(said)
    assert sign(watched) == "" and len(watched.stage.recording.events) <= events + 2
    watched.frames(120)
    assert watched.stage.recording.events[-1] == taken  # nothing of the recording comes any more
    assert "recorded digest" not in " ".join(said)
    assert [line.startswith("The run is yours") for line in said].count(True) == 1
    watched.app.perform("copy")
    watched.frames(5)
    replay_scene(recording_in(board["text"]), watched.stage.scene_type)  # the new run goes again


def test_what_the_recordings_hand_holds_is_let_go_when_somebody_takes_over(watched: Driver):
    while not watched.stage.scene.held:
        watched.frames(1)
    watched.top.play.post(SetParameter("gravity", 3.0))
    assert not watched.stage.scene.held
    kinds = [getattr(one.event, "kind", one.event) for one in watched.stage.recording.events]
    assert kinds == ["down", "cancel", SetParameter("gravity", 3.0)]


@pytest.mark.parametrize("touch", ["slider", "drag", "effect"])
def test_panel_and_hand_take_over(watched: Driver, touch: str):
    if touch == "slider":
        watched.top.play.post(SetParameter("restitution", 0.2))
    elif touch == "effect":
        watched.top.play.post(SetEffect("test-gravity", False))
    else:
        x, y = watched.top.play.view.camera.to_screen(0.2, 0.4)
        watched.move(round(x), round(y))
        assert sign(watched)
        watched.button(True, round(x), round(y))
        watched.frames(2)
    assert sign(watched) == "" and watched.top.play.record.script is None


def test_looking_is_no_touch(watched: Driver, said, board):
    for command in ("slower", "faster", "view", "step-back", "step", "pause", "pause", "charts"):
        watched.app.perform(command)
        watched.frames(2)
    watched.key(pygame.K_ESCAPE)
    watched.frames(20)
    x, y = watched.top.play.view.rect.center
    for i in range(20):
        watched.move(x + i, y)
    watched.top.play.post(SetParameter("gravity", 1e9))  # refused
    watched.wheel(2)
    assert sign(watched)
    watched.app.perform("pause")
    if watched.stage.paused:
        watched.app.perform("pause")
    watched.frames(220)
    assert "The replay came to the recorded digest." in " ".join(said)


def test_step_by_step_a_replay_goes_the_same_way(watched: Driver, said, board):
    watched.key(pygame.K_SPACE)
    steps = recording_in(board["text"]).steps
    while watched.stage.step_number < steps:
        watched.key(pygame.K_PERIOD)
    assert "The replay came to the recorded digest." in " ".join(said)


def test_after_its_end_the_run_is_the_viewers(watched: Driver, said):
    watched.frames(200)
    assert "The replay came to the recorded digest." in " ".join(said) and sign(watched) == ""
    watched.key(pygame.K_k)
    assert watched.stage.recording.events[-1].event == KICK
    assert "The run is yours" not in " ".join(said)


def test_nothing_is_won_or_kept_in_a_run_of_somebody_else(watched: Driver, monkeypatch):
    kept = []
    monkeypatch.setattr(watched.top.play.steps, "_keep", kept.append)
    watched.key(pygame.K_k)
    watched.frames(10)
    assert not kept
    watched.app.perform("reset")
    watched.frames(5)
    assert kept


def test_a_clipboard_that_there_is_not_is_told(driver: Driver, said, monkeypatch):
    monkeypatch.setattr(clipboard, "put", lambda text: "There is no clipboard: none")
    driver.open("example")
    driver.app.perform("copy")
    driver.frames(5)
    assert "Not copied. There is no clipboard" in " ".join(said)


def test_the_systems_own_clipboard(driver: Driver, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.undo()
    assert clipboard.put("carom1 text") == "" and clipboard.get() == "carom1 text"
