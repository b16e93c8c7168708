"""The challenge of the day in the window: from the menu's header to the table, and its best stroke copied."""

from __future__ import annotations

import pygame
import pytest

from game.app.stagehand.challenge import Best, _keep, best_of, day_of, today
from game.app.window import clipboard
from game.scenes import CATALOGUE
from tests.app.tests_app import Driver

LONGEST_S = 300.0


@pytest.fixture
def driver(tmp_path, monkeypatch):
    monkeypatch.setenv("CAROM_HOME", str(tmp_path))
    made = Driver(tmp_path, catalogue=CATALOGUE)
    made.frames(5)
    yield made
    made.close()


def opened(driver):
    driver.frames(5)
    while driver.top.loader is not None:
        driver.top.loader.wait(LONGEST_S)
        driver.frames(2)
    driver.frames(5)
    return driver.stage


@pytest.mark.parametrize("way", ["header", "key"])
def test_the_menu_leads_to_the_challenge_of_this_day(driver, way):
    if way == "header":
        driver.click(*driver.top.header.spots.find("challenge").rect.center)
    else:
        driver.key(pygame.K_d, pygame.KMOD_CTRL)
    stage = opened(driver)
    assert day_of(stage) == today()
    assert stage.scene.scored is not None and stage.scene.play.guide == "first"


def test_the_best_stroke_of_the_day_is_what_is_copied(driver, monkeypatch):
    text: list[str] = []
    monkeypatch.setattr(clipboard, "put", lambda given: text.append(given) or "")
    assert _keep(today(), Best(0.1, "stroke1.mine")) == ""
    driver.app.open_challenge()
    opened(driver)
    driver.key(pygame.K_x, pygame.KMOD_CTRL | pygame.KMOD_SHIFT)
    driver.frames(3)
    assert text == ["stroke1.mine"] == [best_of(today()).text]
