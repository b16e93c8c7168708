"""What is to be heard of a stroke: tip, balls, cushions and pockets, as loud as they meet."""

from __future__ import annotations

from typing import TYPE_CHECKING

from game.billiards.laws.state import (
    BALL_BALL,
    BALL_CUSHION,
    BALL_JAW,
    BALL_POCKET,
)
from game.billiards.shot.trajectory import Trajectory
from game.scenes.billiards.paths import Ways
from game.scenes.shared.tables.sounds import pan_of
from game.stage import Hearing, Sound

if TYPE_CHECKING:
    from game.scenes.billiards.scene import Billiards

KINDS = {BALL_BALL: "ball", BALL_CUSHION: "cushion", BALL_JAW: "cushion", BALL_POCKET: "pocket"}
QUIETEST = 0.05  # m/s; what meets more slowly is not heard


def sounds_of(trajectory: Trajectory, cue_speed: float) -> tuple[Sound, ...]:
    """The sounds of a shot in order of time; speeds are those at which the two close in on each other."""
    length = trajectory.shot.table.length
    white = trajectory.shot.positions[trajectory.shot.ids.index("0")]
    sounds = [Sound(0.0, "tip", cue_speed, pan_of(float(white[1]), length))]
    ways = Ways(trajectory)
    for time, code, i, j in trajectory.rows.tolist():
        kind = KINDS.get(int(code))
        if kind is None:
            continue
        (x, y), (vx, vy) = ways.arriving(int(i), time)
        if kind == "ball":
            (ox, oy), (wx, wy) = ways.arriving(int(j), time)
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


def hearing_of(scene: Billiards) -> Hearing | None:
    """The line of sounds of the shot that rolls or is replayed, and the moment in it."""
    last = scene.round.last
    if scene.phase not in ("rolling", "replay") or last is None or scene.played is None:
        return None
    replay = scene.phase == "replay"
    if replay and (not scene.replay_runs or scene.replay_speed < 0.5):
        return None  # sounds are not slowed down
    time = float(scene.clock[1 if replay else 0])
    return Hearing((scene.phase, scene.round.strokes, id(last)), time, scene.sounds)
