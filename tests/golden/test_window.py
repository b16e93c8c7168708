"""The window shows on a tour what it showed when that was kept; what counts as another picture."""

from __future__ import annotations

import pygame
import pytest

from game.app.stagehand.headless import prepare
from tests.golden import window
from tests.golden.accounts import written_with
from tests.golden.pictures import other_parts, sums_of

SHOWN = 12  # differences in a message


@pytest.mark.compiled
def test_the_window_shows_what_it_showed() -> None:
    prepare()
    kept = window.read()
    if kept.pop("with") != written_with():
        pytest.skip("it was kept with another pygame")
    found = list(window.differences(kept, window.account_of_window()))
    more = f"and {len(found) - SHOWN} more" if len(found) > SHOWN else ""
    meant = "pictures of it: python -m tests.golden.window FOLDER, which keeps them as well"
    assert not found, "\n".join([*found[:SHOWN], more, meant])


def _picture(shift: int = 0, lighter: int = 0) -> str:
    """Letters on a ground, further to the right by some pixels, or lighter."""
    surface = pygame.Surface((640, 360), 0, 32)
    surface.fill((40 + lighter, 40 + lighter, 40 + lighter))
    for x in range(100, 130, 7):
        surface.fill((200 + lighter, 220 + lighter, 90 + lighter), (x + shift, 50, 2, 9))
    return sums_of(surface)


def test_rounding_of_each_pixel_is_no_other_picture() -> None:
    assert list(other_parts(_picture(), _picture(lighter=1))) == []


def test_a_word_a_pixel_further_is_another_picture_and_its_place_is_said() -> None:
    (where,) = other_parts(_picture(), _picture(1))
    assert where.startswith("column 2, row 1: ")


def test_what_is_missing_or_new_on_the_tour_is_named() -> None:
    told = {"0 menu": f"MenuScreen {_picture()}"}
    other = {"0 menu": f"HelpScreen {_picture()}", "1 help": f"HelpScreen {_picture()}"}
    assert list(window.differences(told, other)) == [
        "0 menu: MenuScreen kept, HelpScreen now",
        "1 help: only now",
    ]
    assert list(window.differences(told, told)) == []
