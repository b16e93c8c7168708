"""The fixed-step clock: real time in, whole steps out (Fiedler 2004, "Fix your timestep").

Time that is too much for one frame is dropped and counted, so a slow step cannot ask for ever more steps.
Simulated time is an integer number of steps, never a running sum.
"""

from __future__ import annotations

import math


def checked_dt(dt: float) -> float:
    """The length of a step, s; ValueError unless it is a finite number above 0."""
    if isinstance(dt, bool) or not isinstance(dt, (int, float)) or not (math.isfinite(dt) and dt > 0.0):
        raise ValueError(f"dt = {dt!r}: expected a finite number above 0 s")
    return float(dt)


class FixedStep:
    """Accumulates elapsed time and hands out steps of ``dt``.

    ``dt``: s, above 0. ``max_steps``: the most that one frame may ask for, at least 1. ValueError for other
    numbers.
    """

    def __init__(self, dt: float, max_steps: int = 15):
        if isinstance(max_steps, bool) or not isinstance(max_steps, int) or max_steps < 1:
            raise ValueError(f"max_steps = {max_steps!r}: expected a whole number of at least 1")
        self.dt = checked_dt(dt)
        self.max_steps = max_steps
        self.steps = 0
        self.dropped_s = 0.0
        self._accumulated_s = 0.0

    @property
    def alpha(self) -> float:
        """How far the picture is between the last two states, in [0, 1)."""
        return min(self._accumulated_s / self.dt, 1.0 - 2.0**-53)

    @property
    def time_s(self) -> float:
        """Simulated time: steps times dt."""
        return self.steps * self.dt

    def advance(self, elapsed_s: float) -> int:
        """Steps due after ``elapsed_s`` more seconds; a clock set back counts as no time at all.

        Raises ValueError if ``elapsed_s`` is not a number; infinity is clamped like any long hitch.
        """
        if math.isnan(elapsed_s):
            raise ValueError("elapsed_s is not a number")
        self._accumulated_s += max(elapsed_s, 0.0)
        whole = self._accumulated_s / self.dt
        if whole >= self.max_steps + 1:
            kept = self.max_steps * self.dt
            if math.isfinite(whole):
                kept += math.fmod(self._accumulated_s, self.dt)
            self.dropped_s += self._accumulated_s - kept
            self._accumulated_s = kept
        due = min(int(self._accumulated_s / self.dt), self.max_steps)
        self._accumulated_s = max(self._accumulated_s - due * self.dt, 0.0)
        self.steps += due
        return due

    def change_dt(self, dt: float) -> None:
        """Take steps of another length from now on; what has gathered counts towards the next one.

        ValueError as in the constructor.
        """
        self.dt = checked_dt(dt)
        self._accumulated_s = min(self._accumulated_s, math.nextafter(self.dt, 0.0))

    def hold(self) -> None:
        """Forget the part of a step that has gathered: the picture shows the newest state."""
        self._accumulated_s = 0.0
