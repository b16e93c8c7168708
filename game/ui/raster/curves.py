"""Curves with fewer points that look the same: what a chart of a few hundred pixels needs of many samples."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from game.compiler.decorator import lean_kernel

TOLERANCE_PX = 0.15


@lean_kernel
def finite_range(values: Any) -> Any:
    """Least and greatest finite one of ``values`` (n,), or inf and -inf; whether all of them are whole."""
    low, high, whole = np.inf, -np.inf, True
    for i in range(values.shape[0]):
        value = values[i]
        if abs(value) < np.inf:
            low, high = min(low, value), max(high, value)
            whole = whole and value == math.floor(value)
    return low, high, whole


@lean_kernel
def place_curve(
    times: Any, values: Any, right: float, across: float, foot: float, low: float, up: float, points: Any
) -> None:
    """Write places (n, 2) px of samples: the newest at ``right``, ``low`` at ``foot``.

    ``across`` px to a unit of ``times`` (n,), ``up`` px to a unit of ``values`` (n,).
    """
    n = times.shape[0]
    for i in range(n):
        points[i, 0] = right + (times[i] - times[n - 1]) * across
        points[i, 1] = foot - (values[i] - low) * up


@lean_kernel
def thin_curve(points: Any, tolerance: float, kept: Any) -> int:
    """Write the points of a curve that cannot be left out into ``kept``; how many they are.

    ``points`` (n, 2) px with ascending x, ``kept`` (m, 2), m >= n. A point is left out while a straight line
    from the last one kept passes all since within ``tolerance`` px. The line's slope is narrowed point by
    point (the swing filter of Elmeleegy and others, 2009), so one pass does. One that is not finite is kept
    as a break.
    """
    count, anchor = 0, -1
    low, high = 0.0, 0.0
    n = points.shape[0]
    for i in range(n):
        x, y = points[i, 0], points[i, 1]
        if not (abs(x) < 1e9 and abs(y) < 1e9):
            if anchor >= 0 and anchor != i - 1:
                kept[count, 0], kept[count, 1] = points[i - 1, 0], points[i - 1, 1]
                count += 1
            kept[count, 0], kept[count, 1] = x, y
            count += 1
            anchor = -1
            continue
        if anchor < 0:
            anchor = i
            kept[count, 0], kept[count, 1] = x, y
            count += 1
            low, high = -1e30, 1e30
            continue
        way = x - points[anchor, 0]
        slope = (y - points[anchor, 1]) / way if way > 1e-9 else 0.0
        if way > 1e-9 and low <= slope <= high:
            low = max(low, slope - tolerance / way)
            high = min(high, slope + tolerance / way)
            continue
        if anchor != i - 1:
            anchor = i - 1
            kept[count, 0], kept[count, 1] = points[anchor, 0], points[anchor, 1]
            count += 1
            way = x - points[anchor, 0]
        if way > 1e-9:
            slope = (y - points[anchor, 1]) / way
            low, high = slope - tolerance / way, slope + tolerance / way
        else:  # straight up or down: keep it
            anchor = i
            kept[count, 0], kept[count, 1] = x, y
            count += 1
            low, high = -1e30, 1e30
    if anchor >= 0 and anchor != n - 1:
        kept[count, 0], kept[count, 1] = points[n - 1, 0], points[n - 1, 1]
        count += 1
    return count


def thinned(points: np.ndarray, tolerance: float = TOLERANCE_PX) -> np.ndarray:
    """The points (n, 2) of a curve that it needs, in an array of its own."""
    kept = np.empty_like(points)
    return kept[: thin_curve(points, float(tolerance), kept)]
