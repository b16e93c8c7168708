"""Sparks: what glows and is light enough to go with the gas. They burn out; they warm nothing."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.physics.kernels import linear
from game.stage import Part

MOST = 120
X, Y, VX, VY, AGE, LIFE = range(6)
FOLLOWS = 6.0  # 1/s at which one takes over the speed of the gas
FALLS = 1.2  # m/s², its weight less what carries it


class Sparks(Part):
    """table (MOST, 6): place m, velocity m/s, age s, life s; a life of 0: there is none."""

    def __init__(self, seed: int):
        self.chance = np.random.default_rng(seed + 26)
        self.table: Floats = np.zeros((MOST, 6))

    def alive(self) -> Floats:
        """(n, 6) those that are there."""
        return self.table[self.table[:, LIFE] > 0.0]

    def burst(self, place: tuple[float, float], count: int, speed: float = 0.7) -> None:
        """So many fly off from a place (m), upwards and to the sides."""
        free = np.flatnonzero(self.table[:, LIFE] <= 0.0)[:count]
        random = linear.uniform(self.chance, -1.0, 1.0, (count, 4))[: len(free)]
        for slot, (a, b, c, d) in zip(free.tolist(), random.tolist(), strict=True):
            self.table[slot] = (
                place[0] + 0.02 * a, place[1] + 0.02 * b, 0.7 * speed * c, speed * (0.8 + 0.5 * d), 0.0,
                1.1 + 0.7 * a,
            )  # fmt: skip

    def step(self, wind: Floats, dt: float) -> None:
        """Go with the gas, whose velocity (MOST, 2) m/s is at each."""
        table = self.table
        part = FOLLOWS * dt / (1.0 + FOLLOWS * dt)
        table[:, VX : VY + 1] += part * (wind - table[:, VX : VY + 1])
        table[:, VY] -= FALLS * dt
        table[:, X : Y + 1] += dt * table[:, VX : VY + 1]
        table[:, AGE] += dt
        table[(table[:, AGE] >= table[:, LIFE]) | (table[:, Y] < 0.0)] = 0.0
