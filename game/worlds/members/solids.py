"""Rigid bodies: a world of solids as the parameters have it, its solver's controls, what is seen of it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from game.arrays import Floats, Longs
from game.physics.effects import EffectSet
from game.physics.solids import (
    IMPACT_LAWS,
    SOLVERS,
    TIERS,
    Disc,
    Material,
    SolidSettings,
    SolidState,
    SolidWorld,
)
from game.physics.solids.arrays import state as s
from game.physics.solids.effects import SOLIDS
from game.physics.solids.settings import USUAL_HERTZ
from game.stage import Choice, Param, ParameterError, Parameters
from game.worlds.stopwatch import Stopwatch
from game.worlds.world import Member

# -- controls, each declared once; a scene's parameters take those that it offers ---------------------------


def choose_quality(group: str = "Solver") -> Choice:
    """``tier``: how many substeps."""
    return Choice(
        "play", (*TIERS, "own"), labels=("Play", "Teach", "Film", "Own"), group=group, label="Quality",
        help=f"substeps: {', '.join(map(str, TIERS.values()))}, or as many as you say",
    )  # fmt: skip


def choose_substeps(most: int, group: str = "Solver") -> Param:
    """``substeps``, where the quality is one's own."""
    return Param(4, 1, most, whole=True, log=True, group=group, help="parts of a step, with Own")


def choose_iterations(most: int) -> Param:
    """``iterations``."""
    words = "sweeps over all contacts in each substep"
    return Param(1, 1, most, whole=True, log=True, group="Solver", help=words)


def choose_solver() -> Choice:
    """``solver``."""
    return Choice("soft-step", tuple(SOLVERS), group="Solver", help="what finds the impulses of contacts")


def choose_impact_law() -> Choice:
    """``impact_law``."""
    return Choice(
        "energetic", IMPACT_LAWS, labels=("Newton", "Poisson", "Stronge"), group="World", label="Impact law",
        help="what restitution is a part of: speed, impulse or (squared) work; all the same without friction",
    )  # fmt: skip


def choose_stiffness() -> Param:
    """``stiffness``."""
    return Param(
        0.0, 0.0, 480.0, unit="Hz", group="Solver", label="Contact frequency",
        help="of soft contacts: a stack sinks by its inverse square; "
        f"0: {USUAL_HERTZ:g} of the substeps a second",
    )  # fmt: skip


def choose_step(usual: float, least: float, most: float, group: str = "Solver", help: str = "") -> Param:
    """``step_length``, s."""
    return Param(usual, least, most, unit="s", log=True, group=group, label="Time step", help=help)


OF_SETTINGS = {
    "solver": "solver", "iterations": "iterations", "stiffness": "contact_hertz", "impact_law": "impact_law",
}  # fmt: skip


def substeps_of(parameters: Parameters) -> int:
    """By the quality that is chosen: of ``tier`` and ``substeps``."""
    return TIERS.get(parameters.values["tier"], int(parameters.values["substeps"]))


# -- the member ---------------------------------------------------------------------------------------------


class Solids(Member):
    """``world``: bodies, joints and contacts; ``watch``: what a step takes."""

    def __init__(self, parameters: Parameters, active: EffectSet):
        self.parameters, self.active, self.watch = parameters, active, Stopwatch()
        self.world = SolidWorld(self._settings())

    def _settings(self) -> SolidSettings:
        values = self.parameters.values
        chosen = {field: values[name] for name, field in OF_SETTINGS.items() if name in values}
        try:
            return SolidSettings(
                effects=self.active & SOLIDS.known, substeps=substeps_of(self.parameters),
                gravity=(0.0, -values["gravity"]), **chosen,
            )  # fmt: skip
        except ValueError as error:
            raise ParameterError(str(error)) from None

    def anchor(self) -> int:
        """A body that touches nothing and never moves, for joints to hang on."""
        return self.world.add_body(Disc(0.01, material=Material(mask=0, category=0)), kind="fixed")

    def check(self) -> None:
        self.world.check_solver()

    def step(self, dt: float) -> None:
        with self.watch.time("step"):
            self.world.step(dt)

    def change(self, name: str) -> None:
        self.world.settings = self._settings()
        self.watch.clear()

    def change_effects(self, active: EffectSet) -> None:
        self.active = active
        self.change("")

    def set_frictions(self, bodies: Any, friction: float) -> None:
        """Coulomb's coefficient of all shapes of some bodies."""
        shapes = self.world.shapes
        shapes.frictions[np.isin(shapes.bodies, bodies)] = friction

    def state(self) -> tuple[Any, ...]:
        return (self.world.state(),)

    def restore(self, fields: Iterator[Any]) -> None:
        self.world.restore(next(fields))

    # -- what there is ----------------------------------------------------------------------------------

    def awake(self) -> int:
        """How many dynamic bodies are computed."""
        return int(np.count_nonzero(self.world.bodies.flags & (s.DYNAMIC | s.ASLEEP) == s.DYNAMIC))


def bodies_between(world: SolidWorld, before: SolidState | None, alpha: float) -> tuple[Floats, Floats]:
    """Places (n, 2) m and angles (n,) rad of all slots, ``alpha`` of the way from a state to now.

    A slot that holds another body since, or one that has become fixed, is where it is now.
    """
    rows = world.bodies
    if before is None or before.bodies.angles.shape != rows.angles.shape:
        return rows.positions, rows.angles
    old = before.bodies
    same = (old.flags & s.DYNAMIC == rows.flags & s.DYNAMIC) & (old.inverse_masses == rows.inverse_masses)
    share = np.where(same, 1.0 - alpha, 0.0)
    places = rows.positions - share[:, None] * (rows.positions - old.positions)
    return places, rows.angles - share * (rows.angles - old.angles)


def nearest_box(
    world: SolidWorld, bodies: Longs, sizes: Floats, point: tuple[float, float]
) -> tuple[int, float]:
    """Which of some boxes (their bodies, sizes (n, 2) m) comes nearest to a point, and how far (m) it is
    outside, below 0 inside. -1 where there is none.
    """
    if not len(bodies):
        return -1, np.inf
    rows = world.bodies
    away = np.array(point) - rows.positions[bodies]
    c, sine = rows.rotations[bodies, 0], rows.rotations[bodies, 1]
    across = np.abs(c * away[:, 0] + sine * away[:, 1]) - 0.5 * sizes[:, 0]
    along = np.abs(c * away[:, 1] - sine * away[:, 0]) - 0.5 * sizes[:, 1]
    outside = np.maximum(across, along)
    best = int(np.argmin(outside))
    return best, float(outside[best])
