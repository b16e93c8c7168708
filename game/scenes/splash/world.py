"""The world of the splash: a pool, drops that fall into it, what is measured and heard of them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from game.arrays import Floats, Point
from game.physics.effects import EffectSet
from game.physics.grid.layout import Grid
from game.physics.kernels import elementary
from game.physics.liquid import LiquidState
from game.scenes.splash.measures import Measures
from game.scenes.splash.parameters import HIGH, STEP, WIDE, SplashContent, SplashParameters
from game.ui.sound import BUBBLE_TONES
from game.worlds.hearing import HEARD_KIND, Heard, rows_of
from game.worlds.members.water import Roar, Water
from game.worlds.world import World

CLEAR = 0.42  # m that a drop falls freely in sight before it meets the water, at most
APART = 3.3  # radii from the middle, of two drops that fall at the same time
REFERENCE = 60.0  # J/m of a blow that sounds as fast as it was
SPLASH, BUBBLE = 0, 1  # kinds of what is heard; a bubble's is this and its number in BUBBLE_TONES
MINNAERT = 3.26  # m/s: frequency times radius of an air bubble in water (Minnaert 1933)


class SplashState(NamedTuple):
    """last, waves, pockets as `Measures` has them; loud as `Roar`; heard (k, HEARD_WIDTH)."""

    liquid: LiquidState
    last: Floats
    waves: Floats
    pockets: Floats
    loud: Floats
    heard: Floats


class SplashWorld(World):
    """``water`` fills the lower part of a box; ``measures`` of the last drop."""

    state_type = SplashState
    content: SplashContent
    parameters: SplashParameters

    def __init__(self, content: SplashContent, parameters: SplashParameters, active: EffectSet, seed: int):
        cells = int(parameters.cells)
        grid = Grid(cells, max(4, round(cells * HIGH / WIDE)), WIDE / cells)
        self.water = Water(grid, parameters, active, most=4 * grid.nx * grid.ny)
        self.liquid, self.measures = self.water.liquid, Measures(self.water, WIDE)
        self.roar, self.heard = Roar(self.water), Heard()
        super().__init__(content, parameters, active, self.water, self.measures, self.roar, self.heard)
        self.calm()
        for one in content.drops:
            self._put(one.at, one.radius, (one.speed[0], one.speed[1]))

    def change_parameter(self, name: str) -> None:
        super().change_parameter(name)
        if name == "depth":
            self.calm()

    def calm(self) -> None:
        """The pool is as deep as the parameter says, and still."""
        self.liquid.keep_only(np.zeros(self.liquid.count, dtype=bool))
        self.liquid.add(self.liquid.lattice((0.0, 0.0), (WIDE, float(self.parameters.depth))))
        self.water.begin()
        self.measures.forget()

    def advance(self, dt: float) -> str:
        said = super().advance(dt)
        self.heard.forget(self.time - dt)
        speed = self.roar.splash(REFERENCE)
        if speed > 0.0:
            self.heard.add(self.time, SPLASH, speed, self.water.blow.x)
        if len(self.measures.new):
            self.heard.append(self._rings())
        return said

    def _rings(self) -> Floats:
        """Pockets of air that have closed in this step, as they are heard: each by the bubble of its area."""
        cell, new = self.liquid.grid.cell, self.measures.new
        radii = cell * np.sqrt(new[:, 2] / math.pi)
        rows = rows_of(self.time, BUBBLE, np.full(len(new), 1.0), (new[:, 0] + 0.5) * cell)
        rows[:, HEARD_KIND] += [octave(MINNAERT / radius) for radius in radii.tolist()]
        return rows

    # -- drops --------------------------------------------------------------------------------------------

    def let_go(self, targets: Sequence[float], sizes: Sequence[float] = (1.0, 1.0)) -> str:
        """Drops that come down at x m with the speed and at the angle of the parameters; why not, or "".

        sizes: their radii, of the chosen one.
        """
        chosen, pull = self.parameters, self.measures.pull()
        turn = math.radians(float(chosen.angle))
        along, down = chosen.speed * elementary.sin(turn), chosen.speed * elementary.cos(turn)
        cell, first, given = self.liquid.grid.cell, self.liquid.count, 0
        for x, size in zip(targets, sizes, strict=False):
            radius = size * float(chosen.size)
            top = self._top(x, 1.5 * radius)
            fall = min(CLEAR, HIGH - top - 2.0 * radius - 3.0 * cell)
            if pull > 0.0:
                fall = min(fall, 0.5 * down * down / pull)
            if fall <= 0.0:
                return "There is no space above the water."
            begins = math.sqrt(max(down * down - 2.0 * pull * fall, 0.0))
            time = fall / (0.5 * (begins + down))
            at = (x - along * time, top + radius + cell + fall)
            given += self.water.let_fall(at, radius, (along, -begins))
        if given:
            self.measures.begin(first, float(chosen.size) * max(sizes[: len(targets)]))
        return "" if given else "There is no space above the water."

    def _top(self, x: float, reach: float) -> float:
        """m: the highest water within a reach of x."""
        near = np.abs(self.liquid.places[:, 0] - x) < reach
        return float(self.liquid.places[near, 1].max()) if near.any() else 0.0

    def drop_at(self, at: Point) -> str:
        """A drop with its middle here, so fast that it meets the level at the chosen speed; why not."""
        chosen, turn = self.parameters, math.radians(float(self.parameters.angle))
        fall = max(at[1] - float(chosen.size) - float(chosen.depth), 0.0)
        along, down = chosen.speed * elementary.sin(turn), chosen.speed * elementary.cos(turn)
        begins = math.sqrt(max(down * down - 2.0 * self.measures.pull() * fall, 0.0))
        return self._put(at, float(chosen.size), (along, -begins))

    def throw(self, at: Point, speed: Point) -> str:
        """A drop with its middle here, at a speed (m/s); why not."""
        return self._put(at, float(self.parameters.size), speed)

    def _put(self, at: Point, radius: float, speed: Point) -> str:
        first = self.liquid.count
        if not self.water.let_fall(at, radius, speed):
            return "There is no space for a drop."
        self.measures.begin(first, radius)
        return ""

    def foresee(self) -> None:
        """Keep ripples as they are, to be led on by theory alone."""
        self.measures.foresee(STEP)


def octave(hertz: float) -> int:
    """The number of the nearest of BUBBLE_TONES."""
    return int(np.argmin([abs(math.log2(hertz / tone)) for tone in BUBBLE_TONES]))
