"""Runs as texts in the window: copied with Ctrl+Shift+C, opened with Ctrl+V, compared at their end."""

from __future__ import annotations

import pygame
import pytest

from game.app.menu.screen import MenuScreen
from game.app.scene.screen import SceneScreen
from game.app.window import clipboard
from game.stage.records.run_text import recording_in
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


def test_a_clipboard_that_there_is_not_is_told(driver: Driver, said, monkeypatch):
    monkeypatch.setattr(clipboard, "put", lambda text: "There is no clipboard: none")
    driver.open("example")
    driver.app.perform("copy")
    driver.frames(5)
    assert "Not copied. There is no clipboard" in " ".join(said)


def test_the_systems_own_clipboard(driver: Driver, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.undo()
    assert clipboard.put("carom1 text") == "" and clipboard.get() == "carom1 text"
