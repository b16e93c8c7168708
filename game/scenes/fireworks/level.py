"""What a level file of the fireworks may say: the programme of the show, its winds, what is in the air."""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from game.worlds.entries.entry import LevelEntry

Metre = Annotated[float, msgspec.Meta(ge=-2000.0, le=2000.0)]
Second = Annotated[float, msgspec.Meta(ge=0.0, le=100_000.0)]
Speed = Annotated[float, msgspec.Meta(ge=-1000.0, le=1000.0)]  # m/s
Point = tuple[Metre, Metre]
Shell = Literal[
    "peony", "peony-blue", "peony-green", "dahlia", "chrysanthemum", "willow", "ring", "palm", "crossette",
    "strobe", "spiral", "brocade", "heart", "crackle", "rocket", "comet",
]  # fmt: skip
MOST_CUES = 2_000
FARTHEST = 2000.0  # m


class Cue(LevelEntry, frozen=True, kw_only=True):
    """Shells of the programme. time: s, when the first is fired. at: m, where it is to burst in still air.

    tube: m, where it is fired from; without one below the place. depth: m behind the shore.
    count: how many, each ``step`` m farther and ``delay`` s later.
    """

    time: Second
    shell: Shell
    at: Point
    tube: Metre | None = None
    depth: Annotated[float, msgspec.Meta(ge=-200.0, le=1000.0)] = 0.0
    count: Annotated[int, msgspec.Meta(ge=1, le=200)] = 1
    step: Point = (0.0, 0.0)
    delay: Second = 0.0


class Gust(LevelEntry, frozen=True, kw_only=True):
    """The wind (m/s) that is added at a time (s) of the programme; between two it changes evenly."""

    time: Second
    wind: Speed


class Aloft(LevelEntry, frozen=True, kw_only=True):
    """A shell that is in the air from the beginning: m, m/s. fuse: s until it bursts."""

    shell: Shell
    position: Point
    velocity: tuple[Speed, Speed] = (0.0, 0.0)
    depth: Annotated[float, msgspec.Meta(ge=-200.0, le=1000.0)] = 0.0
    fuse: Annotated[float, msgspec.Meta(gt=0.0, le=1000.0)] = 1.0


class View(LevelEntry, frozen=True, kw_only=True):
    """The part of the world in view, m."""

    left: Metre = -180.0
    bottom: Metre = -38.0
    right: Metre = 180.0
    top: Metre = 164.0


class FireworksContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level. again: s after which the programme begins anew, 0: never. begins: s on the clock.

    listener: m, where along the bank the sound is heard.
    """

    cues: Annotated[tuple[Cue, ...], msgspec.Meta(max_length=MOST_CUES)] = ()
    gusts: Annotated[tuple[Gust, ...], msgspec.Meta(max_length=200)] = ()
    aloft: Annotated[tuple[Aloft, ...], msgspec.Meta(max_length=200)] = ()
    again: Second = 0.0
    begins: Second = 0.0
    listener: Metre = 0.0
    view: View = View()
