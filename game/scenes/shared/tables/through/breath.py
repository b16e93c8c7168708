"""The sway of an aim, and the breath that steadies it for a few seconds."""

from __future__ import annotations

import math
from typing import Any

from game.physics.kernels import elementary
from game.stage import Part

WAVES_HZ = (0.31, 0.73, 1.87)  # no two in a simple ratio: the sway does not repeat itself
SHARES = (0.64, 0.6, 0.48)  # their squares have the sum 1
HELD_S, TIRED_S = 4.0, 5.0  # s that a breath lasts, and until the next one
STEADIED, SHORT_OF_BREATH = 0.2, 1.4  # times the sway
SETTLED = 1e-3  # of the sway, by which it is as it was
SETTLES_S = 0.25  # s, time constant of the change


class Breath(Part):
    """left_s: of the breath; below 0, what is missing until the next. calm: times the sway."""

    def __init__(self, parameters: Any) -> None:
        self.parameters = parameters
        self.left_s = 0.0
        self.calm = 1.0

    @property
    def holding(self) -> bool:
        """True while a breath is held."""
        return self.left_s > 0.0

    def hold(self) -> bool:
        """Hold the breath; False if it must come back first, or is held."""
        if self.left_s != 0.0:
            return False
        self.left_s = HELD_S
        return True

    @property
    def stirs(self) -> bool:
        """True while time changes it."""
        return self.left_s != 0.0 or self.calm != 1.0

    def advance(self, dt: float) -> None:
        """One step of time."""
        if self.left_s > 0.0:
            self.left_s -= dt
            if self.left_s <= 0.0:
                self.left_s = -TIRED_S
        elif self.left_s < 0.0:
            self.left_s = min(self.left_s + dt, 0.0)
        aimed = STEADIED if self.left_s > 0.0 else SHORT_OF_BREATH if self.left_s < 0.0 else 1.0
        self.calm += (aimed - self.calm) * min(dt / SETTLES_S, 1.0)
        if self.left_s == 0.0 and abs(self.calm - 1.0) < SETTLED:
            self.calm = 1.0

    @property
    def size(self) -> float:
        """Standard deviation of the sway now, rad."""
        return math.radians(float(self.parameters.sway)) * self.calm

    def sway_at(self, clock_s: float) -> float:
        """How far the cue points beside the aim at a time, s: rad, left positive."""
        waves = zip(WAVES_HZ, SHARES, strict=True)
        return (
            math.sqrt(2.0)
            * self.size
            * sum(share * elementary.sin(math.tau * hertz * clock_s) for hertz, share in waves)
        )
