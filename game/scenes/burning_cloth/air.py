"""The layer of gas in which the cloth hangs: wind, what burns in it, what cloth and match give it."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats, Point
from game.physics.cloth import Breeze, GasAt
from game.physics.effects import EffectSet
from game.physics.gas import Gas, GasSettings
from game.physics.gas.effects import BUOYANCY
from game.physics.grid import Border, Borders, Grid
from game.physics.kernels import elementary
from game.scenes.burning_cloth import tables
from game.worlds.members.burning_air import FIELDS, FRESH, BurningAir, faded
from game.worlds.painting.glowing import GlowLook

MIXES = 1.3  # 1/s at which the layer takes on the wind before and behind it
VAPOUR = {
    "ignition": 560.0, "rate": 24.0, "oxygen": 1.3, "heat": 1.5e7, "capacity": 1212.0, "soot": 0.06,
    "soot_rate": 1.6, "glow": 1.2e-11, "soot_glow": 3.2e-7, "ambient": tables.ROOM,
}  # fmt: skip
LOOK = GlowLook(620.0, 1300.0, 0.05, 2.0e-4, 2.2e-3, 0.7, 900.0)
SLANT, SWELL, WAVE, RUNS = 0.55, 0.4, 3.4, 0.55  # of the wind: across the plane, its swell, 1/m, its speed
PRESS, BRUSH = 0.72, 0.15  # kg/m³, half the density of air times a coefficient of drag, through and along
GUSTS = ((0.9, 0.22), (2.3, 0.13), (3.7, 0.07))  # rad/s, share of the wind
MATCH_WIDE = 0.03  # m
GLOWING, PILOT = 700.0, 0.4  # K, share: vapour that leaves what is hotter begins to burn as it leaves


class Air(BurningAir):
    """cells: across. wind: m/s that it goes to.

    Its books are of a layer a metre deep; its flows: J from the match, J through the sides; m/s of the wind
    now; rad, how far its swell has run.
    """

    vapour, flame_look = VAPOUR, LOOK

    def __init__(self, cells: int, cycles: int, active: EffectSet, gas_effects: EffectSet):
        cell = 2.0 * tables.HALF / cells
        borders = Borders(Border("open"), Border("open"), Border("wall"), Border("open"))
        gas = Gas(
            Grid(cells, round(tables.TALL / cell), cell, (-tables.HALF, 0.0)), borders,
            GasSettings(
                effects=gas_effects.without(BUOYANCY), turns=cycles, ambient=tables.ROOM,
                conservative=("temperature",),
            ),
            FIELDS, {"oxygen": FRESH},
        )  # fmt: skip
        super().__init__(gas, faded(gas.grid.shape, 0.07, 0.1), active, BUOYANCY in gas_effects)
        self.wind = 0.0
        self.speed_now = np.zeros(self.gas.grid.shape)
        self._nothing = np.zeros(self.gas.grid.shape)  # of expansion, which this layer leaves out
        self._centres = self.gas.grid.centres()

    # -- what it is made of -----------------------------------------------------------------------------

    def at_cloth(self) -> GasAt:
        """For the cloth."""
        volume = self.cell * self.cell * tables.DEEP
        return GasAt(
            -tables.HALF,
            0.0,
            self.cell,
            VAPOUR["capacity"] * volume,
            volume,
            FRESH,
            VAPOUR["oxygen"],
            GLOWING,
            PILOT,
            VAPOUR["heat"],
            VAPOUR["soot"],
        )

    # -- what comes in ------------------------------------------------------------------------------------

    def breeze(self, time: float) -> Breeze:
        """The wind as the cloth feels it."""
        now = float(self.flows[2])
        slow = 0.75 + 0.25 * elementary.sin(0.7 * time)
        run, swell = float(self.flows[3]), SWELL * abs(now)
        return Breeze(-tables.HALF, 0.0, self.cell, SLANT * now * slow, swell, WAVE, run, PRESS, BRUSH)

    def heat_match(self, head: Point, watt: float, dt: float) -> None:
        """The flame of a match warms the gas at it."""
        x, y = self._centres
        ex, ey = (x - head[0]) / MATCH_WIDE, (y - head[1]) / MATCH_WIDE
        near = ex * ex + ey * ey < 1.5
        count = int(np.count_nonzero(near))
        if not count:
            return
        capacity = VAPOUR["capacity"] * self.cell * self.cell * tables.DEEP
        self.gas.scalars[..., 0][near] += watt * dt / (capacity * count)
        self.flows[0] += watt * dt

    def cool(self, place: Point, reach: float) -> None:
        """Water that falls through flames takes their heat along."""
        near = self.near(place, reach)
        t = self.gas.scalars[..., 0]
        taken = np.where(near & (t > 373.15), 0.7 * (t - 373.15), 0.0)
        t -= taken
        self.flows[0] -= float(np.sum(taken)) * VAPOUR["capacity"] * (self.cell * self.cell) * tables.DEEP

    # -- a step -------------------------------------------------------------------------------------------

    def gust(self, time: float, dt: float) -> None:
        """The wind of now goes to what it is to be, and its gusts come and go."""
        share = 1.0 + sum(part * elementary.sin(often * time) for often, part in GUSTS)
        self.flows[2] += (self.wind * share - self.flows[2]) * min(1.0, 1.6 * dt)
        self.flows[3] += WAVE * RUNS * float(self.flows[2]) * dt
        if self.flows[3] > math.tau:
            self.flows[3] -= math.tau
        elif self.flows[3] < 0.0:
            self.flows[3] += math.tau

    def look(self) -> None:
        """How fast the gas is, for the cloth."""
        along, upward = self.velocities()
        np.sqrt(along * along + upward * upward, out=self.speed_now)

    def advance(self, dt: float) -> None:
        """Burn, and flow."""
        gas = self.gas
        self.flames.step(gas.scalars, dt, self._nothing)
        along, upward = self.velocities()
        gas.force[..., 0] = MIXES * (self.flows[2] - along)
        gas.force[..., 1] = 0.0
        self.rise()
        gas.force[..., 1] -= MIXES * upward
        out = (np.maximum(-gas.u[:, 0], 0.0), np.maximum(gas.u[:, -1], 0.0), np.maximum(gas.v[-1], 0.0))
        before = self._through_sides(out)  # heat is carried by the velocities that a step begins with
        gas.step(dt)
        self.flows[1] += 0.5 * (before + self._through_sides(out)) * dt

    # -- what there is ------------------------------------------------------------------------------------

    @property
    def power(self) -> float:
        """W of flames in the last step."""
        return self.flames.power * tables.DEEP

    def heat(self) -> float:
        """J in the gas above that of the surroundings."""
        t = self.gas.scalars[..., 0]
        return float(np.sum(t - tables.ROOM)) * VAPOUR["capacity"] * (self.cell * self.cell) * tables.DEEP

    def _through_sides(self, out: tuple[Floats, Floats, Floats]) -> float:
        """W that leave the box to the left, the right and above with these speeds, in m/s: the temperature on
        a side is that of its cells with the limited slope by which the gas carries it (van Leer 1974).
        """
        warm = self.gas.scalars[..., 0] - tables.ROOM
        total = []
        for speed, cell, within in zip(
            out, (warm[:, 0], warm[:, -1], warm[-1]), (warm[:, 1], warm[:, -2], warm[-2]), strict=True
        ):
            one, two = cell - within, -cell  # beyond the side it is as in the surroundings
            both = one * two
            slope = np.where(both > 0.0, both / np.where(both > 0.0, one + two, 1.0), 0.0)
            total.append(float(np.sum(speed * (cell + slope))))
        return math.fsum(total) * VAPOUR["capacity"] * self.cell * tables.DEEP
