"""What happens when in a match on film: when each round begins, its hit, its end, what matters."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.billiards.game.rules import CUE_BALL
from game.billiards.laws.state import BALL_POCKET
from game.billiards.players.match import Match, Round
from game.scenes.billiards.stroke.motion import StrokeMotion, stroke_motion

TITLE_S, END_S = 4.0, 5.0
BEFORE_S, AFTER_S = 0.5, 0.9  # s of rest before and after each round
LEAST_S = 60.0  # s that a film lasts
LOOK_AHEAD_S, LOOK_BACK_S = 0.4, 0.3  # the story's camera looks ahead by itself
CUE_SHOWN = 0.5  # m of the cue that are seen before the hit
CLOSEST = 1.5  # m, of the table's length that is in view at least
MARGIN = 0.22  # m round what matters
WHOLE = 3.0  # m of length: the whole table
EVERY_S = 0.2  # s between looks how much must be in view


class Act(NamedTuple):
    """One round on film: when it begins, when the tip meets the ball, when it ends, s."""

    round: Round
    begins: float
    hits: float
    ends: float
    motion: StrokeMotion


def acts_of(match: Match) -> tuple[Act, ...]:
    """The rounds one after the other; those of short matches rest a little longer."""
    spare = LEAST_S - TITLE_S - match.playing_time - 2.5 * len(match.rounds)
    rest = max(spare, 0.0) / max(len(match.rounds), 1)
    acts = []
    time = TITLE_S
    for one in match.rounds:
        motion = stroke_motion(one.stroke.cue_speed, practised=True)
        hits = time + BEFORE_S + motion.hit_s
        rolls = max(one.trajectory.end_time, motion.end_s - motion.hit_s)
        ends = hits + rolls + AFTER_S + rest
        acts.append(Act(one, time, hits, ends, motion))
        time = ends
    return tuple(acts)


def potted_at(one: Round) -> float:
    """When the ball of a round falls, s after the hit."""
    row = one.trajectory.shot.ids.index(str(one.fallen.ball))
    for time, code, ball, _ in one.trajectory.rows.tolist():
        if int(code) == BALL_POCKET and int(ball) == row:
            return float(time)
    return one.trajectory.end_time


def what_matters(act: Act, time: float) -> tuple[Floats, Floats]:
    """Corners (m) of a box round the balls of the chain that move or soon will, and then the pocket."""
    trajectory, fallen = act.round.trajectory, act.round.fallen
    chain = [trajectory.shot.ids.index(str(number)) for number in (CUE_BALL, *fallen.chain)]
    places = []
    for moment in (time - LOOK_BACK_S, time, time + 0.5 * LOOK_AHEAD_S, time + LOOK_AHEAD_S):
        at = max(moment - act.hits, 0.0)
        places.append(trajectory.state_at(at).positions[chain])
    points = np.concatenate(places)
    table = trajectory.shot.table
    if time < act.hits:
        azimuth = act.round.stroke.azimuth
        white = trajectory.shot.positions[chain[0]]
        points = np.vstack((points, white - CUE_SHOWN * np.array((math.cos(azimuth), math.sin(azimuth)))))
    if time + LOOK_AHEAD_S > act.hits + potted_at(act.round):
        points = np.vstack((points, table.pockets[fallen.pocket, :2]))
    return points.min(axis=0) - MARGIN, points.max(axis=0) + MARGIN


def width_of(act: Act) -> float:
    """m of the table's length that a picture must show, so that all that matters of a round is in it."""
    widest = CLOSEST
    for time in np.arange(act.begins, act.hits + potted_at(act.round), EVERY_S).tolist():
        low, high = what_matters(act, time)
        widest = max(widest, high[1] - low[1], (high[0] - low[0]) * 16.0 / 9.0)
    return float(min(widest, WHOLE))
