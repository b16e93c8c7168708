"""Fields that fill space: wind, heat, gravity, light; sampled at points, whatever they are made of."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.physics.surfaces.surface import checked_places


class Field(Protocol):
    """Numbers (n, k) at points (n, 2) m and a time s."""

    def sample(self, points: ArrayLike, time: float = 0.0) -> Floats:
        """Values (n, k)."""


class ConstantField:
    """The same everywhere: a value (k,)."""

    def __init__(self, value: ArrayLike):
        self.value: Floats = np.atleast_1d(np.asarray(value, dtype=np.float64))
        if self.value.ndim != 1 or not np.isfinite(self.value).all():
            raise ValueError(f"value = {value!r}: expected finite numbers")

    def sample(self, points: ArrayLike, time: float = 0.0) -> Floats:
        """Values (n, k)."""
        return np.tile(self.value, (len(checked_places(points)), 1))


class FunctionField:
    """By a formula: function(points (n, 2), time) -> (n,) or (n, k)."""

    def __init__(self, function: Callable[[Floats, float], ArrayLike]):
        self.function = function

    def sample(self, points: ArrayLike, time: float = 0.0) -> Floats:
        """Values (n, k); ValueError if the formula gives what is not finite."""
        places = checked_places(points)
        values: Floats = np.asarray(self.function(places, time), dtype=np.float64).reshape(len(places), -1)
        if not np.isfinite(values).all():
            raise ValueError("field: the formula gives numbers that are not finite")
        return values


class GridField:
    """Bilinear between nodes: values (rows, columns) or (rows, columns, k), the first at lower, spacing m.

    Beyond the grid it is as at its border. ValueError for fewer than two rows or columns, or nonsense.
    """

    def __init__(self, values: ArrayLike, lower: tuple[float, float], spacing: float):
        grid = np.asarray(values, dtype=np.float64)
        grid = grid[..., None] if grid.ndim == 2 else grid
        if grid.ndim != 3 or min(grid.shape[:2]) < 2 or not np.isfinite(grid).all():
            raise ValueError("values: expected finite numbers, at least two rows and columns")
        if not 0.0 < spacing < np.inf:
            raise ValueError(f"spacing = {spacing!r}: expected a number above 0, m")
        self.values: Floats = grid
        self.lower, self.spacing = (float(lower[0]), float(lower[1])), float(spacing)

    def sample(self, points: ArrayLike, time: float = 0.0) -> Floats:
        """Values (n, k)."""
        places = (checked_places(points) - self.lower) / self.spacing
        rows, columns = self.values.shape[:2]
        x, y = np.clip(places[:, 0], 0.0, columns - 1.0), np.clip(places[:, 1], 0.0, rows - 1.0)
        i, j = np.minimum(x.astype(int), columns - 2), np.minimum(y.astype(int), rows - 2)
        u, v = (x - i)[:, None], (y - j)[:, None]
        g = self.values
        low = (1.0 - u) * g[j, i] + u * g[j, i + 1]
        high = (1.0 - u) * g[j + 1, i] + u * g[j + 1, i + 1]
        mixed: Floats = (1.0 - v) * low + v * high
        return mixed
