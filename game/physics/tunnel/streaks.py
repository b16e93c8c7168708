"""Smoke from a rake of nozzles: streak lines, of specks that drift with the gas one behind another."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.compiler.decorator import kernel
from game.physics.gas import Gas
from game.physics.tunnel.sticking import linear

PARKED = -1e3  # m: the place of a speck that is not in the air


@kernel
def drift(specks, u, v, numbers, dt):
    """Specks (nozzles, length, 2) m go on for dt (s) by the midpoint rule; beyond the end they are parked.

    numbers (5,): cell m, x and y m of the grid's corner, width and height m of the grid.
    """
    h, x0, y0 = numbers[0], numbers[1], numbers[2]
    for a in range(specks.shape[0]):
        for k in range(specks.shape[1]):
            x, y = (specks[a, k, 0] - x0) / h, (specks[a, k, 1] - y0) / h
            if x < 0.0:
                continue
            half = 0.5 * dt / h
            mx = x + half * linear(u, x, y - 0.5)
            my = y + half * linear(v, x - 0.5, y)
            x, y = x + 2.0 * half * linear(u, mx, my - 0.5), y + 2.0 * half * linear(v, mx - 0.5, my)
            inside = 0.0 <= x * h <= numbers[3] and 0.0 <= y * h <= numbers[4]
            specks[a, k, 0] = x0 + x * h if inside else PARKED
            specks[a, k, 1] = y0 + y * h


class Rake:
    """Nozzles across the inflow.

    ``specks`` (nozzles, length, 2) m, the newest first; ``since`` (1,): s since the last were let go.
    """

    def __init__(self, nozzles: int, length: int, low: float, high: float, spacing: float):
        self.specks: Floats = np.full((nozzles, length, 2), PARKED)
        self.since: Floats = np.zeros(1)
        self.heights: Floats = low + (np.arange(nozzles) + 0.5) * (high - low) / nozzles
        self.specks[..., 1] = self.heights[:, None]
        self.spacing = spacing  # m between specks in the free wind

    def step(self, gas: Gas, dt: float, wind: float) -> None:
        """All drift for dt (s); new ones are let go as the wind (m/s) has carried the last far enough."""
        grid = gas.grid
        wide, tall = grid.upper[0] - grid.lower[0], grid.upper[1] - grid.lower[1]
        numbers = np.array([grid.cell, *grid.lower, wide, tall])
        drift(self.specks, gas.u, gas.v, numbers, float(dt))
        self.since[0] += dt
        if self.since[0] * wind >= self.spacing:
            self.since[0] = 0.0
            self.specks[:, 1:] = self.specks[:, :-1].copy()
            self.specks[:, 0, 0] = grid.lower[0]
            self.specks[:, 0, 1] = self.heights

    def lines(self) -> Floats:
        """(nozzles, length, 2) m: the specks of each nozzle in their order, NaN where a line is torn."""
        found = self.specks.copy()
        way = found[:, 1:] - found[:, :-1]
        torn = (way * way).sum(axis=2) > 16.0 * self.spacing * self.spacing
        torn |= found[:, 1:, 0] < 0.0
        found[:, 1:][torn] = np.nan
        found[found[..., 0] < 0.0] = np.nan
        return found
