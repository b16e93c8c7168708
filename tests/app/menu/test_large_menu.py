"""The menu of eighty cards: categories, scrolling, favourites and recent ones, pictures of what is seen."""

from __future__ import annotations

import threading
from itertools import pairwise
from pathlib import Path

import pygame
import pytest

from game.app.menu import deck, flow
from game.app.menu import thumbnails as thumbnails_module
from game.app.menu.screen import MenuScreen
from game.app.scene.loader import Loader
from game.app.scene.screen import SceneScreen
from game.app.window.settings import load_settings
from tests.app.menu.eighty import NUMBERS, eighty
from tests.app.tests_app import Driver

ORDER = ("Play", "Course", "Lecture", "Stories", "Papers", "Carom", "Inventions")


@pytest.fixture
def many(start) -> Driver:
    driver = start(catalogue=eighty())
    driver.frames(5)
    return driver


def rest(driver: Driver) -> None:
    """Let the menu come to rest."""
    driver.frames(90)
    assert not driver.top.scroll.moving


def place_of(menu: MenuScreen, index: int) -> pygame.Rect:
    """Where an item is in the window."""
    return menu.items[index].rect.move(0, menu.down)


def index_of(menu: MenuScreen, name: str, category: str = "") -> int:
    """The item of a scene, in that category if one is named."""
    return next(
        i for i, item in enumerate(menu.items) if item.entry.name == name and category in ("", item.category)
    )


def test_bar_and_cards_follow_the_order_of_categories(many: Driver):
    menu = many.top
    assert menu.bar.names == ORDER and menu.bar.current == "Play"
    assert list(dict.fromkeys(item.category for item in menu.items)) == list(ORDER)
    assert len(menu.items) == sum(NUMBERS.values()) == 80
    heads = [(head.text, head.number) for head in menu.contents.heads]
    assert heads[:4] == [("Play", 1), ("Animation", 5), ("Broad phase", 5), ("Rigid bodies", 5)]
    assert ("Stories", 22) in heads and ("Inventions", 13) in heads


def test_wheel_scrolls_smoothly_and_stops_at_the_ends(many: Driver):
    menu = many.top
    many.wheel(-3)
    goal, way = menu.scroll.target, [menu.scroll.offset]
    while menu.scroll.moving:
        many.frames()
        way.append(menu.scroll.offset)
        assert len(way) < 90
    assert goal == 300 == way[-1] and way == sorted(way) and len(set(way)) > 8
    many.wheel(-1000)
    rest(many)
    assert place_of(menu, len(menu.items) - 1).bottom <= menu.view.bottom
    assert menu.contents.height - menu.scroll.offset == menu.view.h
    many.wheel(1000)
    rest(many)
    assert menu.scroll.offset == 0


def test_less_motion_scrolls_at_once(start):
    driver = start(catalogue=eighty(), less_motion=True)
    driver.wheel(-2)
    assert driver.top.scroll.offset == 200 and not driver.top.scroll.moving


def test_what_comes_under_the_pointer_is_chosen_when_the_wheel_rests(many: Driver):
    menu = many.top
    many.move(400, 300)
    many.wheel(-10)
    rest(many)
    assert place_of(menu, menu.focus).inflate(40, 80).collidepoint(400, 300)


def test_tab_and_bar_lead_to_categories(many: Driver):
    menu = many.top
    for category in (*ORDER[1:], ORDER[0], ORDER[1]):
        many.key(pygame.K_TAB)
        rest(many)
        assert menu.bar.current == category == menu.focused.category
        assert menu.view.contains(place_of(menu, menu.focus))
    many.key(pygame.K_TAB, pygame.KMOD_SHIFT)
    rest(many)
    assert menu.bar.current == "Play"
    many.click(*menu.bar.spots.find("Papers").rect.center)
    rest(many)
    assert menu.bar.current == "Papers" and menu.focused.entry.name == "papers-0"
    assert place_of(menu, menu.focus).top == menu.view.top + menu.host.look.px(flow.HEAD)


def test_bar_moves_where_it_is_too_narrow(start):
    driver = start(catalogue=eighty(), size=(420, 600))
    menu = driver.top
    driver.frames(3)
    assert menu.bar.spots.find("Inventions").rect.left > 420
    driver.key(pygame.K_TAB, pygame.KMOD_SHIFT)
    rest(driver)
    assert menu.bar.current == "Inventions" and menu.bar.spots.find("Inventions").rect.right <= 420
    driver.post(pygame.Event(pygame.MOUSEWHEEL, x=0, y=50, pos=menu.bar.rect.center))
    assert menu.bar.spots.find("Play").rect.left >= 0 and menu.scroll.offset > 0


def test_pages_and_arrows_walk_through_all_of_it(many: Driver):
    menu = many.top
    tops = [menu.focused.rect.top]
    while menu.focus < len(menu.items) - 1:
        many.key(pygame.K_PAGEDOWN)
        tops.append(menu.focused.rect.top)
        assert len(tops) < 20
    assert len(tops) > 5 and tops == sorted(tops)
    assert all(b - a <= menu.view.h for a, b in pairwise(tops))
    many.key(pygame.K_PAGEUP)
    assert menu.focused.rect.top < tops[-1]
    many.key(pygame.K_HOME)
    assert menu.focus == 0
    seen = {0}
    for _ in range(40):
        many.key(pygame.K_DOWN)
        rest(many)
        assert menu.view.contains(place_of(menu, menu.focus))
        seen.add(menu.focus)
    assert {menu.items[i].category for i in seen} >= {"Play", "Course", "Stories", "Papers"}


def test_arrow_begins_at_what_is_seen(many: Driver):
    menu = many.top
    many.post(pygame.Event(pygame.MOUSEWHEEL, x=0, y=-12, pos=(1275, 400)))  # beside the cards
    rest(many)
    assert menu.focus not in menu.in_view()
    before = menu.scroll.offset
    many.key(pygame.K_DOWN)
    rest(many)
    assert menu.focus in menu.in_view() and menu.scroll.offset == before


def test_keys_need_not_wait_for_the_content(many: Driver):
    many.key(pygame.K_END)
    many.frames(30)
    many.key(pygame.K_HOME)
    many.key(pygame.K_DOWN)
    assert many.top.focused.entry.name == "course-0" and many.top.scroll.moving


def test_drag_moves_the_content_and_opens_nothing(many: Driver):
    menu = many.top
    many.move(700, 500)
    many.button(True, 700, 500)
    for y in range(490, 190, -20):
        many.move(700, y)
    assert menu.scroll.offset == 500 - 210 == menu.scroll.target
    many.button(False, 700, 210)
    assert many.top is menu
    many.click(700, 300)
    assert isinstance(many.top, SceneScreen)


def test_press_that_leaves_its_card_opens_nothing(many: Driver):
    menu = many.top
    x, y = place_of(menu, 0).center
    many.button(True, x, y)
    many.post(pygame.Event(pygame.WINDOWFOCUSLOST))
    many.button(False, x, y)
    assert many.top is menu


def test_thumb_leads_anywhere(many: Driver):
    menu = many.top
    thumb = menu.scroll.thumb(many.app.look)
    many.button(True, *thumb.center)
    many.move(thumb.centerx, thumb.centery + 5000)
    many.button(False, thumb.centerx, 719)
    assert menu.scroll.offset == menu.scroll.most
    assert menu.scroll.thumb(many.app.look).bottom == menu.view.bottom
    many.click(thumb.centerx, menu.view.top + 2)
    assert menu.scroll.offset == 0 and many.top is menu


@pytest.mark.parametrize("size", [(800, 600), (1920, 1080), (640, 480)])
def test_resize_while_it_scrolls_keeps_what_is_looked_at(many: Driver, size: tuple[int, int]):
    menu = many.top
    many.click(*menu.bar.spots.find("Stories").rect.center)
    rest(many)
    many.wheel(-6)
    many.frames(4)
    looked_at = menu.items[menu.in_view()[len(menu.in_view()) // 2]].category
    many.resize(*size)
    many.frames(2)
    assert looked_at in {menu.items[i].category for i in menu.in_view()}
    assert 0 <= menu.scroll.offset <= menu.scroll.most and menu.scroll.offset > 0
    assert menu.contents.height == menu.scroll.most + menu.view.h


# -- favourites and recent ones


def test_star_by_key_stands_first_and_is_kept(many: Driver):
    menu = many.top
    many.click(*menu.bar.spots.find("Papers").rect.center)
    rest(many)
    before = place_of(menu, menu.focus)
    many.key(pygame.K_f, pygame.KMOD_CTRL)
    assert menu.bar.names[0] == "Favourites" and menu.query == ""
    assert place_of(menu, menu.focus) == before and menu.focused.category == "Papers"
    many.key(pygame.K_HOME)
    assert (menu.focused.category, menu.focused.entry.name) == ("Favourites", "papers-0")
    assert load_settings(many.app.folder).settings.favourites == ["papers-0"]
    many.key(pygame.K_f, pygame.KMOD_CTRL)
    assert "Favourites" not in menu.bar.names and len(menu.items) == 80
    assert load_settings(many.app.folder).settings.favourites == []


def test_star_by_press_opens_nothing(many: Driver):
    menu = many.top
    index = index_of(menu, "course-2")
    star = flow.star_of(place_of(menu, index), many.app.look.k)
    many.click(*star.center)
    assert many.top is menu and many.app.settings.favourites == ["course-2"]
    assert many.app.toasts.shown.cause == "Bouncing ball is a favourite"
    surface = many.window.surface
    many.move(5, 130)
    many.wheel(50)
    rest(many)
    place = flow.star_of(place_of(menu, index_of(menu, "course-2", "Favourites")), many.app.look.k)
    accent = many.app.look.theme.accent
    assert surface.get_at(place.center)[:3] == (accent.r, accent.g, accent.b)


def test_letter_f_alone_is_searched_for(many: Driver):
    many.key(pygame.K_f)
    many.type("f")
    assert many.top.query == "f" and many.app.settings.favourites == []


def test_favourites_that_are_no_more_are_kept_and_not_shown(start):
    driver = start(catalogue=eighty(), favourites=["gone", "papers-3", "papers-3"], recent=["gone too"])
    menu = driver.top
    assert menu.bar.names == ("Favourites", *ORDER) and menu.items[0].entry.name == "papers-3"
    assert len(menu.items) == 81
    driver.key(pygame.K_f, pygame.KMOD_CTRL)
    assert driver.app.settings.favourites == ["gone"] and driver.app.settings.recent == ["gone too"]


def test_one_that_loses_its_star_leaves_the_view_where_it_is(start):
    driver = start(catalogue=eighty(), favourites=["papers-1", "papers-2", "papers-3"])
    driver.key(pygame.K_RIGHT)
    driver.key(pygame.K_f, pygame.KMOD_CTRL)
    menu = driver.top
    assert (menu.focused.category, menu.focused.entry.name) == ("Favourites", "papers-3")
    assert menu.scroll.target == 0 and driver.app.settings.favourites == ["papers-1", "papers-3"]


def opened(driver: Driver, wait: bool) -> SceneScreen:
    """The scene that was opened: once it is there, or while it is still loading."""
    screen = driver.top
    assert isinstance(screen, SceneScreen) and screen.loader is not None
    if wait:
        screen.loader.wait()
        driver.frames(2)
        assert screen.play is not None
    return screen


@pytest.mark.parametrize("wait", [True, False])
def test_what_was_opened_comes_first_and_leads_back_to_its_card(many: Driver, wait: bool, monkeypatch):
    """However fast it loads: the scene is waited for, or held up until its screen has been left.

    Not one of the stories: these scenes have none, so that the menu comes back as soon as that is known.
    """
    left, work = threading.Event(), Loader._work

    def held_up(loader: Loader) -> None:
        left.wait(600.0)
        work(loader)

    if not wait:
        monkeypatch.setattr(Loader, "_work", held_up)
    many.click(*many.top.bar.spots.find("Papers").rect.center)
    rest(many)
    many.key(pygame.K_RIGHT)
    many.key(pygame.K_RETURN)
    opened(many, wait)
    many.key(pygame.K_ESCAPE)
    menu = many.top
    assert (menu.focused.category, menu.focused.entry.name) == ("Papers", "papers-1")
    assert menu.view.contains(place_of(menu, menu.focus))
    assert menu.bar.names[0] == "Recent" and menu.items[0].entry.name == "papers-1"
    many.key(pygame.K_HOME)
    many.key(pygame.K_RETURN)
    opened(many, wait)
    many.key(pygame.K_ESCAPE)
    left.set()
    assert many.top.focused.category == "Recent"


def test_recent_ones_are_few_each_once_and_no_favourites(many: Driver):
    names = [f"stories-{i}" for i in range(15)]
    for name in [*names, "stories-3"]:
        many.app.open_scene(name)
        many.app.open_menu()
    recent = many.app.settings.recent
    assert recent[:2] == ["stories-3", "stories-14"] and len(recent) == len(set(recent)) == 12
    shown = [item.entry.name for item in many.top.items if item.category == "Recent"]
    assert (
        shown == recent[: len(shown)] and len({item.rect.top for item in many.top.items[: len(shown)]}) == 1
    )
    many.app.settings.favourites = ["stories-3"]
    many.app.restyle()
    assert [item.entry.name for item in many.top.items[:2]] == ["stories-3", "stories-14"]
    assert [item.category for item in many.top.items[:2]] == ["Favourites", "Recent"]


def test_search_looks_through_all_and_comes_back(many: Driver):
    menu = many.top
    many.click(*menu.bar.spots.find("Carom").rect.center)
    rest(many)
    many.type("papers-7")
    assert menu.items[0].entry.name == "papers-7" and menu.bar.names == ("Scenes",)
    many.key(pygame.K_ESCAPE)
    assert menu.query == "" and menu.focused.entry.name == "papers-7" and menu.focused.category == "Papers"


# -- pictures


def test_drawings_are_made_of_what_is_seen_only(start, monkeypatch):
    drawn: list[str] = []

    def draw(entry, size, look):
        drawn.append(entry.name)
        return pygame.Surface(size, 0, 32)

    monkeypatch.setattr(deck, "sketch", draw)
    driver = start(catalogue=eighty())
    driver.frames(60)
    menu = driver.top
    seen = {menu.items[i].entry.name for i in menu.in_view()}
    assert set(drawn) == seen and len(drawn) == len(seen) < 20
    # At once: how many cards a smooth way draws in passing is a matter of the machine's speed.
    menu.scroll.go(menu.scroll.most, at_once=True)
    rest(driver)
    assert {menu.items[i].entry.name for i in menu.in_view()} < set(drawn) and len(drawn) < 80
    assert len(drawn) == len(set(drawn))


def test_scenes_are_built_of_what_is_seen_only(many: Driver, monkeypatch):
    built: list[str] = []
    monkeypatch.setattr(thumbnails_module, "any_code", lambda: True)
    monkeypatch.setattr(thumbnails_module, "opens_at_once", lambda entry: True)
    monkeypatch.setattr(thumbnails_module, "_build", lambda entry: built.append(entry.name))
    monkeypatch.setattr(many.app.canvas_warming, "wait", lambda seconds: True)
    menu = many.top
    for _ in range(60):
        menu.thumbnails.begin(many.app.look)
        thread = menu.thumbnails._thread
        thread.join(600.0)
        many.frames()
    assert built[0] == menu.focused.entry.name
    assert sorted(built) == sorted(menu.items[i].entry.name for i in menu.in_view())


def test_kept_pictures_are_bounded(many: Driver, monkeypatch):
    monkeypatch.setattr(thumbnails_module, "MOST_PIXELS", 3 * 100 * 65)
    thumbnails, look = many.top.thumbnails, many.app.look
    for i in range(5):
        path = thumbnails_module._path((f"papers-{i}", look.theme.name, 100, 65))
        path.parent.mkdir(parents=True, exist_ok=True)
        pygame.image.save(pygame.Surface((100, 65)), str(path))
        assert thumbnails.load(f"papers-{i}", (100, 65), look) is not None
    kept = [thumbnails.kept(f"papers-{i}", (100, 65), look) is not None for i in range(5)]
    assert kept == [False, False, True, True, True]


@pytest.mark.parametrize("theme", ["dark", "light"])
@pytest.mark.parametrize("size", [(800, 600), (1280, 720), (1920, 1080), (3840, 2160)])
def test_bar_and_cards_stay_apart(start, size: tuple[int, int], theme: str):
    driver = start(catalogue=eighty(), size=size, theme=theme, favourites=["papers-0"])
    menu = driver.top
    driver.key(pygame.K_TAB)
    rest(driver)
    assert menu.header.rect.bottom <= menu.bar.rect.top and menu.bar.rect.bottom <= menu.view.top
    ground = driver.app.look.theme.bg
    rows = range(menu.bar.rect.top, menu.bar.spots.spots[0].rect.top)
    assert all(driver.window.surface.get_at((size[0] // 2, y)) == ground for y in rows)
    cards = [item.card for item in menu.items]
    assert min(card.rect.w for card in cards) >= menu.host.look.px(flow.NARROWEST) - 1


def test_no_file_of_settings_is_written_by_looking(many: Driver, tmp_path: Path):
    many.wheel(-3)
    many.key(pygame.K_TAB)
    assert not (many.app.folder / "settings.toml").exists()
