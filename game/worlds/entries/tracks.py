"""What a level may say of a track: points, or a formula; and the curves by formulas."""

from __future__ import annotations

import math
from typing import Annotated, Literal

import msgspec
import numpy as np

from game.arrays import Floats
from game.physics.kernels import elementary, elementwise
from game.physics.solids.tracks import Curve, moved_aside
from game.physics.solids.tracks.descent import arc_radius, cycloid_through
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


RAMP = 1.6  # length of a loop's ramp over its height


def curve_of(entry: TrackEntry, chords: int = 0) -> Curve:
    """A level's track; chords: how many points instead of its own, for a formula. ValueError."""
    if entry.form == "points":
        return Curve(np.array(entry.points, dtype=np.float64).reshape(-1, 2), entry.closed, entry.corner)
    count = chords if chords >= 4 else entry.count
    points = _FORMS[entry.form](*entry.size, count)
    closed = entry.form in ("circle", "bowl") and entry.size[0] == entry.size[1]
    if entry.carries and not closed:
        points = moved_aside(points, -entry.carries)
    if entry.tail and not closed:
        points = np.concatenate([points, points[-1] + np.array(entry.tail)])
    if entry.mirrored:
        points = points * (-1.0, 1.0)
    return Curve(points + entry.at, closed, entry.corner)


def _line(width: float, depth: float, count: int) -> Floats:
    """From (0, 0) to (width, -depth)."""
    t = np.linspace(0.0, 1.0, count)
    return np.stack([width * t, -depth * t], axis=1)


def _parabola(width: float, depth: float, count: int) -> Floats:
    """From (0, 0), upright at first, through (width, -depth)."""
    t = np.linspace(0.0, 1.0, count)
    return np.stack([width * t * t, -depth * t], axis=1)


def _cycloid(width: float, depth: float, count: int) -> Floats:
    """From its cusp at (0, 0) through (width, -depth)."""
    wheel, end = cycloid_through(width, depth)
    turn = np.linspace(0.0, end, count)
    return wheel * np.stack([turn - elementwise.sin(turn), elementwise.cos(turn) - 1.0], axis=1)


def _arc(width: float, depth: float, count: int) -> Floats:
    """Of a circle, from (0, 0), upright at first, through (width, -depth)."""
    radius = arc_radius(width, depth)
    turn = np.linspace(0.0, elementary.atan2(depth, radius - width), count)
    return radius * np.stack([1.0 - elementwise.cos(turn), -elementwise.sin(turn)], axis=1)


def _whirl(outer: float, inner: float, count: int) -> Floats:
    """Two turns of a spiral, inwards and anticlockwise: from (0, 0), its lowest point, level at first; both
    are its radii.
    """
    turn = np.linspace(0.0, 4.0 * math.pi, count)
    share = turn / (4.0 * math.pi)
    reach = outer + (inner - outer) * share * share * (3.0 - 2.0 * share)
    return np.stack([reach * elementwise.sin(turn), outer - reach * elementwise.cos(turn)], axis=1)


def _loop(radius: float, height: float, count: int) -> Floats:
    """A ramp of that height, a loop that begins and ends at (0, 0), and a straight way on."""
    length = RAMP * height
    ramp_x = np.linspace(-length, 0.0, max(count // 2, 8), endpoint=False)
    ramp = np.stack([ramp_x, height * elementary.square(ramp_x / length)], axis=1)
    turn = np.linspace(0.0, 2.0 * math.pi, count + 1)
    loop = radius * np.stack([elementwise.sin(turn), 1.0 - elementwise.cos(turn)], axis=1)
    way = np.linspace(0.0, 4.0 * radius, max(count // 3, 6))[1:]
    return np.concatenate([ramp, loop, np.stack([way, np.zeros_like(way)], axis=1)])


def _circle(width: float, height: float, count: int) -> Floats:
    """Round (0, 0), anticlockwise from its lowest point."""
    turn = np.linspace(-0.5 * math.pi, 1.5 * math.pi, count, endpoint=False)
    return np.stack([width * elementwise.cos(turn), height * elementwise.sin(turn)], axis=1)


def _spiral(outer: float, inner: float, count: int) -> Floats:
    """Two and a half turns about (0, 0), from the left at the height of its middle."""
    turn = np.linspace(math.pi, 6.0 * math.pi, count)
    reach = outer + (inner - outer) * (turn - math.pi) / (5.0 * math.pi)
    return np.stack([reach * elementwise.cos(turn), reach * elementwise.sin(turn)], axis=1)


def _waves(length: float, height: float, count: int) -> Floats:
    """Eight waves of that height and length each."""
    x = np.linspace(0.0, 8.0 * length, count)
    return np.stack([x, height * elementwise.sin(2.0 * math.pi * x / length)], axis=1)


_FORMS = {
    "line": _line, "parabola": _parabola, "cycloid": _cycloid, "arc": _arc, "loop": _loop,
    "whirl": _whirl, "circle": _circle,
    "bowl": _circle, "spiral": _spiral, "waves": _waves,
}  # fmt: skip
