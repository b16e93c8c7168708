"""Whether a cubic piece crosses itself or has a cusp, in closed form.

B(s) = B(t) with s different from t, divided by s - t, is linear in s + t once the leading coefficient is
crossed out; s and t are then the roots of a quadratic. Where it has a double root the loop has shrunk to a
cusp (Stone and DeRose 1989, "A geometric characterization of parametric cubic curves").
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats


def crosses_itself(controls: Floats) -> NDArray[np.bool_]:
    """Of each planar cubic Bezier piece, (n, 4, 2) control points, whether it meets itself: (n,)."""
    p0, p1, p2, p3 = (controls[:, i] for i in range(4))
    cubic, square, linear = p3 - 3.0 * (p2 - p1) - p0, 3.0 * (p0 - 2.0 * p1 + p2), 3.0 * (p1 - p0)
    across = _cross(square, cubic)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        total = -_cross(linear, cubic) / across
        along = np.sum(
            (cubic * (total[:, None] * total[:, None]) + square * total[:, None] + linear) * cubic, axis=1
        ) / np.sum(cubic * cubic, axis=1)
        apart = np.sqrt(total * total - 4.0 * along)  # product of the roots
        early, late = 0.5 * (total - apart), 0.5 * (total + apart)
    return np.isfinite(apart) & (apart > 0.0) & (early >= 0.0) & (late <= 1.0)


def _cross(a: Floats, b: Floats) -> Floats:
    return np.asarray(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0])
