"""A tank of liquid with solids, taps and drains, and what a hand does to them."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from game.arrays import Floats, Longs, Point
from game.physics.effects import EffectSet
from game.physics.grid.layout import Grid
from game.physics.liquid import LiquidState
from game.physics.solids import Disc, Material, SolidState, box
from game.scenes.liquid.level import LiquidContent, SolidEntry
from game.scenes.liquid.parameters import LiquidParameters
from game.worlds.members.solids import Solids
from game.worlds.members.water import DENSITY, Mouths, Water
from game.worlds.world import Kept, World

MOST_PARTICLES = 40_000
MOST_THINGS = 64  # solids, and taps, and drains
BODY, WIDE, TALL, WEIGHT = range(4)  # columns of things: body, half width, half height (0: a ball), density


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
        self.pours: Point | None = None
        self.scoops: Point | None = None
        self.water = Water(
            grid, parameters, active, self.solids, most=most, spread=spread, open_sides=content.open
        )
        self.liquid, self.mouths = self.water.liquid, Mouths(self.water, MOST_THINGS)
        self.mouths.running = bool(parameters.running)
        for entry in content.solids:
            self._add(entry)
        for tap in content.taps:
            self.mouths.add_tap(tap.at, tap.speed, tap.width)
        for drain in content.drains:
            self.mouths.add_drain(drain.at, drain.radius)
        self.water.meet(without=(self.anchor, *self.walls))
        for one in content.water:
            filled = self.water.disc(one.low, one.radius) if one.radius > 0.0 else None
            self.liquid.add(self.liquid.lattice(one.low, one.high) if filled is None else filled, one.speed)
        self.water.begin()
        super().__init__(
            content, parameters, active, self.solids, self.water, Kept(self, "things"), self.mouths
        )

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
        self.mouths.running = bool(self.parameters.running)

    # -- a step -------------------------------------------------------------------------------------------

    def advance(self, dt: float) -> str:
        self.mouths.step(dt)
        if self.pours is not None:
            self.liquid.refresh()
            width = max(math.sqrt(self.parameters.poured * 0.02), 2.0 * self.liquid.grid.cell)
            self.mouths.run(self.pours, (0.0, -self.parameters.poured / width), width, dt)
        if self.scoops is not None:
            self.mouths.take_out(self.scoops, float(self.parameters.size))
        self.water.step(dt)
        self.solids.step(dt)
        self.time += dt
        return ""

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
