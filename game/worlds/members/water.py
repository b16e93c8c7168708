"""A liquid with a free surface as a member: what moves it, what comes in and goes out, how it is heard."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from game.arrays import Floats, Longs, Point
from game.physics.effects import EffectSet
from game.physics.grid.layout import Grid
from game.physics.kernels import elementary, elementwise
from game.physics.liquid import Liquid, LiquidSettings
from game.physics.liquid.effects import LIQUID
from game.physics.solids.arrays.state import ASLEEP, DYNAMIC
from game.physics.surfaces import SolidSurface, Surface
from game.settings import taken
from game.stage import Parameters, Steady
from game.worlds.hearing import LOUDEST
from game.worlds.members.beds import NearBodies, StillGround
from game.worlds.members.solids import Solids
from game.worlds.stopwatch import Stopwatch
from game.worlds.world import Member

DENSITY = 1000.0  # kg/m³
GOLDEN = 0.6180339887498949
CROWDED = 1.0  # fill of a cell into which no tap runs
FASTEST = 20.0  # m/s, of the hand in water
HARD, MANY = 4.0, 8  # times what gravity gives in a step: a blow; particles that make one
CALMS, STANDS_OUT = 0.25, 2.0  # s in which what is usual is learnt; times the usual is a splash
HALVES = 2.0  # a splash of a fourth of the reference's energy sounds half as fast


def settings_of(parameters: Parameters) -> LiquidSettings:
    """As the parameters have them; the rest as declared."""
    return taken(LiquidSettings, parameters.values)


class Blow(NamedTuple):
    """Water that was stopped in a step: J/m that it lost, mean place x m, how fast it had been m/s."""

    energy: float = 0.0
    x: float = 0.0
    speed: float = 0.0


class Water(Member):
    """``liquid``, by the parameters that a scene offers. Solids are sampled in each step in which one can
    have moved.

    start: m² at the beginning, as `begin` found it; parts: part steps of the last step; blow: what was heard
    of it, where ``listens``. limit: m/s; a pocket of less than a cell that solids close squeezes out drops
    that are faster than any water there could be. They are slowed down to the limit, and counted in slowed.
    """

    limit = math.inf

    def __init__(
        self,
        grid: Grid,
        parameters: Parameters,
        active: EffectSet,
        solids: Solids | None = None,
        *,
        most: int = 40_000,
        spread: int = 2,
        open_sides: tuple[str, ...] = (),
        listens: bool = False,
    ):
        """As `Liquid` takes them. solids: None where no solid is in the water."""
        self.parameters, self.solids, self.watch = parameters, solids, Stopwatch()
        self.liquid = Liquid(
            grid, settings_of(parameters), most=most, spread=spread, density=DENSITY,
            effects=active & LIQUID.known, open_sides=open_sides,
        )  # fmt: skip
        self.surfaces: tuple[Surface, ...] = ()
        self.parts, self.stale, self.start, self.slowed = 0, True, 1e-12, 0
        self.listens, self.blow = listens, Blow()

    def meet(self, without: tuple[int, ...] = (), ground: int | None = None) -> None:
        """From now on the water meets the solids but for bodies ``without``, such as walls of its tank.

        ground: a body that never moves. It is sampled once, and others only where they are: that pays on
        large grids.
        """
        if self.solids is None:
            return
        world, grid = self.solids.world, self.liquid.grid
        if ground is None:
            self.surfaces = (SolidSurface(world, without=without),)
        else:
            others = [body for body in world.ids().tolist() if body != ground]
            still = StillGround(SolidSurface(world, without=others), grid)
            self.surfaces = (still, NearBodies(world, grid, without=(*without, ground)))
        self.liquid.set_solids(*self.surfaces)
        self.stale = True

    def begin(self) -> None:
        """All water of the beginning is there."""
        self.liquid.refresh()
        self.start = max(self.liquid.wet_area(), 1e-12)

    # -- a step ---------------------------------------------------------------------------------------------

    def step(self, dt: float) -> None:
        if self.surfaces and (self.stale or self._may_have_moved()):
            self.liquid.set_solids(*self.surfaces)
            self.stale = False
        if self.limit < math.inf:
            self._slow_down()
        before = self.liquid.speeds.copy() if self.listens else None
        with self.watch.time("step"):
            self.parts = self.liquid.advance(dt)
        if before is not None:
            self._listen(before, dt)

    def _slow_down(self) -> None:
        speeds = elementary.square(self.liquid.speeds).sum(axis=1)
        fast = np.flatnonzero(speeds > elementary.square(self.limit))
        if len(fast):
            share = (self.limit / np.sqrt(speeds[fast]))[:, None]
            self.liquid.speeds[fast] *= share
            self.liquid.particles.affine[fast] *= share
            self.slowed += len(fast)

    def _may_have_moved(self) -> bool:
        if self.solids is None:
            return False
        return bool((self.solids.world.bodies.flags & (DYNAMIC | ASLEEP) == DYNAMIC).any())

    def _listen(self, before: Floats, dt: float) -> None:
        """Find the blow of a step of dt (s) from the speeds (n, 2) m/s before it."""
        self.blow, after = Blow(), self.liquid.speeds
        if len(before) != len(after):
            return
        pull = max(abs(self.liquid.settings.gravity), 0.1)
        lost = 0.5 * (elementary.square(before) - elementary.square(after)).sum(axis=1)
        change = after - before
        change[:, 1] += self.liquid.settings.gravity * dt
        hard = elementary.square(change).sum(axis=1) > elementary.square(HARD * pull * dt)
        struck = np.flatnonzero(hard & (lost > 0.0))
        if len(struck) >= MANY:
            energy = float(lost[struck].sum())
            x = float((lost[struck] * self.liquid.places[struck, 0]).sum()) / energy
            speed = math.sqrt(
                float((lost[struck] * elementary.square(before[struck]).sum(axis=1)).sum()) / energy
            )
            self.blow = Blow(DENSITY * self.liquid.area * energy, x, speed)

    def measure(self) -> None:
        """Find surface and fill of what is there now. Nothing that later steps depend on changes."""
        if self.surfaces:
            self.liquid.sample_solids(*self.surfaces)
            self.stale = True
        self.liquid.refresh()

    def change(self, name: str) -> None:
        self.liquid.settings = settings_of(self.parameters)
        self.watch.clear()

    def change_effects(self, active: EffectSet) -> None:
        self.liquid.effects = active & LIQUID.known

    def state(self) -> tuple[Any, ...]:
        return (self.liquid.state(),)

    def restore(self, fields: Iterator[Any]) -> None:
        self.liquid.restore(next(fields))
        self.stale = True

    # -- what comes in, goes out, is stirred ----------------------------------------------------------------

    def disc(self, at: Point, radius: float) -> Floats:
        """Places (n, 2) m of particles that fill a disc."""
        places = self.liquid.lattice(np.asarray(at) - radius, np.asarray(at) + radius)
        away = places - at
        return np.asarray(places[(away * away).sum(axis=1) <= radius * radius])

    def let_fall(self, at: Point, radius: float, speed: Point = (0.0, 0.0)) -> int:
        """A drop of a radius (m) about a place, where there is no water yet; how many particles."""
        places = self.disc(at, radius)
        self.liquid.refresh()
        if not len(places):
            return 0
        column, row = self.cells_of(places).T
        return self.liquid.add(places[self.liquid.cells.fill[row, column] < 0.5], speed)

    def cells_of(self, places: Floats) -> Longs:
        """(n, 2) column and row of the cells at places (n, 2) m; the nearest ones outside."""
        grid = self.liquid.grid
        found = np.floor((places - grid.lower) / grid.cell).astype(np.int64)
        return np.clip(found, 0, (grid.nx - 1, grid.ny - 1))

    def take_out(self, at: Point, radius: float) -> int:
        """Water within a radius (m) vanishes; how many particles."""
        away = self.liquid.places - at
        return self.liquid.keep_only((away * away).sum(axis=1) > radius * radius)

    def stir(self, at: Point, speed: Point, reach: float) -> None:
        """Let the water about a place go at a speed (m/s), less and less over a reach, m."""
        away = self.liquid.places - at
        near = elementwise.exp(-(away * away).sum(axis=1) / (reach * reach))[:, None]
        goal = np.clip(speed, -FASTEST, FASTEST)
        self.liquid.speeds[:] += near * (goal - self.liquid.speeds)


class Mouths(Member):
    """``taps`` (n, 5): x, y, width m, speed m/s; ``drains`` (n, 3): x, y, radius m. Taps run where
    ``running``.

    flow (3,): particles owed by the taps, given, taken by drains and hand.
    """

    kept = ("taps", "drains", "flow")

    def __init__(self, water: Water, most: int = 64):
        self.water, self.most, self.running = water, most, True
        self.taps: Floats = np.zeros((0, 5))
        self.drains: Floats = np.zeros((0, 3))
        self.flow: Floats = np.zeros(3)

    def step(self, dt: float) -> None:
        if self.running and len(self.taps):
            self.water.liquid.refresh()
            for x, y, width, u, v in self.taps.tolist():
                self.run((x, y), (u, v), width, dt)
        for x, y, radius in self.drains.tolist():
            self.take_out((x, y), radius)

    def run(self, at: Point, speed: Point, width: float, dt: float) -> None:
        """Let so much in as a mouth of a width gives in dt, s; what finds no space is refused.

        The liquid's fill is read: `Liquid.refresh` must have found it in this step.
        """
        liquid = self.water.liquid
        fast = elementary.hypot(*speed)
        owed = float(self.flow[0]) + fast * width * dt / liquid.area
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
        grid, fill = liquid.grid, liquid.cells.fill
        cells = np.floor((places - grid.lower) / grid.cell).astype(np.int64)
        inside = (cells >= 0).all(axis=1) & (cells < (grid.nx, grid.ny)).all(axis=1)
        free = np.array(inside)
        free[inside] = _around(fill, cells[inside]) < CROWDED
        liquid.account[2] += count - int(np.count_nonzero(free))
        liquid.add(places[free], speed)
        self.flow[1] += count

    def take_out(self, at: Point, radius: float) -> None:
        """Water within a radius (m) vanishes, and is counted."""
        self.flow[2] += self.water.take_out(at, radius)

    def add_tap(self, at: Point, speed: Point, width: float) -> str:
        """A tap; why not, or ""."""
        if len(self.taps) >= self.most:
            return f"There are {self.most} taps already."
        self.taps = np.concatenate([self.taps, [(*at, width, *speed)]])
        return ""

    def add_drain(self, at: Point, radius: float) -> str:
        """A drain; why not, or ""."""
        if len(self.drains) >= self.most:
            return f"There are {self.most} drains already."
        self.drains = np.concatenate([self.drains, [(*at, radius)]])
        return ""


def _around(fill: Floats, cells: Longs) -> Floats:
    """Mean fill (n,) of cells (n, 2), column and row, and the eight around each."""
    ny, nx = fill.shape
    total = np.zeros(len(cells))
    for right in (-1, 0, 1):
        for up in (-1, 0, 1):
            total += fill[np.clip(cells[:, 1] + up, 0, ny - 1), np.clip(cells[:, 0] + right, 0, nx - 1)]
    return total / 9.0


class Roar(Member):
    """Ears at the water: what is lost in blows roars, and what stands out of it is a splash.

    loud (3,): W/m in the mean of the last moments, its mean place m, and its mean speed m/s. Steps after the
    water; ``due`` tells whether the step's blow is to be heard as a splash of its own.
    """

    kept = ("loud",)

    def __init__(self, water: Water):
        water.listens = True
        self.water, self.due = water, False
        self.loud: Floats = np.zeros(3)

    def step(self, dt: float) -> None:
        blow = self.water.blow
        power, usual = blow.energy / dt, float(self.loud[0])
        self.due = power > STANDS_OUT * usual and power > 0.0
        part = min(dt / CALMS, 1.0)
        self.loud[0] += part * (power - usual)
        if power > 0.0:
            self.loud[1:] += part * (np.array((blow.x, blow.speed)) - self.loud[1:])

    def heard(self, reference: float, half: float, middle: float) -> list[Steady]:
        """As a sound that goes on: loudest at ``reference`` W/m; ``half`` m beside the middle is one side."""
        power, x, speed = self.loud.tolist()
        level = LOUDEST * math.sqrt(min(power / reference, 1.0))
        pan = max(-1.0, min(1.0, (x - middle) / half))
        return [Steady("water", level, min(speed / FASTEST, 1.0), pan)] if level > 0.0 else []

    def splash(self, reference: float) -> float:
        """m/s at which the step's blow sounds as a splash (`game.ui.sound`); 0 if it does not stand out.

        reference: J/m of one that sounds as fast as it was; others by the fourth root of their share.
        """
        blow = self.water.blow
        share = math.sqrt(math.sqrt(blow.energy / reference))
        return blow.speed * min(share, HALVES) if self.due else 0.0
