"""The sounds of a shot, and the line of them that a course plays."""

from __future__ import annotations

from collections.abc import Callable, Collection
from typing import Any

from game.billiards.laws import state as s
from game.billiards.shot.impacts import heard_impacts
from game.billiards.shot.trajectory import Trajectory
from game.scenes.shared.tables.course import CueCourse
from game.stage import Hearing, Sound


def pan_of(y: float, length: float) -> float:
    """Left (-1) to right (1) across the window of a place ``y`` m along a table that lies on its side."""
    return max(-1.0, min(1.0, 1.6 * (y / length - 0.5)))


KINDS = {s.BALL_BALL: "ball", s.BALL_CUSHION: "cushion", s.BALL_JAW: "cushion", s.BALL_POCKET: "pocket",
         s.BALL_SLATE: "thud", s.BALL_RAIL_TOP: "wood"}  # fmt: skip


def sounds_of(
    trajectory: Trajectory, cue_speed: float, cue: str = "0", slipped: bool = False
) -> tuple[Sound, ...]:
    """The sounds of a shot in order of time; speeds are those at which the two close in on each other.

    cue: name of the ball that is struck, at cue_speed m/s; slipped: the tip did not hold.
    """
    length = trajectory.shot.table.length
    cue_ball = trajectory.shot.positions[trajectory.shot.ids.index(cue)]
    tip = Sound(0.0, "miscue" if slipped else "tip", cue_speed, pan_of(float(cue_ball[1]), length))
    return (
        tip,
        *(
            Sound(one.time, KINDS[one.code], one.speed, pan_of(one.place[1], length))
            for one in heard_impacts(trajectory)
        ),
    )


class StrokeSounds:
    """The sounds of the last stroke, made when they are asked for; no part of the state.

    phases: in which it is heard. cue_of: name of the ball that was struck, from the stroke.
    """

    def __init__(
        self, course: CueCourse, phases: Collection[str], cue_of: Callable[[Any], str] = lambda struck: "0"
    ) -> None:
        self.course = course
        self.phases = phases
        self.cue_of = cue_of
        self._of: Any = None
        self._sounds: tuple[Sound, ...] = ()

    def hearing(self) -> Hearing | None:
        """The line of sounds of the shot that rolls or is replayed, and the moment in it."""
        course, frame = self.course, self.course.model.frame
        played = course.model.played
        if course.phase not in self.phases or frame.last is None or played is None:
            return None
        if self._of is not frame.last:
            struck = frame.last
            slipped = course.push.slipped and struck.stroke == course.made
            self._sounds = sounds_of(played.trajectory, struck.stroke.cue_speed, self.cue_of(struck), slipped)
            self._of = struck
        key = (course.phase, frame.strokes, id(frame.last))
        return Hearing(key, float(course.clock[0]), self._sounds)
