"""Grains and their field as a level makes them."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.acoustics import Levitator, LevitatorSettings, escape_estimate, facing_rows
from game.physics.acoustics.grains import VX, GrainState
from game.physics.acoustics.levitator import AIR, FREQUENCY, POLYSTYRENE
from game.physics.effects import EffectSet
from game.physics.kernels import elementwise
from game.scenes.levitation.level import LevitationContent
from game.scenes.levitation.parameters import LevitationParameters
from game.stage import Part

COUNT, PITCH, APART = 17, 0.010, 0.20  # transducers of a row, m from one to the next, m between facing rows
WAVE = AIR.sound / FREQUENCY  # m
TRAIL = 240  # places that are remembered of each grain
FAR = 0.25 * WAVE  # m to the nearest node: farther, a grain is between two traps
SEARCHED = 0.75  # of half a wave, about where a node is looked for


class LevitationState(NamedTuple):
    """grains; trail: (TRAIL, n, 2) m."""

    grains: GrainState
    trail: Floats


class LevitationModel(Part):
    """The levitator, and the way its grains have made."""

    def __init__(self, content: LevitationContent, parameters: LevitationParameters, active: EffectSet):
        self.content, self.parameters, self.active = content, parameters, active
        self.steps = 0
        array = facing_rows(int(parameters.rows), COUNT, PITCH, APART, parameters.strength)
        self.levitator = Levitator(
            array, [], self._grain(), parameters.figure, parameters.size, self._settings()
        )
        self.trail: Floats = np.zeros((TRAIL, 0, 2))
        for place in [*self.node_places(), *content.grains]:
            self.add(place)

    # -- changes --------------------------------------------------------------------------------------

    def _grain(self) -> Any:
        return POLYSTYRENE._replace(radius=self.parameters.radius, density=self.parameters.density)

    def _settings(self) -> LevitatorSettings:
        chosen = self.parameters
        return LevitatorSettings(
            self.active,
            int(chosen.substeps),
            chosen.gravity,
            chosen.speed,
            chosen.acceleration,
            chosen.pattern,
        )

    def change_parameter(self, name: str) -> None:
        """Take over a parameter's new value. ValueError for a grain that is too large."""
        levitator, chosen = self.levitator, self.parameters
        if name in ("figure", "size"):
            levitator.set_figure(chosen.figure, chosen.size)
        elif name in ("radius", "density"):
            levitator.set_grain(self._grain())
        elif name == "strength":
            levitator.array.set_strength(chosen.strength)
        else:
            levitator.settings = self._settings()
            levitator.aim()

    def change_effects(self, active: EffectSet) -> None:
        """Compute these effects from now on."""
        self.active = active
        self.levitator.settings = self._settings()

    def add(self, place: tuple[float, float]) -> None:
        """A grain at rest; ValueError if there are too many."""
        self.levitator.add(place)
        self.trail = np.concatenate([self.trail, np.broadcast_to(place, (TRAIL, 1, 2))], axis=1)

    def clear(self) -> None:
        """Take all grains away."""
        self.levitator.fields = np.zeros((4, 0))
        self.trail = np.zeros((TRAIL, 0, 2))

    def node_places(self) -> list[tuple[float, float]]:
        """Where the level's grains begin: traps near the focus."""
        x, y = self.levitator.place
        half = 0.5 * WAVE
        wanted = [(x, y + node * half) for node in self.content.nodes]
        columns, rows = self.content.lattice
        wanted += [
            (x + (i - 0.5 * (columns - 1)) * half, y + (j - 0.5 * (rows - 1)) * half)
            for j in range(rows)
            for i in range(columns)
        ]
        return [self.nearest_trap(place) for place in wanted]

    def nearest_trap(self, place: tuple[float, float]) -> tuple[float, float]:
        """The lowest potential within three quarters of half a wave of a place, m, by halving a grid."""
        at, reach = np.array(place), 0.5 * SEARCHED * 0.5 * WAVE
        offsets = np.stack(np.meshgrid(*[np.linspace(-1.0, 1.0, 9)] * 2), axis=-1).reshape(-1, 2)
        for _ in range(14):
            around = at + reach * offsets
            at = around[int(np.argmin(self.levitator.sample(around)[:, 3]))]
            reach *= 0.5
        return float(at[0]), float(at[1])

    # -- a step ---------------------------------------------------------------------------------------

    def advance(self, dt: float, hand: tuple[float, float] | None) -> None:
        """One step; the focus follows the hand if there is one."""
        self.levitator.hand = hand
        self.levitator.step(dt)
        self.trail[self.steps % TRAIL] = self.levitator.positions
        self.steps += 1

    # -- what is there --------------------------------------------------------------------------------

    def held(self) -> NDArray[np.bool_]:
        """(n,) whether a grain is carried by the sound."""
        return self.levitator.held()

    def strongest(self) -> tuple[float, float]:
        """The strongest force across and along the vertical near the focus, in weights of a grain."""
        x, y = self.levitator.place
        way = np.linspace(-1.0, 1.0, 81) * 0.5 * WAVE
        across = self.levitator.sample(np.stack([x + way, np.full_like(way, y)], axis=1))[:, 4]
        upright = self.levitator.sample(np.stack([np.full_like(way, x), y + way], axis=1))[:, 5]
        weight = self.levitator.grain.mass * 9.81
        return float(np.max(np.abs(across))) / weight, float(np.max(np.abs(upright))) / weight

    def escape_speed(self, weights: float) -> float:
        """The steady speed (m/s) at which drag would be as strong as so many weights of a grain."""
        grain = self.levitator.grain
        return escape_estimate(weights * grain.mass * 9.81, grain, AIR)

    def fastest(self) -> float:
        """m/s of the fastest grain."""
        velocities = self.levitator.fields[VX : VX + 2]
        return float(np.max(elementwise.hypot(*velocities), initial=0.0))

    def state(self) -> LevitationState:
        """All that later steps depend on."""
        return LevitationState(self.levitator.state(), self.trail)

    def restore(self, state: LevitationState) -> None:
        """Take over a copy of a state."""
        self.levitator.restore(state.grains)
        self.trail = state.trail.copy()
