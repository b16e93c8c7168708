"""The card of the very first start: games, stories and the course, shown once."""

from __future__ import annotations

import itertools

import pygame
import pytest

from game.app.menu.screen import MenuScreen
from game.app.menu.welcome_card import WelcomeCard
from game.app.scene.screen import SceneScreen
from game.app.stagehand.stars import Stars, keep_stars
from game.app.window.settings import load_settings
from game.scenes import CATALOGUE
from game.stage.catalogue import STORIES, Catalogue
from tests.app.menu.eighty import eighty
from tests.app.tests_app import Driver, example_entry

GAMES = ("billiards", "carom", "snooker")


@pytest.fixture
def first(start) -> Driver:
    """A very first start: billiards is there, and a course."""
    rows = tuple(entry for entry in eighty() if entry.category != "Play")
    billiards = example_entry("billiards")._replace(category="Play")
    driver = start(catalogue=Catalogue((*rows, billiards)))
    driver.app.welcome_due = load_settings(driver.app.folder).first_start
    driver.frames(30)
    assert isinstance(driver.top, WelcomeCard)
    return driver


@pytest.fixture
def with_games(start) -> Driver:
    """A first card where there are all games."""
    rows = tuple(entry for entry in eighty() if entry.category != "Play")
    games = tuple(example_entry(name)._replace(category="Play") for name in GAMES)
    driver = start(catalogue=Catalogue((*rows, *games)))
    driver.app.welcome_due = True
    driver.frames(30)
    assert isinstance(driver.top, WelcomeCard)
    return driver


@pytest.mark.parametrize("game", GAMES)
def test_every_game_that_there_is_can_be_played_from_the_card(with_games: Driver, game: str):
    with_games.click(*with_games.top.spots.find("play" if game == "billiards" else game).rect.center)
    assert isinstance(with_games.top, SceneScreen) and with_games.top.entry.name == game


def test_keys_go_through_games_and_then_the_others(with_games: Driver):
    for _ in range(2):
        with_games.key(pygame.K_RIGHT)
    assert with_games.top.spots.focused == "snooker"
    with_games.key(pygame.K_RIGHT)
    assert with_games.top.spots.focused == "stories"


@pytest.mark.parametrize("size", [(1, 1), (320, 240), (400, 700), (900, 600), (1280, 720), (3840, 2160)])
def test_all_games_fit_any_window(with_games: Driver, size: tuple[int, int]):
    with_games.resize(*size)
    with_games.frames(3)
    card, names = with_games.top.veil.card, ("play", *GAMES[1:], "stories", "course")
    places = [with_games.top.spots.find(name).rect for name in names]
    assert not any(a.colliderect(b) for a, b in itertools.combinations(places, 2))
    if size[0] >= 320:
        assert all(card.contains(place) for place in places)


def test_shown_at_the_very_first_start_only(first: Driver):
    assert not first.app.welcome_due
    loaded = load_settings(first.app.folder)
    assert not loaded.first_start and loaded.complaint == ""
    first.key(pygame.K_ESCAPE)
    first.frames(30)
    assert isinstance(first.top, MenuScreen)
    first.app.open_menu()
    first.frames(30)
    assert isinstance(first.top, MenuScreen)


@pytest.mark.parametrize("beside", [(5, 300), (640, 700)])
def test_press_beside_closes_it_and_nothing_else(first: Driver, beside: tuple[int, int]):
    first.click(*beside)
    first.frames(30)
    assert isinstance(first.top, MenuScreen) and first.app.settings.recent == []


def test_press_on_the_card_leaves_it(first: Driver):
    first.click(first.top.veil.card.x + 20, first.top.veil.card.y + 20)
    first.frames(30)
    assert isinstance(first.top, WelcomeCard)


@pytest.mark.parametrize("way", ["press", "enter", "keys"])
def test_play_opens_billiards(first: Driver, way: str):
    if way == "press":
        first.click(*first.top.spots.find("play").rect.center)
    elif way == "keys":
        first.key(pygame.K_RIGHT)
        first.key(pygame.K_LEFT)
    if way != "press":
        first.key(pygame.K_RETURN)
    assert isinstance(first.top, SceneScreen) and first.top.entry.name == "billiards"


@pytest.mark.parametrize("way", ["press", "keys"])
def test_course_leads_to_the_course(first: Driver, way: str):
    if way == "press":
        first.click(*first.top.spots.find("course").rect.center)
    else:
        for key in (pygame.K_RIGHT, pygame.K_RIGHT, pygame.K_RIGHT, pygame.K_RETURN):
            first.key(key)
    first.frames(90)
    menu = first.top
    assert isinstance(menu, MenuScreen) and menu.bar.current == "Course"
    assert menu.focused.entry.name == "course-0"
    assert menu.view.contains(menu.focused.rect.move(0, menu.down))


@pytest.mark.parametrize("way", ["press", "keys"])
def test_stories_lead_to_the_stories(first: Driver, way: str, monkeypatch):
    shown = []
    monkeypatch.setattr(first.top, "_show_category", shown.append)
    if way == "press":
        first.click(*first.top.spots.find("stories").rect.center)
    else:
        first.key(pygame.K_RIGHT)
        first.key(pygame.K_RETURN)
    first.frames(30)
    assert shown == [STORIES] and isinstance(first.top, MenuScreen)


@pytest.mark.parametrize("size", [(1, 1), (320, 240), (400, 700), (800, 600), (3840, 2160)])
def test_fits_any_window(first: Driver, size: tuple[int, int]):
    first.resize(*size)
    first.frames(3)
    card = first.top.veil.card
    places = [first.top.spots.find(name).rect for name in ("play", "stories", "course")]
    assert not any(a.colliderect(b) for a, b in itertools.combinations(places, 2))
    if size[0] >= 320:
        assert all(card.contains(place) for place in places)


def test_what_it_leads_to_is_there():
    assert CATALOGUE["billiards"].category == "Play"
    assert all(CATALOGUE[game].module for game in GAMES)
    assert "Course" in CATALOGUE.categories() and STORIES in CATALOGUE.categories()
    assert len([entry for entry in CATALOGUE if entry.task.startswith("C")]) >= 15


def test_the_lessons_begin_from_the_card_where_no_star_has_been_won(with_games: Driver, monkeypatch):
    keep_stars("billiards", "lesson-1-stop", Stars(1, 3))
    opened = []
    monkeypatch.setattr(
        with_games.app, "open_scene", lambda name, level=None: opened.append((name, level.stem))
    )
    with_games.top.pressed("lessons")
    assert opened == [("billiards", "lesson-2-follow")]
