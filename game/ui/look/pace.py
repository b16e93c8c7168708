"""How fast a scene really runs, where steps or pictures take too long for the speed that is asked for."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from game.stage import Stage

WINDOW_S = 1.0  # of real time over which it is measured, at least
WINDOW_STEPS = 10  # of the scene, at least: time goes on by whole steps
SHORT = 0.1  # of the speed asked for: what is missing counts from here on


class Pace:
    """Compares simulated with real time. ``speed``: what is reached, in simulated seconds for each real one,
    or None while the speed that was asked for is held."""

    def __init__(self) -> None:
        self.speed: float | None = None
        self._asked = 0.0
        self._real_s = 0.0
        self._begin_s = self._last_s = 0.0  # simulated time at the window's begin, and at the last look

    def pass_time(self, real_s: float, stage: Stage) -> None:
        """Let real time pass. A pause, another speed and a jump in time begin again."""
        still = stage.paused or stage.fault is not None
        if still or stage.speed != self._asked or stage.time_s < self._last_s:
            self.speed = None
            self._begin(stage)
            return
        self._last_s = stage.time_s
        self._real_s += real_s
        if self._real_s < max(WINDOW_S, WINDOW_STEPS * stage.dt / stage.speed):
            return
        made, asked = stage.time_s - self._begin_s, stage.speed * self._real_s
        self.speed = made / self._real_s if asked - made > SHORT * asked + stage.dt else None
        self._begin(stage)

    def _begin(self, stage: Stage) -> None:
        """Measure from now on."""
        self._asked, self._real_s = stage.speed, 0.0
        self._begin_s = self._last_s = stage.time_s
