"""One set-up in as many worlds as there are solvers."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.physics.effects import EffectSet
from game.physics.kernels import elementary, elementwise
from game.physics.solids.arrays.state import DYNAMIC
from game.scenes.solids.bodies import place_of, whole_joints
from game.scenes.solids.measures import contact_points, energies
from game.scenes.solids.model import ModelState, SolidModel
from game.scenes.solids.parameters import SolidParameters
from game.scenes.solids.race.parameters import RaceParameters
from game.scenes.solids.race.setups import SETUPS
from game.stage import Part
from game.worlds.members.solids import substeps_of


class RaceState(NamedTuple):
    """worlds, one for each solver; given_up (n,): 1 where a world could not be computed on."""

    worlds: tuple[ModelState, ...]
    given_up: NDArray[np.int64]


class Result(NamedTuple):
    """Of one solver: m, m, m, m, J, s."""

    sinks: float
    leans: float
    overlap: float
    gap: float
    energy: float
    step: float


class RaceModel(Part):
    """solvers: names; worlds: one each."""

    def __init__(self, parameters: RaceParameters, active: EffectSet):
        self.parameters, self.active = parameters, active
        self.setup = SETUPS[parameters.setup]
        self.solvers = parameters.chosen()
        self.worlds = [self._world(name) for name in self.solvers]
        self.given_up: NDArray[np.int64] = np.zeros(len(self.solvers), dtype=np.int64)
        self.watched, self._start, self._energy = 0, (0.0, 0.0), 0.0
        if self.worlds:
            ids = self.worlds[0].movable()
            self.watched = int(ids[self.setup.watched])
            x, y = self.worlds[0].world.bodies.positions[self.watched].tolist()
            self._start, self._energy = (x, y), energies(self.worlds[0].world).total

    def _world(self, solver: str) -> SolidModel:
        values = dict(SolidParameters().values)
        values.update(solver=solver, tier="own", **self._steps())
        return SolidModel(self.setup.content, SolidParameters(values), self.active, 0)

    def _steps(self) -> dict[str, Any]:
        parameters = self.parameters
        return {"substeps": substeps_of(parameters), "iterations": int(parameters.iterations)}

    def change(self) -> None:
        """Take over how finely all compute."""
        for model in self.worlds:
            model.parameters.values.update(self._steps())
            model.change_parameter("substeps")

    def change_effects(self, active: EffectSet) -> None:
        """Compute these effects from now on."""
        self.active = active
        for model in self.worlds:
            model.change_effects(active)

    def advance(self, dt: float) -> list[str]:
        """One step of each; who could not."""
        lost = []
        for k, model in enumerate(self.worlds):
            if self.given_up[k]:
                continue
            before = model.state()
            try:
                model.advance(dt)
            except (ArithmeticError, ValueError):
                model.restore(before)
                self.given_up[k] = 1
                lost.append(self.solvers[k])
        return lost

    def result(self, k: int) -> Result:
        """What is measured of solver k."""
        model = self.worlds[k]
        world = model.world
        x, y = world.bodies.positions[self.watched].tolist()
        points = contact_points(world)
        gap = max(
            (elementary.dist(place_of(world, j, 0), place_of(world, j, 1)) for j in whole_joints(world)),
            default=0.0,
        )
        return Result(
            self._start[1] - y if not world.joints.kinds.size else 0.0,
            abs(x - self._start[0]) if not world.joints.kinds.size else 0.0,
            max(0.0, float(points.depths.max(initial=0.0))),
            gap,
            energies(world).total - self._energy,
            model.solids.watch.median("step"),
        )

    def moving(self, k: int) -> float:
        """Speed m/s of the fastest body of solver k."""
        rows = self.worlds[k].world.bodies
        dynamic = rows.flags & DYNAMIC != 0
        return float(elementwise.hypot(*rows.velocities[dynamic].T).max(initial=0.0))

    def state(self) -> RaceState:
        """All that later steps depend on."""
        return RaceState(tuple(model.state() for model in self.worlds), self.given_up)

    def restore(self, state: Any) -> None:
        """Take over a copy of a state."""
        for model, kept in zip(self.worlds, state.worlds, strict=True):
            model.restore(kept)
        np.copyto(self.given_up, state.given_up)
