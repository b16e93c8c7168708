"""The tour: its parts, its ways forward and out, and that it comes by itself only once."""

from __future__ import annotations

import pygame
import pytest

from game.app.scene.screen import TOUR_AFTER_S
from game.app.scene.tour import PANEL_OFF, STOPS, TourScreen
from game.app.window.settings import load_settings
from tests.app.tests_app import Driver


@pytest.fixture
def touring(driver: Driver) -> Driver:
    driver.app.tour_due = True
    driver.open()
    driver.frames(int(60 * TOUR_AFTER_S) + 2)
    return driver


def test_it_comes_with_the_first_scene_and_not_again(touring: Driver):
    assert isinstance(touring.top, TourScreen)
    assert load_settings(touring.app.folder).settings.toured
    touring.key(pygame.K_ESCAPE)
    assert not isinstance(touring.top, TourScreen)
    touring.open("example")
    assert not isinstance(touring.top, TourScreen)
    touring.key(pygame.K_F3)
    assert isinstance(touring.top, TourScreen)


def test_it_waits_until_there_is_something_to_be_seen(driver: Driver):
    driver.app.tour_due = True
    driver.open()
    assert not isinstance(driver.top, TourScreen) and driver.app.tour_due
    driver.move(*driver.top.shell.layout.stage.center)
    driver.button(True, *driver.top.shell.layout.stage.center)
    driver.frames(int(60 * TOUR_AFTER_S) + 2)
    assert not isinstance(driver.top, TourScreen)  # not while something is being dragged
    driver.button(False, *driver.top.shell.layout.stage.center)
    driver.frames(2)
    assert isinstance(driver.top, TourScreen)


def test_keys_go_through_all_parts_and_back(touring: Driver):
    titles = []
    for _ in range(len(touring.top.stops)):
        titles.append(touring.top.stop.title)
        touring.key(pygame.K_RETURN)
    assert titles == [stop.title for stop in STOPS]
    assert not isinstance(touring.top, TourScreen)
    touring.key(pygame.K_F3)
    touring.key(pygame.K_RIGHT)
    touring.key(pygame.K_LEFT)
    touring.key(pygame.K_LEFT)
    assert touring.top.at == 0


def test_a_panel_that_is_off_is_named_by_its_key(touring: Driver):
    touring.key(pygame.K_ESCAPE)
    shell = touring.top.shell
    assert not any(
        PANEL_OFF in stop.keys for stop in TourScreen(touring.app, lambda: shell.layout, None).stops
    )
    touring.key(pygame.K_TAB)
    touring.key(pygame.K_F3)
    assert not any(stop.part == "panel" for stop in touring.top.stops)
    assert touring.top.stops[-1].keys[0] == PANEL_OFF


def test_the_hand_can_press_next_and_skip(touring: Driver):
    touring.click(*touring.top.spots.find("next").rect.center)
    assert touring.top.at == 1
    touring.click(*touring.top.spots.find("skip").rect.center)
    assert not isinstance(touring.top, TourScreen)


def test_time_stands_still_meanwhile(touring: Driver):
    before = touring.app.screens._screens[-2].play.stage.step_number
    touring.frames(30)
    assert touring.app.screens._screens[-2].play.stage.step_number == before


@pytest.mark.parametrize("size", [(320, 240), (700, 500), (1280, 720), (1920, 1080)])
def test_its_words_lie_within_any_window(touring: Driver, size):
    touring.resize(*size)
    window = pygame.Rect((0, 0), touring.window.size)
    while isinstance(touring.top, TourScreen):
        assert window.contains(touring.top.card)
        assert all(touring.top.card.contains(spot.rect) for spot in touring.top.spots.spots)
        touring.key(pygame.K_RETURN)
