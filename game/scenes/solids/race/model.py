"""Structures that stand or hang if they are computed well, each in as many worlds as there are solvers."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.physics.effects import EffectSet
from game.physics.kernels import elementary, elementwise
from game.physics.solids.arrays.state import DYNAMIC
from game.scenes.solids.bodies import place_of, whole_joints
from game.scenes.solids.level import (
    ArchEntry,
    BodyEntry,
    CardEntry,
    LinksEntry,
    ShapeEntry,
    SolidContent,
    StackEntry,
    View,
)
from game.scenes.solids.measures import contact_points, energies
from game.scenes.solids.model import ModelState, SolidModel
from game.scenes.solids.parameters import SolidParameters
from game.scenes.solids.race.parameters import RaceParameters
from game.stage import Part
from game.worlds.members.solids import substeps_of

RATIOS = (1.0, 10.0, 100.0, 1_000.0, 20_000.0)


class Setup(NamedTuple):
    """content; watched: number of the body whose sinking and leaning is told, negative from the last."""

    content: SolidContent
    watched: int = -1


def _heavy() -> SolidContent:
    top = BodyEntry(
        shapes=(ShapeEntry(box=(1.0, 1.0)),), position=(0.0, 10.5), density=1_000.0, colour="steel"
    )
    boxes = tuple(
        BodyEntry(shapes=(ShapeEntry(box=(1.0, 1.0)),), position=(0.0, 0.5 + k), colour="wood")
        for k in range(10)
    )
    return SolidContent(bodies=(*boxes, top), view=View(left=-4.5, bottom=-0.8, right=4.5, top=11.6))


def _ratios() -> SolidContent:
    bodies = []
    for k, ratio in enumerate(RATIOS):
        x = 1.8 * (k - 2)
        for row, (density, colour) in enumerate(((1.0, "wood"), (ratio, "steel"))):
            bodies.append(
                BodyEntry(
                    shapes=(ShapeEntry(box=(1.0, 1.0)),), position=(x, 0.5 + row), density=density,
                    colour=colour,  # type: ignore[arg-type]
                )
            )  # fmt: skip
    return SolidContent(bodies=tuple(bodies), view=View(left=-5.2, bottom=-0.6, right=5.2, top=4.6))


SETUPS = {
    "stack": Setup(SolidContent(
        stacks=(StackEntry(at=(0.0, 0.0), count=20, colour="wood"),),
        view=View(left=-6.0, bottom=-1.0, right=6.0, top=21.0),
    )),
    "pyramid": Setup(SolidContent(
        stacks=(StackEntry(form="pyramid", at=(0.0, 0.0), count=20, colour="stone"),),
        view=View(left=-11.0, bottom=-1.0, right=11.0, top=21.0),
    )),
    "heavy": Setup(_heavy()),
    "cards": Setup(SolidContent(
        cards=(CardEntry(at=(0.0, 0.0), storeys=3, thickness=0.03, lean=20.0, friction=0.8,
                         colour="yellow"),),
        view=View(left=-2.2, bottom=-0.2, right=2.2, top=3.4),
    )),
    "chain": Setup(SolidContent(
        links=(LinksEntry(
            start=(0.0, 6.5), end=(5.0, 6.5), links=20, radius=0.06, held="first", load=30.0, load_radius=0.4,
            colour="steel",
        ),),
        floor=None,
        view=View(left=-6.2, bottom=-0.2, right=6.2, top=7.2),
    )),
    "arch": Setup(SolidContent(
        arches=(ArchEntry(at=(0.0, 0.0), radius=3.0, thickness=0.3277, blocks=15, friction=0.8,
                          colour="stone"),),
        view=View(left=-4.4, bottom=-0.4, right=4.4, top=4.4),
    ), watched=7),
    "ratios": Setup(_ratios()),
}  # fmt: skip


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
