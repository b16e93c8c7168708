"""A motion that is played: the second, its frames, what comes at its end, and where the box is by then."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from game.scenes.key_frames.clock import REPEATS, folded, held, phase_of
from game.scenes.key_frames.document import NOTHING, MotionScene
from game.stage import Choice, Param, Toggle

Array = NDArray[np.float64]


class PlayedScene(MotionScene):
    """Base of the key-framing scene: time goes on, and the box with it.

    clock: see c01_clock. pose: of the box, x, y m, angle rad.
    """

    clock: Array
    pose: Array

    time = Param(
        0.0, 0.0, 1.0, unit="s", step=0.001, group="Time", help="where in the second the box is shown"
    )
    fps = Param(
        60, 1, 240, unit="1/s", whole=True, group="Time", label="Frames per second",
        help="how often playback looks at the curve",
    )  # fmt: skip
    duration = Param(
        3.0, 0.25, 30.0, unit="s", log=True, group="Time", label="The second lasts", help="1 s is real time"
    )
    repeat = Choice(
        "loop", REPEATS, labels=("Again", "Once", "Back"), group="Time",
        label="At the end",
    )  # fmt: skip
    playing = Toggle(True, group="Time", label="Play")

    def phase(self) -> float:
        """Where in the second playback is; more than 1 on the way back."""
        return phase_of(self.clock, self.repeat, self.duration)

    def present(self) -> float:
        """Time (s) on the slider."""
        return folded(self.phase())

    def shown_part(self) -> float:
        """The part of the second at which the box is shown: that of the frame while it plays."""
        if not self.playing:
            return self.present()
        return held(self.phase(), self.fps * self.duration)

    def place_box(self) -> None:
        """Put the box where it is at the present time, or where the key in the hand is."""
        what, index = self.hand
        if what in ("key", "turn") and 0 <= index < len(self.motion.keys):
            key = self.motion.keys[index]
            self.pose[:] = (*key.position, math.radians(key.angle))
        else:
            self.pose[:] = self.animation().pose(self.shown_part())

    def set_time(self, time: float) -> None:
        """Go to a time of the slider."""
        self.clock[:2] = time, 0.0
        self.clock[3] = float(self.playing)
        self.values["time"] = min(max(time, 0.0), 1.0)

    def advance(self, dt: float) -> None:
        if not self.playing or self.hand != NOTHING:
            return
        if dt != self.clock[2]:
            self.clock[:3] = self.phase(), 0.0, dt
        self.clock[1] += 1.0
        if self.repeat == "once" and self.phase() >= 1.0:
            self.clock[:2] = 1.0, 0.0
            self.values["playing"] = False
            self.clock[3] = 0.0
        self.values["time"] = self.present()
        self.place_box()
