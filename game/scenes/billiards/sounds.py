"""What is to be heard of a stroke: tip, balls, cushions and pockets, as loud as they meet."""

from __future__ import annotations

from game.billiards.game.frame import Struck
from game.billiards.laws.state import (
    BALL_BALL,
    BALL_CUSHION,
    BALL_JAW,
    BALL_POCKET,
)
from game.billiards.shot.trajectory import Trajectory
from game.scenes.billiards.modes import Replay
from game.scenes.billiards.play import PHASE_S, REPLAY, ROLLING, Play
from game.scenes.billiards.stroke.paths import Paths
from game.scenes.shared.tables.sounds import pan_of
from game.stage import Hearing, Sound

KINDS = {BALL_BALL: "ball", BALL_CUSHION: "cushion", BALL_JAW: "cushion", BALL_POCKET: "pocket"}
QUIETEST = 0.05  # m/s; what meets more slowly is not heard


def sounds_of(trajectory: Trajectory, cue_speed: float) -> tuple[Sound, ...]:
    """The sounds of a shot in order of time; speeds are those at which the two close in on each other."""
    length = trajectory.shot.table.length
    cue_ball = trajectory.shot.positions[trajectory.shot.ids.index("0")]
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


class StrokeSounds:
    """The sounds of the last stroke, made when they are asked for; no part of the state."""

    def __init__(self, play: Play, replay: Replay) -> None:
        self.play = play
        self.replay = replay
        self._of: Struck | None = None
        self._sounds: tuple[Sound, ...] = ()

    @property
    def sounds(self) -> tuple[Sound, ...]:
        """What is to be heard of the last stroke."""
        last = self.play.model.frame.last
        if self._of is not last:
            played = self.play.model.played
            self._sounds = sounds_of(played.trajectory, last.stroke.cue_speed) if last and played else ()
            self._of = last
        return self._sounds

    def hearing(self) -> Hearing | None:
        """The line of sounds of the shot that rolls or is replayed, and the moment in it."""
        play, frame = self.play, self.play.model.frame
        if play.phase not in (ROLLING, REPLAY) or frame.last is None or play.model.played is None:
            return None
        again = play.phase == REPLAY
        if again and (not self.replay.runs or self.replay.speed < 0.5):
            return None  # sounds are not slowed down
        time = self.replay.time if again else float(play.clock[PHASE_S])
        return Hearing((play.phase, frame.strokes, id(frame.last)), time, self.sounds)
