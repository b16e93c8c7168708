"""What a level of the marble run may say: tracks, balls, gates that hold them, what stands and hangs."""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from game.worlds.entries.entry import Degrees, Density, Index, Length, LevelEntry, Metre, Point, Share
from game.worlds.entries.tracks import TrackEntry
from game.worlds.expectations import Expectations

Name = Annotated[str, msgspec.Meta(min_length=1, max_length=40)]
Seconds = Annotated[float, msgspec.Meta(ge=0.0, le=1e4)]
MOST_BALLS, MOST_TRACKS, MOST_THINGS = 400, 60, 100
Few = msgspec.Meta(max_length=MOST_THINGS)


class Box(LevelEntry, frozen=True, kw_only=True):
    """A rectangle, m."""

    left: Metre
    bottom: Metre
    right: Metre
    top: Metre

    def has(self, x: float, y: float, room: float = 0.0) -> bool:
        """Whether a point lies in it, or no farther than ``room`` m from it."""
        across = self.left - room <= x <= self.right + room
        return across and self.bottom - room <= y <= self.top + room


class BallEntry(LevelEntry, frozen=True, kw_only=True):
    """A steel ball. at: m, its centre; gate: that holds it, or none; delay: s after the gate opens.

    seated: it begins on the nearest track. name: for the camera of a story. velocity: m/s. friction: on
    tracks, instead of the parameter's.
    """

    at: Point
    radius: Length = 0.1
    gate: Annotated[str, msgspec.Meta(max_length=40)] = ""
    delay: Seconds = 0.0
    name: Annotated[str, msgspec.Meta(max_length=40)] = ""
    velocity: Point = (0.0, 0.0)
    friction: Annotated[float, msgspec.Meta(ge=0.0, le=1e9)] | None = None
    seated: bool = False


class HeapEntry(LevelEntry, frozen=True, kw_only=True):
    """Balls row by row. at: m, centre of the lowest at the left; counts: in a row, rows. They lie loose."""

    at: Point
    counts: tuple[Annotated[int, msgspec.Meta(ge=1, le=40)], Annotated[int, msgspec.Meta(ge=1, le=40)]]
    radius: Length = 0.1
    grows: Annotated[float, msgspec.Meta(ge=-0.2, le=0.2)] = 0.0  # m, of the radius from ball to ball


class FloorEntry(LevelEntry, frozen=True, kw_only=True):
    """Something solid through points, met from the left of its direction, ``thick`` m deep on the right."""

    points: Annotated[tuple[Point, ...], msgspec.Meta(min_length=2, max_length=500)]
    made_of: Literal["wood", "steel", "glass", "felt"] = "wood"
    thick: Length = 0.12
    friction: Annotated[float, msgspec.Meta(ge=0.0, le=100.0)] = 0.5
    restitution: Share = 0.0


class PlugEntry(LevelEntry, frozen=True, kw_only=True):
    """A bar between two points that goes when its gate opens."""

    start: Point
    end: Point
    gate: Name
    thick: Length = 0.08


class TowerEntry(LevelEntry, frozen=True, kw_only=True):
    """Wooden blocks (m) in columns and layers. at: middle of its foot."""

    at: Point
    counts: tuple[Annotated[int, msgspec.Meta(ge=1, le=30)], Annotated[int, msgspec.Meta(ge=1, le=30)]]
    size: tuple[Length, Length] = (0.3, 0.3)
    density: Density = 0.7


class SeesawEntry(LevelEntry, frozen=True, kw_only=True):
    """A plank that turns about a pin. lean: degrees, positive: its right end is up. A ledge keeps what lies
    on an end from rolling off.
    """

    at: Point
    length: Length = 3.0
    thickness: Length = 0.12
    lean: Degrees = 0.0
    ledge: Annotated[float, msgspec.Meta(ge=0.0, le=1.0)] = 0.08
    density: Density = 0.7


class CradleEntry(LevelEntry, frozen=True, kw_only=True):
    """Newton's cradle. at: m, where the leftmost rod hangs; gap: m between two balls; lifted: how many of
    them are drawn aside, by ``lift`` degrees to the left, until ``gate`` opens; cut: gate that cuts the rods.
    """

    at: Point
    count: Annotated[int, msgspec.Meta(ge=1, le=12)] = 5
    radius: Length = 0.2
    length: Length = 2.2
    gap: Annotated[float, msgspec.Meta(ge=0.0, le=1.0)] = 0.022
    lifted: Annotated[int, msgspec.Meta(ge=0, le=12)] = 1
    lift: Annotated[float, msgspec.Meta(ge=0.0, le=80.0)] = 40.0
    gate: Name
    cut: Annotated[str, msgspec.Meta(max_length=40)] = ""


class GaugeEntry(LevelEntry, frozen=True, kw_only=True):
    """A measured number, of ball ``of`` (its number or its name).

    speeds up: m/s² of its centre from where it was let go to x = level. arrives: s from there to x = level.
    drop: m of its centre down to the foot of the loop ``track``. leaves: degrees from upright at which it
    first left that loop. rode: 1 when it has passed x = level and never left its track. rises: m above where
    it lay. speed: m/s. inside: balls in ``box``. fallen: blocks that are no longer where they stood. kept: %
    of the speed of a cradle's first ball that its last one came to.
    """

    name: Name
    measure: Literal[
        "speeds up", "arrives", "drop", "leaves", "rode", "rises", "speed", "inside", "fallen", "kept"
    ]  # fmt: skip
    of: Annotated[str, msgspec.Meta(max_length=40)] = ""
    level: Metre = 0.0
    track: Index = 0
    box: Box | None = None


class MetalContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level of the marble run.

    gates: in the order in which they open. yards: where balls meet each other and everything solid; anywhere
    else each rolls on its track, or flies, by itself.
    """

    tracks: Annotated[tuple[TrackEntry, ...], msgspec.Meta(max_length=MOST_TRACKS)] = ()
    balls: Annotated[tuple[BallEntry, ...], msgspec.Meta(max_length=MOST_BALLS)] = ()
    heaps: Annotated[tuple[HeapEntry, ...], Few] = ()
    gates: Annotated[tuple[Name, ...], Few] = ()
    yards: Annotated[tuple[Box, ...], Few] = ()
    floors: Annotated[tuple[FloorEntry, ...], Few] = ()
    plugs: Annotated[tuple[PlugEntry, ...], Few] = ()
    towers: Annotated[tuple[TowerEntry, ...], Few] = ()
    seesaws: Annotated[tuple[SeesawEntry, ...], Few] = ()
    cradles: Annotated[tuple[CradleEntry, ...], Few] = ()
    gauges: Annotated[tuple[GaugeEntry, ...], msgspec.Meta(max_length=30)] = ()
    expected: Expectations = ()
    view: Box = Box(left=-1.0, bottom=-1.0, right=8.0, top=4.0)
