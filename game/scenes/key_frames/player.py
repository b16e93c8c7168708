"""The time of the motion that is played: the second, its frames, and what comes at its end."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.scenes.key_frames.clock import folded, frame_of, held, phase_of
from game.scenes.key_frames.parameters import KeyFrameParameters
from game.stage.part import Part


class Player(Part):
    """Where in its second the motion is. clock (4,): see clock.py; its fourth number is whether it plays."""

    def __init__(self, parameters: KeyFrameParameters) -> None:
        self.parameters = parameters
        self.clock: Floats = np.array([parameters.time, 0.0, 0.0, float(parameters.playing)])

    @property
    def frames(self) -> float:
        """How many frames the second has."""
        return self.parameters.fps * self.parameters.duration

    def phase(self) -> float:
        """Where in the second playback is; more than 1 on the way back."""
        return phase_of(self.clock, self.parameters.repeat, self.parameters.duration)

    def present(self) -> float:
        """Time (s) on the slider."""
        return folded(self.phase())

    def frame(self) -> int:
        """Number of the frame that is shown."""
        return frame_of(self.phase(), self.frames)

    def shown_part(self) -> float:
        """The part of the second at which the box is shown: that of the frame while it plays."""
        return held(self.phase(), self.frames) if self.parameters.playing else self.present()

    def set_time(self, time: float) -> None:
        """Go to a time of the slider."""
        self.clock[:2] = time, 0.0
        self.clock[3] = float(self.parameters.playing)
        self.parameters.time = min(max(time, 0.0), 1.0)

    def pause_at(self, time: float) -> None:
        """Stand still at a time of the slider."""
        self.parameters.playing = False
        self.set_time(time)

    def begin_here(self) -> None:
        """Count the steps from the time of the slider on, as the second has another length or end."""
        self.clock[:2] = self.parameters.time, 0.0

    def follow_playing(self) -> None:
        """Play or pause, as the parameter says; from the beginning if it had come to its end."""
        playing = self.parameters.playing
        ended = playing and self.parameters.repeat == "once" and self.present() >= 1.0
        self.clock[:2] = 0.0 if ended else self.phase(), 0.0
        self.clock[3] = float(playing)

    def advance(self, dt: float) -> bool:
        """One step; False if the motion is paused."""
        if dt != self.clock[2]:
            self.clock[:3] = self.phase(), 0.0, dt
        if not self.parameters.playing:
            return False
        self.clock[1] += 1.0
        if self.parameters.repeat == "once" and self.phase() >= 1.0:
            self.clock[:2] = 1.0, 0.0
            self.parameters.playing = False
            self.clock[3] = 0.0
        self.parameters.time = self.present()
        return True

    def restore(self, clock: Floats) -> None:
        """Take over a clock."""
        self.clock[:] = clock
        self.parameters.playing = bool(clock[3])
        self.parameters.time = self.present()
