"""Marks on the cloth: the baulk line and the D, what is on, what is nominated, the cue ball in hand."""

from __future__ import annotations

import math

import numpy as np

from game.billiards.game.rules import CUE_BALL
from game.billiards.table import snooker
from game.billiards.table.table import SNOOKER_WIDTH
from game.scenes.shared.tables.course import AIMING
from game.scenes.shared.tables.lessons.rings import draw_goals
from game.scenes.snooker.course import Course
from game.ui.canvas.canvas import Canvas
from game.ui.look.theme import FELT_COOL, FELT_LINE, FELT_WARM

_ANGLES = np.linspace(math.pi, 2.0 * math.pi, 49)
D = np.stack(
    [snooker.MIDDLE + snooker.D_RADIUS * np.cos(_ANGLES), snooker.BAULK + snooker.D_RADIUS * np.sin(_ANGLES)],
    axis=1,
)


def draw_lines(canvas: Canvas) -> None:
    """The baulk line and the D."""
    canvas.line((0.0, snooker.BAULK), (SNOOKER_WIDTH, snooker.BAULK), FELT_LINE, 1.25, alpha=0.5)
    canvas.polyline(D, FELT_LINE, 1.25, alpha=0.5)


def draw_marks(canvas: Canvas, course: Course) -> None:
    """What is on where that is one ball, what is nominated, the cue ball in hand, a locked aim."""
    frame, game = course.model.frame, course.model.game
    if course.learning.lesson is not None:
        draw_goals(canvas, course.learning.lesson.goals, frame.table)
    if course.phase != AIMING or not frame.playable:
        return
    on, nominated = game.balls_on(), course.call.ball if course.may_aim else None
    for number, x, y in frame.layout.places:
        if number == nominated:
            canvas.circle((x, y), 1.45 * snooker.BALL_RADIUS, outline=FELT_COOL, width=2.0)
        elif number in on and len(on) == 1:
            canvas.circle(
                (x, y),
                1.4 * snooker.BALL_RADIUS,
                fill=FELT_LINE,
                fill_alpha=0.16,
                outline=FELT_LINE,
                width=1.25,
                alpha=0.75,
            )
    place = frame.layout.place_of(CUE_BALL)
    if place is None or not course.person_plays:
        return
    if game.in_hand:
        canvas.circle(place, 1.8 * snooker.BALL_RADIUS, outline=FELT_WARM, width=1.5, dash=(4.0, 3.0))
    elif course.locked and course.may_aim:
        canvas.circle(place, 1.5 * snooker.BALL_RADIUS, outline=FELT_WARM, width=2.0)
