"""Flakes of ash and sparks: what parts from the cloth, goes with the air, and falls. They warm nothing."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.physics.kernels import linear
from game.stage import Part

MOST = 260
X, Y, VX, VY, AGE, LIFE, SIZE, TURN = range(8)
WIDTH = 8
FOLLOWS = 3.5  # 1/s at which one takes over the speed of the air
FALLS = 1.5  # m/s², its weight less what carries it
GLOWS_S = 1.1  # s for which a flake glows
LIES_S = 14.0  # s for which it can be seen


class Ashes(Part):
    """table (MOST, 8): place m, velocity m/s, age s, life s, half size m, rad; a life of 0: there is none."""

    def __init__(self, seed: int):
        self.chance = np.random.default_rng(seed + 10)
        self.table: Floats = np.zeros((MOST, WIDTH))
        self.next = 0

    def alive(self) -> Floats:
        """(n, 8) those that are there."""
        return self.table[self.table[:, LIFE] > 0.0]

    def part(self, places: Floats, velocities: Floats, size: float) -> None:
        """One flake from each place (n, 2) m, with the velocity (n, 2) m/s of the cloth there; if there are
        too many, the oldest go.
        """
        random = linear.uniform(self.chance, -1.0, 1.0, (len(places), 5))
        for place, velocity, (a, b, c, d, e) in zip(places, velocities, random, strict=True):
            self.table[self.next] = (
                place[0], place[1], velocity[0] + 0.12 * a, velocity[1] + 0.25 * b + 0.1, 0.0,
                LIES_S * (0.8 + 0.2 * c), size * (0.55 + 0.25 * d), 3.0 * e,
            )  # fmt: skip
            self.next = (self.next + 1) % MOST

    def step(self, wind: Floats, dt: float) -> None:
        """Go with the air, whose velocity (MOST, 2) m/s is at each; lie on the ground."""
        table = self.table
        flying = table[:, Y] > 0.006
        part = FOLLOWS * dt / (1.0 + FOLLOWS * dt)
        table[:, VX : VY + 1] += np.where(flying, part, 1.0)[:, None] * (
            np.where(flying[:, None], wind, 0.0) - table[:, VX : VY + 1]
        )
        table[flying, VY] -= FALLS * dt
        table[:, X : Y + 1] += dt * table[:, VX : VY + 1]
        table[:, Y] = np.maximum(table[:, Y], 0.005)
        table[flying, TURN] += 4.0 * dt * table[flying, VX] + 1.5 * dt
        table[:, AGE] += dt
        table[table[:, AGE] >= table[:, LIFE]] = 0.0
