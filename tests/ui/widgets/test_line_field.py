"""A field for one line: which keys are its own, and what it takes of them."""

from __future__ import annotations

import pygame
import pytest

from game.ui.widgets.line_field import LineField


def key(code: int, mod: int = 0) -> pygame.Event:
    return pygame.Event(pygame.KEYDOWN, key=code, mod=mod)


@pytest.mark.parametrize(
    ("event", "own"),
    [
        (key(pygame.K_a), True), (key(pygame.K_a, pygame.KMOD_LSHIFT), True), (key(pygame.K_SPACE), True),
        (key(pygame.K_RETURN), True), (key(pygame.K_BACKSPACE, pygame.KMOD_LCTRL), True),
        (key(pygame.K_a, pygame.KMOD_LCTRL), False), (key(pygame.K_a, pygame.KMOD_LMETA), False),
        (key(pygame.K_F7), False), (key(pygame.K_LEFT), False), (key(pygame.K_F7, pygame.KMOD_LCTRL), False),
        (key(pygame.K_ESCAPE), False), (key(pygame.K_TAB), False),
    ],
)  # fmt: skip
def test_what_prints_is_for_the_field_and_commands_are_not(event: pygame.Event, own: bool) -> None:
    assert LineField.wants(event) is own


def test_it_takes_letters_up_to_its_length_and_gives_them_back_one_by_one_or_whole() -> None:
    field = LineField("", "name", 5)
    assert not field.handle(pygame.Event(pygame.TEXTINPUT, text="  Ad\x07a Lovelace"))
    assert field.text == "Ada L"
    assert not field.handle(key(pygame.K_BACKSPACE)) and field.text == "Ada "
    assert not field.handle(key(pygame.K_BACKSPACE, pygame.KMOD_LCTRL)) and field.text == ""
    assert field.handle(key(pygame.K_RETURN)) and field.handle(key(pygame.K_KP_ENTER))
