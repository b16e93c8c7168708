"""Fronts of falling columns as they were filmed (Martin and Moyce 1952)."""

from __future__ import annotations

import math

import numpy as np

from game.physics.kernels import linear

# front over width against t sqrt(2 g / width), of a column of water twice as high as wide
COLUMN_TWICE_AS_HIGH = ((0.832, 1.217), (1.219, 1.474), (1.997, 2.292), (2.547, 2.995))


def filmed_front(height: float, t: float, gravity: float = 9.81) -> float:
    """How far (m) a front is from its gate at a time (s); NaN where none was filmed.

    height: m, of a column half as wide. Fronts of longer ones are ahead of it: no back wall is near, and
    their pressure at the gate falls later.
    """
    width = 0.5 * height
    times, fronts = zip(*COLUMN_TWICE_AS_HIGH, strict=True)
    scaled = t * math.sqrt(2.0 * gravity / width)
    if not times[0] <= scaled <= times[-1]:
        return math.nan
    return width * (float(linear.interpolated(np.array([scaled]), times, fronts)[0]) - 1.0)
