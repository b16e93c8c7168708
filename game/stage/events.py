"""What comes in to a scene, and all that comes in: pointer, action, decision, parameter set, effect switched.

Each is stamped with the number of steps made before it acts, so a list of them is a replay. A story or a test
is written in the same words as a person's hand.
"""

from __future__ import annotations

from typing import Literal

import msgspec

PointerKind = Literal["move", "down", "up", "wheel", "cancel"]


class Pointer(msgspec.Struct, frozen=True, tag="pointer", forbid_unknown_fields=True):
    """A pointer in world coordinates. ``cancel`` takes back a drag (Esc, focus lost, resize)."""

    kind: PointerKind
    x: float
    y: float
    button: int = 0  # 1 left, 2 middle, 3 right; for "move" the one held down, 0 if none
    wheel: float = 0.0  # notches, up is positive
    shift: bool = False
    control: bool = False


class Action(msgspec.Struct, frozen=True, tag="action", forbid_unknown_fields=True):
    """A named action that the scene declares, by key, button or gamepad."""

    name: str


class Decision(msgspec.Struct, frozen=True, tag="decision", forbid_unknown_fields=True):
    """What a player without a hand has decided, such as a stroke: a name, and numbers that the scene knows.

    A computer player thinks as long as it likes, in a thread. Only what it decides comes in, so a recording
    holds its choices and a replay needs no thinking.
    """

    name: str
    values: tuple[float, ...] = ()


class SetParameter(msgspec.Struct, frozen=True, tag="knob", forbid_unknown_fields=True):
    """A parameter, choice or switch set to a value."""

    name: str
    value: float | bool | str


class SetEffect(msgspec.Struct, frozen=True, tag="effect", forbid_unknown_fields=True):
    """A declared effect switched off or on."""

    name: str
    on: bool


StageEvent = Pointer | Action | Decision | SetParameter | SetEffect


class Stamped(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """An event and the number of steps made before it acts."""

    step: int
    event: StageEvent
