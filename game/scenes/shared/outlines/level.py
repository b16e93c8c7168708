"""What a level file of the scenes with polylines may say: corners one by one, or outlines made by rule."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Annotated, Any

import msgspec
import numpy as np

from game.arrays import Floats
from game.scenes.shared.outlines import shapes
from game.scenes.shared.outlines.outline import Outline
from game.worlds.expectations import Expectations

MOST_POINTS = 4_096  # of an outline
FARTHEST = 1e9  # m
Metre = Annotated[float, msgspec.Meta(ge=-FARTHEST, le=FARTHEST)]
Size = Annotated[float, msgspec.Meta(gt=0.0, le=1e9)]
Share = Annotated[float, msgspec.Meta(ge=0.0, le=1.0)]
Degrees = Annotated[float, msgspec.Meta(ge=-36_000.0, le=36_000.0)]
Segments = Annotated[int, msgspec.Meta(ge=3, le=MOST_POINTS)]
Few = Annotated[int, msgspec.Meta(ge=2, le=200)]
Point = tuple[Metre, Metre]


class _Entry(msgspec.Struct, forbid_unknown_fields=True, frozen=True, kw_only=True, tag_field="shape"):
    """An outline at a place, turned by degrees."""

    position: Point = (0.0, 0.0)
    angle: Degrees = 0.0


class PointsEntry(_Entry, frozen=True, kw_only=True, tag="points"):
    """Corners one by one, m; about ``position``."""

    points: Annotated[tuple[Point, ...], msgspec.Meta(min_length=1, max_length=MOST_POINTS)]
    closed: bool = True


class CoastEntry(_Entry, frozen=True, kw_only=True, tag="coast"):
    """A coast; see `shapes.coast`."""

    seed: Annotated[int, msgspec.Meta(ge=0, le=2**31)] = 0
    segments: Segments = 128
    size: Size = 1.5
    bays: Share = 0.3
    roughness: Share = 0.02


class GearEntry(_Entry, frozen=True, kw_only=True, tag="gear"):
    """A gear; see `shapes.gear`."""

    teeth: Annotated[int, msgspec.Meta(ge=3, le=200)] = 12
    radius: Size = 1.5
    depth: Size = 0.35
    steps: Annotated[int, msgspec.Meta(ge=1, le=10)] = 3


class HandEntry(_Entry, frozen=True, kw_only=True, tag="hand"):
    """A hand; see `shapes.hand`."""

    size: Size = 3.4
    mirrored: bool = False
    spread: Annotated[float, msgspec.Meta(ge=0.5, le=2.0)] = 1.0
    steps: Annotated[int, msgspec.Meta(ge=2, le=40)] = 8


class ArcEntry(_Entry, frozen=True, kw_only=True, tag="arc"):
    """An open arc; its place is the middle of the circle."""

    radius: Size = 1.5
    start: Degrees = 0.0
    sweep: Annotated[float, msgspec.Meta(ge=-360.0, le=360.0)] = 90.0
    segments: Annotated[int, msgspec.Meta(ge=1, le=MOST_POINTS - 1)] = 128


class SpiralEntry(_Entry, frozen=True, kw_only=True, tag="spiral"):
    """An open spiral."""

    inner: Annotated[float, msgspec.Meta(ge=0.0, le=1e9)] = 0.1
    outer: Size = 1.5
    turns: Annotated[float, msgspec.Meta(gt=0.0, le=100.0)] = 3.0
    segments: Annotated[int, msgspec.Meta(ge=1, le=MOST_POINTS - 1)] = 256


class StarEntry(_Entry, frozen=True, kw_only=True, tag="star"):
    """A star of so many points."""

    points: Few = 5
    outer: Size = 1.5
    inner: Size = 0.6


class CombEntry(_Entry, frozen=True, kw_only=True, tag="comb"):
    """A comb; see `shapes.comb`."""

    teeth: Few = 9
    width: Size = 3.6
    height: Size = 1.4


Entry = PointsEntry | CoastEntry | GearEntry | HandEntry | ArcEntry | SpiralEntry | StarEntry | CombEntry


class View(msgspec.Struct, forbid_unknown_fields=True, frozen=True, kw_only=True):
    """The part of the world in view, m."""

    left: Metre = -4.8
    bottom: Metre = -2.56
    right: Metre = 4.8
    top: Metre = 2.56


class OutlinesContent(msgspec.Struct, forbid_unknown_fields=True, frozen=True, kw_only=True):
    """[content] of such a level: two outlines at most, A and B; what is in view; expected of readouts."""

    outlines: Annotated[tuple[Entry, ...], msgspec.Meta(max_length=2)] = ()
    view: View = View()
    expected: Expectations = ()


_MAKERS: dict[type[Any], tuple[bool, Callable[[Any], Floats]]] = {
    CoastEntry: (True, lambda e: shapes.coast(e.seed, e.segments, e.size, e.bays, e.roughness)),
    GearEntry: (True, lambda e: shapes.gear(e.teeth, e.radius, e.depth, e.steps)),
    HandEntry: (True, lambda e: shapes.hand(e.size, e.mirrored, e.spread, e.steps)),
    ArcEntry: (False, lambda e: shapes.arc(e.radius, e.start, e.sweep, e.segments)),
    SpiralEntry: (False, lambda e: shapes.spiral(e.inner, e.outer, e.turns, e.segments)),
    StarEntry: (True, lambda e: shapes.star(e.points, e.outer, e.inner)),
    CombEntry: (True, lambda e: shapes.comb(e.teeth, e.width, e.height)),
}


def outline_of(entry: Entry) -> Outline:
    """The outline that an entry stands for. ValueError if it has too many corners."""
    if isinstance(entry, PointsEntry):
        points, closed = entry.points, entry.closed
    else:
        closed, make = _MAKERS[type(entry)]
        points = tuple((float(x), float(y)) for x, y in make(entry))
    if len(points) > MOST_POINTS:
        raise ValueError(f"outlines: {len(points)} points, expected at most {MOST_POINTS}")
    return Outline(points, closed, entry.position, math.radians(entry.angle))


def content_of(outlines: tuple[Outline, ...], view: View) -> OutlinesContent:
    """Outlines as they stand, corner by corner."""
    return OutlinesContent(
        outlines=tuple(
            PointsEntry(
                points=outline.points,
                closed=outline.closed,
                position=outline.position,
                angle=math.degrees(outline.angle),
            )
            for outline in outlines
        ),
        view=view,
    )


def array_of(outline: Outline) -> Floats:
    """Corners (n, 2) of an outline in its own frame, m."""
    return np.array(outline.points, dtype=np.float64).reshape(-1, 2)
