"""What the hand at a cue table holds, as a value: its kind, and which of that kind."""

from __future__ import annotations

import enum
from typing import NamedTuple


class Held(enum.Enum):
    """Kinds of things that a hand at a table takes hold of."""

    NOTHING = "nothing"
    BUTTON = "button"  # named
    CARD = "card"  # of a player, numbered
    CUE = "cue"
    EYE = "eye"  # the corner of the view from the cue
    CUE_BALL = "cue ball"  # in hand, after a foul
    BALL = "ball"  # numbered
    POWER = "power"
    TIP = "tip"  # on its picture
    TIP_FREELY = "tip freely"  # from anywhere on the table
    ELEVATION = "elevation"
    LIST = "list"  # beside the table
    OPTION = "option"  # numbered
    REPLAY = "replay"  # the moment that is shown
    ZONE = "zone"  # of a drill


class Grip(NamedTuple):
    """What is held; false for nothing. name: of a button; number: of a ball, player or option."""

    kind: Held = Held.NOTHING
    name: str = ""
    number: int = -1

    def __bool__(self) -> bool:
        return self.kind is not Held.NOTHING


NOTHING = Grip()
CUE, CUE_BALL, POWER, TIP = Grip(Held.CUE), Grip(Held.CUE_BALL), Grip(Held.POWER), Grip(Held.TIP)
EYE = Grip(Held.EYE)
ELEVATION, LIST = Grip(Held.ELEVATION), Grip(Held.LIST)
TIP_FREELY, REPLAY, ZONE = Grip(Held.TIP_FREELY), Grip(Held.REPLAY), Grip(Held.ZONE)


def button(name: str) -> Grip:
    """A button of that name, held down."""
    return Grip(Held.BUTTON, name)


def card(player: int) -> Grip:
    """The card of a player, 0 or 1, held down."""
    return Grip(Held.CARD, number=player)


def option(row: int) -> Grip:
    """An option, counted from 0, held down."""
    return Grip(Held.OPTION, number=row)


def ball(number: int) -> Grip:
    """A ball of that number, dragged."""
    return Grip(Held.BALL, number=number)
