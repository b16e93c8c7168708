"""What is to be heard of a stroke at snooker."""

from __future__ import annotations

from game.billiards.game.frame import Struck
from game.scenes.shared.tables.course import ROLLING
from game.scenes.shared.tables.sounds import sounds_of
from game.scenes.snooker.course import REPLAY, Course
from game.stage import Hearing, Sound


class SnookerSounds:
    """The sounds of the last stroke, made when they are asked for; no part of the state."""

    def __init__(self, course: Course) -> None:
        self.course = course
        self._of: Struck | None = None
        self._sounds: tuple[Sound, ...] = ()

    def hearing(self) -> Hearing | None:
        """The line of sounds of the shot that rolls or is replayed, and the moment in it."""
        course, frame = self.course, self.course.model.frame
        played = course.model.played
        if course.phase not in (ROLLING, REPLAY) or frame.last is None or played is None:
            return None
        if self._of is not frame.last:
            self._sounds = sounds_of(played.trajectory, frame.last.stroke.cue_speed)
            self._of = frame.last
        key = (course.phase, frame.strokes, id(frame.last))
        return Hearing(key, float(course.clock[0]), self._sounds)
