"""Plates that fall: the level's and those that a hand drops, what they do, where they were."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.effects import EffectSet
from game.physics.fields import GROUND
from game.physics.kernels import elementwise
from game.physics.plates import GustyWind, Plate, Plates, PlateSettings, PlateState, law
from game.physics.plates.watch import NO_COURSE, Course, Watch
from game.scenes.plates.level import PlatesContent
from game.scenes.plates.parameters import OF_PLATE, PlatesParameters
from game.stage import Part

LEFT, RIGHT, FLOOR, CEILING = (
    -0.9,
    0.9,
    -0.62,
    0.62,
)  # m, of the tank; what leaves it comes back on the other side
FLASHES = 64  # poses that are remembered of each plate
FLASH_S = 1.0 / 15.0  # s between two
MOST_PLATES = 96
REFERENCES = {  # by inertia at beta = 1/14: spin, descent and period in a/U; see tests/physics/plates
    0.4: (0.0, 0.2978127877608484, 5.633964661665585),
    0.8: (0.0, 0.3289077924388688, 9.416737158777423),
    1.4: (0.4916568893203183, 0.32405452937239226, 2.0 * math.pi / 0.4916568893203183),
}


class PlatesState(NamedTuple):
    """plates; events and counts of `Watch`; flashes: (FLASHES, 4, n) x, y, angle, bend; gains: (2,) J/m."""

    plates: PlateState
    events: Floats
    counts: NDArray[np.int64]
    flashes: Floats
    gains: Floats


class PlatesModel(Part):
    """``chosen``: the plate that is measured, -1 for none; steps and flashes so far."""

    def __init__(self, content: PlatesContent, parameters: PlatesParameters, active: EffectSet):
        self.content, self.parameters = content, parameters
        self.steps = self.flashed = 0
        self.wind = GustyWind(parameters.wind, floor=None)
        for gust in content.gusts:
            self.wind.add(gust.gust())
        self.plates = Plates(
            effects=active, wind=self.wind, walls=content.walls, method=parameters.method,
            settings=self._settings(),
        )  # fmt: skip
        self.watch = Watch(0)
        self.flashes: Floats = np.zeros((FLASHES, 4, 0))
        self.gains: Floats = np.zeros(2)  # the largest gain of a step so far, the largest energy
        self.chosen = -1
        for entry in content.plates:
            for k in range(entry.count):
                at = (entry.at[0] + k * entry.step[0], entry.at[1] + k * entry.step[1])
                self.add(entry.plate(k), at, entry.tilt, entry.velocity, entry.spin)
        if content.plates:
            self.chosen = 0

    def _settings(self) -> PlateSettings:
        return PlateSettings(self.parameters.gravity, FLOOR)

    # -- changes --------------------------------------------------------------------------------------

    def own_plate(self) -> Plate:
        """The plate that the parameters describe."""
        return Plate(**{name: getattr(self.parameters, name) for name in OF_PLATE})

    def add(
        self, plate: Plate, place: tuple[float, float], tilt: float, velocity: tuple[float, float],
        spin: float,
    ) -> None:  # fmt: skip
        """One more plate, which is then the chosen one; ValueError if it is none, or there are too many."""
        if len(self.plates) >= MOST_PLATES:
            raise ValueError(f"plates: at most {MOST_PLATES}")
        self.chosen = self.plates.add(plate, place, tilt, velocity, spin)
        self.watch.grow()
        pose = self._poses()[:, -1:]
        self.flashes = np.concatenate([self.flashes, np.broadcast_to(pose, (FLASHES, 4, 1))], axis=2)

    def remove(self, number: int) -> None:
        """Take one away."""
        self.plates.remove(number)
        self.watch.remove(number)
        self.flashes = np.delete(self.flashes, number, axis=2)
        self.chosen = min(self.chosen, len(self.plates) - 1)

    def clear(self) -> None:
        """Take all away."""
        while len(self.plates):
            self.remove(len(self.plates) - 1)

    def change_parameter(self, name: str) -> None:
        """Take over a parameter's new value. ValueError for a plate that makes no sense."""
        chosen = self.parameters
        if name == "method":
            self.plates.set_method(chosen.method)
        elif name == "wind":
            self.wind.set_wind(chosen.wind)
        elif name == "gravity":
            self.plates.settings = self._settings()
        elif name in OF_PLATE:
            plate = self.own_plate()
            if self.chosen >= 0:
                self.plates.change(self.chosen, plate)
                self.watch.forget(self.chosen)

    # -- a step ---------------------------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        """One step."""
        plates = self.plates
        before, energy = plates.rows.copy(), plates.energy()
        plates.step(dt)
        plates.check()
        self.steps += 1
        self.watch.look(before, plates.rows, plates.time, dt)
        if len(plates):
            after = plates.energy()
            height = float(np.max(np.abs(after), initial=0.0))
            self.gains[1] = max(self.gains[1], height)
            self.gains[0] = max(self.gains[0], float(np.max(after - energy)))
        if plates.time >= self.flashed * FLASH_S:
            self.flashes[self.flashed % FLASHES] = self._poses()
            self.flashed += 1

    def _poses(self) -> Floats:
        return self.plates.rows[[law.X, law.Y, law.THETA, law.BEND]]

    # -- what is there --------------------------------------------------------------------------------

    @property
    def wraps(self) -> bool:
        """Whether what falls out of the tank comes in above again: in the picture, not in the physics."""
        return GROUND not in self.plates.effects and not self.content.walls

    def shown(self, places: Floats) -> Floats:
        """Places (n, 2) m as they are drawn."""
        if not self.wraps:
            return places
        low, size = np.array((LEFT, FLOOR)), np.array((RIGHT - LEFT, CEILING - FLOOR))
        return np.asarray(low + np.mod(places - low, size))

    def near(self, place: tuple[float, float], reach: float) -> int:
        """The plate that is drawn nearest to a place, within ``reach`` m; -1 for none."""
        if not len(self.plates):
            return -1
        away = elementwise.hypot(*(self.shown(self.plates.positions) - place).T)
        best = int(np.argmin(away))
        return best if away[best] < reach else -1

    def course(self, number: int) -> Course:
        """What a plate does now."""
        if not 0 <= number < len(self.plates):
            return NO_COURSE
        return self.watch.course(number, self.plates.rows, self.plates.time)

    def numbers_of(self, number: int) -> tuple[float, float, float, float]:
        """Inertia and thickness, half chord (m) and speed unit (m/s) of a plate."""
        laws = self.plates.laws
        half = float(laws[law.HALF, number])
        return (
            float(laws[law.MASS_Y, number]) - 1.0,
            float(laws[law.RADIUS, number]) / half,
            half,
            float(laws[law.UNIT, number]),
        )

    def reference(self, number: int) -> tuple[float, float, float]:
        """Spin, descent and period (a/U) of the chosen plate's kind; NaN where none is known."""
        nothing = (math.nan, math.nan, math.nan)
        if not 0 <= number < len(self.plates):
            return nothing
        own = self.plates.laws[:, number]
        inertia, _, half, _ = self.numbers_of(number)
        found = REFERENCES.get(round(inertia, 6))
        usual = Plates([Plate(half, max(inertia, 0.1))], [(0.0, 0.0, 0.0)]).laws[:, 0]
        return found if found is not None and np.allclose(own, usual, rtol=1e-9) else nothing

    def change_effects(self, active: EffectSet) -> None:
        """Compute these effects from now on."""
        self.plates.effects = active

    def state(self) -> PlatesState:
        """All that later steps depend on."""
        return PlatesState(
            self.plates.state(), self.watch.events, self.watch.counts, self.flashes, self.gains
        )

    def restore(self, state: PlatesState) -> None:
        """Take over a copy of a state."""
        self.plates.restore(state.plates)
        self.watch.events, self.watch.counts = state.events.copy(), state.counts.copy()
        self.flashes, self.gains = state.flashes.copy(), state.gains.copy()
