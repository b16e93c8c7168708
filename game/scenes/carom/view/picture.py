"""How carom is drawn: table, balls at any moment, cue, paths, and what stands round the table."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats
from game.billiards.game.carom_frame import CaromFrame
from game.billiards.game.games.artistic import Artistic
from game.billiards.laws.state import OFF_TABLE
from game.billiards.table.carom import BALL_RADIUS, SPOTS
from game.billiards.table.table import CAROM_LENGTH, CAROM_WIDTH
from game.scenes.carom import layout
from game.scenes.carom.advisor import Advisor, Drawn
from game.scenes.carom.coach import CaromCoach
from game.scenes.carom.course import Course
from game.scenes.carom.hand import CaromHand
from game.scenes.carom.opponents import CaromOpponents
from game.scenes.carom.view.map_list import draw_list, draw_tip
from game.scenes.carom.view.paths import (
    Foresight,
    draw_declared,
    draw_ends,
    draw_faint,
    draw_sight,
    lines_seen,
)
from game.scenes.carom.view.score_board import counted_of, draw_board, draw_foot
from game.scenes.carom.view.zones import draw_zones
from game.scenes.shared.tables.beside.coach_card import draw_coach
from game.scenes.shared.tables.boxes import look_of
from game.scenes.shared.tables.course import AIMING, REPLAY, ROLLING, STRIKING
from game.scenes.shared.tables.eye.course_view import CourseEye
from game.scenes.shared.tables.eye.lines import Line
from game.scenes.shared.tables.eye.picture import Furniture, Seen
from game.scenes.shared.tables.furnishing.felts import FELTS
from game.scenes.shared.tables.grip import Held
from game.scenes.shared.tables.lessons.rings import draw_goals
from game.scenes.shared.tables.minds.walking import draw_walk
from game.scenes.shared.tables.referee.banner import draw_call
from game.scenes.shared.tables.referee.calls import carom_call
from game.scenes.shared.tables.referee.card import draw_card
from game.scenes.shared.tables.referee.remark import draw_remark, said
from game.scenes.shared.tables.through.recoil import draw_recoil
from game.scenes.shared.tables.view import Balls, draw_balls, draw_cue_behind, draw_table
from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look
from game.ui.look.theme import FELT, FELT_WARM
from game.ui.painters.ball_look import CAROM_WHITE
from game.ui.painters.table import Dress, carom_dress

SHARES = tuple((x / CAROM_WIDTH, y / CAROM_LENGTH) for x, y in SPOTS)
DRESSES = {name: carom_dress(felt, SHARES) for name, felt in {**FELTS, "green": FELT}.items()}
FAINT = 3  # choices whose paths are shown
CUE_WORDS = 22.0  # design px below the ball


class CaromView:
    """The picture of the game."""

    def __init__(
        self, course: Course, hand: CaromHand, advisor: Advisor, opponents: CaromOpponents, coach: CaromCoach
    ) -> None:
        self.coach = coach
        self.course = course
        self.advisor = advisor
        self.opponents = opponents
        self._aimed = Foresight()
        self._eye = CourseEye(course, hand.inset, layout.TABLE, _cue_ball_of, _row_of, BALL_RADIUS)
        self._faint = tuple(Foresight() for _ in range(FAINT))
        self._declared = Foresight()

    @property
    def dress(self) -> Dress:
        """What the table wears."""
        return DRESSES[str(self.course.parameters.felt)]

    def draw(self, canvas: Canvas, alpha: float, clock_before: Floats | None) -> None:
        """The game, ``alpha`` of the step from the clock before to the clock now."""
        course, frame, dress = self.course, self.course.model.frame, self.dress
        draw_table(canvas, frame.table, dress=dress)
        canvas.halo = dress.felt
        drawn = self.advisor.drawn()
        furniture, balls = Furniture(frame.table, dress), self._balls(alpha, clock_before)
        if self._eye.from_side:
            self._eye.draw_side(canvas, furniture, balls, float(course.clock[0]))
        else:
            self._draw_play(canvas, drawn, furniture, balls)
        if canvas.pixels_per_unit >= layout.LEAST_PIXELS:
            look = look_of(canvas, layout.PIXELS)
            draw_board(canvas, look, course)
            if course.parameters.coach:
                draw_coach(canvas, look, layout.COLUMN, self.coach)
            else:
                draw_list(canvas, look, course, self.advisor, drawn)
            draw_tip(canvas, look, course, self.advisor.study())
            draw_foot(canvas, look, course, drawn, self.opponents.words_of_thoughts)
            self._draw_calls(canvas, look)
        last = frame.last
        if course.phase == ROLLING and last is not None and last.stroke == course.made:
            draw_recoil(canvas, course.parameters, last.stroke, float(course.clock[0]))

    def _draw_calls(self, canvas: Canvas, look: Look) -> None:
        """What the referee calls; at the end of a game the card."""
        course, game, played = self.course, self.course.model.frame.game, self.course.model.played
        if course.phase != AIMING or played is None:
            return
        draw_call(canvas, look, layout.TABLE, carom_call(played.verdict), course.called_s)
        draw_remark(canvas, look, layout.TABLE, said(course, self.opponents.told.tried), course.called_s)
        if game.ended and len(game.players) == 2:
            draw_card(canvas, look, layout.TABLE, counted_of(course))

    def _draw_play(self, canvas: Canvas, drawn: Drawn | None, furniture: Furniture, balls: Balls) -> None:
        """What lies and moves on the table, from above; the view from the cue."""
        course = self.course
        draw_zones(canvas, course)
        if course.learning.lesson is not None:
            draw_goals(canvas, course.learning.lesson.goals, course.model.frame.table)
        lines = self._draw_paths(canvas, drawn) if course.phase == AIMING else []
        draw_balls(canvas, balls, furniture.table, felt=furniture.dress.felt)
        if course.may_aim or course.phase == STRIKING:
            ball = np.array(course.cue_ball)
            if course.grip.kind is not Held.BALL:
                draw_cue_behind(
                    canvas, furniture.table, ball, BALL_RADIUS, course.cue, CUE_WORDS, course.push
                )
            canvas.circle(ball, 1.25 * BALL_RADIUS, outline=FELT_WARM, width=1.4, alpha=0.8)
        if self.opponents.walks:
            draw_walk(canvas, furniture.table, self.opponents.walk)
        self._eye.draw_inset(canvas, furniture, Seen(balls, lines))

    def _balls(self, alpha: float, clock_before: Floats | None) -> Balls:
        """The balls as they lie, or on their paths."""
        course, model = self.course, self.course.model
        numbers = np.arange(CAROM_WHITE, CAROM_WHITE + 3)
        played = model.played
        if course.phase not in (ROLLING, REPLAY) or played is None:
            return Balls(model.places, np.full(3, BALL_RADIUS), numbers, model.turns, np.ones(3))
        time = float(course.clock[0])
        before = time if clock_before is None else float(clock_before[0])
        if before <= time <= before + 0.1:
            time = before + alpha * (time - before)
        time = min(time, played.trajectory.end_time)
        places = model.places.copy()
        places[model.rows] = played.trajectory.state_at(time).positions
        heights = np.zeros(3)
        heights[model.rows] = played.trajectory.heights_at(time)
        there = np.ones(3)
        there[model.rows] = played.trajectory.state_at(time).motions != OFF_TABLE
        return Balls(places, np.full(3, BALL_RADIUS), numbers, model.turns_at(time), there, heights)

    def _draw_paths(self, canvas: Canvas, drawn: Drawn | None) -> list[Line]:
        """Of the chosen stroke, or the one that is aimed; faintly those of the first choices. The paths of
        the first two as lines.
        """
        course, frame = self.course, self.course.model.frame
        if isinstance(frame.game, Artistic) and not frame.game.over:
            draw_declared(canvas, self._declared.of(frame, frame.game.now.stroke))
        lines: list[Line] = []
        if not course.may_aim:
            return lines
        chosen = course.chosen
        then = self.advisor.frame_of(drawn) if drawn is not None else None
        if chosen is None and drawn is not None and then is not None:  # late while a ball is dragged
            for foresight, group in zip(self._faint, drawn.map.groups, strict=False):
                sight = foresight.of(then, group.stroke)
                if sight is not None:
                    draw_faint(canvas, sight)
        elif chosen is not None and drawn is not None and course.parameters.ends:
            for group in drawn.map.groups:
                if group.stroke == chosen and len(group.ends):
                    draw_ends(canvas, group.ends, frame.game.cue)
        if course.grip.kind is not Held.BALL and (chosen is not None or course.parameters.path):
            stroke = chosen if chosen is not None else course.stroke
            sight = self._aimed.of(frame, stroke)
            if sight is not None:
                draw_sight(canvas, sight, chosen is not None)
                lines = lines_seen(sight, chosen is not None)
                if sight.scores and chosen is None:
                    place = np.array(course.cue_ball) + 2.4 * BALL_RADIUS * np.array(
                        (math.cos(course.cue.aim + 2.2), math.sin(course.cue.aim + 2.2))
                    )
                    canvas.label(place, "scores", FELT_WARM, 12, "semibold")
        return lines


def _cue_ball_of(frame: CaromFrame) -> tuple[float, float]:
    """Where the ball lies that the player at turn plays, m."""
    return frame.places[frame.game.cue]


def _row_of(frame: CaromFrame) -> int:
    """The row of the ball that is struck in the trajectory of a stroke."""
    return 0
