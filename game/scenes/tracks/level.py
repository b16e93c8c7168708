"""What a level of tracks may say: curves by points or by a formula, balls, and what is measured."""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from game.worlds.entries.entry import Length, LevelEntry, Metre, Point
from game.worlds.entries.tracks import TrackEntry
from game.worlds.expectations import Expectations

Colour = Literal["chalk", "green", "vermilion", "pink", "violet", "yellow", "amber"]
Few = msgspec.Meta(max_length=40)


class BallEntry(LevelEntry, frozen=True, kw_only=True):
    """position m of the centre; velocity m/s, spin rad/s; share: I/(m r²); friction: None, as the parameter.

    rolling: it begins without slip. seated: it begins on the nearest track.
    """

    position: Point
    radius: Length = 0.1
    velocity: Point = (0.0, 0.0)
    spin: Annotated[float, msgspec.Meta(ge=-1e5, le=1e5)] = 0.0
    share: Annotated[float, msgspec.Meta(gt=0.0, le=1.0)] = 0.5
    mass: Annotated[float, msgspec.Meta(ge=1e-12, le=1e9)] = 1.0
    friction: Annotated[float, msgspec.Meta(ge=0.0, le=1e9)] | None = None
    restitution: Annotated[float, msgspec.Meta(ge=0.0, le=1.0)] | None = None
    colour: Colour = "chalk"
    seated: bool = True
    rolling: bool = False


class GaugeEntry(LevelEntry, frozen=True, kw_only=True):
    """A measured number.

    arrives: s, when ball ``of`` first is right of x = level (left of it, if it began right of it). leaves:
    degrees from upright about ``about`` when it first leaves its track. period: s between its last two
    passages of x = level to the left. speed m/s, high m. past: balls right of x = level; rode: of the first
    fifty, those that came there and never left their track before.
    """

    name: Annotated[str, msgspec.Meta(min_length=1, max_length=40)]
    measure: Literal["arrives", "leaves", "period", "speed", "high", "past", "rode"]
    of: Annotated[int, msgspec.Meta(ge=0, le=10_000)] = 0
    level: Metre = 0.0
    about: Point = (0.0, 0.0)


class View(LevelEntry, frozen=True, kw_only=True):
    """The part of the world in view, m."""

    left: Metre = -4.0
    bottom: Metre = -0.6
    right: Metre = 4.0
    top: Metre = 4.0


class TrackContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level of tracks."""

    tracks: Annotated[tuple[TrackEntry, ...], Few] = ()
    balls: Annotated[tuple[BallEntry, ...], msgspec.Meta(max_length=2_000)] = ()
    gauges: Annotated[tuple[GaugeEntry, ...], msgspec.Meta(max_length=8)] = ()
    expected: Expectations = ()
    view: View = View()
