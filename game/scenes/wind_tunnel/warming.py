"""What a sweep's end compiles, compiled before."""

from __future__ import annotations

import math

import numpy as np

from game.physics.kernels import elementwise
from game.physics.plates import Plate
from game.physics.tunnel import DataFlight, fit_plate, fit_series


def warm_up() -> None:
    """A fit of eight angles, and a step of a flight by it."""
    angles = 0.25 * math.pi * np.arange(8.0)
    values = np.stack(
        [1.0 - elementwise.cos(2.0 * angles), elementwise.sin(2.0 * angles), np.zeros(8)], axis=1
    )
    fit_plate(angles, values)
    DataFlight(Plate(), fit_series(angles, values, 2)).step(1e-3)
