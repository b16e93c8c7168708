"""World points to pixels, many at once and without allocation."""

from __future__ import annotations

from typing import Any

import numpy as np

from game.compiler.decorator import lean_kernel


@lean_kernel
def map_points(points: Any, a: float, b: float, c: float, d: float, e: float, f: float, mapped: Any) -> None:
    """Write a x + b y + e, c x + d y + f into ``mapped`` (m, 2), m >= n, for ``points`` (n, 2)."""
    for i in range(points.shape[0]):
        x, y = points[i, 0], points[i, 1]
        mapped[i, 0] = a * x + b * y + e
        mapped[i, 1] = c * x + d * y + f


class PointBuffer:
    """Memory for mapped points that grows by doubling and is kept."""

    def __init__(self) -> None:
        self._buffer = np.empty((64, 2))

    def take(self, count: int) -> np.ndarray:
        """An (count, 2) float64 view; good until the next call."""
        if count > self._buffer.shape[0]:
            self._buffer = np.empty((max(count, 2 * self._buffer.shape[0]), 2))
        return self._buffer[:count]


def as_points(points: Any) -> np.ndarray:
    """Any (n, 2) numbers as a C-ordered float64 array; ValueError for another shape."""
    array = np.ascontiguousarray(points, dtype=np.float64)
    if array.ndim != 2 or array.shape[1] != 2:
        if array.size == 0:
            return np.empty((0, 2))
        raise ValueError(f"points: expected an (n, 2) array, not {array.shape}")
    return array
