"""Liquids of particles in a vessel, what heats and feeds them, and what a hand does to them."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.effects import EffectSet
from game.physics.particle_fluids import FluidState, Liquid, ParticleFluid, lattice
from game.physics.particle_fluids.air import renew_air
from game.physics.particle_fluids.effects import AIR_ON_DEMAND, WARMTH
from game.physics.particle_fluids.settings import NEVER, FluidSettings
from game.physics.particle_fluids.walls import is_held
from game.scenes.honey.level import HeaterEntry, HoneyContent, PoolEntry
from game.scenes.honey.parameters import HoneyParameters
from game.settings import taken
from game.worlds.world import Kept, Whole, World

MOST_PARTICLES = 20_000  # of a scene
HAND = 4.0  # spacings that the hand reaches
POUR_SPEED = 1.0  # m/s
AIR_EVERY = 4  # steps
FULL = "There are as many particles as a scene may have."


class HoneyState(NamedTuple):
    """fluid; counts: (6,) particles from the beginning, by the hand, by taps, air made and gone, scooped out.

    owed: (taps + 1,) spacings that have run out and are not filled yet, of taps and of the hand.
    run: (taps,) particles that each tap has let out.
    """

    fluid: FluidState
    counts: Floats
    owed: Floats
    run: Floats


START, BY_HAND, BY_TAPS, AIR_MADE, AIR_GONE, SCOOPED = range(6)


class HoneyWorld(World):
    """Fluid of a level. pours: where the hand pours, m, or None; stirs: where and how fast it stirs."""

    state_type = HoneyState

    def __init__(self, content: HoneyContent, parameters: HoneyParameters, active: EffectSet, seed: int):
        self.fluid = ParticleFluid(
            content.spacing, self._liquids(content, parameters), content.vessel,
            taken(FluidSettings, parameters.values), active,
        )  # fmt: skip
        for pool in content.pools:
            if pool.kind >= len(content.liquids):
                raise ValueError(f"pools: kind {pool.kind}, there are {len(content.liquids)} liquids")
            self._fill(pool)
        if any(tap.kind >= len(content.liquids) for tap in content.taps):
            raise ValueError("taps: kind of a liquid that there is not")
        self.counts: Floats = np.zeros(6)
        self.counts[START] = len(self.fluid.place)
        self.owed: Floats = np.zeros(len(content.taps) + 1)
        self.run: Floats = np.zeros(len(content.taps))
        self.pours: tuple[float, float] | None = None
        self.substeps = 0
        super().__init__(content, parameters, active, Whole(self.fluid), Kept(self, "counts", "owed", "run"))

    @staticmethod
    def _liquids(content: HoneyContent, chosen: HoneyParameters) -> tuple[Liquid, ...]:
        return tuple(
            Liquid(
                one.density, one.viscosity * chosen.thickness, one.tension * chosen.hold, one.swelling,
                one.boils or NEVER, one.latent, one.vapour, one.springy, one.air,
            )
            for one in content.liquids
        )  # fmt: skip

    def _fill(self, pool: PoolEntry) -> None:
        spacing = self.fluid.spacing
        area = (pool.right - pool.left) * (pool.top - pool.bottom) / (spacing * spacing)
        if not 0.0 <= area <= MOST_PARTICLES - len(self.fluid.place):
            raise ValueError(f"pools: {area:.0f} particles in one, expected at most {MOST_PARTICLES} in all")
        places = lattice((pool.left, pool.bottom), (pool.right, pool.top), spacing)
        if pool.round:
            x, y = 0.5 * (pool.left + pool.right), 0.5 * (pool.bottom + pool.top)
            half = max(0.5 * (pool.right - pool.left), 1e-9), max(0.5 * (pool.top - pool.bottom), 1e-9)
            across, up = (places[:, 0] - x) / half[0], (places[:, 1] - y) / half[1]
            places = places[across * across + up * up < 1.0]
        held = np.array([is_held(self.fluid.edges, place) for place in places], dtype=bool)
        if len(places):
            self.fluid.add(places[held], pool.kind, pool.speed, pool.heat)

    def change_parameter(self, name: str) -> None:
        self.fluid.settings = taken(FluidSettings, self.parameters.values)
        self.fluid.set_liquids(self._liquids(self.content, self.parameters))

    def change_effects(self, active: EffectSet) -> None:
        super().change_effects(active)
        self.fluid.active = active

    # -- a step ---------------------------------------------------------------------------------------

    def advance(self, dt: float) -> str:
        for number, tap in enumerate(self.content.taps):
            if self.run[number] < tap.most:
                made = self._run(number, tap.at, tap.width, tap.speed, tap.kind, dt)
                self.run[number] += made
                self.counts[BY_TAPS] += made
        if self.pours is not None:
            width = 2.0 * HAND * self.fluid.spacing
            kind = min(int(self.parameters.poured), len(self.content.liquids) - 1)
            self.counts[BY_HAND] += self._run(-1, self.pours, width, POUR_SPEED, kind, dt)
        if WARMTH in self.active:
            for heater in self.content.heaters:
                self._heat(heater, dt)
        self.substeps = self.fluid.advance(dt)
        if AIR_ON_DEMAND in self.active and round(self.time / dt) % AIR_EVERY == 0:
            made, gone = renew_air(self.fluid)
            self.counts[AIR_MADE] += made
            self.counts[AIR_GONE] += gone
        self.time += dt
        return ""

    def _run(self, number: int, at: tuple[float, float], width: float, speed: float, kind: int,
             dt: float) -> int:  # fmt: skip
        """As many rows of particles as have run out in a step, a spacing from row to row; how many particles.

        A row begins as far below the tap as it has gone since it left it, so no gap comes of the step.
        """
        spacing, fluid = self.fluid.spacing, self.fluid
        self.owed[number] += speed * dt / spacing
        rows = math.floor(self.owed[number])
        if rows == 0:
            return 0
        self.owed[number] -= rows
        across = max(1, round(width / spacing))
        x = at[0] + (np.arange(across) - 0.5 * (across - 1)) * spacing
        y = at[1] - (self.owed[number] + np.arange(rows)) * spacing
        places = np.stack([np.tile(x, rows), np.repeat(y, across)], axis=1)
        free = [
            is_held(fluid.edges, place)
            and float(np.min(np.sum(np.square(fluid.place - place), axis=1), initial=math.inf))
            > 0.49 * spacing * spacing
            for place in places
        ]
        places = places[np.array(free)]
        if not len(places) or len(fluid.place) + len(places) > MOST_PARTICLES:
            return 0
        fluid.add(places, kind, (0.0, -speed))
        return len(places)

    def _heat(self, heater: HeaterEntry, dt: float) -> None:
        place, heat = self.fluid.place, self.fluid.heat
        here = (
            (place[:, 0] >= heater.left) & (place[:, 0] <= heater.right)
            & (place[:, 1] >= heater.bottom) & (place[:, 1] <= heater.top)
        )  # fmt: skip
        share = heater.rate * dt / (1.0 + heater.rate * dt)
        heat[here] += share * (heater.heat - heat[here])

    # -- the hand -------------------------------------------------------------------------------------

    def near(self, at: tuple[float, float]) -> Floats:
        """(n,) how much of the hand at a place is felt by each particle, 0 to 1."""
        reach = HAND * self.fluid.spacing
        square = np.sum(np.square(self.fluid.place - np.asarray(at)), axis=1) / (reach * reach)
        return np.asarray(np.maximum(1.0 - square, 0.0))

    def stir(self, at: tuple[float, float], velocity: tuple[float, float]) -> str:
        """Let the liquid near a place go with the hand."""
        near = self.near(at)
        self.fluid.velocity += near[:, None] * (np.asarray(velocity) - self.fluid.velocity)
        return "" if near.any() else "There is no liquid there."

    def scoop(self, at: tuple[float, float]) -> str:
        """Take away what is near a place."""
        near = self.near(at) > 0.0
        self.counts[SCOOPED] += float(np.sum(near))
        self.fluid.remove(near)
        return "" if near.any() else "There is no liquid there."

    def pour(self, at: tuple[float, float] | None) -> str:
        """Pour at a place from now on; None: no more."""
        self.pours = at
        if at is not None and len(self.fluid.place) >= MOST_PARTICLES:
            return FULL
        return ""
