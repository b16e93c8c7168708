"""A tank of liquid with solids, taps and drains, and what a hand does to them."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from game.arrays import Floats, Longs, Point
from game.physics.effects import EffectSet
from game.physics.grid.layout import Grid
from game.physics.kernels import elementary, elementwise
from game.physics.liquid import Liquid, LiquidSettings, LiquidState
from game.physics.liquid.effects import LIQUID
from game.physics.solids import Disc, Material, SolidState, box
from game.physics.solids.arrays.state import DYNAMIC
from game.physics.surfaces import SolidSurface
from game.scenes.liquid.level import LiquidContent, SolidEntry
from game.scenes.liquid.parameters import LiquidParameters
from game.settings import taken
from game.worlds.members.solids import Solids
from game.worlds.stopwatch import Stopwatch
from game.worlds.world import Kept, Member, World

DENSITY = 1000.0  # kg/m³
MOST_PARTICLES = 40_000
MOST_THINGS = 64  # solids, and taps, and drains
GOLDEN = 0.6180339887498949
CROWDED = 1.0  # fill of a cell into which no tap runs
BODY, WIDE, TALL, WEIGHT = range(4)  # columns of things: body, half width, half height (0: a ball), density
FASTEST = 20.0  # m/s, of the hand in water


class LiquidWorldState(NamedTuple):
    """solids; liquid; things (n, 4) see BODY; taps (n, 5): x, y, width m, speed m/s; drains (n, 3): x, y,
    radius m; flow: (3,) particles owed by the taps, given, taken by drains and hand.
    """

    solids: SolidState
    liquid: LiquidState
    things: Floats
    taps: Floats
    drains: Floats
    flow: Floats


class Water(Member):
    """The liquid as a member. Solids are sampled in each step in which one can have moved."""

    def __init__(self, liquid: Liquid, solids: Solids, surface: SolidSurface):
        self.liquid, self.solids, self.surface, self.watch = liquid, solids, surface, Stopwatch()
        self.parts, self.stale = 0, True

    def step(self, dt: float) -> None:
        rows = self.solids.world.bodies
        if self.stale or bool((rows.flags & DYNAMIC).any()):
            self.liquid.set_solids(self.surface)
            self.stale = False
        with self.watch.time("step"):
            self.parts = self.liquid.advance(dt)

    def measure(self) -> None:
        """Find surface and fill of what is there now. Nothing that later steps depend on changes."""
        self.liquid.sample_solids(self.surface)
        self.liquid.refresh()
        self.stale = True

    def state(self) -> tuple[Any, ...]:
        return (self.liquid.state(),)

    def restore(self, fields: Iterator[Any]) -> None:
        self.liquid.restore(next(fields))
        self.stale = True


class LiquidWorld(World):
    """The tank. pours: where the hand pours, None while it does not; anchor: what a grip hangs on."""

    state_type = LiquidWorldState

    def __init__(self, content: LiquidContent, parameters: LiquidParameters, active: EffectSet, seed: int):
        wide, high = content.tank
        cell = wide / int(parameters.cells)
        grid = Grid(int(parameters.cells), max(4, round(high / cell)), cell)
        spread = int(parameters.spread)
        most = min(MOST_PARTICLES, 2 * grid.nx * grid.ny * spread * spread)
        self.solids = Solids(parameters, active)
        self.anchor = self.solids.anchor()
        self.walls = self._build_walls(grid, content.open)
        self.things: Floats = np.zeros((0, 4))
        self.taps: Floats = np.zeros((0, 5))
        self.drains: Floats = np.zeros((0, 3))
        self.flow: Floats = np.zeros(3)
        self.pours: Point | None = None
        self.scoops: Point | None = None
        self.liquid = Liquid(
            grid, self._settings(parameters), most=most, spread=spread, density=DENSITY,
            effects=active & LIQUID.known, open_sides=content.open,
        )  # fmt: skip
        for entry in content.solids:
            self._add(entry)
        for tap in content.taps:
            self.add_tap(tap.at, tap.speed, tap.width)
        for drain in content.drains:
            self.add_drain(drain.at, drain.radius)
        surface = SolidSurface(self.solids.world, without=(self.anchor, *self.walls))
        self.water = Water(self.liquid, self.solids, surface)
        self.liquid.set_solids(surface)
        for one in content.water:
            places = self.liquid.lattice(one.low, one.high)
            if one.radius > 0.0:
                places = self._disc(one.low, one.radius)
            self.liquid.add(places, one.speed)
        self.liquid.refresh()
        self.start = max(self.liquid.wet_area(), 1e-12)
        super().__init__(
            content, parameters, active, self.solids, self.water,
            Kept(self, "things", "taps", "drains", "flow"),
        )  # fmt: skip

    @staticmethod
    def _settings(chosen: LiquidParameters) -> LiquidSettings:
        return taken(LiquidSettings, chosen.values)

    def _build_walls(self, grid: Grid, open_sides: tuple[str, ...]) -> list[int]:
        """Bodies that keep solids in the tank."""
        (left, bottom), (right, top), thick = grid.lower, grid.upper, 0.5
        wide, high, x, y = right - left, top - bottom, 0.5 * (left + right), 0.5 * (bottom + top)
        walls = {
            "left": (thick, 3.0 * high, left - 0.5 * thick, y),
            "right": (thick, 3.0 * high, right + 0.5 * thick, y),
            "bottom": (wide + 2.0 * thick, thick, x, bottom - 0.5 * thick),
        }  # fmt: skip
        return [
            self.solids.world.add_body(box(width, height), (at_x, at_y), kind="fixed")
            for side, (width, height, at_x, at_y) in walls.items()
            if side not in open_sides
        ]

    def change_parameter(self, name: str) -> None:
        super().change_parameter(name)
        self.liquid.settings = self._settings(self.parameters)
        self.water.watch.clear()

    def change_effects(self, active: EffectSet) -> None:
        super().change_effects(active)
        self.liquid.effects = active & LIQUID.known

    # -- a step -------------------------------------------------------------------------------------------

    def advance(self, dt: float) -> str:
        if self.pours is not None or (self.parameters.running and len(self.taps)):
            self.liquid.refresh()
        if self.parameters.running:
            for x, y, width, u, v in self.taps.tolist():
                self._run((x, y), (u, v), width, dt)
        if self.pours is not None:
            width = max(math.sqrt(self.parameters.poured * 0.02), 2.0 * self.liquid.grid.cell)
            self._run(self.pours, (0.0, -self.parameters.poured / width), width, dt)
        for x, y, radius in self.drains.tolist():
            self.take_out((x, y), radius)
        if self.scoops is not None:
            self.take_out(self.scoops, float(self.parameters.size))
        self.water.step(dt)
        self.solids.step(dt)
        self.time += dt
        return ""

    def _run(self, at: Point, speed: Point, width: float, dt: float) -> None:
        """Let so much in as a mouth of a width gives in dt, s; what finds no space is refused."""
        fast = elementary.hypot(*speed)
        owed = float(self.flow[0]) + fast * width * dt / self.liquid.area
        count = int(owed)
        self.flow[0] = owed - count
        if count == 0 or fast == 0.0:
            return
        number = self.flow[1] + np.arange(count)
        across = number * GOLDEN
        across = (across - np.floor(across) - 0.5) * width
        along = (np.arange(count) + 0.5) / count * fast * dt
        nx, ny = speed[0] / fast, speed[1] / fast
        places = np.stack([at[0] + along * nx - across * ny, at[1] + along * ny + across * nx], axis=1)
        grid, fill = self.liquid.grid, self.liquid.cells.fill
        cells = np.floor((places - grid.lower) / grid.cell).astype(np.int64)
        inside = (cells >= 0).all(axis=1) & (cells < (grid.nx, grid.ny)).all(axis=1)
        free = np.array(inside)
        free[inside] = self._around(fill, cells[inside]) < CROWDED
        self.liquid.account[2] += count - int(np.count_nonzero(free))
        self.liquid.add(places[free], speed)
        self.flow[1] += count

    @staticmethod
    def _around(fill: Floats, cells: Longs) -> Floats:
        """Mean fill (n,) of cells (n, 2), column and row, and the eight around each."""
        ny, nx = fill.shape
        total = np.zeros(len(cells))
        for right in (-1, 0, 1):
            for up in (-1, 0, 1):
                total += fill[np.clip(cells[:, 1] + up, 0, ny - 1), np.clip(cells[:, 0] + right, 0, nx - 1)]
        return total / 9.0

    def take_out(self, at: Point, radius: float) -> None:
        """Water within a radius (m) vanishes."""
        away = self.liquid.places - at
        self.flow[2] += self.liquid.keep_only((away * away).sum(axis=1) > radius * radius)

    # -- solids, taps, drains -------------------------------------------------------------------------------

    def _add(self, entry: SolidEntry) -> None:
        material = Material(density=max(entry.density, 1e-3) * DENSITY, friction=0.3, restitution=0.1)
        kind = "dynamic" if entry.density > 0.0 else "fixed"
        turn = math.radians(entry.angle)
        if entry.radius > 0.0:
            shape: Any = Disc(entry.radius, material=material)
            wide, tall = entry.radius, 0.0
        else:
            shape, (wide, tall) = (
                box(*entry.size, material=material),
                (0.5 * entry.size[0], 0.5 * entry.size[1]),
            )
        body = self.solids.world.add_body(shape, entry.at, turn, kind=kind, restless=True)
        self.things = np.concatenate([self.things, [(body, wide, tall, entry.density)]])

    def add_solid(self, at: Point, ball: bool) -> str:
        """A box or a ball of the chosen size and density; why not."""
        if len(self.things) >= MOST_THINGS:
            return f"There are {MOST_THINGS} solids already."
        half, density = float(self.parameters.size), float(self.parameters.weight)
        self._add(
            SolidEntry(at=at, size=(2.0 * half, 2.0 * half), radius=half if ball else 0.0, density=density)
        )
        self.water.stale = True
        return ""

    def remove_solid(self, body: int) -> None:
        """Take a body out."""
        self.solids.world.remove_body(body)
        self.things = self.things[self.things[:, BODY] != body]
        self.water.stale = True

    def loose(self) -> Longs:
        """Bodies that a hand may take."""
        return self.things[self.things[:, WEIGHT] > 0.0, BODY].astype(np.int64)

    def bodies(self) -> Longs:
        """Those of all things."""
        return self.things[:, BODY].astype(np.int64)

    def add_tap(self, at: Point, speed: Point, width: float) -> str:
        """A tap; why not."""
        if len(self.taps) >= MOST_THINGS:
            return f"There are {MOST_THINGS} taps already."
        self.taps = np.concatenate([self.taps, [(*at, width, *speed)]])
        return ""

    def add_drain(self, at: Point, radius: float) -> str:
        """A drain; why not."""
        if len(self.drains) >= MOST_THINGS:
            return f"There are {MOST_THINGS} drains already."
        self.drains = np.concatenate([self.drains, [(*at, radius)]])
        return ""

    # -- the hand -------------------------------------------------------------------------------------------

    def _disc(self, at: Point, radius: float) -> Floats:
        places = self.liquid.lattice(np.asarray(at) - radius, np.asarray(at) + radius)
        away = places - at
        return np.asarray(places[(away * away).sum(axis=1) <= radius * radius])

    def let_fall(self, at: Point) -> None:
        """A drop about a place, where there is no water yet."""
        places = self._disc(at, float(self.parameters.size))
        self.liquid.refresh()
        grid, fill = self.liquid.grid, self.liquid.cells.fill
        if len(places):
            cells = np.clip(
                np.floor((places - grid.lower) / grid.cell).astype(np.int64), 0, (grid.nx - 1, grid.ny - 1)
            )
            self.liquid.add(places[fill[cells[:, 1], cells[:, 0]] < 0.5])

    def stir(self, at: Point, speed: Point) -> None:
        """Let the water near a place go at a speed, m/s."""
        reach = float(self.parameters.size)
        away = self.liquid.places - at
        near = elementwise.exp(-(away * away).sum(axis=1) / (reach * reach))[:, None]
        goal = np.clip(speed, -FASTEST, FASTEST)
        self.liquid.speeds[:] += near * (goal - self.liquid.speeds)
