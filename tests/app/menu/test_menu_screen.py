"""The menu by mouse, keys and typing."""

import pygame
import pytest

from game.app.menu.flow import NARROWEST
from game.app.menu.items import WIDE
from game.app.menu.screen import MenuScreen
from game.app.menu.search import words_of
from game.app.scene.screen import SceneScreen
from game.app.screens.keys_card import KeysCard
from game.app.screens.settings_card import SettingsCard
from game.scenes import CATALOGUE
from game.stage.catalogue import Catalogue
from game.ui.look.look import Look
from game.ui.look.theme import DARK
from tests.app.tests_app import Driver, example_entry


def middle_of(driver: Driver, index: int) -> tuple[int, int]:
    """Pixel in the middle of the n-th item."""
    menu = driver.top
    return menu.items[index].rect.move(0, menu.down).center


def test_menu_shows_a_card_for_each_scene(driver: Driver):
    driver.frames(3)
    assert isinstance(driver.top, MenuScreen)
    assert [item.entry.name for item in driver.top.items] == ["example", "broken"]
    colors = {tuple(driver.window.surface.get_at((x, 300))) for x in range(40, 1240, 7)}
    assert len(colors) > 5


def test_enter_opens_the_chosen_scene(driver: Driver):
    driver.key(pygame.K_RETURN)
    assert isinstance(driver.top, SceneScreen)
    assert driver.top.entry.name == "example"
    driver.key(pygame.K_ESCAPE)
    assert isinstance(driver.top, MenuScreen)


def test_arrows_and_mouse_choose(driver: Driver):
    driver.key(pygame.K_RIGHT)
    assert driver.top.focus == 1
    driver.key(pygame.K_LEFT)
    assert driver.top.focus == 0
    driver.move(*middle_of(driver, 1))
    assert driver.top.focus == 1
    driver.key(pygame.K_END)
    driver.key(pygame.K_HOME)
    assert driver.top.focus == 0


def test_click_opens(driver: Driver):
    driver.click(*middle_of(driver, 0))
    assert isinstance(driver.top, SceneScreen)


def test_scene_that_cannot_be_opened_is_told_and_the_menu_stays(driver: Driver):
    screen = driver.open("broken")
    assert screen.play is None
    assert isinstance(driver.top, MenuScreen)
    assert driver.top.items[driver.top.focus].entry.name == "broken"
    toast = driver.app.toasts.shown
    assert "cannot be opened" in toast.cause
    assert "no_such_module" in toast.consequence


def test_typing_searches(driver: Driver):
    driver.type("boun")
    assert driver.top.query == "boun"
    assert [item.entry.name for item in driver.top.items] == ["example"]
    driver.key(pygame.K_BACKSPACE)
    assert driver.top.query == "bou"
    driver.type("zzz")
    assert driver.top.items == ()
    driver.key(pygame.K_RETURN)
    driver.key(pygame.K_DOWN)
    driver.frames(2)
    assert isinstance(driver.top, MenuScreen)
    driver.key(pygame.K_ESCAPE)
    assert driver.top.query == ""
    assert len(driver.top.items) == 2
    driver.key(pygame.K_ESCAPE)
    assert driver.app.running


def test_query_is_bounded_and_shown(driver: Driver):
    driver.type("x" * 300)
    driver.type("\x00\x07\n")
    assert driver.top.query == "x" * 40
    driver.frames(2)


def test_cross_clears_the_search(driver: Driver):
    driver.type("ball")
    driver.frames(2)
    driver.click(*driver.top.header.spots.find("clear").rect.center)
    assert driver.top.query == ""


def test_theme_settings_and_keys_by_key_and_button(driver: Driver):
    driver.key(pygame.K_F2)
    assert driver.app.settings.theme == driver.app.look.theme.name == "light"
    driver.click(*driver.top.header.spots.find("theme").rect.center)
    assert driver.app.settings.theme == "dark"
    for key, kind, name in ((pygame.K_F10, SettingsCard, "settings"), (pygame.K_F1, KeysCard, "help")):
        driver.key(key)
        assert isinstance(driver.top, kind)
        driver.frames(20)
        driver.key(pygame.K_ESCAPE)
        driver.frames(20)
        assert isinstance(driver.top, MenuScreen)
        driver.click(*driver.top.header.spots.find(name).rect.center)
        assert isinstance(driver.top, kind)
        driver.frames(20)
        driver.click(*driver.top.spots.find("close").rect.center)
        driver.frames(20)
        assert isinstance(driver.top, MenuScreen)


def test_settings_act_at_once_and_are_kept(driver: Driver):
    driver.key(pygame.K_F10)
    driver.frames(20)
    for name in ("theme-light", "scale-1.5", "motion-less"):
        driver.click(*driver.top.spots.find(name).rect.center)
    assert (driver.app.look.theme.name, driver.app.look.k, driver.app.look.less_motion) == (
        "light",
        1.5,
        True,
    )
    text = (driver.app.folder / "settings.toml").read_text()
    assert 'theme = "light"' in text
    assert "ui_scale = 1.5" in text
    driver.key(pygame.K_TAB)
    driver.key(pygame.K_RETURN)
    assert driver.app.settings.theme == "dark"


@pytest.mark.parametrize("size", [(1, 1), (320, 240), (500, 900), (2560, 1440), (3840, 2160)])
def test_menu_fits_any_window(driver: Driver, size: tuple[int, int]):
    driver.resize(*size)
    driver.frames(2)
    assert driver.window.surface.get_size() == size
    driver.wheel(-3)
    driver.type("ball")
    driver.resize(1280, 720)
    driver.frames(2)


def test_many_scenes_scroll(start):
    driver = start(catalogue=Catalogue(tuple(example_entry(f"s{i}") for i in range(60))), size=(640, 480))
    driver.key(pygame.K_END)
    menu = driver.top
    assert menu.scroll.moving
    driver.frames(60)
    assert menu.scroll.offset > 0 and not menu.scroll.moving
    assert menu.view.contains(menu.items[-1].rect.move(0, menu.down))
    driver.wheel(200)
    driver.frames(60)
    assert menu.scroll.offset == 0


def test_resting_menu_paints_nothing_anew(driver: Driver):
    driver.frames(30)
    painted = driver.top.painter.painted
    driver.frames(30)
    assert driver.top.painter.painted == painted > 0


def test_no_words_on_a_card_are_cut_off():
    look = Look(DARK, 1.0)
    room = NARROWEST - 2 * 12  # of the narrowest card, beside its margins
    for entry in CATALOGUE:
        assert look.fonts.fit(entry.title, 13, "semibold", room) == entry.title
        if entry.name != WIDE[0]:
            used = look.fonts.size(entry.task, 11, "semibold")[0] + 7
            assert look.fonts.fit(entry.fact, 11, "medium", room - used) == entry.fact


def test_every_scene_has_a_drawing_for_its_card():
    painters = [entry.card_painter() for entry in CATALOGUE]
    assert None not in painters and len(set(painters)) == len(painters)


def test_the_first_letter_finds_all_texts_ready(start):
    """They are got ready while the menu stands, a few in a frame."""
    words_of.cache_clear()
    driver = start(catalogue=CATALOGUE)
    driver.frames(120)
    before = words_of.cache_info().misses
    driver.type("b")
    assert driver.top.query == "b" and words_of.cache_info().misses == before
