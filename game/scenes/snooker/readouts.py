"""What the snooker table measures."""

from __future__ import annotations

import math

import numpy as np

from game.billiards.game.rules import CUE_BALL
from game.billiards.table.snooker import BALL_MASS
from game.physics.kernels import linear
from game.scenes.shared.tables.course import REPLAY, ROLLING
from game.scenes.snooker.course import Course
from game.stage import Readout


def readouts(course: Course) -> tuple[Readout, ...]:
    """Break, points left, energy (of motion along the cloth), speed of the cue ball, events, time of the
    shot.
    """
    game, played = course.model.game, course.model.played
    energy, speed, count, time = 0.0, 0.0, 0, 0.0
    if played is not None and course.phase in (ROLLING, REPLAY):
        time = float(course.clock[0])
        trajectory = played.trajectory
        moving = trajectory.state_at(min(time, trajectory.end_time)).velocities
        energy = float(0.5 * BALL_MASS * (moving * moving).sum())
        cue_ball = moving[course.model.numbers.index(CUE_BALL)]
        speed = math.sqrt(float(linear.product(cue_ball, cue_ball)))
        count = int(np.searchsorted(trajectory.times, time, side="right"))
    return (
        Readout("break", game.run),
        Readout("points left", game.points_left),
        Readout("energy", energy, "J"),
        Readout("cue ball", speed, "m/s"),
        Readout("events", count),
        Readout("shot", time, "s"),
    )
