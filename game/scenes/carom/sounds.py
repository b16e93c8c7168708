"""What is to be heard of a stroke at carom."""

from __future__ import annotations

from game.billiards.game.carom_frame import CaromStruck
from game.billiards.table.carom import BALL_NAMES
from game.scenes.carom.course import Course
from game.scenes.shared.tables.course import ROLLING
from game.scenes.shared.tables.sounds import sounds_of
from game.stage import Hearing, Sound


class CaromSounds:
    """The sounds of the last stroke, made when they are asked for; no part of the state."""

    def __init__(self, course: Course) -> None:
        self.course = course
        self._of: CaromStruck | None = None
        self._sounds: tuple[Sound, ...] = ()

    def hearing(self) -> Hearing | None:
        """The line of sounds of the shot that rolls, and the moment in it."""
        course, frame = self.course, self.course.model.frame
        played = course.model.played
        if course.phase != ROLLING or frame.last is None or played is None:
            return None
        if self._of is not frame.last:
            cue = BALL_NAMES[frame.last.frame.game.cue]
            self._sounds = sounds_of(played.trajectory, frame.last.stroke.cue_speed, cue)
            self._of = frame.last
        return Hearing((frame.strokes, id(frame.last)), float(course.clock[0]), self._sounds)
