"""A front that burns its way across a grid: checked, stepped, and asked where it is."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from game.physics.heat.fronts import REACTIONS, front_step
from game.physics.heat.grid import checked_grid


class BurningFront:
    """u (ny, nx), 0 unburnt to 1 burnt, in cells of ``cell`` m.

    reaction: of REACTIONS; diffusivity m²/s, rate 1/s; threshold: of "ignition", 0 to 1/2. ValueError.
    """

    def __init__(
        self, values: ArrayLike, cell: float, diffusivity: float, rate: float, reaction: str = "fisher",
        threshold: float = 0.2,
    ):  # fmt: skip
        self.values = checked_grid("values", values, 0.0, 1e6)
        self._next = np.zeros_like(self.values)
        for name, value in (("cell", cell), ("diffusivity", diffusivity)):
            if not 0.0 < value < math.inf:
                raise ValueError(f"{name} = {value!r}: expected a finite number above 0")
        if not 0.0 <= rate < math.inf or not 0.0 <= threshold <= 1.0:
            raise ValueError(f"rate, threshold = {rate!r}, {threshold!r}: expected from 0, and 0 to 1")
        if reaction not in REACTIONS:
            raise ValueError(f"reaction = {reaction!r}: expected one of {', '.join(REACTIONS)}")
        self.cell, self.diffusivity, self.rate = float(cell), float(diffusivity), float(rate)
        self.kind, self.threshold = REACTIONS.index(reaction), float(threshold)
        self.explicit_limit = (self.cell * self.cell) / (
            (4.0 if self.values.shape[0] > 1 else 2.0) * self.diffusivity
        )

    def step(self, dt: float) -> None:
        """Go on by dt (s). ValueError unless above 0 and within the explicit limit."""
        if not 0.0 < dt <= self.explicit_limit * (1.0 + 1e-12):
            raise ValueError(f"dt = {dt!r}: expected above 0 and at most {self.explicit_limit:g} s")
        number = self.diffusivity * dt / (self.cell * self.cell)
        front_step(self.values, self._next, number, self.kind, self.rate, self.threshold, float(dt))
        self.values, self._next = self._next, self.values

    def place(self, row: int = 0, level: float = 0.5) -> float:
        """Where u falls to ``level`` along a row, m from the left edge, between the middles of cells; nan:
        nowhere.
        """
        line = self.values[row]
        found = np.flatnonzero((line[:-1] >= level) & (line[1:] < level))
        if not len(found):
            return math.nan
        k = int(found[-1])
        return (k + 0.5 + float((line[k] - level) / (line[k] - line[k + 1]))) * self.cell
