"""Keys: places on the keyboard, their names in settings and in hints."""

import pygame
import pytest

from game.app.window.commands import COMMANDS
from game.app.window.keys import Chord, Keys, chord_label, parse_chord


@pytest.fixture(autouse=True)
def display():
    pygame.display.init()


def press(code: int, mod: int = 0) -> pygame.Event:
    scancode = pygame.key.ScancodeWrapper(tuple(range(512)))[code]
    return pygame.Event(pygame.KEYDOWN, key=code, scancode=scancode, mod=mod, unicode="")


@pytest.mark.parametrize("command", COMMANDS, ids=lambda command: command.name)
def test_every_command_has_a_key_of_its_own(command):
    keys = Keys()
    chord = keys.chords[command.name]
    event = pygame.Event(
        pygame.KEYDOWN,
        key=0,
        scancode=chord.scancode,
        mod=(pygame.KMOD_LCTRL if chord.control else 0) | (pygame.KMOD_LSHIFT if chord.shift else 0),
        unicode="",
    )
    assert keys.command(event) == command.name
    assert keys.label(command.name) not in ("", "?")


def test_place_counts_and_not_the_letter():
    event = pygame.Event(pygame.KEYDOWN, key=pygame.K_q, scancode=pygame.KSCAN_A, mod=0, unicode="q")
    assert Keys().command(event) == "accuracy"


def test_control_makes_another_key():
    keys = Keys()
    assert keys.command(press(pygame.K_s, pygame.KMOD_LCTRL)) == "save"
    assert keys.command(press(pygame.K_s, pygame.KMOD_LMETA)) == "save"
    assert keys.command(press(pygame.K_s)) is None


def test_key_is_bound_anew():
    keys = Keys({"pause": "ctrl+p", "panel": "F5"})
    assert keys.command(press(pygame.K_p, pygame.KMOD_RCTRL)) == "pause"
    assert keys.command(press(pygame.K_F5)) == "panel"
    assert keys.command(press(pygame.K_SPACE)) is None
    assert keys.label("pause") == "Ctrl+P"


def test_key_given_away_is_taken_from_its_default():
    keys = Keys({"pause": "a"})
    assert keys.command(press(pygame.K_a)) == "pause"
    assert keys.label("accuracy") == "–"


def test_one_key_cannot_be_given_twice():
    with pytest.raises(ValueError, match=r"keys\.levels: x is also the key of pause"):
        Keys({"pause": "x", "levels": "x"})


def test_two_commands_may_change_places():
    keys = Keys({"accuracy": "l", "levels": "a"})
    assert keys.command(press(pygame.K_a)) == "levels"


@pytest.mark.parametrize("word", ["", "shift+a", "ctrl+", "ctrl+ctrl", "hyper", "a+b", "ctrl+alt+a", "\x00"])
def test_nonsense_is_no_key(word: str):
    with pytest.raises(ValueError, match="is not a key"):
        parse_chord(word)


def test_labels_are_short():
    assert chord_label(parse_chord("escape")) == "Esc"
    assert chord_label(parse_chord("ctrl+s")) == "Ctrl+S"
    assert chord_label(parse_chord("left")) == "←"
    assert chord_label(Chord(0)) != ""


def test_shift_makes_another_chord_of_ctrl_and_is_else_passed_over():
    keys = Keys()
    both = pygame.KMOD_LCTRL | pygame.KMOD_LSHIFT

    def command(scancode: int, mod: int) -> str | None:
        return keys.command(pygame.Event(pygame.KEYDOWN, key=0, scancode=scancode, mod=mod))

    assert command(pygame.KSCAN_C, both) == "copy" and command(pygame.KSCAN_C, pygame.KMOD_LCTRL) is None
    assert command(pygame.KSCAN_S, both) == command(pygame.KSCAN_S, pygame.KMOD_LCTRL) == "save"
    assert command(pygame.KSCAN_PERIOD, pygame.KMOD_LSHIFT) == "step"
    assert chord_label(parse_chord("ctrl+shift+c")) == "Ctrl+Shift+C"
    assert Keys({"pause": "ctrl+shift+p"}).label("pause") == "Ctrl+Shift+P"
    assert Keys().changed_by("pause", parse_chord("ctrl+shift+p")) == {"pause": "ctrl+shift+p"}
