"""How good the computer players are: tables cleared in one visit, racks won, what an unsteady hand costs.

    from game.lab.players import measure_clearing, measure_series
    measure_clearing(GRADES["master"], range(200))
    measure_series(GRADES["master"], GRADES["expert"], range(100))

A table is a rack of eight-ball after a hard break, the cue ball in hand anywhere, no group taken yet.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

import msgspec
import numpy as np

from game.billiards.game.arrangement import Stroke, after_shot
from game.billiards.game.frame import Frame, new_frame
from game.billiards.game.games import EightBall
from game.billiards.game.games.eight_ball import EIGHT
from game.billiards.game.rules import CUE_BALL
from game.billiards.players.opponents import Grade, decide, stroke_of_hand
from game.billiards.search.breaking import apex_of
from game.physics.kernels import elementary

BREAK_SPEED = 6.0  # m/s of the cue
FROM = (0.3, 0.5)  # share of the width, m of the length: where breaks come from
SPREAD = 0.004  # rad; how far breaks vary


class Visit(NamedTuple):
    """One visit to a table: whether it was cleared, and how many balls were potted."""

    cleared: bool
    potted: int


class Clearing(NamedTuple):
    """Visits of a grade: tables, how many were cleared, potted balls a visit, share of strokes that pot."""

    tables: int
    cleared: int
    potted: float
    success: float


class Series(NamedTuple):
    """Racks of two grades: won by the first and the second, and strokes a rack."""

    first: int
    second: int
    strokes: float


def broken_table(seed: int) -> Frame:
    """Eight-ball after a break at which the 8 stayed up; the cue ball is in hand for the first player."""
    random = np.random.default_rng(seed)
    while True:
        frame = new_frame(EightBall(), seed=int(random.integers(1 << 30)))
        x = frame.table.width * random.uniform(FROM[0], 1.0 - FROM[0])
        placed = frame.place_cue_ball(x, FROM[1])
        apex = apex_of(placed.layout, placed.table)
        azimuth = elementary.atan2(apex[1] - FROM[1], apex[0] - x) + SPREAD * random.standard_normal()
        played = placed.play(Stroke(BREAK_SPEED, azimuth, tip_up=0.1))
        if EIGHT in played.summary.balls_down:
            continue
        layout = after_shot(placed.layout, played.summary).without(CUE_BALL)
        game = msgspec.structs.replace(
            EightBall(), opening=False, in_hand="anywhere", on_table=layout.numbers
        )
        return frame.replace(game=game, layout=layout)


def visit(seed: int, grade: Grade, threads: int | None = None) -> Visit:
    """One visit to a broken table: until it is cleared, or over."""
    frame = broken_table(seed)
    potted = 0
    for turn in range(20):
        thought = decide(frame, grade, 1000 * seed + turn, threads=threads, alone=True)
        if thought.place is not None:
            frame = frame.place_cue_ball(*thought.place)
        if thought.stroke is None:
            break
        stroke = stroke_of_hand(thought.stroke, grade, 1000 * seed + 500 + turn)
        played = frame.play(stroke, thought.call)
        frame = played.frame
        if frame.game.over or frame.game.turn != 0 or not played.verdict.scored:
            cleared = frame.game.winner == 0
            return Visit(cleared, potted + cleared)
        potted += 1
    return Visit(False, potted)


def measure_clearing(grade: Grade, seeds: Iterable[int], threads: int | None = None) -> Clearing:
    """Visits of a grade to the tables of these seeds."""
    visits = [visit(seed, grade, threads) for seed in seeds]
    cleared = sum(one.cleared for one in visits)
    potted = sum(one.potted for one in visits)
    strokes = potted + len(visits) - cleared  # a visit that does not clear the table ends with a miss
    return Clearing(len(visits), cleared, potted / len(visits), potted / strokes)


def with_hand(grade: Grade, unsteady: float) -> Grade:
    """The grade's way to think, with another hand: 1 is the usual noise, 0 none."""
    return grade._replace(unsteady=unsteady)


def play_rack(
    frame: Frame, grades: tuple[Grade, ...], seed: int, threads: int | None = None, most: int = 400
) -> tuple[Frame, list[Stroke]]:
    """A rack played to its end, or for at most so many turns: the last frame, and all strokes."""
    strokes: list[Stroke] = []
    radius = float(frame.layout.balls.radii[CUE_BALL])
    for turn in range(most):
        if frame.game.over:
            break
        grade = grades[frame.game.turn]
        decision = decide(frame, grade, seed * 100_003 + turn, threads=threads)
        if decision.option:
            frame = frame.choose(decision.option, seed * 100_003 + turn)
            continue
        if decision.place is not None:
            frame = frame.place_cue_ball(*decision.place)
        assert decision.stroke is not None
        stroke = stroke_of_hand(decision.stroke, grade, seed * 100_003 + 50_021 + turn, radius)
        strokes.append(stroke)
        frame = frame.play(stroke, decision.call).frame
    return frame, strokes


def measure_series(first: Grade, second: Grade, seeds: Iterable[int], threads: int | None = None) -> Series:
    """Racks of eight-ball between two grades, who break in turns."""
    wins = [0, 0]
    strokes = 0
    racks = 0
    for seed in seeds:
        breaker = seed % 2
        game = EightBall(players=(first.title, second.title), turn=breaker, breaker=breaker)
        frame, played = play_rack(new_frame(game, seed=seed), (first, second), seed, threads)
        if frame.game.winner is not None:
            wins[frame.game.winner] += 1
        strokes += len(played)
        racks += 1
    return Series(wins[0], wins[1], strokes / max(racks, 1))
