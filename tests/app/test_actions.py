"""The table of commands and what they do: each name in it means something, and nothing acts that it lacks."""

from __future__ import annotations

import pygame
import pytest

from game.app.menu.screen import MenuScreen
from game.app.scene.screen import ANOTHER_GAME
from game.app.screens.choices import ChoiceCard
from game.app.window.commands import BY_NAME, COMMANDS
from game.ui.widgets.list_row import ListRow
from tests.app.tests_app import Driver

WITHOUT_A_KEY = {"menu", "defaults"}  # buttons only
OF_THE_MENU = {"favourite"}
OF_A_STORY = {"story", "marks", "film"}  # see test_story_window


def test_every_command_acts_once_in_a_scene(driver: Driver):
    scene, program = set(driver.open("example").actions), set(driver.app.actions)
    assert not scene & program
    assert scene | program | OF_THE_MENU | OF_A_STORY == set(BY_NAME) | WITHOUT_A_KEY


def test_what_belongs_to_the_menu_acts_there(driver: Driver):
    assert set(driver.top.actions) >= OF_THE_MENU


def test_what_does_not_need_the_scene_acts_while_it_loads(driver: Driver):
    driver.app.open_scene("example")
    assert set(driver.top.actions) == {"menu", "back", "next", "previous", "panel"}


def test_what_means_nothing_on_a_screen_is_not_done(driver: Driver):
    assert isinstance(driver.top, MenuScreen)
    assert not driver.app.perform("pause") and not driver.app.perform("no such command")
    assert driver.app.perform("theme")


@pytest.mark.parametrize("name", [command.name for command in COMMANDS if command.choice])
def test_the_card_of_a_pause_does_what_it_offers(driver: Driver, name: str):
    driver.open("example")
    driver.app.perform("pause-menu")
    card = driver.top
    before = (driver.top, driver.app.running)
    card.pressed(f"row-{[row.value for row in card.rows].index(name)}")
    driver.frames(40)
    assert (driver.top, driver.app.running) != before


def test_home_and_end_move_in_a_list(driver: Driver):
    driver.open("example")
    driver.app.cards.open_choices(
        "Numbers", [ListRow(str(i), value=i) for i in range(40)], lambda value: None
    )
    card = driver.top
    assert isinstance(card, ChoiceCard)
    driver.key(pygame.K_END)
    assert card.focus == 39 and any(spot.name == "row-39" for spot in card.spots.spots)
    driver.key(pygame.K_HOME)
    assert card.focus == 0 and any(spot.name == "row-0" for spot in card.spots.spots)


def test_the_card_of_a_pause_leads_to_the_card_before_a_game(driver: Driver, monkeypatch: pytest.MonkeyPatch):
    """A scene that begins with a start card offers it again; one without does not."""
    driver.open("example")
    driver.app.perform("pause-menu")
    assert ANOTHER_GAME not in [row.value for row in driver.top.rows]
    driver.app.pop()
    driver.frames(2)
    screen = driver.top
    monkeypatch.setattr(screen, "entry", screen.entry._replace(start="START"))
    opened: list[str] = []
    monkeypatch.setattr(driver.app, "open_scene", lambda name, *more, **options: opened.append(name))
    driver.app.perform("pause-menu")
    card = driver.top
    card.pressed(f"row-{[row.value for row in card.rows].index(ANOTHER_GAME)}")
    driver.frames(40)
    assert opened == ["example"]
