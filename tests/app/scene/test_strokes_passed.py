"""A stroke for the other player, in the window: copied, kept in a file, taken, refused."""

from __future__ import annotations

import pygame
import pytest

from game.app.window import clipboard
from game.stage import Action
from tests.app.tests_app import Driver
from tests.stage.example_scene import KICK

SHIFTED = pygame.KMOD_CTRL | pygame.KMOD_SHIFT


@pytest.fixture
def said(driver: Driver, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """What messages have said."""
    lines: list[str] = []
    monkeypatch.setattr(
        driver.app, "tell", lambda cause, more="", kind="info": lines.append(f"{cause} {more}")
    )
    return lines


@pytest.fixture
def board(monkeypatch: pytest.MonkeyPatch) -> dict[str, str]:
    """A clipboard of the test's own."""
    kept = {"text": ""}
    monkeypatch.setattr(clipboard, "put", lambda text: kept.update(text=text) or "")
    monkeypatch.setattr(clipboard, "get", lambda: kept["text"])
    return kept


def opened(driver: Driver) -> Driver:
    driver.open("example")
    driver.frames(10)
    return driver


def test_a_scene_without_strokes_says_so(driver: Driver, said, board):
    opened(driver).key(pygame.K_x, mod=SHIFTED)
    driver.frames(3)
    assert "Not copied. stroke: this scene has none" in " ".join(said) and board["text"] == ""


def test_a_stroke_is_copied_by_its_key(driver: Driver, said, board, monkeypatch):
    monkeypatch.setattr(opened(driver).stage.scene, "given_text", lambda: "stroke1.x")
    driver.key(pygame.K_x, mod=SHIFTED)
    driver.frames(3)
    assert board["text"] == "stroke1.x" and "copied for the other player" in " ".join(said)


def test_without_a_clipboard_the_text_lies_in_a_file_and_is_read_from_it(monkeypatch, tmp_path):
    def none(*given):
        raise pygame.error("no clipboard")

    monkeypatch.setenv("CAROM_HOME", str(tmp_path))
    monkeypatch.setattr(pygame.scrap, "put_text", none)
    monkeypatch.setattr(pygame.scrap, "get_text", none)
    assert clipboard.get() == ""
    where = clipboard.put_or_keep("stroke1.y")
    assert str(tmp_path) in where and clipboard.get() == "stroke1.y"


def test_a_pasted_stroke_is_played_and_one_that_does_not_fit_is_told(
    driver: Driver, said, board, monkeypatch
):
    scene = opened(driver).stage.scene
    posted: list[object] = []
    monkeypatch.setattr(driver.top.play.passing, "_post", lambda event: posted.append(event) or True)
    monkeypatch.setattr(scene, "take_text", lambda text: (KICK,))
    driver.key(pygame.K_v, mod=pygame.KMOD_CTRL)
    driver.frames(3)
    assert posted == [Action(KICK.name)] and "same end here" in " ".join(said)

    def refuses(text):
        raise ValueError("check: a letter of the text is wrong, or missing")

    monkeypatch.setattr(scene, "take_text", refuses)
    driver.key(pygame.K_v, mod=pygame.KMOD_CTRL)
    driver.frames(3)
    assert "Not played. check: a letter" in " ".join(said) and len(posted) == 1
