"""What a level may say of a track: points, or a formula."""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from game.worlds.entries.entry import Length, LevelEntry, Point


class TrackEntry(LevelEntry, frozen=True, kw_only=True):
    """A track through points, or a formula: see `shapes`. at: m, its reference point; size: m.

    carries: radius (m) of the ball whose centre is to follow the formula; corner: degrees, see `Curve`;
    count: of points. tail: points (m, from the end of a formula) through which it goes on.
    """

    form: Literal[
        "points", "line", "parabola", "cycloid", "arc", "loop", "circle", "spiral", "whirl", "waves", "bowl"
    ] = "points"  # fmt: skip
    points: Annotated[tuple[Point, ...], msgspec.Meta(max_length=5_000)] = ()
    at: Point = (0.0, 0.0)
    size: tuple[Length, Length] = (1.0, 1.0)
    carries: Annotated[float, msgspec.Meta(ge=0.0, le=100.0)] = 0.0
    mirrored: bool = False
    closed: bool = False
    corner: Annotated[float, msgspec.Meta(ge=0.0, le=180.0)] = 35.0
    count: Annotated[int, msgspec.Meta(ge=2, le=5_000)] = 200
    tail: Annotated[tuple[Point, ...], msgspec.Meta(max_length=200)] = ()
