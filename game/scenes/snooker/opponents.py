"""What computer players decide at snooker, and what the table plays by itself."""

from __future__ import annotations

from functools import partial

import numpy as np

from game.billiards.game.arrangement import Stroke
from game.billiards.game.rules import CUE_BALL, Call
from game.billiards.game.snooker.frame import SnookerFrame
from game.billiards.players.ladder import SNOOKER, ladder_of
from game.billiards.shot.cue import strike as struck_ball
from game.billiards.table.snooker import COLOURS, name_of
from game.physics.kernels import elementwise, linear
from game.scenes.shared.tables.choices import GRADES
from game.scenes.shared.tables.course import AIMING
from game.scenes.shared.tables.demo_shots import choose_stroke
from game.scenes.shared.tables.minds.thoughts import called, told_of
from game.scenes.shared.tables.opponents import TableOpponents, check_option
from game.scenes.shared.thinker import Question, Thought
from game.scenes.snooker.course import BALL_PER_CUE, Course
from game.stage import Decision

THINK_S = 1.4  # s, after which a player begins nothing more; what is under way is finished within 0.6 s
HAND_SEED = 50_021


def think(question: Question) -> Thought:
    """The decisions of a player of some grade. One in a hurry uses one processor: the other one draws."""
    from game.billiards.players.graded import snooker_players
    from game.billiards.players.snooker import decide_snooker, hand_of

    frame, grade = question.frame, snooker_players()[question.grade]
    limits = (None, None) if question.patient else (THINK_S, 1)
    made = decide_snooker(frame, grade, question.seed, *limits)
    if made.option == "concede":
        return Thought((Decision("concede", ()),))
    if made.option:
        names = [option.name for option in frame.game.options]
        return Thought((Decision("option", (float(names.index(made.option)),)),))
    decisions = [Decision("white", made.place)] if made.place is not None else []
    if made.stroke is not None:
        decisions.append(decision_of(hand_of(made.stroke, grade, question.seed + HAND_SEED), made.call))
    on = frame.snooker.balls_on()
    ball = made.call.ball if made.call.ball is not None else on[0] if on else None
    pot = f"the {name_of(ball)}" if ball is not None else "a pot"
    told = told_of(called(question.grade, frame.game.shooter), made, pot, in_points=True)
    return Thought(tuple(decisions), made.considered, told)


def warm_up(grade: str) -> None:
    """Compile what a player of a grade needs to think, by letting it think about a small table."""
    from game.billiards.game.snooker.frame import new_snooker_frame
    from game.billiards.game.snooker.rules import Snooker
    from game.billiards.players.snooker import SNOOKER_GRADES, decide_snooker

    places = {0: (0.9, 1.0), COLOURS[-2]: (0.5, 2.0), COLOURS[-1]: (0.889, 3.245)}
    game = Snooker(on_table=COLOURS[-2:], stage="order", opening=False, in_hand="")
    decide_snooker(new_snooker_frame(game, places), SNOOKER_GRADES[grade], 0, 0.1, 1)


WARM_UPS = tuple(partial(warm_up, grade) for grade in GRADES[:1])  # what it compiles the others need


def simple_stroke(frame: SnookerFrame, seed: int) -> tuple[Stroke, Call]:
    """The straightest open pot of a ball that is on, or a hit at the nearest; the same for a seed."""
    layout, on = frame.layout, set(frame.snooker.balls_on())
    in_play = np.array([number == CUE_BALL or number in on for number in layout.numbers])
    chosen = choose_stroke(layout.positions, layout.radii, in_play, frame.table, seed, 1)
    offset = layout.positions - layout.positions[0]
    along = linear.product(offset, (elementwise.cos(chosen.aim), elementwise.sin(chosen.aim)))
    across = np.abs(linear.product(offset, (-elementwise.sin(chosen.aim), elementwise.cos(chosen.aim))))
    rows = [
        k for k in range(1, len(along)) if along[k] > 0.0 and across[k] < 2.0 * layout.radii[k] and in_play[k]
    ]
    ball = layout.numbers[min(rows, key=lambda k: float(along[k]))] if rows else None
    call = Call(ball) if frame.snooker.needs_call() and ball in COLOURS else Call()
    return Stroke(chosen.speed / BALL_PER_CUE, chosen.aim), call


def decision_of(stroke: Stroke, call: Call) -> Decision:
    """A stroke and what is nominated with it, as a decision."""
    return Decision("stroke", (*stroke, -1.0 if call.ball is None else float(call.ball)))


class SnookerOpponents(TableOpponents):
    """Computer players of snooker, and the table by itself."""

    def __init__(self, course: Course, seed: int) -> None:
        super().__init__(course, think, WARM_UPS, (*GRADES, *(one.name for one in ladder_of(SNOOKER))))
        self._seed = seed

    def instead(self) -> list[Decision]:
        """The first option, or a simple stroke."""
        frame = self.course.model.frame
        if frame.game.options:
            return [Decision("option", (0.0,))]
        return [decision_of(*simple_stroke(frame, frame.strokes))]

    def begin_again(self) -> None:
        """The next frame."""
        self.course.next_one()

    def play_itself(self) -> None:
        """The first option, or a simple stroke of its own seed."""
        course, frame = self.course, self.course.model.frame
        if frame.game.options:
            course.take_option(0)
        elif frame.playable:
            course.begin_stroke(*simple_stroke(frame, self._seed + frame.strokes))

    def decide(self, event: Decision) -> None:
        """Let a decision act. ValueError for one that cannot be."""
        values, course = event.values, self.course
        if course.phase != AIMING:
            raise ValueError(f"{event.name}: nothing is to be decided now")
        if event.name == "stroke" and len(values) == 6:
            stroke = Stroke(*values[:5])
            struck_ball(*stroke)  # refuses what no stroke can be
            course.begin_stroke(stroke, Call(None if values[5] < 0.0 else int(values[5])))
        elif event.name == "white" and len(values) == 2:
            course.model.move_cue_ball(*values)
        elif event.name == "option" and len(values) == 1:
            course.take_option(check_option(values[0], course.model.game.options))
        elif event.name == "concede" and not values:
            course.concede(at_once=True)
        else:
            raise ValueError(
                f"{event.name}: expected stroke, white, option or concede, each with its numbers"
            )
