"""The cue of who plays: at the ball, drawn back, in its swing, or after it."""

from __future__ import annotations

import math
from typing import NamedTuple

from game.billiards.game.arrangement import Stroke
from game.billiards.game.frame import Frame
from game.billiards.game.rules import CUE_BALL
from game.billiards.table.table import Table
from game.scenes.billiards.play import REPLAY, ROLLING, STRIKING, Play
from game.scenes.billiards.stroke.motion import pull_of
from game.scenes.shared.tables import grip
from game.scenes.shared.tables.cue import REST_GAP
from game.ui.canvas.canvas import Canvas
from game.ui.look.theme import FELT_WARM
from game.ui.painters.cue import draw_cue

BANDS = ("amber", "chalk")  # of the two players' cues
BAND, BAND_RADIUS = (0.80, 0.845), 0.0088  # m from the tip, m
SEEN = 0.05  # share of solid; a cue that is less so is not drawn

Point = tuple[float, float]


class CueSeen(NamedTuple):
    """The cue as it is seen: of which stroke, from which frame, m between tip and ball, how solid."""

    stroke: Stroke
    before: Frame
    gap: float
    solid: float


def cue_seen(play: Play, time: float) -> CueSeen | None:
    """The cue at a time of the phase, s; None where none is seen."""
    frame, last = play.model.frame, play.model.frame.last
    if play.phase == STRIKING and play.pending is not None:
        return CueSeen(play.pending, frame, *play.motion.track.sample(time).tolist())
    if play.phase in (ROLLING, REPLAY) and last is not None:
        at = time + play.motion.hit_s
        if at > play.motion.end_s:
            return None
        return CueSeen(last.stroke, last.frame, *play.motion.track.sample(at).tolist())
    if not play.may_aim or play.grip == grip.CUE_BALL:
        return None
    stroke = play.aiming.stroke
    if play.push.chosen:
        return CueSeen(stroke._replace(azimuth=stroke.azimuth + play.push.swayed), frame, play.push.gap, 1.0)
    return CueSeen(stroke, frame, pull_of(play.aiming.cue.speed) if play.aiming.pulling else REST_GAP, 1.0)


def draw_players_cue(canvas: Canvas, play: Play, time: float) -> None:
    """The cue at a time of the phase, s."""
    seen = cue_seen(play, time)
    if seen is None:
        return
    stroke, before, gap, solid = seen
    place = before.cue_ball
    if place is None or solid < SEEN:
        return
    radius = float(before.layout.balls.radii[CUE_BALL])
    table, band = play.model.frame.table, BANDS[before.game.turn]
    _draw_stick(canvas, stroke, _tip_of(stroke, place, gap, radius), table, band)
    if play.push.held:
        canvas.label(place, play.push.words, FELT_WARM, 13, "semibold", offset=(0.0, -28.0))
    elif play.aiming.pulling:
        power = f"{play.parameters.power:.1f} m/s"
        canvas.label(place, power, FELT_WARM, 13, "semibold", offset=(0.0, -28.0))


def _tip_of(stroke: Stroke, place: Point, gap: float, radius: float) -> Point:
    """Where the tip is, ``gap`` m from a ball at a place, aside and raised as the stroke says."""
    ux, uy = math.cos(stroke.azimuth), math.sin(stroke.azimuth)
    aside = radius * stroke.tip_left
    depth = radius * math.sqrt(max(1.0 - stroke.tip_left**2 - stroke.tip_up**2, 0.0))
    back = (depth + gap) * math.cos(stroke.elevation) - radius * stroke.tip_up * math.sin(stroke.elevation)
    return place[0] - back * ux - aside * uy, place[1] - back * uy + aside * ux


def _draw_stick(canvas: Canvas, stroke: Stroke, tip: Point, table: Table, color: str) -> None:
    """A cue with its tip at a place; a band says whose it is."""
    ux, uy, flat = math.cos(stroke.azimuth), math.sin(stroke.azimuth), math.cos(stroke.elevation)
    pixels, clip = canvas.raster_target
    x, y = canvas.place(tip)
    far_x, far_y = canvas.place((tip[0] - ux, tip[1] - uy))
    scale = canvas.pixels_per_unit
    middle = canvas.place((0.5 * table.width, 0.5 * table.length))
    draw_cue(
        pixels, clip, (x, y), ((far_x - x) / scale, (far_y - y) / scale), scale, stroke.elevation, middle
    )
    ends = [(tip[0] - ux * d * flat, tip[1] - uy * d * flat) for d in BAND]
    canvas.line(ends[0], ends[1], color, 2.0 * BAND_RADIUS * scale / canvas.k)
