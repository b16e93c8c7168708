"""The impacts of a played shot, and how fast the two close in on each other: what is heard of it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

from game.billiards.laws import state as s
from game.billiards.shot.paths import Paths
from game.billiards.shot.trajectory import Trajectory

QUIETEST = 0.05  # m/s; what meets more slowly is not heard
LANDINGS = (s.BALL_SLATE, s.BALL_RAIL_TOP)
FALL = 0.5  # m/s; a ball falls into a pocket with at least this, however slowly it came


class Impact(NamedTuple):
    """A ball against another, a cushion, a jaw, a pocket, or the slate; code: of the event, as in `state`."""

    time: float  # s
    code: int
    ball: int  # row
    speed: float  # m/s at which the two close in; at a jaw the ball's own
    place: tuple[float, float]  # m, of the ball


def arriving_falls(trajectory: Trajectory, paths: Paths, ball: int, time: float) -> float:
    """Vertical speed, m/s, upwards, of a ball on the stretch that ends at a time; at time 0 of the stroke."""
    if time == 0.0:
        return float(trajectory.shot.balls[ball, s.IN_VZ])
    row = paths.stretch(ball, time)
    return float(row[s.SEG_VZ]) - trajectory.shot.physics.gravity * (time - float(row[s.SEG_TIME]))


def heard_impacts(trajectory: Trajectory) -> Iterator[Impact]:
    """All impacts of a shot that are heard, in order of time."""
    paths = Paths(trajectory)
    for time, code, i, j in trajectory.rows.tolist():
        if code > s.BALL_POCKET and code not in LANDINGS:
            continue
        (x, y), (vx, vy) = paths.arriving(int(i), time)
        if code == s.BALL_BALL:
            (ox, oy), (wx, wy) = paths.arriving(int(j), time)
            dx, dy = ox - x, oy - y
            speed = ((vx - wx) * dx + (vy - wy) * dy) / max(math.sqrt(dx * dx + dy * dy), 1e-9)
        elif code == s.BALL_CUSHION:
            nx, ny = trajectory.shot.table.cushions[int(j), 4:6].tolist()
            speed = -(vx * nx + vy * ny)
        elif code in LANDINGS:
            speed = -arriving_falls(trajectory, paths, int(i), time)
        else:
            speed = math.sqrt(vx * vx + vy * vy)
        if code == s.BALL_POCKET:
            speed = max(speed, FALL)
        if speed > QUIETEST:
            yield Impact(time, int(code), int(i), speed, (x, y))
