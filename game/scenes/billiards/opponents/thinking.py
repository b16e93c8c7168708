"""Computer players at the table: how one of them thinks about a frame, and what its hand makes of it."""

from __future__ import annotations

from functools import partial

import numpy as np

from game.billiards.game.arrangement import Stroke
from game.billiards.game.frame import Frame
from game.billiards.game.rules import CUE_BALL, Call
from game.scenes.billiards.layout import pocket_words
from game.scenes.shared.tables.choices import GRADES
from game.scenes.shared.tables.demo_shots import choose_stroke
from game.scenes.shared.tables.minds.thoughts import called, told_of
from game.scenes.shared.thinker import Question, Thought
from game.stage import Decision

THINK_S = 1.4  # s, after which a player begins nothing more; what is under way is finished within 0.6 s
SWING_RATIO = 0.65  # speed of the cue over that of the ball that a simple stroke is meant to give
HAND_SEED = 50_021


def think(question: Question) -> Thought:
    """The decisions of a player of some grade. One in a hurry uses one processor: the other one draws."""
    from game.billiards.players.graded import pool_players
    from game.billiards.players.opponents import decide, stroke_of_hand

    frame, grade = question.frame, pool_players()[question.grade]
    limits = (None, None) if question.patient else (THINK_S, 1)
    made = decide(frame, grade, question.seed, *limits)
    if made.option:
        names = [option.name for option in frame.game.options]
        return Thought((Decision("option", (float(names.index(made.option)),)),))
    decisions = [Decision("white", made.place)] if made.place is not None else []
    if made.stroke is not None:
        radius = float(frame.layout.balls.radii[CUE_BALL])
        stroke = stroke_of_hand(made.stroke, grade, question.seed + HAND_SEED, radius)
        decisions.append(decision_of(stroke, made.call))
    call = made.call
    where = f" into the {pocket_words(call.pocket)}" if call.pocket is not None else ""
    pot = f"the {call.ball}{where}" if call.ball else "a pot"
    told = told_of(called(question.grade, frame.game.shooter), made, pot)
    return Thought(tuple(decisions), made.considered, told)


def warm_up(grade: str) -> None:
    """Compile what a player of a grade needs to think, by letting it think about a small table."""
    from game.billiards.game.frame import new_frame
    from game.billiards.game.games import EightBall
    from game.billiards.players.opponents import GRADES as PLAYERS
    from game.billiards.players.opponents import decide

    frame = new_frame(EightBall(on_table=(1, 8, 9), opening=False, in_hand="anywhere"))
    decide(frame, PLAYERS[grade], 0, 0.1, threads=1)


# the weakest first: what it compiles the others need as well
WARM_UPS = tuple(partial(warm_up, grade) for grade in GRADES)


def simple_stroke(frame: Frame, seed: int) -> Stroke:
    """The straightest open pot of a ball that counts, or a hit at the nearest ball; the same for a seed."""
    balls, targets = frame.layout, set(frame.game.targets())
    in_play = np.array([number == CUE_BALL or number in targets for number in balls.numbers])
    chosen = choose_stroke(
        balls.positions, balls.radii, in_play, frame.table, seed, int(not frame.game.opening)
    )
    return Stroke(chosen.speed * SWING_RATIO, chosen.aim)


def decision_of(stroke: Stroke, call: Call = Call()) -> Decision:  # noqa: B008  (immutable)
    """A stroke and what is announced with it, as a decision."""
    ball = -1.0 if call.ball is None else float(call.ball)
    pocket = -1.0 if call.pocket is None else float(call.pocket)
    return Decision("stroke", (*stroke, ball, pocket, float(call.safety), float(call.push_out)))
