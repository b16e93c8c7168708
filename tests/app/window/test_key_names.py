"""Key caps: a key has one name, wherever it is printed."""

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
