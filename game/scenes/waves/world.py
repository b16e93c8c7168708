"""Water in a channel, the exact surface beside it where there is one, and what a hand does to both."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.effects import EffectSet
from game.physics.fields import GRAVITY
from game.physics.kernels import elementary, elementwise, linear
from game.physics.waves import (
    AiryTank,
    Bowl,
    DamBreak,
    ShallowSettings,
    ShallowState,
    ShallowWater,
    dam_break,
)
from game.physics.waves.effects import BED_FRICTION, RAIN
from game.scenes.waves.level import HumpEntry, WavesContent
from game.scenes.waves.parameters import WavesParameters
from game.settings import taken
from game.worlds.world import Kept, Whole, World

THIN = 0.01  # m; less is no front
NOWHERE = math.nan
SPREAD = 0.012  # of the channel's length: half of what the hand reaches
RAIN_UNIT = 1e-3 / 3600.0  # m/s in a mm/h


class WavesState(NamedTuple):
    """water; volume: (2,) m² at the beginning, poured by the hand since."""

    water: ShallowState
    volume: Floats


def hump_of(entry: HumpEntry, x: Floats) -> Floats:
    """Its height (n,) m at places x."""
    return np.asarray(entry.height * elementwise.exp(-0.5 * elementary.square((x - entry.at) / entry.width)))


class WavesWorld(World):
    """A channel of one row of cells. x: (n,) m, their middles.

    pours: where the hand pours, m, NaN while it does not. touched: the hand has changed something, or a
    control, so that nothing exact is known any more.
    """

    state_type = WavesState

    def __init__(self, content: WavesContent, parameters: WavesParameters, active: EffectSet, seed: int):
        count, length = int(parameters.cells), float(parameters.length)
        self.cell = length / count
        self.x: Floats = np.asarray((np.arange(count) + 0.5) * self.cell - 0.5 * length)
        self.theory: DamBreak | Bowl | AiryTank | None = None
        settings = self._settings(parameters, active)
        bed: Floats = np.zeros(count)
        depth: Floats = np.zeros(count)
        flow: Floats = np.zeros(count)
        if content.dam is not None:
            depth[:] = np.where(self.x < 0.0, content.dam.left, content.dam.right)
            if content.dam.left > content.dam.right and settings.gravity:
                self.theory = dam_break(content.dam.left, content.dam.right, settings.gravity)
        elif content.bowl is not None:
            bowl = Bowl(content.bowl.depth, content.bowl.half, content.bowl.swing, settings.gravity)
            bed, depth, self.theory = bowl.bed(self.x), bowl.at(self.x, 0.0)[0], bowl
        else:
            if content.bed:
                points = sorted(content.bed)
                bed = linear.interpolated(self.x, [x for x, _ in points], [z for _, z in points])
            for entry in content.water:
                inside = (self.x >= entry.left) & (self.x <= entry.right)
                depth = np.where(inside, np.maximum(entry.level - bed, 0.0), depth)
                flow = np.where(inside & (depth > 0.0), entry.flow, flow)
        if content.hump is not None:
            depth = np.maximum(depth + (depth > 0.0) * hump_of(content.hump, self.x), 0.0)
        if content.airy:
            still = float(np.mean(depth))
            if len(content.bed) or content.ends != ("wall", "wall") or flow.any() or still <= 0.0:
                raise ValueError("airy: only for water at rest over a flat bed, between walls")
            self.theory = AiryTank(depth - still, self.cell, still, settings.gravity)
        self.still = max(float(depth[0]), 0.05)  # m, of the water that a swell comes through
        self.water = ShallowWater(
            depth, bed, self.cell, settings,
            (self._left_end(content, parameters), content.ends[1], "wall", "wall"),
            (*content.values, 0.0, 0.0),
        )  # fmt: skip
        self.water.along[0] = flow
        self.pours = NOWHERE
        self.touched = bool(settings.roughness or settings.rain)
        self.steps = 0
        self.volume: Floats = np.array((self.water.volume(), 0.0))
        super().__init__(content, parameters, active, Whole(self.water), Kept(self, "volume"))

    @staticmethod
    def _settings(chosen: WavesParameters, active: EffectSet) -> ShallowSettings:
        """What is chosen, without the effects that are off."""
        found = taken(ShallowSettings, chosen.values)
        return found._replace(
            gravity=found.gravity if GRAVITY in active else 0.0,
            roughness=found.roughness if BED_FRICTION in active else 0.0,
            rain=RAIN_UNIT * chosen.rain if RAIN in active else 0.0,
        )

    @staticmethod
    def _left_end(content: WavesContent, chosen: WavesParameters) -> str:
        return "flow" if chosen.swell > 0.0 else content.ends[0]

    def _take_settings(self) -> None:
        """Step as is chosen now; by other forces than at first, no theory holds any longer."""
        before, now = self.water.settings, self._settings(self.parameters, self.active)
        same = before._replace(method=now.method, courant=now.courant) == now
        self.water.settings, self.touched = now, self.touched or not same

    def change_parameter(self, name: str) -> None:
        self._take_settings()
        if name == "swell":
            self.water.set_end(0, self._left_end(self.content, self.parameters), self.content.values[0])
            self.touched = True

    def change_effects(self, active: EffectSet) -> None:
        super().change_effects(active)
        self._take_settings()

    # -- a step ---------------------------------------------------------------------------------------

    def advance(self, dt: float) -> str:
        chosen, water = self.parameters, self.water
        if chosen.swell > 0.0:
            speed = math.sqrt(water.settings.gravity * self.still)
            water.values[0] = (
                0.5 * chosen.swell * speed * elementary.sin(math.tau * self.time / chosen.period)
            )
        if math.isfinite(self.pours):
            near = self.near(self.pours)
            total = float(np.sum(near)) * self.cell
            water.depth[0] += near * (chosen.poured * dt / total)
            self.volume[1] += chosen.poured * dt
        self.steps = water.advance(dt)
        self.time += dt
        return ""

    def near(self, x: float) -> Floats:
        """(n,) how much of the hand at a place is felt in each cell, 0 to 1."""
        spread = max(SPREAD * float(self.parameters.length), 1.5 * self.cell)
        return np.asarray(elementwise.exp(-0.5 * elementary.square((self.x - x) / spread)))

    def pour(self, x: float) -> None:
        """Pour at a place from now on; NaN: no more."""
        self.pours = x
        self.touched = self.touched or math.isfinite(x)

    def push(self, x: float, speed: float) -> None:
        """Let the water near a place go at a speed, m/s."""
        depth, near = self.water.depth[0], self.near(x)
        self.water.along[0] += near * (depth * speed - self.water.along[0])
        self.touched = True

    def draw_bed(self, before: tuple[float, float], now: tuple[float, float]) -> None:
        """Let the bed go through a stroke of the hand, from (x, z) to (x, z); water on it goes up with it."""
        (x0, z0), (x1, z1) = sorted((before, now))
        reach = max(0.5 * SPREAD * float(self.parameters.length), self.cell)
        here = (self.x >= x0 - reach) & (self.x <= x1 + reach)
        self.water.bed[0, here] = linear.interpolated(self.x[here], [x0, max(x1, x0 + 1e-9)], [z0, z1])
        self.touched = True

    # -- what is there --------------------------------------------------------------------------------

    @property
    def undisturbed(self) -> bool:
        """Whether nothing has acted that the theory does not know. A dam: until a wave meets an end."""
        theory = self.theory
        if theory is None or self.touched or not isinstance(theory, DamBreak):
            return theory is not None and not self.touched
        fastest = max(theory.bore, math.sqrt(theory.gravity * theory.left))
        return self.water.time * fastest <= 0.5 * float(self.parameters.length)

    def expected(self) -> Floats | None:
        """Depths (n,) m as the theory has them now; None where there is none, or no longer."""
        theory, time = self.theory, self.water.time
        if theory is None or not self.undisturbed:
            return None
        if isinstance(theory, AiryTank):
            return np.asarray(self.volume[0] / float(self.parameters.length) + theory.at(time))
        if isinstance(theory, DamBreak) and time == 0.0:
            return np.where(self.x < 0.0, theory.left, theory.right)
        return theory.at(self.x, time)[0]

    def front(self) -> float:
        """Where water is foremost to the right, m; of a bore, where it is half as high as behind it."""
        theory = self.theory
        least = THIN
        if isinstance(theory, DamBreak) and theory.right > 0.0:
            least = 0.5 * (theory.right + theory.middle)
        wet = np.nonzero(self.water.depth[0] > least)[0]
        return float(self.x[wet[-1]]) + 0.5 * self.cell if len(wet) else math.nan
