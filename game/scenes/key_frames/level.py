"""What a level file of the key-framing scene may say: keys, the timing curve, the view."""

from __future__ import annotations

from typing import Annotated

import msgspec

from game.worlds.entries.entry import LevelEntry
from game.worlds.expectations import Expectations

MOST_KEYS = 200
FARTHEST = 1000.0  # m
FASTEST = 100_000.0  # m/s
MOST_TURNED = 36_000.0  # degrees
Metre = Annotated[float, msgspec.Meta(ge=-FARTHEST, le=FARTHEST)]
Speed = Annotated[float, msgspec.Meta(ge=-FASTEST, le=FASTEST)]  # m/s
Degrees = Annotated[float, msgspec.Meta(ge=-MOST_TURNED, le=MOST_TURNED)]
Part = Annotated[float, msgspec.Meta(ge=0.0, le=1.0)]
Point = tuple[Metre, Metre]
Velocity = tuple[Speed, Speed]


class KeyEntry(LevelEntry, frozen=True, kw_only=True):
    """A key-frame: time s, position m, angle degrees.

    velocity: m/s, for Bezier curves, whose control points lie a third of the piece's duration times it before
    and after the key. Without, it is found from the neighbours. velocity_before: another one before the key,
    which is then a corner.
    """

    time: Part
    position: Point = (0.0, 0.0)
    angle: Degrees = 0.0
    velocity: Velocity | None = None
    velocity_before: Velocity | None = None


class View(LevelEntry, frozen=True, kw_only=True):
    """The part of the world in view, m; its lowest quarter is the timeline."""

    left: Metre = -6.4
    bottom: Metre = -3.45
    right: Metre = 6.4
    top: Metre = 3.2


class Motion(LevelEntry, frozen=True, kw_only=True):
    """[content] of a key-framing level.

    keys: in any order; of equal times the order counts. timing: x1, y1, x2, y2 of the timing curve, where the
    panel says "own". start: s, time of the keys where the slider has 0. box: width and height, m.
    expected: of readouts.
    """

    keys: Annotated[tuple[KeyEntry, ...], msgspec.Meta(min_length=1, max_length=MOST_KEYS)] = (
        KeyEntry(time=0.0),
    )
    timing: tuple[Part, Annotated[float, msgspec.Meta(ge=-3.0, le=4.0)], Part,
                  Annotated[float, msgspec.Meta(ge=-3.0, le=4.0)]] = (0.42, 0.0, 0.58, 1.0)  # fmt: skip
    start: Annotated[float, msgspec.Meta(ge=-1e12, le=1e12)] = 0.0
    box: tuple[
        Annotated[float, msgspec.Meta(ge=1e-6, le=100.0)], Annotated[float, msgspec.Meta(ge=1e-6, le=100.0)]
    ] = (
        1.1,
        0.66,
    )
    expected: Expectations = ()
    view: View = View()
