"""The litter basket: one outline, by which leaves are stopped, counted, sheltered and drawn.

Its walls are straight and slanted, from the foot on the lawn, which is narrower, up to the rim.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.scenes.leaves.level import BasketEntry

FOOT = 0.85  # of the rim's width
WIRE, FRICTION = 0.006, 0.4  # m, radius of a wall; friction on it
SHELTER = 0.12  # m: so fast the wind dies away below the rim


class Basket(NamedTuple):
    """x: its middle; half: half its width at the rim; height of the rim, m."""

    x: float
    half: float
    height: float

    @classmethod
    def of(cls, entry: BasketEntry) -> Basket:
        """As a level says."""
        return cls(entry.x, entry.half, entry.height)

    @property
    def slant(self) -> float:
        """m that each wall leans outwards for each m up."""
        return (1.0 - FOOT) * self.half / self.height

    def half_at(self, height: Floats | float) -> Floats:
        """Half the width (m) between the walls at heights (m); that of the rim above it."""
        return self.half - self.slant * (self.height - np.clip(height, 0.0, self.height))

    def holds(self, x: Floats, y: Floats) -> NDArray[np.bool_]:
        """Whether places (m) are within the inner faces of the walls, not above the rim."""
        return np.asarray((np.abs(x - self.x) < self.half_at(y) - WIRE) & (y < self.height))

    def away(self, x: Floats, y: Floats) -> Floats:
        """How far places (m) are from what the basket holds, m, across or up; 0 within it."""
        across = np.maximum(np.abs(x - self.x) - self.half_at(y), 0.0)
        return np.asarray(np.maximum(across, np.maximum(y - self.height, 0.0)))

    def walls(self) -> list[tuple[float, ...]]:
        """Rows (2, WALL) of `plates.contacts`: the left wall and the right one."""
        foot = FOOT * self.half
        return [
            (self.x + side * foot, 0.0, self.x + side * self.half, self.height, WIRE, FRICTION)
            for side in (-1.0, 1.0)
        ]

    def shelter(self) -> tuple[float, ...]:
        """A row (SHELTER,) of `plates.wind`."""
        return (self.x - self.half, self.x + self.half, self.height, SHELTER, self.slant)
