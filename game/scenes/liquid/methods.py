"""Methods that a dam is shown by: each steps a column of water in its own tank and tells its front.

One more method is one more class here, its name in `COLUMNS` and in `DamState`, and its brush in the view.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.grid.layout import Grid
from game.physics.liquid import CARRIERS, Liquid, LiquidSettings, LiquidState
from game.physics.particle_fluids import LAWS, FluidSettings, ParticleFluid, lattice
from game.physics.particle_fluids.store import FluidState
from game.physics.waves import ShallowSettings, ShallowState, ShallowWater
from game.worlds.stopwatch import Stopwatch
from game.worlds.world import Member

SOFTNESS = 6.0  # speed of sound of laws that squeeze, in √(g height)
THIN = 0.01  # of the column's height: shallower water is no front
AT_MOST, COURANT = 12, 0.4  # iterations, spacings in a step: a front is no resting column, which needs more
TALL = 1.15  # height of the tanks, in that of the column; there they have a lid


class Column(NamedTuple):
    """Of water before the gate goes: width and height m, length of the floor m, gravity m/s²."""

    width: float
    height: float
    length: float
    gravity: float


class DamMethod(Member):
    """One method. name, title: as readouts and the picture call it; floor: m, where it is drawn; area:
    m² at first; stepped: s, the last time; watch: what steps cost. parameters: of the scene.
    """

    name = title = ""

    def __init__(self, column: Column, floor: float, parameters: Any):
        self.column, self.floor, self.watch = column, floor, Stopwatch()
        self.area, self.stepped = column.width * column.height, np.nan

    def step(self, dt: float) -> None:
        self.stepped = dt
        with self.watch.time("step"):
            self.go_on(dt)

    def go_on(self, dt: float) -> None:
        """Step by dt, s."""
        raise NotImplementedError

    def front(self) -> float:
        """m, from the wall."""
        raise NotImplementedError

    def volume(self) -> float:
        """m² of water."""
        raise NotImplementedError


class ByLiquid(DamMethod):
    """Particles on cells, by APIC or FLIP."""

    name, title = "liquid", "liquid"

    def __init__(self, column: Column, floor: float, parameters: Any):
        super().__init__(column, floor, parameters)
        cell = column.width / int(parameters.cells)
        high = round(TALL * column.height / cell)
        grid = Grid(round(column.length / cell), high, cell, (0.0, floor))
        settings = LiquidSettings(gravity=column.gravity, carrier=CARRIERS.index(parameters.carrier))
        self.liquid = Liquid(grid, settings, most=min(6 * grid.nx * grid.ny, 200_000))
        self.liquid.add(self.liquid.lattice((0.0, floor), (column.width, floor + column.height)))
        self.area = self.liquid.count * self.liquid.area

    def go_on(self, dt: float) -> None:
        self.liquid.advance(dt)

    def front(self) -> float:
        """One cell's worth of liquid lies beyond it."""
        x = self.liquid.places[:, 0]
        beyond = self.liquid.spread * self.liquid.spread
        return float(np.partition(x, len(x) - beyond)[len(x) - beyond]) if len(x) > beyond else np.nan

    def volume(self) -> float:
        self.liquid.refresh()
        return self.liquid.wet_area()

    def state(self) -> tuple[Any, ...]:
        return (self.liquid.state(),)

    def restore(self, fields: Iterator[Any]) -> None:
        self.liquid.restore(next(fields))


class ByParticles(DamMethod):
    """Particles that feel each other, by a law of fluids of particles."""

    name, title = "particles", "particles"

    def __init__(self, column: Column, floor: float, parameters: Any):
        super().__init__(column, floor, parameters)
        rows = math.sqrt(int(parameters.particles) * column.width / column.height)
        spacing, top = column.width / max(round(rows), 1), floor + TALL * column.height
        tank = ((0.0, floor), (column.length, floor), (column.length, top), (0.0, top))
        settings = FluidSettings(
            gravity=column.gravity, law=LAWS.index(parameters.law), iterations=AT_MOST,
            softness=SOFTNESS * math.sqrt(column.gravity * column.height), courant=COURANT,
        )  # fmt: skip
        self.fluid = ParticleFluid(spacing, vessel=(tank,), settings=settings)
        self.fluid.add(lattice((0.0, floor), (column.width, floor + column.height), spacing))
        self.area = len(self.fluid.place) * spacing * spacing

    def go_on(self, dt: float) -> None:
        self.fluid.advance(dt)

    def front(self) -> float:
        """Half a spacing beyond the foremost: there a particle's own liquid ends."""
        return float(np.max(self.fluid.place[:, 0])) + 0.5 * self.fluid.spacing

    def volume(self) -> float:
        """What is squeezed takes less room."""
        spacing = self.fluid.spacing
        return float(np.sum(1.0 / np.maximum(self.fluid.density(), 1.0))) * spacing * spacing

    def state(self) -> tuple[Any, ...]:
        return (self.fluid.state(),)

    def restore(self, fields: Iterator[Any]) -> None:
        self.fluid.restore(next(fields))


class ByShallowWater(DamMethod):
    """A row of depths: at each place the water goes at one speed from surface to bed."""

    name, title = "shallow", "shallow water"

    def __init__(self, column: Column, floor: float, parameters: Any):
        super().__init__(column, floor, parameters)
        cells = int(parameters.row)
        self.x: Floats = np.asarray((np.arange(cells) + 0.5) * (column.length / cells))
        depth = np.where(self.x < column.width, column.height, 0.0)
        settings = ShallowSettings(gravity=column.gravity)
        self.water = ShallowWater(depth, np.zeros(cells), column.length / cells, settings)
        self.area = self.water.volume()

    def go_on(self, dt: float) -> None:
        self.water.advance(dt)

    def front(self) -> float:
        wet = np.flatnonzero(self.water.depth[0] > THIN * self.column.height)
        return float(self.x[wet[-1]] + 0.5 * self.water.cell) if len(wet) else np.nan

    def volume(self) -> float:
        return self.water.volume()

    def state(self) -> tuple[Any, ...]:
        return (self.water.state(),)

    def restore(self, fields: Iterator[Any]) -> None:
        self.water.restore(next(fields))


COLUMNS: tuple[type[DamMethod], ...] = (ByLiquid, ByParticles, ByShallowWater)  # from the top


class DamState(NamedTuple):
    """Each method's own, in the order of `COLUMNS`."""

    liquid: LiquidState
    particles: FluidState
    shallow: ShallowState
