"""The time bar of a story: which moment a pixel means, what each press asks for, which buttons there are."""

from __future__ import annotations

import itertools

import pygame
import pytest

from game.ui.look.look import Look
from game.ui.look.theme import DARK
from game.ui.widgets.timebar import (
    BUTTON,
    CLOCK,
    CONTROL_GAP,
    HEIGHT,
    PAUSE,
    SIDE,
    SMALL,
    SNAP,
    SPEED,
    TimeBar,
    TimeBarState,
)
from game.ui.widgets.timebar import (
    CHAPTERS as CHAPTERS_WIDTH,
)
from game.ui.widgets.wishes import Wish

CHAPTERS = (("One", 0.0), ("Two", 20.0), ("Three", 44.0))


def bar_of(width: int = 1000, scale: float = 1.0, **state) -> TimeBar:
    bar = TimeBar(Look(DARK, scale))
    bar.place(pygame.Rect(30, 10, width, 500), bar.look)
    bar.update(0.1, TimeBarState(**{"chapters": CHAPTERS, **state}))
    return bar


def at(bar: TimeBar, x: float, kind: int = pygame.MOUSEBUTTONDOWN, y: int | None = None, button: int = 1):
    place = (round(x), bar.rect.centery if y is None else y)
    more = {} if kind == pygame.MOUSEMOTION else {"button": button}
    return bar.handle(pygame.event.Event(kind, pos=place, **more))


def names(bar: TimeBar) -> list[str]:
    return [spot.name for spot in bar.spots.spots]


@pytest.mark.parametrize("scale", [1.0, 1.5])
def test_it_lies_along_the_foot_and_its_track_between_clock_and_buttons(scale):
    bar = bar_of(scale=scale)
    px = bar.look.px
    assert bar.rect == pygame.Rect(30, 510 - px(HEIGHT), 1000, px(HEIGHT))
    button = bar.spots.spots[0].rect
    assert names(bar) == ["story-take-over"]
    assert (button.right, button.w, button.h) == (1030 - px(SIDE), px(BUTTON), px(28))
    track = bar.track
    pause, speed, chapters = (spot.rect for spot in bar.controls.spots)
    assert pause.x == 30 + px(SIDE) and speed.right == button.x - px(8)
    assert chapters.right == speed.x - px(CONTROL_GAP)
    assert track.x == pause.right + px(CONTROL_GAP + CLOCK) and track.h == px(6)
    assert track.right == chapters.x - px(CONTROL_GAP)
    low = TimeBar(bar.look)
    low.place(pygame.Rect(0, 0, 500, 20), bar.look)
    assert low.rect == pygame.Rect(0, 0, 500, 20)


@pytest.mark.parametrize(
    ("state", "expected"),
    [
        ({}, ["story-take-over"]),
        ({"ended": True}, []),
        ({"free": True}, ["story-take-over", "story-camera"]),
        ({"taken_over": True}, ["story-go-on", "story-here"]),
        ({"taken_over": True, "ended": True, "free": True}, ["story-go-on", "story-here", "story-camera"]),
    ],
)
def test_the_buttons_are_those_that_make_sense_from_right_to_left(state, expected):
    bar = bar_of(**state)
    assert names(bar) == expected
    places = [spot.rect for spot in bar.spots.spots]
    for right, left in itertools.pairwise(places):
        assert right.x - left.right == bar.look.px(8)
    assert all(spot.enabled for spot in bar.spots.spots)
    bar.update(0.1, bar.state._replace(share=0.5))
    assert names(bar) == expected and not any(spot.enabled for spot in bar.spots.spots)


def test_a_bar_without_room_has_no_buttons():
    least = SIDE + CLOCK + 120 + BUTTON + 8
    assert names(bar_of(least)) == ["story-take-over"] and names(bar_of(least - 1)) == []


def test_a_pixel_means_its_share_of_the_time_and_near_a_mark_the_chapter():
    bar = bar_of(length_s=60.0)
    track = bar.track
    for chapter in (20.0, 44.0):
        mark = track.x + track.w * chapter / 60.0
        for side in (-1, 1):
            inside = round(mark + side * (SNAP - 0.6))
            beyond = round(mark + side * (SNAP + 1.6))
            assert bar._time_at(inside) == chapter
            assert bar._time_at(beyond) == pytest.approx((beyond - track.x) / track.w * 60.0)
            assert bar._time_at(beyond) != chapter
    assert bar._time_at(track.x - 50) == 0.0 and bar._time_at(track.right + 50) == 60.0
    assert [bar._x_of(t) for t in (-5.0, 0.0, 30.0, 60.0, 99.0)] == [
        track.x, track.x, track.x + 0.5 * track.w, track.right, track.right
    ]  # fmt: skip
    exact = bar_of(length_s=bar.track.w / 1.0)  # a second a pixel: the edge of what still means a mark
    near = round(exact.track.x + 20.0 + SNAP)
    assert exact._time_at(near) == 20.0 and exact._time_at(near + 1) == pytest.approx(28.0)


def test_a_press_on_the_bar_seeks_where_it_is_let_go():
    bar = bar_of()
    track = bar.track
    x = track.x + track.w // 2 + 60
    assert at(bar, x, pygame.MOUSEMOTION) == (True, None) and bar.pointed == bar._time_at(x)
    assert at(bar, x, pygame.MOUSEMOTION, y=5) == (False, None) and bar.pointed is None
    assert at(bar, x, y=5) == (False, None)
    assert at(bar, x, pygame.MOUSEBUTTONUP) == (True, None)  # nothing was pressed
    assert at(bar, x, button=3) == (True, None)
    assert at(bar, x, pygame.MOUSEBUTTONUP) == (True, None)
    assert at(bar, x) == (True, None)
    assert at(bar, x + 90, pygame.MOUSEMOTION, y=5) == (True, None) and bar.pointed == bar._time_at(x + 90)
    assert at(bar, x + 90, pygame.MOUSEBUTTONUP, button=3, y=5) == (False, None)
    assert at(bar, x + 90, pygame.MOUSEBUTTONUP, y=5) == (True, Wish("seek", bar._time_at(x + 90)))
    assert at(bar, x, pygame.MOUSEMOTION, y=5) == (False, None)
    assert bar.handle(pygame.event.Event(pygame.KEYDOWN, key=pygame.K_RETURN)) == (False, None)


def test_a_press_on_a_button_is_its_wish_and_does_not_seek():
    bar = bar_of(taken_over=True)
    for name in names(bar):
        x = bar.spots.find(name).rect.centerx
        assert at(bar, x) == (True, None)
        assert at(bar, x, pygame.MOUSEBUTTONUP) == (True, Wish(name))
        assert at(bar, bar.track.centerx, pygame.MOUSEBUTTONUP) == (True, None)


def test_while_a_jump_is_under_way_nothing_is_sought():
    bar = bar_of(share=0.3)
    assert at(bar, bar.track.centerx) == (True, None)
    assert at(bar, bar.track.centerx, pygame.MOUSEBUTTONUP) == (True, None)


def test_a_bar_too_small_is_not_drawn_and_any_other_is():
    for width, height, drawn in ((SIDE + CLOCK + 60, 500, True), (SIDE + CLOCK + 59, 500, False),
                                 (400, HEIGHT // 2, True), (400, HEIGHT // 2 - 1, False)):  # fmt: skip
        surface = pygame.Surface((width, height), 0, 32)
        bar = TimeBar(Look(DARK, 1.0))
        bar.place(surface.get_rect(), bar.look)
        bar.draw(surface)
        assert any(surface.get_buffer().raw) == drawn, (width, height)


def controls(bar: TimeBar) -> list[str]:
    return [spot.name for spot in bar.controls.spots]


def test_pause_speed_and_chapters_ask_by_name():
    bar = bar_of()
    assert controls(bar) == ["pause", "story-speed", "story-chapters"]
    for spot in bar.controls.spots:
        x, y = spot.rect.center
        assert at(bar, x, y=y) == (True, None)
        assert at(bar, x, pygame.MOUSEBUTTONUP, y=y) == (True, Wish(spot.name))
    bar.update(0.1, bar.state._replace(share=0.5))
    assert not any(spot.enabled for spot in bar.controls.spots)


def test_controls_go_before_the_track_becomes_too_short():
    least = PAUSE + CHAPTERS_WIDTH + SPEED + 3 * CONTROL_GAP + SIDE + CLOCK + 120 + SIDE + BUTTON + 8
    assert len(controls(bar_of(least))) == 3 and controls(bar_of(least - 1)) == []
    assert bar_of(least).track.w >= 120 and bar_of(least - 1).track.w >= 120


def test_what_is_pointed_at_is_shown_small_above_the_bar():
    picture = pygame.Surface((240, 135), 0, 32)
    picture.fill((10, 200, 30))
    bar = bar_of(picture=picture)
    x = bar.track.centerx
    at(bar, x, pygame.MOUSEMOTION)
    surface = pygame.Surface((1100, 600), 0, 32)
    bar.draw(surface)
    above = bar.rect.y - 28 - SMALL[1] // 2
    assert surface.get_at((x, above))[:3] == pytest.approx((10, 200, 30), abs=3)
    bar.update(0.1, bar.state._replace(share=0.5))  # a jump says how far it is instead
    surface.fill((0, 0, 0))
    bar.draw(surface)
    assert surface.get_at((x, above))[:3] == (0, 0, 0)


def test_the_sign_of_pause_is_that_of_going_on_once_it_is_paused():
    pictures = []
    for paused in (False, True):
        bar = bar_of(paused=paused)
        surface = pygame.Surface((1100, 600), 0, 32)
        bar.draw(surface)
        pictures.append(pygame.image.tobytes(surface.subsurface(bar.controls.spots[0].rect), "RGB"))
    assert pictures[0] != pictures[1]
