"""What a level of dominoes may say: floors, what stands and lies on them, and what is expected."""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from game.worlds.entries.entry import Degrees, Density, Index, Length, LevelEntry, Metre, Point
from game.worlds.expectations import Expectations

Grip = Annotated[float, msgspec.Meta(ge=0.0, le=100.0)]
MOST_DOMINOES = 3_000
MOST_FLOORS, MOST_THINGS = 60, 100


class PieceEntry(LevelEntry, frozen=True, kw_only=True):
    """A piece of a floor, from where the last one ended: straight, by run (m) and rise (m); the same in so
    many steps; or an arc of a radius (m) through ``turn`` degrees, upwards if positive.
    """

    run: Metre = 0.0
    rise: Metre = 0.0
    steps: Annotated[int, msgspec.Meta(ge=0, le=500)] = 0
    radius: Annotated[float, msgspec.Meta(ge=0.0, le=1e4)] = 0.0
    turn: Annotated[float, msgspec.Meta(ge=-180.0, le=180.0)] = 0.0
    look: Literal["", "bridge", "gap"] = ""


class FloorEntry(LevelEntry, frozen=True, kw_only=True):
    """A floor from its left end on. friction: with a domino or a ball, exactly; None: the parameter's.

    look: board (wood, on posts), ground (earth, as far down as one sees), or lane, the way of the sliding
    blocks.
    """

    start: Point
    pieces: Annotated[tuple[PieceEntry, ...], msgspec.Meta(min_length=1, max_length=200)]
    friction: Grip | None = None
    look: Literal["board", "ground", "lane"] = "board"


class RowEntry(LevelEntry, frozen=True, kw_only=True):
    """Dominoes on a floor (by its number), from x on; ``to`` 1: to the right, -1: to the left.

    gap: m between two, along the floor's run; None: the parameter's. size: thickness and height, m.
    """

    floor: Index = 0
    x: Metre
    count: Annotated[int, msgspec.Meta(ge=1, le=MOST_DOMINOES)]
    to: Literal[1, -1] = 1
    gap: Length | None = None
    size: tuple[Length, Length] = (0.16, 1.0)
    density: Density = 1.0
    grows: Annotated[float, msgspec.Meta(ge=0.5, le=2.0)] = 1.0  # each is so many times as large as the last


class SingleEntry(LevelEntry, frozen=True, kw_only=True):
    """A domino by itself. at: m, middle of its foot; lean: degrees from upright, anticlockwise."""

    at: Point
    lean: Degrees = 0.0
    to: Literal[1, -1] = 1
    size: tuple[Length, Length] = (0.16, 1.0)


class BallEntry(LevelEntry, frozen=True, kw_only=True):
    """A ball on a floor at x; its density is that of what it is made of. name: for the camera of a story."""

    floor: Index = 0
    x: Metre
    radius: Length
    made_of: Literal["steel", "glass", "wood", "cork"] = "wood"
    name: Annotated[str, msgspec.Meta(max_length=20)] = ""
    velocity: Annotated[float, msgspec.Meta(ge=-100.0, le=100.0)] = 0.0  # m/s, to the right; it rolls


class PlankEntry(LevelEntry, frozen=True, kw_only=True):
    """A plank over a gap in a floor; ``at``: middle of its upper side. seesaw: it turns about that point."""

    floor: Index = 0
    at: Point
    length: Length
    thickness: Length = 0.2
    density: Density = 1.0
    seesaw: bool = False
    lean: Degrees = 0.0  # of a seesaw, at the beginning; positive: its right end is up


class SliderEntry(LevelEntry, frozen=True, kw_only=True):
    """A block in a lane of its own, upright at x on a floor: it meets all but those of other lanes.

    friction: with the lane. speed: m/s along the floor at the beginning; it lies flat then.
    """

    floor: Index
    x: Metre
    friction: Grip
    density: Density = 1.0
    size: tuple[Length, Length] = (0.16, 1.0)
    speed: Annotated[float, msgspec.Meta(ge=0.0, le=100.0)] = 0.0


class View(LevelEntry, frozen=True, kw_only=True):
    """The part of the world in view, m."""

    left: Metre = -2.0
    bottom: Metre = -2.0
    right: Metre = 18.0
    top: Metre = 6.0


class DominoContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level of dominoes. x_measured: m, from where on the stopping distance counts.

    pushed_at: s after the beginning at which the first domino is pushed; None: it waits for a hand.
    """

    floors: Annotated[tuple[FloorEntry, ...], msgspec.Meta(min_length=1, max_length=MOST_FLOORS)]
    rows: Annotated[tuple[RowEntry, ...], msgspec.Meta(max_length=MOST_THINGS)] = ()
    singles: Annotated[tuple[SingleEntry, ...], msgspec.Meta(max_length=MOST_DOMINOES)] = ()
    balls: Annotated[tuple[BallEntry, ...], msgspec.Meta(max_length=MOST_THINGS)] = ()
    planks: Annotated[tuple[PlankEntry, ...], msgspec.Meta(max_length=MOST_THINGS)] = ()
    sliders: Annotated[tuple[SliderEntry, ...], msgspec.Meta(max_length=12)] = ()
    x_measured: Metre | None = None
    pushed_at: Annotated[float, msgspec.Meta(ge=0.0, le=1e4)] | None = None
    expected: Expectations = ()
    view: View = View()
