"""What a level file of the V-Clip and GJK scenes may say: two outlines, and how they move by themselves."""

from __future__ import annotations

import math
from typing import Annotated

import msgspec

from game.physics.kernels import elementary
from game.scenes.shared.outlines.board import Board
from game.scenes.shared.outlines.outline import Outline, Point
from game.worlds.entries.entry import LevelEntry
from game.worlds.expectations import Expectations

Unit = Annotated[float, msgspec.Meta(ge=-10_000.0, le=10_000.0)]
Place = tuple[Unit, Unit]
MOST_CORNERS = 2_000


class ShapeEntry(LevelEntry, frozen=True, kw_only=True):
    """An outline. points: in order, about ``position``; or so many ``corners`` on an ellipse.

    radius, flat: the ellipse's long half axis, and the short one over it. turn: °, about the position.
    velocity: per second; spin: °/s. All lengths in the level's unit.
    """

    points: Annotated[tuple[Place, ...], msgspec.Meta(max_length=MOST_CORNERS)] = ()
    corners: Annotated[int, msgspec.Meta(ge=3, le=MOST_CORNERS)] | None = None
    radius: Annotated[float, msgspec.Meta(ge=1e-6, le=10_000.0)] = 1.0
    flat: Annotated[float, msgspec.Meta(gt=0.0, le=1.0)] = 1.0
    position: Place = (0.0, 0.0)
    turn: Annotated[float, msgspec.Meta(ge=-360.0, le=360.0)] = 0.0
    velocity: Place = (0.0, 0.0)
    spin: Annotated[float, msgspec.Meta(ge=-720.0, le=720.0)] = 0.0


class View(LevelEntry, frozen=True, kw_only=True):
    """The part of the world in view, in the level's unit."""

    left: Unit = -4.8
    bottom: Unit = -2.5
    right: Unit = 4.8
    top: Unit = 2.6


class PairContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level. scale: m to a unit; origin: where the level's (0, 0) is, in units; expected: of
    readouts.

    What is far from the origin is computed there, but drawn near.
    """

    a: ShapeEntry
    b: ShapeEntry
    scale: Annotated[float, msgspec.Meta(gt=1e-12, le=1e12)] = 1.0
    origin: tuple[float, float] = (0.0, 0.0)
    view: View = View()
    expected: Expectations = ()


def outline_of(entry: ShapeEntry, name: str) -> Outline:
    """The outline that an entry describes; ValueError, naming it, if it says nothing or two things."""
    if bool(entry.points) == (entry.corners is not None):
        raise ValueError(f"{name}: expected either points or corners")
    points: tuple[Point, ...] = entry.points
    if entry.corners is not None:
        turns = [2.0 * math.pi * k / entry.corners for k in range(entry.corners)]
        points = tuple(
            (entry.radius * elementary.cos(t), entry.radius * entry.flat * elementary.sin(t)) for t in turns
        )
    return Outline(points, len(points) > 2, entry.position, math.radians(entry.turn))


def board_of(content: PairContent) -> Board:
    """Both outlines, ready for the hand; ValueError for what makes no sense."""
    if abs(content.origin[0]) > 1e12 or abs(content.origin[1]) > 1e12:
        raise ValueError("origin: must be within 1e12")
    return Board((outline_of(content.a, "a"), outline_of(content.b, "b")))


def entry_of(outline: Outline, velocity: Point, spin: float) -> ShapeEntry:
    """An outline as a level has it."""
    return ShapeEntry(
        points=outline.points,
        position=outline.position,
        turn=math.degrees(outline.angle),
        velocity=velocity,
        spin=spin,
    )
