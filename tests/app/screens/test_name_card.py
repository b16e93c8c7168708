"""The card that asks for a name: of what is saved, and of the player."""

from __future__ import annotations

from collections.abc import Callable

import pygame
import pytest

from game.app.screens.name_card import NameCard
from game.app.screens.settings_card import SettingsCard
from game.app.window.settings import load_settings
from tests.app.tests_app import Driver


@pytest.fixture
def scene(start: Callable[..., Driver]) -> Driver:
    """A program in the example scene."""
    driver = start()
    driver.open()
    driver.frames(20)
    return driver


def typed(driver: Driver, words: str) -> None:
    """Press the keys of some words, as a keyboard does: the key, and then its letter."""
    for letter in words:
        driver.key(pygame.key.key_code(letter.lower()) if letter != " " else pygame.K_SPACE)
        driver.type(letter)


def saved(driver: Driver) -> list[tuple[str, str]]:
    """Titles and kinds of what was saved."""
    return [(row.title, row.chip) for row in driver.top.play.shelf.saved()]


def test_what_is_saved_has_the_title_that_was_typed(scene: Driver):
    """The letters are no commands meanwhile: "a" opens no study, the space bar pauses nothing."""
    scene.key(pygame.K_s, pygame.KMOD_LCTRL)
    assert isinstance(scene.top, NameCard)
    typed(scene, "Half way upp")
    scene.key(pygame.K_BACKSPACE)
    assert isinstance(scene.top, NameCard)
    scene.key(pygame.K_RETURN)
    scene.frames(30)
    assert saved(scene) == [("Half way up", "level"), ("Half way up", "recording")]
    assert "Half way up" in scene.app.toasts.shown.consequence


def test_without_a_title_it_has_its_date(scene: Driver):
    scene.key(pygame.K_s, pygame.KMOD_LCTRL)
    scene.key(pygame.K_RETURN)
    scene.frames(30)
    assert [title[:6] for title, _ in saved(scene)] == ["Saved ", "Saved "]


@pytest.mark.parametrize("key", [pygame.K_ESCAPE, None], ids=["Esc", "Cancel"])
def test_nothing_is_saved_by_who_thinks_better_of_it(scene: Driver, key):
    scene.key(pygame.K_s, pygame.KMOD_LCTRL)
    typed(scene, "no")
    if key is not None:
        scene.key(key)
    else:
        scene.click(*scene.top.spots.find("leave").rect.center)
    scene.frames(30)
    assert scene.top.play is not None
    assert saved(scene) == []


def test_a_title_with_signs_is_read_back(scene: Driver):
    title = 'A "quoted" \\ title = é'
    scene.top.play.shelf.save(title)
    scene.frames(30)
    assert saved(scene)[0] == (title, "level")


def test_the_settings_ask_for_the_players_name_and_keep_it(driver: Driver):
    driver.app.cards.open_settings()
    driver.frames(20)
    driver.click(*driver.top.spots.find("name-asked").rect.center)
    driver.frames(20)
    typed(driver, "Ada ")
    driver.click(*driver.top.spots.find("take").rect.center)
    driver.frames(30)
    assert isinstance(driver.top, SettingsCard)
    assert load_settings(driver.app.folder).settings.name == "Ada"
    driver.click(*driver.top.spots.find("name-asked").rect.center)
    driver.frames(20)
    assert driver.top.field.text == "Ada"
    driver.key(pygame.K_BACKSPACE, pygame.KMOD_LCTRL)
    driver.key(pygame.K_RETURN)
    driver.frames(30)
    assert load_settings(driver.app.folder).settings.name == ""


def test_a_name_has_at_most_forty_letters(driver: Driver):
    driver.app.cards.open_settings()
    driver.top.pressed("name-asked")
    driver.frames(20)
    driver.type(50 * "x" + "\n")
    driver.key(pygame.K_RETURN)
    driver.frames(30)
    assert load_settings(driver.app.folder).settings.name == 40 * "x"
