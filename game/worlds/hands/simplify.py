"""A drawn line with few points (Douglas and Peucker 1973)."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.physics.kernels import elementwise, linear


def simplified(points: Floats, tolerance: float) -> Floats:
    """Points (n, 2) m of a line, of which none that is left out lies farther than ``tolerance`` from it."""
    keep = np.zeros(len(points), dtype=bool)
    keep[0] = keep[-1] = True
    parts = [(0, len(points) - 1)]
    while parts:
        first, last = parts.pop()
        if last - first < 2:
            continue
        a, way = points[first], points[last] - points[first]
        between = points[first + 1 : last] - a
        length = float(elementwise.hypot(*way))
        if length > 0.0:
            along = np.clip(linear.product(between, way) / (length * length), 0.0, 1.0)
            away = elementwise.hypot(*(between - along[:, None] * way).T)
        else:
            away = elementwise.hypot(*between.T)
        k = int(away.argmax())
        if away[k] > tolerance:
            middle = first + 1 + k
            keep[middle] = True
            parts += [(first, middle), (middle, last)]
    return points[keep]
