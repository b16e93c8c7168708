"""What scenes that are heard have in common."""

from __future__ import annotations

from game.billiards.laws.state import BALL_BALL, BALL_CUSHION, BALL_JAW, BALL_POCKET
from game.billiards.shot.trajectory import Trajectory
from game.scenes.shared.tables.paths import Paths
from game.stage import Sound

REMEMBERED_S = 0.4  # s that an impact stays in a line of sounds: more than the longest gap that is heard


def pan_of(y: float, length: float) -> float:
    """Left (-1) to right (1) across the window of a place ``y`` m along a table that lies on its side."""
    return max(-1.0, min(1.0, 1.6 * (y / length - 0.5)))


KINDS = {BALL_BALL: "ball", BALL_CUSHION: "cushion", BALL_JAW: "cushion", BALL_POCKET: "pocket"}
QUIETEST = 0.05  # m/s; what meets more slowly is not heard


def sounds_of(trajectory: Trajectory, cue_speed: float, cue: str = "0") -> tuple[Sound, ...]:
    """The sounds of a shot in order of time; speeds are those at which the two close in on each other.

    cue: name of the ball that is struck, at cue_speed m/s.
    """
    length = trajectory.shot.table.length
    cue_ball = trajectory.shot.positions[trajectory.shot.ids.index(cue)]
    sounds = [Sound(0.0, "tip", cue_speed, pan_of(float(cue_ball[1]), length))]
    paths = Paths(trajectory)
    for time, code, i, j in trajectory.rows.tolist():
        kind = KINDS.get(int(code))
        if kind is None:
            continue
        (x, y), (vx, vy) = paths.arriving(int(i), time)
        if kind == "ball":
            (ox, oy), (wx, wy) = paths.arriving(int(j), time)
            dx, dy = ox - x, oy - y
            speed = ((vx - wx) * dx + (vy - wy) * dy) / max((dx * dx + dy * dy) ** 0.5, 1e-9)
        elif kind == "cushion" and int(code) == BALL_CUSHION:
            nx, ny = trajectory.shot.table.cushions[int(j), 4:6].tolist()
            speed = -(vx * nx + vy * ny)
        else:
            speed = (vx * vx + vy * vy) ** 0.5
        if kind == "pocket":
            speed = max(speed, 0.5)  # it falls in, however slowly it came
        if speed > QUIETEST:
            sounds.append(Sound(time, kind, speed, pan_of(y, length)))
    return tuple(sounds)
