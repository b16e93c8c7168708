"""What a level file of the skeleton scenes may say: bones by name and parent, skins, a chain, a target."""

from __future__ import annotations

from typing import Annotated

import msgspec

from game.worlds.entries.entry import LevelEntry
from game.worlds.expectations import Expectations

Metre = Annotated[float, msgspec.Meta(ge=-10_000.0, le=10_000.0)]
Length = Annotated[float, msgspec.Meta(ge=0.0, le=10_000.0)]
Degrees = Annotated[float, msgspec.Meta(ge=-36_000.0, le=36_000.0)]
Share = Annotated[float, msgspec.Meta(ge=0.0, le=1.0)]
Weight = Annotated[float, msgspec.Meta(ge=-1e6, le=1e6)]  # a wrong one is named by what binds it
Name = Annotated[str, msgspec.Meta(min_length=1, max_length=40)]
Point = tuple[Metre, Metre]

MOST_BONES = 2_000
MOST_POINTS = 20_000


class SwingEntry(LevelEntry, frozen=True, kw_only=True):
    """How a bone moves when it is not posed: to and fro by so many degrees, at a rate and a phase (turns)."""

    by: Degrees
    rate: Annotated[float, msgspec.Meta(ge=0.0, le=20.0)] = 0.5
    phase: Annotated[float, msgspec.Meta(ge=-10.0, le=10.0)] = 0.0


class BoneEntry(LevelEntry, frozen=True, kw_only=True):
    """A bone in the bind pose. angle: against its parent. place: in the parent's frame, else its end.

    turn: degrees from the bind pose to the pose at the beginning. limits: of the angle against the bind
    pose, degrees.
    """

    name: Name
    length: Length
    parent: Annotated[str, msgspec.Meta(max_length=40)] = ""
    angle: Degrees = 0.0
    place: Point | None = None
    turn: Degrees = 0.0
    limits: tuple[Degrees, Degrees] | None = None
    swing: SwingEntry | None = None


class SkinEntry(LevelEntry, frozen=True, kw_only=True):
    """A closed outline in the bind pose, bound by distance or by weights given.

    fill: a colour by name or "#rrggbb". bones: those that it may follow, else all. weights: a row for each
    point, a column for each bone.
    """

    points: Annotated[tuple[Point, ...], msgspec.Meta(min_length=3, max_length=MOST_POINTS)]
    fill: Annotated[str, msgspec.Meta(max_length=12)] = "chalk"
    strength: Share = 1.0
    outline: bool = True
    bones: Annotated[tuple[Name, ...], msgspec.Meta(max_length=MOST_BONES)] = ()
    weights: tuple[tuple[Weight, ...], ...] | None = None


class PathEntry(LevelEntry, frozen=True, kw_only=True):
    """How a target moves when it is not pulled: about a centre, so far along each axis, so often a second.

    turns: how many times it goes up and down while it goes once to and fro.
    """

    centre: Point
    reach: tuple[Length, Length]
    rate: Annotated[float, msgspec.Meta(ge=0.0, le=20.0)] = 0.1
    turns: Annotated[float, msgspec.Meta(ge=0.0, le=20.0)] = 2.0


class ChainEntry(LevelEntry, frozen=True, kw_only=True):
    """A chain from one bone to another, and where its end is to go."""

    start: Name
    end: Name
    target: Point
    path: PathEntry | None = None


class View(LevelEntry, frozen=True, kw_only=True):
    """The part of the world in view, m."""

    left: Metre = -1.2
    bottom: Metre = -0.1
    right: Metre = 1.2
    top: Metre = 2.0


class FigureContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of C02 and C03. sway: how far the root goes sideways and up by itself, m.

    expected: of readouts. guide: what to do comes step by step, as in a level in which one makes a figure.
    """

    bones: Annotated[tuple[BoneEntry, ...], msgspec.Meta(min_length=1, max_length=MOST_BONES)]
    skins: Annotated[tuple[SkinEntry, ...], msgspec.Meta(max_length=200)] = ()
    chain: ChainEntry | None = None
    shift: Point = (0.0, 0.0)
    sway: Point = (0.0, 0.0)
    sway_rate: Annotated[float, msgspec.Meta(ge=0.0, le=20.0)] = 0.5
    ground: Metre | None = None
    expected: Expectations = ()
    guide: bool = False
    view: View = View()


def bone_named(figure: FigureContent, name: str) -> int:
    """Index of a bone; ValueError if there is none of that name."""
    for i, bone in enumerate(figure.bones):
        if bone.name == name:
            return i
    raise ValueError(f"no bone is named {name!r}")


def fresh_name(figure: FigureContent) -> str:
    """A name that no bone has yet."""
    names = {bone.name for bone in figure.bones}
    number = max(len(names), 1)  # beside a root the first is the first
    while f"bone {number}" in names:
        number += 1
    return f"bone {number}"
