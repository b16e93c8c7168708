"""The moments of a stroke that are worth a second look, known as soon as it has been computed.

When the balls meet, which ball decides, when it drops, or hangs over a pocket and stays out.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.billiards.laws.state import BALL_BALL, BALL_POCKET, IN_RADIUS
from game.billiards.shot.trajectory import Trajectory

OFF, PERSPECTIVE = "off", "perspective"  # a camera that follows the ball that decides
SAMPLES = 96  # of a path
HANGS = 1.25  # radii of the ball beyond a pocket's, from which on it is not near it any more
SLOW = 0.2  # of the pace
BEFORE_S, AFTER_S = 0.10, 0.22  # s about a moment that are seen slowly
EASE_S = 0.12  # s in which the pace changes


class Moments(NamedTuple):
    """Of a stroke. ball: row of the one that decides: the last to drop, else the first that is met, else the
    cue ball. contact: when the cue ball first meets a ball, s; drop: when the deciding ball drops; hangs:
    when it is nearest to a pocket that it misses by little. None where there is no such.
    """

    ball: int
    contact: float | None = None
    drop: float | None = None
    hangs: float | None = None

    @property
    def times(self) -> tuple[float, ...]:
        """All of them, s."""
        return tuple(time for time in (self.contact, self.drop, self.hangs) if time is not None)


def moments_of(trajectory: Trajectory, cue: int) -> Moments:
    """The moments of a stroke with the ball of row ``cue``."""
    rows = trajectory.rows.tolist()
    met = next((row for row in rows if row[1] == BALL_BALL and cue in (int(row[2]), int(row[3]))), None)
    drops = [(time, int(ball)) for time, code, ball, _ in rows if code == BALL_POCKET and int(ball) != cue]
    contact = float(met[0]) if met is not None else None
    if drops:
        return Moments(drops[-1][1], contact, float(drops[-1][0]))
    if met is None:
        return Moments(cue)
    ball = int(met[3] if int(met[2]) == cue else met[2])
    return Moments(ball, contact, None, _hangs(trajectory, ball, float(met[0])))


def decider(moments: Moments | None, over: bool) -> Moments:
    """The moments that keep one waiting while balls roll: the drop that ends the game, a ball that hangs."""
    if moments is None:
        return Moments(0)
    return moments._replace(contact=None, drop=moments.drop if over else None)


def _hangs(trajectory: Trajectory, ball: int, since: float) -> float | None:
    """When a ball that is not potted is nearest to a pocket, if that is near; s."""
    pockets = trajectory.shot.table.pockets
    if len(pockets) == 0:
        return None
    times, places = path_of(trajectory, ball, since, trajectory.end_time)
    away = places[:, None, :] - pockets[None, :, :2]
    beyond = np.sqrt((away * away).sum(axis=2)) - pockets[None, :, 2]
    nearest = beyond.min(axis=1)
    best = int(nearest.argmin())
    radius = float(trajectory.shot.balls[ball, IN_RADIUS])
    return float(times[best]) if nearest[best] < HANGS * radius else None


def path_of(trajectory: Trajectory, ball: int, begin: float, end: float) -> tuple[Floats, Floats]:
    """Times (SAMPLES,) s from begin to end, and where a ball then is (SAMPLES, 2) m."""
    times = np.linspace(begin, max(end, begin), SAMPLES)
    return times, np.array([trajectory.state_at(float(time)).positions[ball] for time in times])


def slowed_s(moments: int) -> float:
    """How much longer a stroke takes that is slowed down about so many moments, at most, s."""
    return moments * (BEFORE_S + AFTER_S + 2.0 * EASE_S) * (1.0 / SLOW - 1.0)


def pace_at(time: float, moments: Moments) -> float:
    """How fast a replay goes on at a time of the stroke, s: slowly about each moment."""
    pace = 1.0
    for moment in moments.times:
        outside = max(moment - BEFORE_S - time, time - moment - AFTER_S, 0.0)
        pace = min(pace, SLOW + (1.0 - SLOW) * min(outside / EASE_S, 1.0))
    return pace
