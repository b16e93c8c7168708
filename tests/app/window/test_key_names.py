"""Key caps: a key has one name, wherever it is printed."""

import pygame
import pytest

from game.app.window.keys import chord_label, parse_chord
from game.scenes import CATALOGUE
from game.scenes.skeletons.base import MAKING
from game.ui.widgets.keycap import key_name


@pytest.mark.parametrize(
    ("key", "name"),
    (
        ("z", "Z"),
        ("ctrl+z", "Ctrl+Z"),
        ("left", "←"),
        ("[", "["),
        ("return", "Enter"),
        ("f5", "F5"),
        ("space", "Space"),
    ),
)
def test_what_is_printed_on_a_key(key, name):
    assert key_name(key) == name


@pytest.mark.parametrize("entry", tuple(CATALOGUE), ids=lambda entry: entry.name)
def test_hints_and_actions_call_no_key_by_a_second_name(entry):
    scene_type = entry.load()
    named = {key for hint in scene_type.hints for key in hint.keys}
    named |= {key_name(action.key) for action in scene_type.actions}
    assert not named & {"Return", "Escape", "Backspace"}


@pytest.mark.parametrize("tool", tuple(MAKING))
def test_nor_do_those_of_a_tool(tool):
    assert not {key for hint in MAKING[tool] for key in hint.keys} & {"Return", "Escape", "Backspace"}


@pytest.mark.parametrize("key", ("return", "escape", "left", "pageup", "backspace", "space", "f1"))
def test_the_card_of_keys_prints_the_same(key):
    assert chord_label(parse_chord(key)) == key_name(key)


def test_a_layout_is_asked_for_its_keys_once_and_another_one_again(monkeypatch):
    """Asking for all of them takes milliseconds, and hints name keys whenever the menu is painted."""
    asked, moved = [], {}
    plain = pygame.key.ScancodeWrapper

    class Table:
        def __init__(self, places):
            self.places = plain(places)

        def __getitem__(self, code):
            asked.append(code)
            return self.places[moved.get(code, code)]

    monkeypatch.setattr(pygame.key, "ScancodeWrapper", Table)
    assert chord_label(parse_chord("q")) == "Q"
    asked.clear()
    assert chord_label(parse_chord("a")) == "A" and len(asked) < 100
    moved.update({pygame.K_q: pygame.K_a, pygame.K_a: pygame.K_q})
    assert chord_label(parse_chord("q")) == "A"
