"""Easing: how far along a motion is at a part of its time, by a Bezier curve from (0, 0) to (1, 1).

The curve is x(s), y(s) with two free control points (x1, y1), (x2, y2). At a time x the value y needs s with
x(s) = x, by Newton's method in a bracket. Its slope vanishes for x1 = 0, for x2 = 1 and halfway for x1 = 1,
x2 = 0. x1 and x2 must lie in [0, 1], else x(s) would turn back. The same family and names as in W3C 2023,
"CSS Easing Functions Level 1".
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.compiler.decorator import kernel

EASINGS = {
    "linear": (0.0, 0.0, 1.0, 1.0),
    "ease": (0.25, 0.1, 0.25, 1.0),
    "ease-in": (0.42, 0.0, 1.0, 1.0),
    "ease-out": (0.0, 0.0, 0.58, 1.0),
    "ease-in-out": (0.42, 0.0, 0.58, 1.0),
    "swing": (0.68, -0.45, 0.32, 1.45),  # draws back, then overshoots
    "rush": (0.9, 0.0, 0.1, 1.0),
}
CLOSE = 1e-15  # of x(s) to x; 1e-12 is what is promised
MOST_ROUNDS = 100
STEEPEST = 1e6  # a slope beyond it is given as this: at a vertical place it has no value


@kernel(_nrt=False)
def bezier_at(a, b, s):
    """One coordinate of the curve, with control values 0, a, b, 1."""
    return ((1.0 - 3.0 * b + 3.0 * a) * s + (3.0 * b - 6.0 * a)) * s * s + 3.0 * a * s


@kernel(_nrt=False)
def bezier_slope_at(a, b, s):
    """Its derivative by s."""
    return (3.0 * (1.0 - 3.0 * b + 3.0 * a) * s + 2.0 * (3.0 * b - 6.0 * a)) * s + 3.0 * a


@kernel(_nrt=False)
def solve_timing(x1, x2, x):
    """s in [0, 1] with x(s) = x, for x in (0, 1)."""
    low, high = 0.0, 1.0
    s = x
    for _ in range(MOST_ROUNDS):
        off = bezier_at(x1, x2, s) - x
        if abs(off) <= CLOSE:
            break
        if off > 0.0:
            high = s
        else:
            low = s
        slope = bezier_slope_at(x1, x2, s)
        s = s - off / slope if slope > 0.0 else low
        if not low < s < high:
            s = 0.5 * (low + high)
            if not low < s < high:
                break
    return s


@kernel(_nrt=False)
def ease_all(x1, y1, x2, y2, steep, at, out):
    """Write y at each part of the time ``at`` (k,), or with ``steep`` the slope dy/dx.

    Beyond 0 to 1 those of the ends.
    """
    for k in range(at.shape[0]):
        x = min(max(at[k], 0.0), 1.0)
        s = x if x == 0.0 or x == 1.0 else solve_timing(x1, x2, x)
        if not steep:
            out[k] = s if s == 0.0 or s == 1.0 else bezier_at(y1, y2, s)
            continue
        dx, dy = bezier_slope_at(x1, x2, s), bezier_slope_at(y1, y2, s)
        if abs(dx) < 1e-12 and abs(dy) < 1e-12:  # a handle lies on its end: the next derivative says
            dx = 6.0 * (1.0 - 3.0 * x2 + 3.0 * x1) * s + 2.0 * (3.0 * x2 - 6.0 * x1)
            dy = 6.0 * (1.0 - 3.0 * y2 + 3.0 * y1) * s + 2.0 * (3.0 * y2 - 6.0 * y1)
            if abs(dx) < 1e-12 and abs(dy) < 1e-12:
                dx, dy = 1.0, 1.0  # all on the diagonal
        limit = STEEPEST * abs(dx)
        out[k] = dy / dx if abs(dy) < limit else (STEEPEST if dy > 0.0 else -STEEPEST)


class Easing:
    """A timing curve with control points (x1, y1) and (x2, y2), or of one of the names in EASINGS.

    ValueError for another name, for what is not finite, and for x1 or x2 outside 0 to 1.
    """

    def __init__(self, handles: str | ArrayLike = "linear") -> None:
        if isinstance(handles, str):
            if handles not in EASINGS:
                raise ValueError(f"easing: expected one of {', '.join(EASINGS)}, not {handles!r}")
            handles = EASINGS[handles]
        four = np.array(handles, dtype=np.float64).reshape(-1)
        if four.shape != (4,) or not np.all(np.abs(four) <= 1e6):
            raise ValueError("easing: expected four finite numbers x1, y1, x2, y2")
        if not (0.0 <= four[0] <= 1.0 and 0.0 <= four[2] <= 1.0):
            raise ValueError(f"easing: x1 and x2 must lie in 0 to 1, not {four[0]:g} and {four[2]:g}")
        self.handles: tuple[float, float, float, float] = tuple(four.tolist())  # type: ignore[assignment]

    def __call__(self, parts: ArrayLike) -> Floats:
        """How far along (0 at the beginning, 1 at the end) at parts of the time, which are cut to 0 to 1."""
        return self._eased(parts, False)

    def slope(self, parts: ArrayLike) -> Floats:
        """Pace dy/dx (...,) at parts (...,), cut to a million where the curve is vertical.

        ValueError for what is not finite.
        """
        return self._eased(parts, True)

    def _eased(self, parts: ArrayLike, steep: bool) -> Floats:
        at = np.ascontiguousarray(parts, dtype=np.float64).reshape(np.shape(parts))
        if not np.isfinite(at).all():
            raise ValueError("parts: expected finite numbers")
        out = np.empty(at.size)
        ease_all(*self.handles, steep, at.reshape(-1), out)
        return out.reshape(at.shape)
