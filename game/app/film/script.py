"""What happens when in the film of a match: title, rounds, end; and where the camera looks, by key-frames."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.billiards.game.rules import CUE_BALL
from game.billiards.laws.state import BALL_POCKET
from game.billiards.players.match import Match, Round
from game.physics.animation import Keyframes
from game.scenes.billiards.stroke.motion import StrokeMotion, stroke_motion

Array = NDArray[np.float64]

TITLE_S, END_S = 4.0, 5.0
BEFORE_S, AFTER_S = 0.5, 0.9  # s of rest before and after each round
LEAST_S = 60.0  # s that a film lasts
EVERY_S = 0.4  # s between two keys of the camera
LOOK_AHEAD_S, LOOK_BACK_S = 0.9, 0.3
CUE_SHOWN = 0.5  # m of the cue that are seen before the hit
CLOSEST = 1.5  # m, of the table's length that is in view at least
MARGIN = 0.22  # m round what matters
WHOLE = 3.0  # m of length, and the middle of the table: the whole of it


class Act(NamedTuple):
    """One round in the film: when it begins, when the tip meets the ball, when it ends, s."""

    round: Round
    begins: float
    hits: float
    ends: float
    motion: StrokeMotion


class Script(NamedTuple):
    """The whole film. camera: x, y m of what is in its middle, and the length m in view, over time."""

    acts: tuple[Act, ...]
    camera: Keyframes
    length: float

    def act_at(self, time: float) -> Act | None:
        """The round that is on at a moment; None during title and end."""
        for act in self.acts:
            if act.begins <= time < act.ends:
                return act
        return None


def write_script(match: Match) -> Script:
    """The film of a match; short matches rest a little longer between rounds."""
    spare = LEAST_S - TITLE_S - END_S - match.playing_time - 2.5 * len(match.rounds)
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
    length = time + END_S
    return Script(tuple(acts), camera_of(tuple(acts), length), length)


def camera_of(acts: tuple[Act, ...], length: float) -> Keyframes:
    """The camera's track: the whole table between rounds, what matters during them."""
    times, views = [0.0], [_whole(acts)]
    for act in acts:
        times.append(act.begins)
        views.append(_whole(acts))
        start = act.begins + 0.4 * (act.hits - act.begins)
        stop = act.hits + potted_at(act.round) + 0.3
        for time in np.arange(start, stop, EVERY_S).tolist():
            times.append(time)
            views.append(_framed(act, time))
        times += [min(stop + 1.2, act.ends), act.ends]
        views += [_whole(acts)] * 2
    times.append(length)
    views.append(_whole(acts))
    return Keyframes(times, views, "monotone")


def potted_at(one: Round) -> float:
    """When the ball of a round falls, s after the hit."""
    row = one.trajectory.shot.ids.index(str(one.fallen.ball))
    for time, code, ball, _ in one.trajectory.rows.tolist():
        if int(code) == BALL_POCKET and int(ball) == row:
            return float(time)
    return one.trajectory.end_time


def _whole(acts: tuple[Act, ...]) -> tuple[float, float, float]:
    if not acts:
        return 0.635, 1.27, WHOLE
    table = acts[0].round.shot.table
    return 0.5 * table.width, 0.5 * table.length, WHOLE


def _framed(act: Act, time: float) -> tuple[float, float, float]:
    """What matters about a moment: the balls of the chain that move or soon will, and then the pocket."""
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
    low, high = points.min(axis=0) - MARGIN, points.max(axis=0) + MARGIN
    length = max(CLOSEST, high[1] - low[1], (high[0] - low[0]) * 16.0 / 9.0)
    length = min(length, WHOLE)
    x, y = 0.5 * (low + high)
    share = (WHOLE - length) / WHOLE  # the wider the view, the nearer its middle stays to the table's
    middle = 0.5 * table.width, 0.5 * table.length
    reach_x, reach_y = 0.5 * share * table.width, 0.5 * share * table.length
    return (
        float(np.clip(x, middle[0] - reach_x, middle[0] + reach_x)),
        float(np.clip(y, middle[1] - reach_y, middle[1] + reach_y)),
        float(length),
    )
