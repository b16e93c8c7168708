"""What gives birth to particles, as data: a nozzle with a rate, a direction, a spread and a speed."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from game.physics.particles.births import EMITTER_COLUMNS
from game.physics.particles.solids import checked_point

MAX_RATE = 1e7  # 1/s; above it the births of one step alone would stop the clock
MAX_SPEED = 1e4  # m/s


@dataclass(frozen=True, slots=True)
class Emitter:
    """A nozzle. ValueError, naming the field, for a number that makes no sense.

    position: m. rate: births a second, evenly spaced in time. speed: m/s. spread: rad to each side of the
    axis, evenly at random. axis: rad from straight up, clockwise. speed_range: part of the speed by which it
    may differ to each side, evenly at random. width: m, of the nozzle, across the axis.
    """

    position: tuple[float, float] = (0.0, 0.0)
    rate: float = 1_000.0
    speed: float = 9.0
    spread: float = 0.28
    axis: float = 0.0
    speed_range: float = 0.0
    width: float = 0.0

    def __post_init__(self) -> None:
        checked_point("position", self.position)
        limits = {
            "rate": (0.0, MAX_RATE),
            "speed": (0.0, MAX_SPEED),
            "spread": (0.0, math.pi),
            "axis": (-2.0 * math.pi, 2.0 * math.pi),
            "speed_range": (0.0, 1.0),
            "width": (0.0, 1e3),
        }
        for name, (least, most) in limits.items():
            value = getattr(self, name)
            if not least <= value <= most:
                raise ValueError(f"{name} = {value!r}: expected {least:g} to {most:g}")

    def row(self, since: float) -> NDArray[np.float64]:
        """The row (EMITTER_COLUMNS,) that kernels read, for an emitter that begins at an instant (s)."""
        row = np.empty(EMITTER_COLUMNS)
        row[:] = (
            *self.position,
            *self.position,
            self.axis,
            self.spread,
            self.speed,
            self.speed_range,
            self.width,
            self.rate,
            0.0,
            since,
        )
        return row
