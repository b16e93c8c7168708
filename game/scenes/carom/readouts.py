"""What the carom table measures."""

from __future__ import annotations

import numpy as np

from game.billiards.laws.state import BALL_CUSHION
from game.billiards.table.carom import BALL_MASS
from game.scenes.carom.course import Course
from game.scenes.shared.tables.course import ROLLING
from game.stage import Readout


def readouts(course: Course) -> tuple[Readout, ...]:
    """Energy of the balls' flight, cushions of the cue ball, time of the shot, points and average."""
    played = course.model.played
    time = float(course.clock[0]) if course.phase == ROLLING else 0.0
    energy, cushions, speed = 0.0, 0, 0.0
    if played is not None and course.phase == ROLLING:
        moving = played.trajectory.state_at(min(time, played.trajectory.end_time)).velocities
        energy = float(0.5 * BALL_MASS * (moving * moving).sum())
        speed = float(np.sqrt((moving[0] * moving[0]).sum()))
        rows = played.trajectory.rows
        cushions = int(((rows[:, 0] <= time) & (rows[:, 1] == BALL_CUSHION) & (rows[:, 2] == 0)).sum())
    game = course.model.frame.game
    return (
        Readout("points", game.points[game.turn]),
        Readout("average", game.average(game.turn)),
        Readout("cushions", cushions),
        Readout("shot", time, "s"),
        Readout("energy", energy, "J"),
        Readout("cue ball", speed, "m/s"),
    )
