"""Lines on the cloth and in the air, as a camera sees them: what is foreseen of a stroke."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import pygame

from game.arrays import Floats
from game.scenes.shared.tables.prediction import Sight, beginning
from game.scenes.shared.tables.sight import DASH, FLIGHT_DASH
from game.ui.look.theme import FELT_COOL, FELT_LINE, FELT_WARM
from game.ui.painters.perspective.eye import Eye, room_points
from game.ui.raster import packed, scratch_for, stroke_dashes, stroke_polyline

BOUNCE, POTTED = 0.009, 0.015  # m; radii of rings
ABOUT = 1.35  # cue ball's radii of the ring about the first ball
THROUGH = 0.55  # how much is seen through a ball
TURN = np.linspace(0.0, 2.0 * np.pi, 33)
CIRCLE = np.stack((np.cos(TURN), np.sin(TURN)), axis=1)


class Line(NamedTuple):
    """A chain of points (n, 2) m on the cloth, or (n, 3) with the height, in the table's frame.

    over: it is painted over the balls, which else hide it.
    """

    points: Floats
    color: pygame.Color
    width: float = 1.75  # design px
    dash: tuple[float, float] | None = None
    alpha: float = 0.9
    over: bool = False


class Ghost(NamedTuple):
    """Where the cue ball meets the first ball (x, y) m, and whether that would be a foul."""

    place: tuple[float, float]
    radius: float
    foul: bool = False


def lines_of(sight: Sight, radius: float) -> list[Line]:
    """What is drawn of a sight: all that the picture from above has of it. radius of the cue ball, m.

    Where the first ball sets off is seen through it: from behind the cue ball it hides its own way.
    """
    found = _marks_of(sight, radius)
    found += [
        Line(beginning(path.points), FELT_COOL, 2.0, None, THROUGH, over=True)
        for path in sight.others if path.number == sight.target
    ]  # fmt: skip
    found += [
        Line(path.points, FELT_COOL, 2.0 if path.number == sight.target else 1.5, DASH,
             0.9 if path.number == sight.target else 0.55)
        for path in sight.others
    ]  # fmt: skip
    if sight.flights:
        found += [Line(points, FELT_LINE) for points in sight.rolls]
        found += [Line(flight, FELT_WARM, 1.75, FLIGHT_DASH) for flight in sight.flights]
        return found
    if len(sight.after) > 1:
        found.append(Line(sight.after, FELT_LINE, 1.5, DASH))
    return [*found, Line(sight.approach, FELT_LINE)]


def _marks_of(sight: Sight, radius: float) -> list[Line]:
    """Rings on the cloth: about the first ball, where cushions are met, pots, and where the cue ball ends."""
    rings = [(place, BOUNCE, FELT_LINE) for place in sight.bounces]
    rings += [(path.points[-1], POTTED, FELT_COOL) for path in sight.others if path.potted]
    if sight.ghost is not None:
        rings.append((sight.target_place, ABOUT * radius, FELT_COOL))
    if sight.last is not None:
        rings.append((sight.last, radius, FELT_LINE))
    return [Line(np.asarray(place) + reach * CIRCLE, color, 1.5) for place, reach, color in rings]


def draw_lines_seen(
    pixels: Any, clip: Any, eye: Eye, lines: list[Line], bed: tuple[float, float], scale: float
) -> None:
    """Lines as an eye sees them. bed: width and length, m; scale: px to a design px."""
    cover, _, _ = scratch_for(pixels)
    width, length = bed
    for line in lines:
        places = np.asarray(line.points, float)
        if len(places) < 2:
            continue
        heights = places[:, 2] if places.shape[1] > 2 else 0.0
        points = room_points(places[:, :2], heights, width, length)
        for piece in eye.chain(points):
            ink, broad = packed(line.color), line.width * scale
            if line.dash is None:
                stroke_polyline(pixels, clip, cover, piece, broad, False, ink, line.alpha)
            else:
                on, off = line.dash[0] * scale, line.dash[1] * scale
                stroke_dashes(pixels, clip, cover, piece, broad, False, on, off, 0.0, ink, line.alpha)
