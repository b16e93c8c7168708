"""The stack of screens: what is taken away, and what stays."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from game.app.screens.stack import ScreenStack


def screen(name, overlay=False):
    told = []
    return SimpleNamespace(
        name=name, overlay=overlay, told=told, covered=lambda: told.append("covered"),
        uncovered=lambda: told.append("uncovered"), closed=lambda: told.append("closed"),
    )  # fmt: skip


@pytest.fixture
def pair():
    stack, screens = ScreenStack(), [screen("menu"), screen("card", overlay=True)]
    for one in screens:
        stack.push(one)
    return stack, screens


def test_a_screen_that_failed_is_forgotten_and_asked_nothing(pair):
    stack, (menu, card) = pair
    stack.remove(menu)
    assert list(stack) == [card] and menu.told == ["covered"]


def test_the_last_screen_stays(pair):
    stack, (menu, card) = pair
    stack.remove(card)
    stack.remove(menu)
    stack.pop()
    assert list(stack) == [menu]


def test_a_screen_that_is_not_open_changes_nothing(pair):
    stack, screens = pair
    stack.remove(screen("other"))
    assert list(stack) == screens


def test_what_is_below_an_overlay_is_seen_and_called_back(pair):
    stack, (menu, card) = pair
    assert stack.visible() == [menu, card]
    stack.pop()
    assert card.told == ["closed"] and menu.told == ["covered", "uncovered"]
    stack.push(screen("scene"))
    assert [one.name for one in stack.visible()] == ["scene"]


def test_another_in_place_of_the_top_closes_all_overlays(pair):
    stack, (menu, card) = pair
    other = screen("other")
    stack.replace(other)
    assert list(stack) == [other] and menu.told[-1] == card.told[-1] == "closed"
    stack.clear()
    assert len(stack) == 0 and other.told == ["closed"]
