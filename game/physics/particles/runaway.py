"""Particles that drag has thrown away: an explicit method makes drag speed up what it should slow down once
(k + 2 q |v|) h is beyond its limit. Quadratic drag then squares the speed in every step. They are kept at a
great speed, far out, so that all numbers stay numbers.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from game.compiler.decorator import kernel

FARTHEST = 1e9  # m, and m/s in each direction


@kernel
def hold_runaways(fields: NDArray[np.float64], low: int, high: int, most: float) -> int:
    """Keep places and velocities of particles ``low`` to ``high`` (rows x, y, vx, vy of ``fields``) within
    ``most`` (m, m/s) of zero; what is no number goes to the end. Returns how many were beyond."""
    beyond = 0
    for i in range(low, high):
        far = 0
        for row in range(4):
            value = fields[row, i]
            if not abs(value) <= most:
                fields[row, i] = -most if value < 0.0 else most
                far = 1
        beyond += far
    return beyond
