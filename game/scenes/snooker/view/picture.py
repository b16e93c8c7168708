"""How snooker is drawn: table, balls at any moment, cue, aim, and what stands round the table."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.billiards.game.frame import Frame
from game.billiards.game.rules import CUE_BALL
from game.billiards.game.snooker.rules import Snooker
from game.billiards.table.snooker import BALL_RADIUS, SPOTS
from game.billiards.table.table import SNOOKER_LENGTH, SNOOKER_WIDTH
from game.scenes.shared.tables import grip
from game.scenes.shared.tables.boxes import look_of
from game.scenes.shared.tables.choices import FIRST, NONE
from game.scenes.shared.tables.course import AIMING, REPLAY, ROLLING, STRIKING
from game.scenes.shared.tables.eye.course_view import CourseEye
from game.scenes.shared.tables.eye.lines import lines_of
from game.scenes.shared.tables.eye.picture import Furniture, Seen
from game.scenes.shared.tables.eye.view import ghost_of
from game.scenes.shared.tables.furnishing.felts import dresses
from game.scenes.shared.tables.minds.walking import draw_walk
from game.scenes.shared.tables.odds import Asked, Odds, OddsMeter
from game.scenes.shared.tables.prediction import FIRST_BALL, Foresight, Sight
from game.scenes.shared.tables.referee.banner import draw_call
from game.scenes.shared.tables.referee.calls import snooker_call
from game.scenes.shared.tables.referee.card import draw_card
from game.scenes.shared.tables.referee.remark import draw_remark, said
from game.scenes.shared.tables.rolling import balls_at
from game.scenes.shared.tables.sight import draw_considered, draw_fan, draw_label, draw_sight
from game.scenes.shared.tables.through.recoil import draw_recoil
from game.scenes.shared.tables.unsteady import SURE, spread_of
from game.scenes.shared.tables.view import Balls, draw_balls, draw_cue_behind, draw_table
from game.scenes.snooker import layout
from game.scenes.snooker.course import Course
from game.scenes.snooker.hand import SnookerHand
from game.scenes.snooker.opponents import SnookerOpponents
from game.scenes.snooker.view.board import draw_board, draw_foot, look_number
from game.scenes.snooker.view.instruments import draw_instruments
from game.scenes.snooker.view.magnifier import Magnifier, box_beside, magnifies
from game.scenes.snooker.view.marks import draw_lines, draw_marks
from game.scenes.snooker.view.words import counted_of, foul_to_come, legality_to_come, line_of, standing_of
from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look
from game.ui.look.theme import FELT_GREEN
from game.ui.painters.table import Dress, carom_dress

DRESS = carom_dress(
    FELT_GREEN, tuple((x / SNOOKER_WIDTH, y / SNOOKER_LENGTH) for x, y in SPOTS.values())
)._replace(sights=False)
LOOKS = np.array([look_number(ball) for ball in range(22)])
DRESSES = dresses(DRESS)
CUE_WORDS = 22.0  # design px below the ball


class SnookerView:
    """The picture of the game. title: of the level."""

    def __init__(self, course: Course, hand: SnookerHand, opponents: SnookerOpponents, title: str) -> None:
        self.course = course
        self.hand = hand
        self.opponents = opponents
        self.title = title
        self._foresight = Foresight()
        self._odds = OddsMeter()
        self._magnifier = Magnifier()
        self._eye = CourseEye(course, hand.inset, layout.TABLE, _cue_ball_of, _row_of, BALL_RADIUS)

    @property
    def dress(self) -> Dress:
        """What the table wears."""
        return DRESSES[str(self.course.parameters.felt)]

    def draw(self, canvas: Canvas, alpha: float, clock_before: Floats | None) -> None:
        """The game, ``alpha`` of the step from the clock before to the clock now."""
        course, frame = self.course, self.course.model.frame
        if self._eye.from_side:
            self._draw_side(canvas, alpha, clock_before)
            return
        dress = self.dress
        draw_table(canvas, frame.table, dress=dress)
        canvas.halo = dress.felt
        draw_lines(canvas)
        draw_marks(canvas, course)
        sight = self._sight()
        foul = foul_to_come(course, sight.target) if sight is not None else ""
        if sight is not None:
            spread = SURE * spread_of(course.stroke, str(course.parameters.hand), BALL_RADIUS)
            draw_fan(canvas, sight, spread)
            draw_sight(canvas, sight, BALL_RADIUS, BALL_RADIUS, bool(foul))
        balls = self._balls(alpha, clock_before)
        draw_balls(canvas, balls, frame.table, felt=dress.felt)
        if sight is not None:
            draw_label(canvas, sight, frame.layout.places, frame.table, BALL_RADIUS, foul)
        if course.parameters.considered and course.phase == STRIKING and not course.person_plays:
            draw_considered(canvas, self.opponents.considered, frame.layout.places, frame.table, played=False)
        place = frame.cue_ball
        if (
            place is not None
            and (course.may_aim or course.phase == STRIKING)
            and course.grip != grip.CUE_BALL
        ):
            draw_cue_behind(
                canvas, frame.table, np.array(place), BALL_RADIUS, course.cue, CUE_WORDS, course.push
            )
        if self.opponents.walks:
            draw_walk(canvas, frame.table, self.opponents.walk)
        if sight is not None and place is not None:
            self._magnify(canvas, sight, balls, place, bool(foul))
        lines = lines_of(sight, BALL_RADIUS) if sight is not None else []
        seen = Seen(balls, lines, ghost_of(sight, BALL_RADIUS, bool(foul)))
        self._eye.draw_inset(canvas, Furniture(frame.table, dress, draw_lines), seen)
        self._draw_around(canvas, sight)
        last = frame.last
        if course.phase == ROLLING and last is not None and last.stroke == course.made:
            draw_recoil(canvas, course.parameters, last.stroke, float(course.clock[0]))

    def _draw_side(self, canvas: Canvas, alpha: float, clock_before: Floats | None) -> None:
        """The stroke from its best side in place of the table from above."""
        table, balls = self.course.model.frame.table, self._balls(alpha, clock_before)
        draw_table(canvas, table, dress=self.dress)
        furniture = Furniture(table, self.dress, draw_lines)
        self._eye.draw_side(canvas, furniture, balls, float(self.course.clock[0]))
        self._draw_around(canvas, None)

    def _draw_around(self, canvas: Canvas, sight: Sight | None) -> None:
        """Score board, line of words, instruments."""
        course = self.course
        if canvas.pixels_per_unit < layout.LEAST_PIXELS:
            return
        look = look_of(canvas, layout.PIXELS)
        draw_board(canvas, look, standing_of(course, self.opponents.thinker, self.title))
        draw_foot(canvas, look, course, self.opponents.words_of_thoughts.beside(line_of(course)))
        draw_instruments(canvas, look, course, self.hand, self._odds_of(sight))
        self._draw_calls(canvas, look)

    def _draw_calls(self, canvas: Canvas, look: Look) -> None:
        """What the referee calls; at the end of a frame the card."""
        course, frame, played = self.course, self.course.model.frame, self.course.model.played
        if course.phase != AIMING:
            return
        if played is not None and frame.last is not None:
            before = frame.last.frame.game
            assert isinstance(before, Snooker)
            draw_call(canvas, look, layout.TABLE, snooker_call(before, played.verdict), course.called_s)
            draw_remark(canvas, look, layout.TABLE, said(course, self.opponents.told.tried), course.called_s)
        if frame.game.over and len(frame.game.players) == 2:
            draw_card(canvas, look, layout.TABLE, counted_of(course))

    def _magnify(
        self, canvas: Canvas, sight: Sight, balls: Balls, place: tuple[float, float], foul: bool
    ) -> None:
        """The contact from near, where the picture is small."""
        if sight.ghost is None or not magnifies(str(self.course.parameters.magnifier), canvas):
            return
        others = [(x, y) for number, x, y in self.course.model.frame.layout.places if number != CUE_BALL]
        self._magnifier.draw(
            canvas, box_beside(place, sight.ghost, others), balls, sight, foul, self.dress.felt
        )

    def _sight(self) -> Sight | None:
        """What is foreseen of the stroke that is aimed."""
        course = self.course
        if not course.may_aim or course.guide == NONE or course.grip == grip.CUE_BALL:
            return None
        events = FIRST_BALL if course.guide == FIRST else int(course.parameters.events)
        return self._foresight.of(course.model.frame, course.stroke, events)

    def _odds_of(self, sight: Sight | None) -> Odds | None:
        """Of the stroke that is aimed at a ball that is on."""
        course, frame = self.course, self.course.model.frame
        if sight is None or sight.target is None or frame.game.opening or course.phase != AIMING:
            return None
        if foul_to_come(course, sight.target):
            return None
        return self._odds.of(frame, course.stroke, Asked(sight.target, legality=legality_to_come(course)))

    def _balls(self, alpha: float, clock_before: Floats | None) -> Balls:
        """The balls as they lie, or on their paths."""
        course, model = self.course, self.course.model
        played = model.played
        if course.phase not in (ROLLING, REPLAY) or played is None or model.frame.last is None:
            placed = model.frame.layout
            numbers = np.array(placed.numbers, dtype=np.int64)
            return Balls(
                placed.positions, placed.radii, LOOKS[numbers], model.turns[numbers], np.ones(len(numbers))
            )
        time = float(course.clock[0])
        before = time if clock_before is None else float(clock_before[0])
        if before <= time <= before + 0.1:
            time = before + alpha * (time - before)
        balls = balls_at(model.frame.last.frame, played.trajectory, model.turns_before, time)
        return balls._replace(numbers=LOOKS[balls.numbers])


def _cue_ball_of(frame: Frame) -> tuple[float, float] | None:
    """Where the cue ball of a frame lies, m."""
    return frame.cue_ball


def _row_of(frame: Frame) -> int:
    """The row of the cue ball in the trajectory of a stroke."""
    return frame.layout.numbers.index(CUE_BALL)
