"""What is foreseen of a stroke as lines on the cloth, and the strokes that a computer player considers."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from game.arrays import Floats
from game.billiards.game.arrangement import Places
from game.billiards.game.rules import CUE_BALL
from game.billiards.table.table import Table
from game.scenes.shared.tables.prediction import Sight
from game.scenes.shared.tables.view import cut_words
from game.ui.canvas.canvas import Canvas
from game.ui.look.theme import FELT, FELT_COOL, FELT_LINE, FELT_WARM
from game.ui.painters.cloth_label import draw_cloth_label

if TYPE_CHECKING:
    from game.billiards.search.finding import FoundShot


FLIGHT_DASH = (3.0, 7.0)  # design px
SEEN_HEIGHT = 0.005  # m; a lower flight has no side view
DASH = (8.0, 6.0)  # design px
ON_PATH = 1e-6  # m; a bounce so near to a path is on it


def draw_sight(canvas: Canvas, sight: Sight, radius: float, target_radius: float, foul: bool = False) -> None:
    """The lines on the cloth. foul: the ball that is met first must not be."""
    for path in sight.others:
        own = path.number == sight.target
        canvas.polyline(path.points, FELT_COOL, 2.0 if own else 1.5, dash=DASH, alpha=0.9 if own else 0.55)
        if path.potted:
            canvas.ring(path.points[-1], 5.0, FELT_COOL, 1.5)
    if sight.flights:
        _draw_flown(canvas, sight)
    else:
        if len(sight.after) > 1:
            canvas.polyline(sight.after, FELT_LINE, 1.5, dash=DASH, alpha=0.9)
        canvas.polyline(sight.approach, FELT_LINE, 1.5)
    for place in sight.bounces:
        canvas.dot(place, 3.0, FELT)
        canvas.ring(place, 3.0, FELT_LINE, 1.25)
    if sight.ghost is not None:
        canvas.circle(sight.ghost, radius, fill=FELT_LINE, fill_alpha=0.22, outline=FELT_LINE, width=1.5)
        ring = (FELT_WARM, 2.5) if foul else (FELT_COOL, 1.5)
        canvas.circle(sight.target_place, target_radius + canvas.px(4.0), outline=ring[0], width=ring[1])
    if sight.last is not None:
        canvas.circle(
            sight.last, radius, fill=FELT_LINE, fill_alpha=0.16, outline=FELT_LINE, width=1.0, alpha=0.7
        )


def _draw_flown(canvas: Canvas, sight: Sight) -> None:
    """The cue ball's path where it jumps: dashed wide in the air. The side view of each flight is folded down
    beside it in the same measure, with how high the highest goes.
    """
    for points in sight.rolls:
        canvas.polyline(points, FELT_LINE, 1.5)
    highest = max(sight.flights, key=lambda flight: float(flight[:, 2].max()))
    for flight in sight.flights:
        canvas.polyline(flight[:, :2], FELT_WARM, 1.75, dash=FLIGHT_DASH)
        side = side_view(flight)
        if float(flight[:, 2].max()) > SEEN_HEIGHT:
            canvas.polygon(side, FELT_WARM, 0.14)
            canvas.polyline(side, FELT_WARM, 1.0, alpha=0.8)
    top = int(np.argmax(highest[:, 2]))
    height = float(highest[top, 2])
    if height > SEEN_HEIGHT:
        words = f"{100.0 * height:.1f} cm high"
        canvas.label(side_view(highest)[top], words, FELT_WARM, 12, "semibold", offset=(0.0, -12.0))


def side_view(flight: Floats) -> Floats:
    """A flight (n, 3) m seen from its side, folded down onto the cloth beside its path: points (n, 2) m."""
    along = flight[-1, :2] - flight[0, :2]
    length = float(np.hypot(*along))
    across = np.array((-along[1], along[0])) / length if length > 1e-6 else np.array((-1.0, 0.0))
    if across[0] > 0.0:
        across = -across  # upwards on the screen
    return flight[:, :2] + flight[:, 2:] * across


def fan_of(sight: Sight, aside: float) -> Floats:
    """Corners (3, 2) m of where a cue ball may go that sets off up to ``aside`` rad to either side.

    The first is where it lies; the others are as far as its path leads, or as its first cushion.
    """
    start, end = sight.approach[0], sight.approach[-1]
    for bounce in sight.bounces[:1]:
        if float(np.hypot(*(sight.approach - bounce).T).min()) < ON_PATH:
            end = np.array(bounce)
    along, reach = math.atan2(end[1] - start[1], end[0] - start[0]), math.dist(start, end)
    turned = np.array((along - aside, along + aside))
    return np.concatenate([start[None], start + reach * np.stack((np.cos(turned), np.sin(turned)), axis=1)])


def draw_fan(canvas: Canvas, sight: Sight, aside: float) -> None:
    """Where an unsteady hand may send the cue ball instead; nothing for a steady one (``aside`` 0)."""
    if not aside or len(sight.approach) < 2:
        return
    start, *sides = corners = fan_of(sight, aside)
    canvas.polygon(corners, FELT_WARM, 0.28)
    for side in sides:
        canvas.line(start, side, FELT_WARM, 1.0, alpha=0.7)


def draw_label(canvas: Canvas, sight: Sight, places: Places, table: Table, radius: float, foul: str) -> None:
    """The cut, or why the stroke is a foul, on a plate on the cloth beside the ghost ball where no ball is
    covered.
    """
    if sight.ghost is None:
        return
    gx, gy = sight.ghost
    tx, ty = sight.target_place
    apart = math.sqrt((tx - gx) ** 2 + (ty - gy) ** 2) or 1.0
    ux, uy = (tx - gx) / apart, (ty - gy) / apart
    best = (-1.0, gx, gy)
    high, wide = canvas.px(20.0), canvas.px(46.0)  # the plate is wide along y
    for ring in range(1, 4):
        side = (1.6 * radius + canvas.px(34.0)) * (0.6 + 0.4 * ring)
        for ax, ay in ((-uy, ux), (uy, -ux), (-ux, -uy)):
            x, y = gx + side * ax, gy + side * ay
            if not (high < x < table.width - high and wide < y < table.length - wide):
                continue
            clear = min(max(abs(bx - x) / high, abs(by - y) / wide) for _, bx, by in places)
            if min(clear, 1.0) > best[0]:
                best = (min(clear, 1.0), x, y)
    words = foul or cut_words(sight.cut)
    draw_cloth_label(canvas.surface, canvas.fonts, words, canvas.camera.to_screen(*best[1:]))


def draw_considered(
    canvas: Canvas, shots: tuple[FoundShot, ...], places: Places, table: Table, played: bool
) -> None:
    """Shots that a computer player considered: from the cue ball to the ball and on to its pocket.

    The best is strongest, with the chance that it was given; ``played``: that is the one being played.
    """
    where = {number: (x, y) for number, x, y in places}
    cue_ball = where.get(CUE_BALL)
    if cue_ball is None:
        return
    named = {shot.ball: rank for rank, shot in reversed(list(enumerate(shots)))}  # the best for each ball
    for rank, shot in reversed(list(enumerate(shots))):
        strong = rank == 0
        color, alpha = (FELT_WARM, 0.95 if strong else 0.4)
        width = 2.0 if strong else 1.25
        reach = 0.25
        direction = (math.cos(shot.stroke.azimuth), math.sin(shot.stroke.azimuth))
        ball = where.get(shot.ball) if shot.ball is not None else None
        first = where.get(shot.via) if shot.via is not None else ball
        if first is not None and shot.kind != "kick":
            reach = math.hypot(first[0] - cue_ball[0], first[1] - cue_ball[1])
        end = (cue_ball[0] + reach * direction[0], cue_ball[1] + reach * direction[1])
        canvas.line(cue_ball, end, color, width, alpha=alpha)
        if ball is None or shot.pocket is None:
            continue
        if shot.via is not None and first is not None:
            canvas.line(first, ball, color, width, dash=DASH, alpha=alpha)
        canvas.line(ball, table.pockets[shot.pocket, :2], color, width, dash=DASH, alpha=alpha)
        if strong or (not played and named[shot.ball] == rank):
            words = f"{shot.kind} {100.0 * shot.chance:.0f} %"
            canvas.label(
                ball, words, color, 11, "semibold", offset=(0.0, -18.0), alpha=1.0 if strong else 0.7
            )
