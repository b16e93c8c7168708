"""What is heard of a shot: the times of its impacts, and how fast the two close in on each other."""

from __future__ import annotations

import numpy as np

from game.billiards.laws.state import BALL_BALL, BALL_CUSHION, BALL_POCKET
from game.billiards.shot.trajectory import Trajectory

TOGETHER = 0.012  # s; impacts this close are one to the ear
AUDIBLE = 0.12  # m/s; slower impacts are not heard


def heard_impacts(trajectory: Trajectory, last: float) -> tuple[float, ...]:
    """Times (s) of the impacts that are heard until a little after ``last``, the stroke's (0) among them.

    Of those within TOGETHER the first counts.
    """
    times = [0.0]
    for time, code, i, j in trajectory.rows.tolist():
        if code > BALL_POCKET or time > last + TOGETHER or time - times[-1] < TOGETHER:
            continue
        if code == BALL_POCKET or closing_speed(trajectory, time, int(code), int(i), int(j)) > AUDIBLE:
            times.append(time)
    return tuple(times)


def closing_speed(trajectory: Trajectory, time: float, code: int, i: int, j: int) -> float:
    """Speed (m/s) at which ball i and what it meets close in on each other just before an impact.

    code: the type of the event, as `state` has them; at a jaw or a pocket the ball's own speed.
    """
    state = trajectory.state_at(max(time - 1e-7, 0.0))
    velocity = state.velocities[i]
    if code == BALL_BALL:
        away = state.positions[j] - state.positions[i]
        return float((velocity - state.velocities[j]) @ away / max(float(np.hypot(*away)), 1e-9))
    if code == BALL_CUSHION:
        return float(-velocity @ trajectory.shot.table.cushions[j, 4:6])
    return float(np.hypot(*velocity))
