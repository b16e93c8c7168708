"""The balls on their paths at a moment of a shot, in the air, falling, as they are drawn."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.billiards.game.frame import Frame
from game.billiards.laws.state import BALL_OFF, BALL_POCKET
from game.billiards.shot.trajectory import Trajectory
from game.scenes.shared.tables.view import Balls

FALL_S = 0.35  # s in which a ball drops out of sight


def balls_at(before: Frame, trajectory: Trajectory, turns_before: Floats, time: float) -> Balls:
    """The balls at a time of a shot, s. before: the frame from which it was played."""
    numbers = np.array(before.layout.numbers, dtype=np.int64)
    positions = trajectory.state_at(time).positions.copy()
    turns = trajectory.orientations_at(time, turns_before[numbers])
    opacities = np.ones(len(numbers))
    radii = before.layout.radii.copy()
    pockets = before.table.pockets
    for at, code, ball, hole in trajectory.rows.tolist():
        if int(code) not in (BALL_POCKET, BALL_OFF) or at > time:
            continue
        fallen = min((time - at) / FALL_S, 1.0)
        row = int(ball)
        opacities[row] = 1.0 - fallen
        radii[row] *= 1.0 - 0.2 * fallen
        if int(code) == BALL_OFF:
            continue
        positions[row] += min(2.0 * fallen, 1.0) * (pockets[int(hole), :2] - positions[row])
    return Balls(positions, radii, numbers, turns, opacities, trajectory.heights_at(time))
