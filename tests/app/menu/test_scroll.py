"""How far the menu is scrolled: bounds, the way there, drags."""

import pygame
import pytest

from game.app.menu.scroll import Scroll
from game.ui.look.look import Look
from game.ui.look.theme import DARK

LOOK = Look(DARK, 1.0)
VIEW = pygame.Rect(0, 120, 800, 400)


@pytest.fixture
def scroll() -> Scroll:
    one = Scroll()
    one.bound(2000, VIEW, LOOK)
    return one


@pytest.mark.parametrize(("target", "goal"), [(-50, 0), (700, 700), (5000, 1600)])
def test_goes_no_farther_than_the_ends(scroll: Scroll, target: float, goal: int):
    scroll.go(target)
    for _ in range(200):
        scroll.update(1.0 / 60.0)
    assert scroll.offset == goal and not scroll.moving


def test_way_is_the_same_at_any_frame_rate(scroll: Scroll):
    other = Scroll()
    other.bound(2000, VIEW, LOOK)
    scroll.go(1000)
    other.go(1000)
    scroll.update(0.1)
    for _ in range(10):
        other.update(0.01)
    assert scroll.at == pytest.approx(other.at) and 0 < scroll.at < 1000
    before = scroll.at
    assert not scroll.update(0.0) and scroll.at == before


@pytest.mark.parametrize(("top", "bottom", "goal"), [(100, 300, 100), (600, 800, 500), (1500, 1700, 1300)])
def test_shows_by_as_little_as_it_can(scroll: Scroll, top: int, bottom: int, goal: int):
    scroll.go(500, at_once=True)
    scroll.show(top, bottom, at_once=True)
    assert scroll.offset == goal


def test_shows_the_top_of_what_is_higher_than_the_view(scroll: Scroll):
    scroll.show(300, 900, at_once=True)
    assert scroll.offset == 300


def test_less_content_brings_it_back(scroll: Scroll):
    scroll.go(1600, at_once=True)
    scroll.bound(500, VIEW, LOOK)
    assert scroll.offset == scroll.target == scroll.most == 100
    scroll.bound(300, VIEW, LOOK)
    assert scroll.offset == scroll.most == 0 and scroll.thumb(LOOK) is None


def test_small_move_is_no_drag(scroll: Scroll):
    scroll.press((300, 300), LOOK)
    assert not scroll.drag((300, 294), LOOK)
    assert not scroll.release() and scroll.offset == 0
    assert not scroll.drag((300, 100), LOOK) and scroll.offset == 0


def test_drag_follows_and_can_be_taken_back(scroll: Scroll):
    scroll.press((300, 400), LOOK)
    assert scroll.drag((300, 150), LOOK) and scroll.offset == 250
    assert scroll.drag((300, 400), LOOK) and scroll.offset == 0
    assert scroll.release()


def test_thumb_is_in_proportion_and_goes_to_both_ends(scroll: Scroll):
    thumb = scroll.thumb(LOOK)
    assert thumb is not None and thumb.h == 400 * 400 // 2000 and thumb.top == VIEW.top
    scroll.go(1600, at_once=True)
    assert scroll.thumb(LOOK).bottom == VIEW.bottom
    scroll.press((795, scroll.thumb(LOOK).centery), LOOK)
    scroll.drag((795, scroll.thumb(LOOK).centery - 160), LOOK)
    assert scroll.offset == pytest.approx(800, abs=2)
