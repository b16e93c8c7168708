"""Methods that a dam is shown by: each steps a column of water in its own tank and tells its front.

One more method is one more class here, its name in `COLUMNS` and in `DamState`, and its brush in the view.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.grid.layout import Grid
from game.physics.liquid import CARRIERS, Liquid, LiquidSettings, LiquidState
from game.physics.waves import ShallowSettings, ShallowState, ShallowWater
from game.worlds.stopwatch import Stopwatch
from game.worlds.world import Member

THIN = 0.01  # of the column's height: shallower water is no front
TALL = 1.15  # height of the tanks, in that of the column; there they have a lid


class Column(NamedTuple):
    """Of water before the gate goes: width and height m, length of the floor m, gravity m/s²."""

    width: float
    height: float
    length: float
    gravity: float


class DamMethod(Member):
    """One method. name, title: as readouts and the picture call it; floor: m, where it is drawn; area:
    m² at first. parameters: of the scene.
    """

    name = title = ""

    def __init__(self, column: Column, floor: float, parameters: Any):
        self.column, self.floor, self.watch = column, floor, Stopwatch()
        self.area = column.width * column.height

    def step(self, dt: float) -> None:
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


COLUMNS: tuple[type[DamMethod], ...] = (ByLiquid, ByShallowWater)  # from the top


class DamState(NamedTuple):
    """Each method's own, in the order of `COLUMNS`."""

    liquid: LiquidState
    shallow: ShallowState
