"""Paths of strokes on the cloth: of the one that is aimed, of the chosen one, of the first of the map."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.billiards.game.arrangement import Stroke
from game.billiards.game.carom_frame import CaromFrame, carom_trajectory, rows_of
from game.billiards.game.carom_summary import summarize_carom
from game.billiards.shot.paths import Paths
from game.billiards.table.carom import BALL_RADIUS
from game.scenes.shared.tables.eye.lines import Line
from game.scenes.shared.tables.sight import FLIGHT_DASH
from game.ui.canvas.canvas import Canvas
from game.ui.look.theme import FELT, FELT_COOL, FELT_LINE, FELT_WARM

LEAST_PATH = 0.01  # m; a ball that moves less is not shown to move


class Sight(NamedTuple):
    """What a stroke would do: paths of the balls by row (cue ball first), whether it scores.

    flights: those of the cue ball, points (n, 3) m with the height.
    """

    paths: tuple[Floats, ...]
    scores: bool
    flights: tuple[Floats, ...] = ()


class Foresight:
    """What is foreseen of one stroke, kept while neither it nor what it is played from changes."""

    def __init__(self) -> None:
        self._key: object = None
        self._sight: Sight | None = None

    def of(self, frame: CaromFrame, stroke: Stroke) -> Sight | None:
        """The whole paths of a stroke; None if it cannot be played."""
        key = (frame.places, frame.physics, frame.game, stroke)
        if key != self._key:
            self._key, self._sight = key, _foresee(frame, stroke)
        return self._sight


def _foresee(frame: CaromFrame, stroke: Stroke) -> Sight | None:
    try:
        trajectory = carom_trajectory(frame, stroke)
    except ValueError:
        return None
    paths = Paths(trajectory)
    summary = summarize_carom(trajectory, frame.game.cue, frame.game.rule.barred)
    scores = frame.playable and frame.game.judge(summary).scored
    end = trajectory.end_time
    flights = tuple(paths.in_air(0, 0.0, end, frame.physics.gravity))
    return Sight(tuple(paths.path(row, 0.0, end) for row in range(3)), scores, flights)


def draw_sight(canvas: Canvas, sight: Sight, chosen: bool) -> None:
    """The paths of all balls, the cue ball's strongest; where it ends."""
    for row, points in enumerate(sight.paths):
        if len(points) < 2 or float(np.ptp(points, axis=0).max()) < LEAST_PATH:
            continue
        color = FELT_COOL if row else FELT_WARM if chosen else FELT_LINE
        canvas.polyline(points, color, 1.4 if row else 2.0, alpha=0.75 if row else 0.95)
        canvas.circle(points[-1], BALL_RADIUS, outline=color, width=1.2, alpha=0.8)
    for flight in sight.flights:
        canvas.polyline(flight[:, :2], FELT, 2.4, dash=(4.0, 7.0))  # gaps in the line: it flies


def draw_declared(canvas: Canvas, sight: Sight | None) -> None:
    """The way that a figure of artistic billiards asks for, as its known stroke goes."""
    if sight is not None and len(sight.paths[0]) > 1:
        canvas.polyline(sight.paths[0], FELT_WARM, 1.6, dash=(7.0, 5.0), alpha=0.7)


def lines_seen(sight: Sight, chosen: bool) -> list[Line]:
    """The same paths as an eye sees them."""
    moving = [
        (row, points) for row, points in enumerate(sight.paths)
        if len(points) > 1 and float(np.ptp(points, axis=0).max()) >= LEAST_PATH
    ]  # fmt: skip
    found = [Line(points, FELT_COOL if row else FELT_WARM if chosen else FELT_LINE) for row, points in moving]
    return found + [Line(flight, FELT_WARM, 1.75, FLIGHT_DASH) for flight in sight.flights]


def draw_faint(canvas: Canvas, sight: Sight) -> None:
    """The cue ball's path of a stroke that might be chosen."""
    points = sight.paths[0]
    if len(points) > 1:
        canvas.polyline(points, FELT_LINE, 1.2, alpha=0.38)


def draw_ends(canvas: Canvas, ends: Floats, cue: int) -> None:
    """Where the balls end, stroke by stroke of a hand. ends (k, 3, 2) m of white, yellow, red."""
    own, _, red = rows_of(cue)
    for row in range(3):
        color = FELT_WARM if row == own else "vermilion" if row == red else FELT_COOL
        canvas.discs(ends[:48, row], 0.35 * BALL_RADIUS, color, alpha=0.55)
