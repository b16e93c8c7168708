"""The gas about wick and glass: what the wick gives it, what burns, where the glass stands."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from game.arrays import Floats
from game.physics.combustion.effects import COMBUSTION
from game.physics.effects import EffectSet
from game.physics.gas import Gas, GasSettings
from game.physics.gas.effects import BUOYANCY, GAS
from game.physics.grid import Border, Borders, Grid
from game.physics.kernels import elementary, elementwise
from game.physics.surfaces.surface import Sample
from game.scenes.candle.parameters import CandleContent, CandleParameters
from game.worlds.members.boxes import Boxes, box_rows
from game.worlds.members.burning_air import FIELDS, FRESH, AirState, BurningAir, faded
from game.worlds.painting.glowing import GlowLook

HALF, TALL = 0.16, 0.36  # m: of the box of gas
CANDLE, TOP = 0.011, 0.05  # m: half the width of the candle, its height
WICK = (TOP + 0.002, TOP + 0.012)  # m: from where to where vapour leaves, about the middle
WIDE = 0.008  # m to either side of it
WALL, UP = 0.01, 0.37  # m: of the glass; its rim when it is up
QUICK = 0.12  # m/s at which the glass is moved
ROOM, AIR, PER_VOLUME = 293.15, 1.2, 20.95  # K; kg/m³ of air; % of it that are oxygen
BESIDE, ABOVE = (0.015, 0.035), 0.02  # m beside and above the wick's foot: from there the flame draws its air
GLOWS, MATCH = 700.0, 1300.0  # K of a wick that burns, and of one that is lit
COMES, HOLDS, LEAVES = 0.7, 0.6, 0.7  # s of a match on its way, at the wick, on its way back
LAG, OUT = 0.3, 0.2  # s by which the supply follows; share at which the flame is quenched
SMOKES, SMOKE_S, SMOKE_HOT = 8e-6, 5.0, 420.0  # kg/(s m) of smoke from a wick just out, s of fading, K
QUICKEST = 60.0  # 1/s at which a cell grows or shrinks at most
SLOWS = 3.0  # 1/s at which whirls die down: in space they fall apart, in the plane they would last
# paraffin: C25H52 needs 3.4 kg of oxygen a kilogram, and gives 44 MJ
VAPOUR = {
    "ignition": 580.0, "rate": 60.0, "oxygen": 3.4, "heat": 4.4e7, "capacity": 1212.0, "soot": 0.05,
    "soot_size": 30e-9, "glow": 8e-12, "soot_glow": 3.2e-7, "ambient": ROOM,
}  # fmt: skip
LOOK = GlowLook(820.0, 1450.0, 0.004, 5.0e-4, 7.0e-3, 0.75, 950.0)
COOLS = 4.0  # 1/s of the gas in cells at a wall: 24 W/(m² K) where they are 5 mm wide
KEPT = (*FIELDS, "air")  # carried in flux form under a glass that stands, so that none is lost
NEVER = -1.0
# of flows: rim of the glass m and m/s, where it is to go m, its half width and height m, kg/(s m) from the
# wick, s until a match is away, s since the flame went out; s when the glass came down, kg/m of oxygen then
# in it and used until then; s that the flame then lived; W/m, smoothed
RIM, SPEED, GOAL, RADIUS, HIGH, SUPPLY, LIGHTING, SINCE, SEALED, OXYGEN, USED, LIVED, POWER = range(13)


class Shapes(Boxes):
    """Glass (three boxes) and candle; the glass moves at ``speed`` m/s upwards."""

    speed = 0.0

    def place(self, flows: Floats) -> None:
        """Where the glass is by `flows`."""
        y, radius, high = float(flows[RIM]), float(flows[RADIUS]), float(flows[HIGH])
        side, half = radius + 0.5 * WALL, 0.5 * (high + WALL)
        # on the table the walls go on into it, so that no slit is left
        middles = np.array([(-side, y + half), (side, y + half), (0.0, y + high + 0.5 * WALL), (0.0, 0.0)])
        halves = [(0.5 * WALL, half), (0.5 * WALL, half), (radius + WALL, 0.5 * WALL), (CANDLE, TOP)]
        self.rows = box_rows(middles, np.tile((1.0, 0.0), (4, 1)), np.array(halves))
        self.speed = float(flows[SPEED])

    def sample(self, points: Floats) -> Sample:
        found = super().sample(points)
        found.velocity[:, 1] = np.where((found.body >= 0) & (found.body < 3), self.speed, 0.0)
        return found


class Air(BurningAir):
    """Its flows: see the numbers RIM to POWER."""

    vapour, flame_look, counts = VAPOUR, LOOK, 13

    def __init__(self, content: CandleContent, parameters: CandleParameters, active: EffectSet):
        self.parameters, self.time = parameters, 0.0
        cells, gas_effects = parameters.cells_now(), active & GAS.known
        cell, free = 2.0 * HALF / cells, Border("open")
        settings = GasSettings(
            effects=gas_effects.without(BUOYANCY), turns=int(parameters.cycles), ambient=ROOM
        )
        gas = Gas(
            Grid(cells, round(TALL / cell), cell, (-HALF, 0.0)), Borders(free, free, Border("wall"), free),
            settings, (*FIELDS, "air"), {"oxygen": FRESH, "air": AIR},
        )  # fmt: skip
        edge = faded(gas.grid.shape, 0.1, 0.3)
        super().__init__(gas, edge, active & COMBUSTION.known, BUOYANCY in gas_effects)
        x, y = gas.grid.centres()
        away = np.abs(x)
        self.wick = (away < WIDE) & (y > WICK[0]) & (y < WICK[1])
        self._beside = (away > BESIDE[0]) & (away < BESIDE[1]) & (y > TOP) & (y < TOP + ABOVE)
        self.flows[[SEALED, LIVED, SINCE]] = NEVER, NEVER, 1e3
        self.flows[[RADIUS, HIGH]] = parameters.half_width, parameters.height
        self.flows[[RIM, GOAL]] = 0.0 if content.lowered else UP
        self.shapes = Shapes()
        self.shapes.place(self.flows)
        gas.set_solids(self.shapes, moving=True)
        if content.lit:
            self.flows[[LIGHTING, SUPPLY]] = LEAVES + HOLDS, parameters.supply
        if content.lowered:
            self._seal()

    # -- what is done to it -----------------------------------------------------------------------------

    def light(self) -> None:
        """Lead a match to the wick."""
        self.flows[LIGHTING] = COMES + HOLDS + LEAVES

    def match(self) -> tuple[float, bool]:
        """How far a match is on its way to the wick, 0 to 1, and whether it touches."""
        left = float(self.flows[LIGHTING])
        share = min((COMES + HOLDS + LEAVES - left) / COMES, left / LEAVES, 1.0)
        return share * share * (3.0 - 2.0 * share), LEAVES < left <= LEAVES + HOLDS

    def lead(self, height: float) -> None:
        """The rim of the glass is to go to a height, m."""
        self.flows[GOAL] = min(max(height, 0.0), UP)

    # -- a step -----------------------------------------------------------------------------------------

    def step(self, dt: float) -> None:
        """Glass, wick, flame, then the gas."""
        gas, flows = self.gas, self.flows
        self._move(dt)
        self._feed(dt)
        gas.expansion[:] = 0.0
        self.flames.step(gas.scalars, dt, gas.expansion)
        flows[POWER] += (self.flames.power - flows[POWER]) * min(dt / LAG, 1.0)
        self._follow(dt)
        np.clip(gas.expansion, -QUICKEST, QUICKEST, out=gas.expansion)
        self._cool(dt)
        gas.force[:] = 0.0
        self.rise()
        self.slow(SLOWS, SLOWS)
        if gas.settings.conservative:
            self._carry_shut(dt)
        else:
            self._carry(dt)
        self.time += dt

    def _carry(self, dt: float) -> None:
        """A step of open air, whose density follows from its temperature."""
        gas, fuel = self.gas, self.gas.scalars[..., 1]
        before = float(np.sum(fuel))
        # what is carried as a value grows thin as the gas expands
        gas.scalars[..., 1:] *= elementwise.exp(-dt * gas.expansion)[..., None]
        gas.step(dt)
        # nor is it lost on its way but through the sides
        left = max(before - self._out(fuel) * dt / self.cell, 0.0)
        fuel *= left / max(float(np.sum(fuel)), 1e-12)
        oxygen = gas.scalars[..., 2]  # air of a temperature has no more
        np.minimum(oxygen, FRESH * ROOM / self.temperature, out=oxygen)
        np.divide(AIR * ROOM, self.temperature, out=gas.scalars[..., 4])

    def _carry_shut(self, dt: float) -> None:
        """A step under a glass that stands. Heat goes with the mass that has it, in flux form as all else.

        Density times temperature is the pressure, which is the same all over. Where a cell would drift from
        it in this step, gas goes out or in (Pember et al. 1998). Or cells would keep the oxygen of cold gas
        as they warm.
        """
        gas, warm, air = self.gas, self.temperature, self.gas.field("air")
        gas.expansion[:] = 0.0  # of this step's carrying by the velocity that there is
        under, pressure = self.under(), warm * air * elementwise.exp(-dt * gas.divergence())
        even = np.where(under, 1.0 / float(np.mean(1.0 / pressure[under])), AIR * ROOM)
        gas.expansion[:] = (1.0 - even / pressure) / dt
        warm *= air / AIR
        gas.step(dt)
        np.divide(AIR * warm, air, out=warm)

    def _out(self, cells: Floats) -> float:
        """Of what cells (ny, nx) hold for each m³ so much leaves through the sides, m/s times that."""
        u, v = self.gas.u, self.gas.v
        ways = (cells[:, -1], u[:, -1]), (cells[:, 0], -u[:, 0]), (cells[-1], v[-1])
        return sum(float(np.sum(rim * np.maximum(out, 0.0))) for rim, out in ways)

    def _move(self, dt: float) -> None:
        """The glass on its way; its solids are sampled only while it moves, and once as it has stopped."""
        flows, gas = self.flows, self.gas
        was, left = float(flows[SPEED]), float(flows[GOAL] - flows[RIM])
        flows[SPEED] = min(max(left / dt, -QUICK), QUICK)
        flows[RIM] = flows[GOAL] if abs(left) <= QUICK * dt else flows[RIM] + flows[SPEED] * dt
        resized = False
        if flows[RIM] == UP:
            size = np.array([self.parameters.half_width, self.parameters.height])
            resized = not np.array_equal(flows[[RADIUS, HIGH]], size)
            flows[[RADIUS, HIGH]] = size
        gas.solids.moving = flows[SPEED] != 0.0 or was != 0.0 or resized
        if gas.solids.moving:
            self.shapes.place(flows)
        if flows[RIM] > 0.0:
            flows[SEALED] = NEVER
        elif not gas.solids.moving and flows[SEALED] == NEVER:
            self._seal()
        kept = () if flows[SEALED] == NEVER else KEPT
        if gas.settings.conservative != kept:
            self._change(conservative=kept)

    def _seal(self) -> None:
        """The glass stands on the table: what is in it stays in it."""
        self.flows[[SEALED, OXYGEN, USED, LIVED]] = self.time, self.inside("oxygen"), self.used, NEVER

    def _feed(self, dt: float) -> None:
        """Vapour from a wick that burns, smoke from one that does not; how hot the wick is."""
        flows, cells, wick, lit = self.flows, self.gas.scalars, self.wick, self.match()[1]
        flows[LIGHTING] = max(flows[LIGHTING] - dt, 0.0)
        if lit:
            flows[SUPPLY] = self.parameters.supply
        share = dt / (self.cell * self.cell * float(np.count_nonzero(wick)))
        if flows[SUPPLY] > 0.0:
            cells[wick, 1] += flows[SUPPLY] * share
            cells[wick, 0] = np.maximum(cells[wick, 0], MATCH if lit else GLOWS)
        else:
            fading = elementary.exp(-float(flows[SINCE]) / SMOKE_S)
            cells[wick, 3] += SMOKES * fading * share
            cells[wick, 0] = np.maximum(cells[wick, 0], ROOM + (SMOKE_HOT - ROOM) * fading)
            flows[SINCE] += dt

    def _cool(self, dt: float) -> None:
        """Glass, table and candle take heat from the gas beside them; it shrinks."""
        warm, beside = self.temperature, (self.gas.faces.clear < 1.5) & ~self.wick
        colder = np.where(beside, (ROOM - warm) * min(COOLS * dt, 1.0), 0.0)
        self.gas.expansion += colder / (warm * dt)
        warm += colder

    def _follow(self, dt: float) -> None:
        """The flame's heat makes the vapour: with less power less of it, until it is out. In air with less
        oxygen than its limit a flame is too cold to go on, however much more of it comes.
        """
        flows, most = self.flows, self.parameters.supply
        if flows[SUPPLY] <= 0.0 or self.match()[1]:
            return
        kept = self.flames.power / (self.parameters.feedback * most * VAPOUR["heat"])
        kept = kept if self.fed() >= self.parameters.limit else 0.0
        flows[SUPPLY] += (most * min(kept, 1.0) - flows[SUPPLY]) * min(dt / LAG, 1.0)
        if flows[SUPPLY] < OUT * most:
            flows[[SUPPLY, SINCE]] = 0.0
            if flows[SEALED] != NEVER and flows[LIVED] == NEVER:
                flows[LIVED] = self.time - flows[SEALED]

    # -- what there is ----------------------------------------------------------------------------------

    def strength(self) -> float:
        """Of the flame, 0 to 1: the vapour that comes and burns, beside what must come and what can."""
        most = self.parameters.supply
        comes = max(float(self.flows[SUPPLY]) / most - OUT, 0.0) / (1.0 - OUT)
        return min(comes, float(self.flows[POWER]) / (most * VAPOUR["heat"]), 1.0)

    @property
    def used(self) -> float:
        """kg/m of oxygen that has burnt since the beginning."""
        return self.flames.books_now().used

    def under(self) -> Any:
        """(ny, nx) which open cells are under the glass, or in it where it is up."""
        x, y = self.gas.grid.centres()
        low, reach = self.flows[RIM], self.flows[RADIUS] + 0.5 * WALL
        inside = (np.abs(x) < reach) & (y > low) & (y < low + self.flows[HIGH] + 0.5 * WALL)
        return inside & (self.gas.solver.equation.inverse > 0.0)

    def inside(self, name: str) -> float:
        """kg/m of a field under the glass."""
        return float(np.sum(self.gas.field(name)[self.under()])) * (self.cell * self.cell)

    def share(self, cells: Any) -> float:
        """% by volume that are oxygen in all gas of these cells (ny, nx)."""
        oxygen, air = (float(np.sum(self.gas.field(name)[cells])) for name in ("oxygen", "air"))
        return PER_VOLUME * (oxygen / air) * (AIR / FRESH) if air > 0.0 else math.nan

    def fed(self) -> float:
        """% by volume that are oxygen in the gas from which the flame draws its air."""
        return self.share(self._beside)

    def restore(self, fields: Iterator[Any]) -> None:
        state: AirState = next(fields)
        self.flows[:] = state.flows
        self.shapes.place(self.flows)
        super().restore(iter((state,)))
