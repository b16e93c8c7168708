"""The menu under a random hand."""

from __future__ import annotations

from random import Random

import pygame
import pytest

from game.app.fuzz.hand import SIZES, any_drag, any_event
from game.app.menu.screen import MenuScreen
from tests.app.menu.eighty import eighty

MENU_KEYS = (
    pygame.K_TAB,
    pygame.K_PAGEUP,
    pygame.K_PAGEDOWN,
    pygame.K_HOME,
    pygame.K_END,
    pygame.K_BACKSPACE,
)


@pytest.mark.parametrize("seed", range(3))
def test_any_hand_leaves_the_menu_whole(start, seed: int):
    hand = Random(f"menu {seed}")
    driver = start(catalogue=eighty(), recent=["papers-1"])
    for step in range(1200):
        _one_thing(driver, hand)
        if step % 40 == 0 and len(driver.app.screens) > 1:
            driver.app.pop()
        menu = driver.top
        if not isinstance(menu, MenuScreen):
            if not menu.overlay:
                driver.app.open_menu(menu.entry.name)
            continue
        driver.app.running = True
        assert menu.focus < max(1, len(menu.items))
        assert 0 <= menu.scroll.offset <= menu.scroll.most
        assert menu.bar.current in ("", *menu.bar.names)
        keys = [item.key for item in menu.items]
        assert len(set(keys)) == len(keys)
    settings = driver.app.settings
    assert len(set(settings.favourites)) == len(settings.favourites) and len(settings.recent) <= 12


def _one_thing(driver, hand: Random) -> None:
    """An event, a drag, a key of the menu, or another size of the window."""
    kind = hand.random()
    size = driver.window.size
    if kind < 0.6:
        driver.waiting += any_event(hand, size)
        driver.frames(1, hand.choice((0.0, 0.016, 0.1)))
    elif kind < 0.7:
        for events in any_drag(hand, size):
            driver.waiting += events
            driver.frames()
    elif kind < 0.97:
        driver.key(hand.choice(MENU_KEYS), hand.choice((0, 0, pygame.KMOD_SHIFT)))
        if hand.random() < 0.2:
            driver.key(pygame.K_f, pygame.KMOD_CTRL)
    else:
        driver.resize(*hand.choice(SIZES))
