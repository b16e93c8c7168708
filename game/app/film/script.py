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
WHOLE = 3.2  # m of length, and the middle of the table: the whole of it, and the cue that lies beside it
ASPECT = 1280.0 / 656.0  # width to height of what the camera shows: the row of words is below it
SLOW, SLOW_FROM_S = 4.0, 0.35  # the deciding ball falls so many times slower, from s before it is down
SLOW_CLOSEST = 0.8  # m of length in view then


class Act(NamedTuple):
    """One round in the film: when it begins, when the tip meets the ball, when it ends, s.

    decides: the match; its ball falls in slow motion.
    """

    round: Round
    begins: float
    hits: float
    ends: float
    motion: StrokeMotion
    decides: bool = False

    @property
    def slow_from(self) -> float:
        """From when on the shot is slower, s after the hit; inf: never."""
        return max(potted_at(self.round) - SLOW_FROM_S, 0.0) if self.decides else math.inf

    def shot_time(self, time: float) -> float:
        """The time of the shot, s after the hit, that is seen at a moment of the film."""
        since = time - self.hits
        slow = self.slow_from
        if since <= slow:
            return since
        return max(slow + (since - slow) / SLOW, since - (potted_at(self.round) - slow) * (SLOW - 1.0))

    def film_time(self, since: float) -> float:
        """The moment of the film at which a time of the shot, s after the hit, is seen."""
        slowed = max(min(since, potted_at(self.round)) - self.slow_from, 0.0)
        return self.hits + since + slowed * (SLOW - 1.0)

    @property
    def potted(self) -> float:
        """The moment of the film at which its ball falls."""
        return self.film_time(potted_at(self.round))


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
        act = Act(one, time, hits, math.inf, motion, decides=one is match.rounds[-1])
        time = act.film_time(rolls) + AFTER_S + rest
        acts.append(act._replace(ends=time))
    length = time + END_S
    return Script(tuple(acts), camera_of(tuple(acts), length), length)


def camera_of(acts: tuple[Act, ...], length: float) -> Keyframes:
    """The camera's track: the whole table between rounds, what matters during them."""
    times, views = [0.0], [_whole(acts)]
    for act in acts:
        times.append(act.begins)
        views.append(_whole(acts))
        start = act.begins + 0.4 * (act.hits - act.begins)
        stop = act.potted + 0.3
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
        at = max(act.shot_time(moment), 0.0)
        places.append(trajectory.state_at(at).positions[chain])
    points = np.concatenate(places)
    table = trajectory.shot.table
    if time < act.hits:
        azimuth = act.round.stroke.azimuth
        white = trajectory.shot.positions[chain[0]]
        points = np.vstack((points, white - CUE_SHOWN * np.array((math.cos(azimuth), math.sin(azimuth)))))
    if time + LOOK_AHEAD_S > act.potted:
        points = np.vstack((points, table.pockets[fallen.pocket, :2]))
    low, high = points.min(axis=0) - MARGIN, points.max(axis=0) + MARGIN
    slow = time - act.hits > act.slow_from and time < act.potted + LOOK_BACK_S
    closest = SLOW_CLOSEST if slow else CLOSEST
    length = max(closest, high[1] - low[1], (high[0] - low[0]) * ASPECT)
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
