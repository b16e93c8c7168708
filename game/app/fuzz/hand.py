"""What a hand, or the window system, may do: one random thing at a time."""

from __future__ import annotations

from collections.abc import Sequence
from random import Random
from typing import Any

import pygame

from game.app.window.commands import COMMANDS
from game.app.window.keys import Chord, parse_chord

LEAVING = ("quit", "full-screen")  # would end the program, or change the screen of the person at it
SELDOM_USED = ("accuracy", "next", "previous")  # begin something long: pressed, but seldom
SELDOM = tuple(parse_chord(command.key) for command in COMMANDS if command.name in SELDOM_USED)
PLACES = tuple(parse_chord(command.key) for command in COMMANDS if command.name not in LEAVING + SELDOM_USED)
LETTERS = tuple(parse_chord(letter) for letter in "bcdefghijklmnoprstuvwxyz1234567890")
MORE = tuple(parse_chord(word) for word in ("return", "up", "down", "left", "right", "end", "delete"))
KEYS = PLACES + LETTERS + MORE
SIZES = ((1, 1), (40, 900), (320, 240), (640, 480), (1000, 700), (1280, 720), (1600, 1000))
BUTTONS = (1, 1, 1, 1, 2, 3, 9)


def any_event(hand: Random, size: tuple[int, int], chords: Sequence[Chord] = ()) -> list[pygame.Event]:
    """One thing that a hand may do in a window of that size, px. ``chords``: keys of the scene."""
    at = (hand.randrange(-5, size[0] + 5), hand.randrange(-5, size[1] + 5))
    kind = hand.randrange(12)
    if kind < 4:
        own = bool(chords) and hand.random() < 0.4
        chord = hand.choice(SELDOM if hand.random() < 0.01 else chords if own else KEYS)
        code = hand.choice([pygame.K_RETURN, pygame.K_UP, pygame.K_DOWN, pygame.K_a, pygame.K_TAB])
        modifier = (pygame.KMOD_CTRL if chord.control else 0) | (pygame.KMOD_SHIFT if chord.shift else 0)
        fields: dict[str, Any] = {"key": code, "scancode": chord.scancode, "mod": modifier}
        return [pygame.Event(pygame.KEYDOWN, unicode="", **fields), pygame.Event(pygame.KEYUP, **fields)]
    if kind < 7:
        rel = (hand.randrange(-30, 30), hand.randrange(-30, 30))
        return [pygame.Event(pygame.MOUSEMOTION, pos=at, rel=rel, buttons=(0, 0, 0))]
    if kind < 10:
        button, down = hand.choice(BUTTONS), hand.random() < 0.5
        return [pygame.Event(pygame.MOUSEBUTTONDOWN if down else pygame.MOUSEBUTTONUP, pos=at, button=button)]
    if kind == 10:
        return [pygame.Event(pygame.MOUSEWHEEL, x=0, y=hand.randrange(-3, 4), pos=at)]
    return [hand.choice(_rare_events(hand))]


def _rare_events(hand: Random) -> list[pygame.Event]:
    """What windows and gamepads do, and what is not expected."""
    return [
        pygame.Event(pygame.WINDOWFOCUSLOST),
        pygame.Event(pygame.WINDOWLEAVE),
        pygame.Event(pygame.WINDOWMINIMIZED),
        pygame.Event(pygame.WINDOWRESTORED),
        pygame.Event(pygame.TEXTINPUT, text=hand.choice("ab1-. é")),
        pygame.Event(pygame.JOYAXISMOTION, instance_id=0, axis=hand.randrange(4), value=hand.uniform(-1, 1)),
        pygame.Event(pygame.JOYBUTTONDOWN, instance_id=0, button=hand.randrange(9)),
        pygame.Event(pygame.JOYBUTTONUP, instance_id=0, button=hand.randrange(9)),
        pygame.Event(pygame.JOYHATMOTION, instance_id=0, hat=0, value=(hand.randrange(-1, 2), 0)),
        pygame.Event(pygame.USEREVENT),
    ]


def any_drag(hand: Random, size: tuple[int, int]) -> list[list[pygame.Event]]:
    """Frames of a drag from somewhere to somewhere else, as people do them."""
    button = hand.choice(BUTTONS)
    x, y = hand.randrange(size[0]), hand.randrange(size[1])
    frames = [[pygame.Event(pygame.MOUSEBUTTONDOWN, pos=(x, y), button=button)]]
    for _ in range(hand.randrange(1, 5)):
        rel = (hand.randrange(-80, 81), hand.randrange(-80, 81))
        x, y = x + rel[0], y + rel[1]
        frames.append([pygame.Event(pygame.MOUSEMOTION, pos=(x, y), rel=rel, buttons=(1, 0, 0))])
    frames.append([pygame.Event(pygame.MOUSEBUTTONUP, pos=(x, y), button=button)])
    return frames
