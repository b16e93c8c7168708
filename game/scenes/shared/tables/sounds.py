"""What scenes that are heard have in common."""

from __future__ import annotations

from game.billiards.laws import state as s
from game.billiards.shot.impacts import heard_impacts
from game.billiards.shot.trajectory import Trajectory
from game.stage import Sound


def pan_of(y: float, length: float) -> float:
    """Left (-1) to right (1) across the window of a place ``y`` m along a table that lies on its side."""
    return max(-1.0, min(1.0, 1.6 * (y / length - 0.5)))


KINDS = {s.BALL_BALL: "ball", s.BALL_CUSHION: "cushion", s.BALL_JAW: "cushion", s.BALL_POCKET: "pocket",
         s.BALL_SLATE: "thud", s.BALL_RAIL_TOP: "wood"}  # fmt: skip


def sounds_of(trajectory: Trajectory, cue_speed: float, cue: str = "0") -> tuple[Sound, ...]:
    """The sounds of a shot in order of time; speeds are those at which the two close in on each other.

    cue: name of the ball that is struck, at cue_speed m/s.
    """
    length = trajectory.shot.table.length
    cue_ball = trajectory.shot.positions[trajectory.shot.ids.index(cue)]
    tip = Sound(0.0, "tip", cue_speed, pan_of(float(cue_ball[1]), length))
    return (
        tip,
        *(
            Sound(one.time, KINDS[one.code], one.speed, pan_of(one.place[1], length))
            for one in heard_impacts(trajectory)
        ),
    )
