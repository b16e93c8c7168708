"""A display without a screen, and the helpers that all tests of widgets use."""

from __future__ import annotations

import pygame
import pytest

from game.ui.look.look import Look
from game.ui.look.theme import DARK, LIGHT


@pytest.fixture(scope="session", autouse=True)
def display():
    """pygame with its dummy driver."""
    pygame.display.init()
    pygame.font.init()
    pygame.display.set_mode((320, 240))
    return pygame.display.get_surface()


@pytest.fixture
def look():
    """The dark look at scale 1."""
    return Look(DARK)


@pytest.fixture(params=[(DARK, 1.0), (LIGHT, 1.5), (DARK, 2.0)], ids=["dark", "light-1.5", "dark-2"])
def any_look(request):
    """Looks of both themes and several scales."""
    return Look(*request.param)
