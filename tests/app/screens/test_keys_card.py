"""Keys are changed in their card and kept in the settings, never so that nobody gets out."""

import pygame
import pytest

from game.app.screens.keys_card import KeysCard
from game.app.screens.settings_card import SettingsCard
from game.app.window.commands import COMMANDS
from game.app.window.keys import Keys, parse_chord
from tests.app.tests_app import Driver


@pytest.fixture
def card(driver: Driver) -> KeysCard:
    driver.key(pygame.K_F1)
    driver.frames(20)
    assert isinstance(driver.top, KeysCard)
    return driver.top


def press_row(driver: Driver, name: str) -> None:
    driver.click(*driver.top.spots.find(name).rect.center)
    driver.frames(2)


def test_a_row_waits_for_its_key_and_keeps_it(driver: Driver, card: KeysCard):
    press_row(driver, "pause")
    assert card.waiting == "pause"
    driver.key(pygame.K_LSHIFT)
    assert card.waiting == "pause"
    driver.key(pygame.K_j)
    assert card.waiting == "" and driver.app.keys.label("pause") == "J"
    assert 'pause = "j"' in (driver.app.folder / "settings.toml").read_text()
    driver.key(pygame.K_ESCAPE)
    driver.frames(20)
    driver.open("example")
    stood = driver.stage.paused
    driver.key(pygame.K_j)
    assert driver.stage.paused is not stood


def test_a_key_of_another_command_is_exchanged_and_all_go_back(driver: Driver, card: KeysCard):
    press_row(driver, "accuracy")
    driver.key(pygame.K_l)
    assert (driver.app.keys.label("accuracy"), driver.app.keys.label("levels")) == ("L", "A")
    assert driver.app.settings.keys == {"accuracy": "l", "levels": "a"}
    press_row(driver, "defaults")
    assert driver.app.settings.keys == {} and driver.app.keys.label("accuracy") == "A"
    assert card.spots.find("defaults") is None


def test_esc_takes_the_question_back_and_stays_the_way_out(driver: Driver, card: KeysCard):
    press_row(driver, "pause")
    driver.key(pygame.K_ESCAPE)
    assert card.waiting == "" and driver.top is card and driver.app.settings.keys == {}
    with pytest.raises(ValueError, match="get out"):
        Keys().changed_by("pause", parse_chord("escape"))
    press_row(driver, "pause")
    driver.post(pygame.Event(pygame.WINDOWFOCUSLOST))
    assert card.waiting == ""


def test_settings_lead_to_the_keys_and_back(driver: Driver):
    driver.key(pygame.K_F10)
    driver.frames(20)
    press_row(driver, "keys-shown")
    driver.frames(20)
    assert isinstance(driver.top, KeysCard)
    driver.key(pygame.K_ESCAPE)
    driver.frames(20)
    assert isinstance(driver.top, SettingsCard)


def test_what_the_card_writes_is_what_the_settings_read():
    changed = Keys().changed_by("pause", parse_chord("ctrl+p"))
    again = Keys(Keys(changed).changed_by("step", parse_chord("ctrl+p")))
    assert again.label("step") == "Ctrl+P" and again.label("pause") == "."
    assert Keys(Keys(changed).changed_by("pause", parse_chord("space"))).chords == Keys().chords


@pytest.mark.parametrize(("size", "scale"), [((640, 480), 1.0), ((640, 480), 2.0), ((320, 240), 1.0)])
def test_every_row_can_be_reached_in_a_small_window(start, size, scale):
    driver = start(size=size, ui_scale=scale)
    driver.key(pygame.K_F1)
    driver.frames(20)
    card, seen = driver.top, set()
    for _ in range(40):
        rows = [spot for spot in card.spots.spots if spot.name != "close"]
        assert all(card.veil.card.contains(spot.rect) for spot in rows)
        seen |= {spot.name for spot in rows}
        driver.wheel(-1)
    assert seen == {command.name for command in COMMANDS}
    driver.key(pygame.K_PAGEUP)
    driver.wheel(40)
    assert card.spots.find("pause") is not None


@pytest.mark.parametrize(("size", "scale"), [((640, 480), 1.0), ((640, 480), 2.0), ((1280, 720), 2.0)])
def test_the_settings_fit_a_small_window(start, size, scale):
    driver = start(size=size, ui_scale=scale)
    driver.key(pygame.K_F10)
    driver.frames(20)
    spots = driver.top.spots.spots
    assert {"theme-dark", "scale-2", "keys-shown"} <= {spot.name for spot in spots}
    for i, spot in enumerate(spots):
        assert driver.top.veil.card.contains(spot.rect)
        assert spot.rect.collidelist([other.rect for other in spots[i + 1 :]]) == -1
