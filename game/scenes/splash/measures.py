"""What is measured of a splash: the touch, the crater, the crown, the jet, ripples, pockets of air."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats, Longs
from game.compiler.decorator import lean_kernel
from game.physics.fields import GRAVITY
from game.physics.kernels import elementary, elementwise, linear
from game.physics.liquid import Liquid
from game.worlds.members.water import DENSITY, Water
from game.worlds.world import Member

FRAMES, MODES = 7, 40  # steps by which ripples are known as they are foreseen; waves of the pool
WINDOW = (0.5, 2.0)  # radii over speed: between them the way into the pool is timed
THROWN = 3.5  # the same: by then the crown has been thrown
SMALLEST = 2  # cells, of a pocket of air that rings
FEW, BESIDE = 10, 0.15  # particles that make water; m from a wall, at which water runs up
SAME = 4.0  # cells that a pocket moves in a step at most


def heights(liquid: Liquid) -> Floats:
    """(nx,) m: of the water that stands on the floor in each column, the median of five columns."""
    phi = liquid.cells.phi
    rows, columns = phi.shape
    first = np.clip(np.argmax(phi >= 0.0, axis=0), 1, rows - 1)
    column = np.arange(columns)
    below, above = phi[first - 1, column], phi[first, column]
    part = np.where(below < 0.0, below / np.where(below < above, below - above, -1.0), 0.0)
    found = np.where(phi[0] < 0.0, first - 0.5 + np.clip(part, 0.0, 1.0), 0.0) * liquid.grid.cell
    wider = np.pad(found, 2, mode="edge")
    return np.median(np.stack([wider[k : k + columns] for k in range(5)]), axis=0)


def surface_length(liquid: Liquid) -> float:
    """m, of the liquid's surface: the share of cells that is full, by how it changes from cell to cell."""
    full = np.clip(0.5 - liquid.cells.phi, 0.0, 1.0)
    along, up = np.diff(full, axis=1), np.diff(full, axis=0)
    corners = elementwise.hypot(0.5 * (along[1:] + along[:-1]), 0.5 * (up[:, 1:] + up[:, :-1]))
    return float(corners.sum()) * liquid.grid.cell


@lean_kernel
def find_pockets(rank, seen, stack, found):
    """Regions of dry cells from which no way leads to the top row; how many.

    rank: (ny, nx) 0 where dry; seen (ny, nx), stack (ny nx, 2): spare. found (most, 3): column and row of the
    middle, cells.
    """
    ny, nx = rank.shape
    seen[:] = 0
    count = 0
    for start in range(-1, ny * nx):
        top = 0
        if start < 0:  # the open air first
            for i in range(nx):
                if rank[ny - 1, i] == 0:
                    seen[ny - 1, i], stack[top, 0], stack[top, 1] = 1, ny - 1, i
                    top += 1
        elif rank[start // nx, start % nx] == 0 and seen[start // nx, start % nx] == 0:
            seen[start // nx, start % nx], stack[0, 0], stack[0, 1] = 1, start // nx, start % nx
            top = 1
        size, along, up = 0, 0.0, 0.0
        while top > 0:
            top -= 1
            j, i = stack[top, 0], stack[top, 1]
            size, along, up = size + 1, along + i, up + j
            for k in range(4):
                y, x = j + (k == 0) - (k == 1), i + (k == 2) - (k == 3)
                if 0 <= y < ny and 0 <= x < nx and rank[y, x] == 0 and seen[y, x] == 0:
                    seen[y, x], stack[top, 0], stack[top, 1] = 1, y, x
                    top += 1
        if start >= 0 and size > 0 and count < found.shape[0]:
            found[count, 0], found[count, 1], found[count, 2] = along / size, up / size, size
            count += 1
    return count


class Measures(Member):
    """Of the last drop, whose particles are those from ``first`` on. Lengths are from the level before it.

    touched: s, when it met the water. As it did: speed m/s, at m, energy J/m (of all water beside still
    water), own J/m (kinetic, of the drop), area m², momentum kg/s. closes: s, when the crater shrinks.
    number: of the drop, from 1. ways: (s, m) of the drop's foremost point. flies: m, how high the crown can.
    craters: of each drop, the Froude number and depth in radii. worst: error of the volume, of all steps.
    last (FRAMES, nx): heights of the last steps; waves (3, MODES): parts of ripples that are foreseen, and
    their time; pockets (k, 3) as `find_pockets` has them; new: those that were not there a step before.
    """

    kept = ("last", "waves", "pockets")

    def __init__(self, water: Water, wide: float):
        self.water, self.wide = water, wide
        grid = water.liquid.grid
        self.x = (np.arange(grid.nx) + 0.5) * grid.cell
        self.last: Floats = np.zeros((FRAMES, grid.nx))
        self.waves: Floats = np.full((3, MODES), math.nan)
        self.pockets: Floats = np.zeros((0, 3))
        self.new: Floats = np.zeros((0, 3))
        self._spare: tuple[Longs, Longs, Floats] = (
            np.zeros(grid.shape, np.int64), np.zeros((grid.nx * grid.ny, 2), np.int64), np.zeros((64, 3))
        )  # fmt: skip
        self.craters: list[tuple[float, float]] = []
        self.time, self.number, self.worst = 0.0, 0, 0.0
        self.begin(0, math.nan)

    def begin(self, first: int, radius: float) -> None:
        """A drop falls: particles from ``first`` on."""
        nan, liquid = math.nan, self.water.liquid
        self.first, self.radius = first, radius
        self.level = first * liquid.area / self.wide
        self.falling = math.isfinite(radius)
        self.number += self.falling
        self.touched = self.speed = self.at = self.energy = self.own = self.momentum = nan
        self.closes = self.flies = self.area = self.lost_at_once = self.lands = nan
        self.ways: list[tuple[float, float]] = []
        self.deepest = self.highest = self.jet_most = 0.0

    def forget(self) -> None:
        """The water is still."""
        self.begin(self.water.liquid.count, math.nan)
        self.waves[:] = math.nan
        self.pockets = self.new = np.zeros((0, 3))

    # -- a step -------------------------------------------------------------------------------------------

    def step(self, dt: float) -> None:
        self.time += dt
        liquid = self.water.liquid
        self.last[:-1], self.last[-1] = self.last[1:], heights(liquid)
        self._find_pockets()
        full = liquid.count * liquid.area
        self.worst = max(self.worst, abs(liquid.wet_area() / full - 1.0) if full else 0.0)
        if self.falling:
            self._await(dt)
        elif math.isfinite(self.touched):
            self._follow()

    def _find_pockets(self) -> None:
        count = find_pockets(self.water.liquid.cells.rank, *self._spare)
        now = self._spare[2][:count]
        now = now[now[:, 2] >= SMALLEST]
        away = now[:, None, :2] - self.pockets[None, :, :2]
        near = (elementary.square(away).sum(axis=2) < SAME * SAME).any(axis=1)
        self.new, self.pockets = now[~near], now.copy()

    def _await(self, dt: float) -> None:
        """Whether the drop meets the water in the next step."""
        liquid, cell = self.water.liquid, self.water.liquid.grid.cell
        places, speeds = liquid.places[self.first :], liquid.speeds[self.first :]
        if not len(places):
            self.falling = False
            return
        u, v = speeds.mean(axis=0).tolist()
        low, at = float(places[:, 1].min()), float(places[:, 0].mean())
        near = np.abs(self.x - at) < self.radius
        if low - float(self.last[-1][near].max(initial=0.0)) > cell - 1.1 * v * dt:
            return
        self.falling, self.touched, self.at, self.speed = False, self.time, at, elementary.hypot(u, v)
        mass = DENSITY * liquid.area
        self.area = len(places) * liquid.area
        self.own = 0.5 * mass * float(elementary.square(speeds).sum())
        self.energy, self.momentum = sum(self.energies()), self.momentum_now()

    def _follow(self) -> None:
        liquid, cell, since = self.water.liquid, self.water.liquid.grid.cell, self.time - self.touched
        pace = since * self.speed / self.radius  # radii
        if len(self.ways) < 2 and pace >= WINDOW[len(self.ways)]:
            self.ways.append((since, self.level - float(liquid.places[self.first :, 1].min())))
        depth, jet = self.crater(), self.jet()
        self.deepest = max(self.deepest, depth)
        if not self.time > self.lands:
            self.highest = max(self.highest, self._high(liquid.places[:, 1]))
        if math.isnan(self.flies) and pace >= THROWN:
            self.flies, self.lost_at_once = self.can_fly(), 100.0 * (1.0 - sum(self.energies()) / self.energy)
            if self.flies > 0.0:
                self.lands = self.time + math.sqrt(2.0 * self.flies / self.pull())
        if math.isnan(self.closes):
            if pace > THROWN and depth < self.deepest - 0.2 * cell:
                self.closes = self.time
                if self.pull() > 0.0:
                    froude = self.speed * self.speed / (self.pull() * self.radius)
                    self.craters.append((froude, self.deepest / self.radius))
        else:
            self.jet_most = max(self.jet_most, jet)

    # -- what there is ------------------------------------------------------------------------------------

    def pull(self) -> float:
        """m/s² downwards, as it acts."""
        liquid = self.water.liquid
        return float(liquid.settings.gravity) if GRAVITY in liquid.effects else 0.0

    def energies(self) -> tuple[float, float]:
        """J/m: of motion, and of height beside the same water at rest."""
        liquid = self.water.liquid
        moving, height = liquid.energy()
        filled = liquid.count * liquid.area
        return moving, height - 0.5 * DENSITY * self.pull() * filled * filled / self.wide

    def momentum_now(self) -> float:
        """kg/s to the right: of a metre of water."""
        liquid = self.water.liquid
        return DENSITY * liquid.area * float(liquid.speeds[:, 0].sum())

    def crater(self) -> float:
        """m below the level, of the lowest surface within six radii of where the drop came down."""
        near = np.abs(self.x - self.at) < 6.0 * self.radius
        return self.level - float(self.last[-1][near].min()) if near.any() else math.nan

    def jet(self) -> float:
        """m above the level, of the water within a radius of there."""
        near = np.abs(self.x - self.at) < self.radius
        return float(self.last[-1][near].max()) - self.level if near.any() else math.nan

    def can_fly(self) -> float:
        """m above the level that what is in the air can reach, if only its weight acts: y + v^2 / (2 g)."""
        liquid = self.water.liquid
        pull, up = self.pull(), np.maximum(liquid.speeds[:, 1], 0.0)
        free = liquid.places[:, 1] > self.level + 2.0 * liquid.grid.cell
        return self._high(liquid.places[:, 1] + free * up * up / (2.0 * pull)) if pull > 0.0 else math.nan

    def _high(self, y: Floats) -> float:
        """m above the level: the FEW-th highest of places (n,) of particles that are not beside a wall."""
        inside = np.abs(self.water.liquid.places[:, 0] - 0.5 * self.wide) < 0.5 * self.wide - BESIDE
        few = min(FEW, int(np.count_nonzero(inside)))
        return float(np.partition(y[inside], -few)[-few]) - self.level if few else 0.0

    def limit(self) -> float:
        """m: radius of a half round crater with all of the drop's energy, (3 A U^2 / (4 g))^(1/3)."""
        pull = self.pull()
        return elementary.cbrt(0.75 * self.area * self.speed * self.speed / pull) if pull > 0.0 else math.nan

    def sinks(self) -> float:
        """Speed of the drop's foremost point in the pool, over that of the drop; NaN before it is timed."""
        if len(self.ways) < 2:
            return math.nan
        (t0, way0), (t1, way1) = self.ways
        return (way1 - way0) / (t1 - t0) / self.speed

    # -- ripples ------------------------------------------------------------------------------------------

    def rates(self) -> tuple[Floats, Floats]:
        """Wave numbers (MODES,) 1/m that fit into the pool, and rates: w^2 = g k tanh(k h) (Airy 1841)."""
        k: Floats = np.arange(1.0, MODES + 1.0) * (math.pi / self.wide)
        h = float(self.last[-1].mean())
        return k, np.asarray(np.sqrt(self.pull() * k * elementwise.tanh(k * h)), dtype=np.float64)

    def foresee(self, dt: float) -> None:
        """Take ripples as they were in the last steps of dt (s) as waves that do not disturb each other."""
        k, rate = self.rates()
        shapes = elementwise.cos(k[:, None] * self.x)
        away = self.last - self.last.mean(axis=1, keepdims=True)
        parts = 2.0 / len(self.x) * linear.product(away, shapes.T)
        times = (np.arange(FRAMES) - (FRAMES - 1)) * dt
        for m in range(MODES):
            both = np.stack([elementwise.cos(rate[m] * times), elementwise.sin(rate[m] * times)])
            (a, b), (_, d) = linear.product(both, both.T)
            right = linear.product(both, parts[:, m])
            whole = a * d - b * b
            if whole <= 1e-9 * a * a:  # so slow that only where it is can be told
                self.waves[:2, m] = right[0] / a, 0.0
            else:
                self.waves[0, m] = (d * right[0] - b * right[1]) / whole
                self.waves[1, m] = (a * right[1] - b * right[0]) / whole
        self.waves[2] = self.time

    def foreseen(self) -> Floats | None:
        """(nx,) m: heights now by dispersion alone; None if nothing was foreseen."""
        if math.isnan(self.waves[2, 0]):
            return None
        k, rate = self.rates()
        turned = rate * (self.time - self.waves[2, 0])
        sizes = self.waves[0] * elementwise.cos(turned) + self.waves[1] * elementwise.sin(turned)
        return linear.product(sizes, elementwise.cos(k[:, None] * self.x)) + float(self.last[-1].mean())

    def likeness(self) -> float:
        """Correlation of heights with those foreseen; NaN if there are none."""
        law, now = self.foreseen(), self.last[-1]
        if law is None:
            return math.nan
        a, b = now - now.mean(), law - law.mean()
        both = math.sqrt(float((a * a).sum() * (b * b).sum()))
        return float((a * b).sum()) / both if both > 0.0 else math.nan
