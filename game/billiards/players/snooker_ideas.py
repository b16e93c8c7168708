"""What a player may play for at snooker, places for its cue ball in hand, and strokes that keep it safe."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.billiards.game.rules import Call
from game.billiards.game.snooker.frame import SnookerFrame
from game.billiards.search import outcomes as o
from game.billiards.search.aims import bits_of
from game.billiards.search.outcomes import Outcomes
from game.billiards.search.rating import FOULED, MISSED, SCORED, Aims
from game.billiards.search.view import View
from game.billiards.table import snooker
from game.billiards.table.snooker import touching, value_of
from game.physics.kernels import elementary, elementwise

SAFE_OFFSETS = np.linspace(-0.96, 0.96, 9)  # where a ball is hit, as a share of what can be
SAFE_BALLS, SAFE_LEFTS = 6, (-0.3, 0.0, 0.3)
ROUND = 360  # directions all around, for escapes


class Idea(NamedTuple):
    """Something to play for: the aims of the search, what is nominated, the points of a pot. What is on after
    it, and for the other after a miss. The balls that the cue ball touches, which it must not be played into
    (bits of rows).
    """

    aims: Aims
    call: Call
    points: int
    following: int
    others: int
    touched: int = 0


def ideas_of(frame: SnookerFrame) -> list[Idea]:
    """What the striker may play for."""
    game, numbers = frame.snooker, frame.layout.numbers
    touched = bits_of(numbers, touching(frame.places_by_number))

    def bits(*balls: int) -> int:
        return bits_of(numbers, balls)

    every, reds, colours = bits(*game.on_table), bits(*game.reds_left), bits(*game.colours_left)
    on, solo = game.balls_on(), len(game.players) == 1
    after = reds or colours  # what the other will be on

    def idea(first: tuple[int, ...], needed: int, call: Call, points: int) -> Idea:
        score = bits(*first)
        aims = Aims(
            score & ~touched, score, needed, lose=every & ~score, other=needed or after, called=False,
            rotation=game.stage == "order", solo=solo,
        )  # fmt: skip
        following = needed if game.stage != "order" else needed & -needed
        return Idea(aims, call, points, following, after if reds else score, touched)

    if game.free_ball:
        value = 1 if game.stage == "red" else value_of(on[0])
        then = colours if value == 1 else after
        free = [ball for ball in game.colours_left if ball not in on]
        return [idea(on, then, Call(), value), *(idea((ball,), then, Call(ball), value) for ball in free)]
    if game.stage == "red":
        return [idea(on, colours, Call(), 1)]
    if game.stage == "colour":
        return [idea((ball,), after, Call(ball), value_of(ball)) for ball in on]
    return [idea(on, colours & ~bits(*on), Call(), value_of(on[0]))]


def classes_of(outcomes: Outcomes, idea: Idea) -> NDArray[np.int64]:
    """What each stroke led to (m,): SCORED, MISSED or FOULED, as snooker has it."""
    facts, aims = outcomes.facts, idea.aims
    first, down = facts[:, o.FIRST_BALLS], facts[:, o.DOWN]
    foul = (facts[:, o.GIVEN_UP] != 0) | (facts[:, o.SCRATCH] != 0) | (first & idea.touched != 0)
    if not idea.touched & aims.score:  # else a ball on is hit already
        foul |= (first & aims.first == 0) | (first & ~np.int64(aims.first) != 0)
    foul |= down & ~np.int64(aims.score) != 0
    return np.where(foul, FOULED, np.where(down & aims.score != 0, SCORED, MISSED)).astype(np.int64)


def moved(frame: SnookerFrame, x: float, y: float) -> SnookerFrame:
    placed = frame.move_cue_ball(x, y)
    assert isinstance(placed, SnookerFrame)
    return placed


def places_in_hand(frame: SnookerFrame) -> list[tuple[tuple[float, float], SnookerFrame]]:
    """Places for the cue ball in hand: over the D, or over the table if it may go anywhere."""
    if frame.game.in_hand == "anywhere":
        asked = [(x * frame.table.width, y * frame.table.length)
                 for x in (0.2, 0.35, 0.5, 0.65, 0.8) for y in (0.3, 0.5, 0.62, 0.7, 0.8, 0.88)]  # fmt: skip
    else:
        asked = [
            (
                snooker.MIDDLE + snooker.D_RADIUS * r * elementary.cos(a),
                snooker.BAULK + snooker.D_RADIUS * r * elementary.sin(a),
            )
            for r in (0.35, 0.75, 1.0)
            for a in np.linspace(math.pi, 2.0 * math.pi, 7).tolist()
        ]
    found = []
    for x, y in asked:
        place = frame.nearest_place(x, y)
        found.append((place, moved(frame, *place)))
    return found


def idea_for_safety(frame: SnookerFrame, view: View) -> Idea:
    """What a safe stroke is played at: what is on; of colours the one that is nearest."""
    ideas = ideas_of(frame)
    if frame.snooker.stage != "colour":
        return ideas[0]
    cue = view.places[view.board.cue]
    numbers = frame.layout.numbers

    def far(idea: Idea) -> float:
        ball = idea.call.ball
        return (
            math.inf if ball is None else float(elementwise.hypot(*(view.places[numbers.index(ball)] - cue)))
        )

    return min(ideas, key=far)


def safe_strokes(view: View, first: int, speeds: tuple[float, ...]) -> Floats:
    """Strokes (m, 5) at the nearest balls on, and the last ones, thick and thin. first: of `Aims`."""
    cue_ball = view.places[view.board.cue]
    rows = [ball for ball in range(view.board.count) if first >> ball & 1]
    rows.sort(key=lambda ball: float(elementwise.hypot(*(view.places[ball] - cue_ball))))
    thin: list[float] = []
    for ball in rows[:SAFE_BALLS] + rows[SAFE_BALLS:][-2:]:
        dx, dy = view.places[ball] - cue_ball
        half = elementary.asin(min(1.0, 2.0 * snooker.BALL_RADIUS / elementary.hypot(dx, dy)))
        thin += (elementary.atan2(dy, dx) + half * SAFE_OFFSETS).tolist()
    strokes = [(v, a, 0.0, left, 0.0) for a in thin for v in speeds for left in SAFE_LEFTS]
    return np.array(strokes).reshape(-1, 5)


def strokes_all_around(speeds: tuple[float, ...]) -> Floats:
    """Strokes (m, 5) in every direction, for what is hidden."""
    around = np.linspace(0.0, 2.0 * math.pi, ROUND, endpoint=False).tolist()
    return np.array([(v, a, 0.0, 0.0, 0.0) for a in around for v in speeds])
