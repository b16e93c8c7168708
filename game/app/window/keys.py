"""Keys by their place on the keyboard: what each does, how the settings name it, what is printed on it.

A command belongs to a scancode (the place), so that the keys lie alike on every layout. Hints show the letter
that the layout has there. Settings write the place by its name on a US keyboard: "space", "period", "ctrl+s".
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from typing import Any, NamedTuple

import pygame

from game.app.window.commands import BY_NAME, COMMANDS
from game.ui.widgets.keycap import CAPS


class Chord(NamedTuple):
    """A key by its place, with or without Ctrl (Cmd on a Mac), and with that also with Shift."""

    scancode: int
    control: bool = False
    shift: bool = False


_PLACES = {
    name.removeprefix("KSCAN_").lower(): getattr(pygame, name)
    for name in dir(pygame)
    if name.startswith("KSCAN_") and name != "KSCAN_UNKNOWN"
}
NO_KEY = "–"


def parse_chord(text: str) -> Chord:
    """The chord that a settings word names; ValueError if there is no such key."""
    words = [word.strip().lower() for word in text.split("+")]
    control = len(words) >= 2 and words[0] in ("ctrl", "cmd")
    shift = control and len(words) == 3 and words[1] == "shift"
    if len(words) != 1 + control + shift or words[-1] not in _PLACES:
        raise ValueError(
            f'{text!r} is not a key; keys are named as "a", "space", "f5", "ctrl+s" or "ctrl+shift+s"'
        )
    return Chord(_PLACES[words[-1]], control, shift)


class Keys:
    """Which command a key press means, and what to print for a command in a hint."""

    def __init__(self, changed: Mapping[str, str] | None = None):
        """``changed``: key words by command, for those that differ. ValueError names what is wrong.

        A key that was given to another command is taken from the one that has it by default.
        """
        changed = dict(changed or {})
        self.chords: dict[str, Chord] = {}
        self._commands: dict[Chord, str] = {}
        for name, word in changed.items():
            if name not in BY_NAME:
                raise ValueError(f"keys.{name}: no such command; there are {', '.join(BY_NAME)}")
            try:
                chord = parse_chord(word)
            except ValueError as error:
                raise ValueError(f"keys.{name}: {error}") from None
            if chord in self._commands:
                raise ValueError(f"keys.{name}: {word} is also the key of {self._commands[chord]}")
            self._bind(name, chord)
        for command in COMMANDS:
            if command.name not in changed and parse_chord(command.key) not in self._commands:
                self._bind(command.name, parse_chord(command.key))

    def _bind(self, name: str, chord: Chord) -> None:
        self.chords[name] = chord
        self._commands[chord] = name

    def command(self, event: pygame.Event) -> str | None:
        """The command of a KEYDOWN event, or None. Shift that no command asks for is passed over."""
        chord = chord_of(event)
        return self._commands.get(chord) or self._commands.get(chord._replace(shift=False))

    def label(self, name: str) -> str:
        """What is printed on the command's key in the present layout; a dash if it has none."""
        return chord_label(self.chords[name]) if name in self.chords else NO_KEY

    def changed_by(self, name: str, chord: Chord) -> dict[str, str]:
        """What the settings say when a command gets a key, in the form that ``Keys`` takes.

        A command that has the key already gets the other's in exchange. ValueError if the key is the way
        back, or has no name that the settings could keep.
        """
        if not _place_name(chord.scancode):
            raise ValueError("this key has no name")
        if chord in (self.chords.get("back"), self.chords.get("quit")) and self._commands[chord] != name:
            raise ValueError(f"{chord_label(chord)} stays the key to get out")
        chords = dict(self.chords)
        other, old = self._commands.get(chord), chords.get(name)
        if other is not None and other != name:
            del chords[other]
            if old is not None:
                chords[other] = old
        chords[name] = chord
        return {n: chord_word(c) for n, c in chords.items() if c != parse_chord(BY_NAME[n].key)}


def chord_word(chord: Chord) -> str:
    """The chord as the settings name it: "space", "ctrl+s", "ctrl+shift+s"."""
    name = _place_name(chord.scancode)
    return f"ctrl+{'shift+' * chord.shift}{name}" if chord.control else name


def chord_of(event: pygame.Event) -> Chord:
    """The chord of a KEYDOWN event."""
    control = bool(event.mod & (pygame.KMOD_CTRL | pygame.KMOD_META))
    return Chord(event.scancode, control, control and bool(event.mod & pygame.KMOD_SHIFT))


def chord_label(chord: Chord) -> str:
    """The key's name in the present keyboard layout, e.g. "Ctrl+S", "Esc", "."."""
    name = pygame.key.name(_keycodes(_layout()).get(chord.scancode, 0)) or _place_name(chord.scancode) or "?"
    shown = CAPS.get(name) or name.capitalize()
    return f"Ctrl+{'Shift+' * chord.shift}{shown}" if chord.control else shown


def _place_name(scancode: int) -> str:
    """The key's name on a US keyboard, empty if it has none."""
    return next((name for name, place in _PLACES.items() if place == scancode), "")


def _places_by_code() -> Any:
    """A table that gives each key code's place in the present layout.

    pygame only looks this way round: its pressed-keys table takes a code and finds the place, here in a
    table that holds the places' own numbers.
    """
    places: tuple[Any, ...] = tuple(range(512))
    return pygame.key.ScancodeWrapper(places)


def _layout() -> tuple[int, ...]:
    """What tells the present layout from others: the places of what can be printed in ASCII."""
    table = _places_by_code()
    return tuple(int(table[code]) for code in range(0x21, 0x7F))


@lru_cache(maxsize=4)
def _keycodes(layout: tuple[int, ...]) -> dict[int, int]:
    """Key codes by scancode; asking for all of them takes milliseconds, so each layout's are kept."""
    table = _places_by_code()
    named = [getattr(pygame, name) for name in dir(pygame) if name.startswith("K_")]
    return {int(table[code]): code for code in (*named, *range(0x21, 0x250))}
