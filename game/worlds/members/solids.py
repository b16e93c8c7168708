"""Rigid bodies: a world of solids as the parameters have it, its solver's controls, what is seen of it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from game.arrays import Floats, Longs, Point
from game.physics.effects import EffectSet
from game.physics.kernels import elementary, elementwise
from game.physics.solids import (
    IMPACT_LAWS,
    SOLVERS,
    TIERS,
    Disc,
    Material,
    SolidSettings,
    SolidState,
    SolidWorld,
    box,
)
from game.physics.solids.arrays import state as s
from game.physics.solids.effects import SOLIDS
from game.physics.solids.settings import USUAL_HERTZ
from game.stage import Choice, Param, ParameterError, Parameters
from game.worlds.quality import Quality
from game.worlds.stopwatch import Stopwatch
from game.worlds.world import Member

ROPE = 0.05  # m: radius of the discs in which rods of a rope meet
AIR_DENSITY, SPHERE_DRAG = 1.2, 0.47  # kg/m³; coefficient of a smooth sphere at 1e4 to 1e5 (Hoerner 1965)

# -- controls, each declared once; a scene's parameters take those that it offers ---------------------------


def choose_quality(group: str = "Solver") -> Choice:
    """``tier``: how many substeps."""
    return Quality(**TIERS, of="substeps").choose("play", group, rebuild=False)


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


class Links(NamedTuple):
    """What a rope is made of, from its start to its end."""

    bodies: list[int]
    joints: list[int]


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

    def hang_rope(self, ends: tuple[int, int], start: Point, end: Point, parts: int, mass: float) -> Links:
        """A rope of rods between two bodies, from one's point to the other's (m). The rods meet in discs that
        touch nothing, each of ``mass`` kg.
        """
        small = Disc(ROPE, material=Material(mass / (math.pi * ROPE * ROPE), 0.0, 0.0, 0, 0))
        before, place, bodies, joints = ends[0], start, list[int](), list[int]()
        for k in range(1, parts + 1):
            at = (start[0] + (end[0] - start[0]) * k / parts, start[1] + (end[1] - start[1]) * k / parts)
            body = ends[1] if k == parts else self.world.add_body(small, at)
            joints.append(self.world.add_joint("distance", before, body, place, at))
            before, place = body, at
            bodies += [body] * (k < parts)
        return Links(bodies, joints)

    def lay_courses(
        self, left: float, counts: tuple[int, int], size: Point, material: Material
    ) -> tuple[Longs, Floats]:
        """A wall on the ground, of so many courses and blocks in each: its bodies (n,), their sizes (n, 2) m.

        Every other course has half a block at both ends; two merlons stand on top. size: of a block, m.
        """
        (rows, columns), made, sizes = counts, list[int](), list[Point]()
        for row in range(rows + 1):
            shares = [0.5, *[1.0] * (columns - 1), 0.5] if row % 2 else [1.0] * columns
            x = left
            for k, share in enumerate(shares):
                wide = share * size[0]
                if row < rows or k in (0, len(shares) - 1):
                    shape = box(wide, size[1], material=material)
                    made.append(self.world.add_body(shape, (x + 0.5 * wide, (row + 0.5) * size[1])))
                    sizes.append((wide, size[1]))
                x += wide
        return np.array(made, dtype=np.int64), np.array(sizes)

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


def turned_between(world: SolidWorld, before: SolidState | None, alpha: float) -> tuple[Floats, Floats]:
    """As `bodies_between`, with cosine and sine (n, 2) of the angles."""
    places, angles = bodies_between(world, before, alpha)
    return places, np.stack([elementwise.cos(angles), elementwise.sin(angles)], axis=1)


def momentum(world: SolidWorld, bodies: Any) -> float:
    """kg m/s along x, of some dynamic bodies."""
    rows = world.bodies
    return float((rows.velocities[bodies, 0] / rows.inverse_masses[bodies]).sum())


def energy(world: SolidWorld, bodies: Any) -> float:
    """J of motion and height, of some dynamic bodies; height by the gravity of the settings."""
    rows = world.bodies
    masses, inertias = 1.0 / rows.inverse_masses[bodies], 1.0 / rows.inverse_inertias[bodies]
    speeds, spins, pull = rows.velocities[bodies], rows.spins[bodies], world.settings.gravity[1]
    moving = 0.5 * (masses * (speeds * speeds).sum(axis=1) + inertias * spins * spins)
    return float((moving - masses * pull * rows.positions[bodies, 1]).sum())


def drag_sphere(world: SolidWorld, body: int, radius: float) -> None:
    """The force of still air on a body that is a sphere, for the next step: c rho A v² / 2 (Newton 1687)."""
    vx, vy = world.bodies.velocities[body].tolist()
    force = -0.5 * AIR_DENSITY * SPHERE_DRAG * math.pi * radius * radius * elementary.hypot(vx, vy)
    world.add_force(body, (force * vx, force * vy))


def resist_rolling(world: SolidWorld, body: int, radius: float, share: float, dt: float) -> None:
    """Soft ground slows a ball that rolls on it, in the next step of dt (s), by a torque: so great a share of
    its weight (the coefficient of rolling resistance) times its radius (m); not beyond rest.
    """
    rows, spin = world.bodies, float(world.bodies.spins[body])
    mass, inertia = 1.0 / float(rows.inverse_masses[body]), 1.0 / float(rows.inverse_inertias[body])
    most = (inertia + mass * radius * radius) * abs(spin) / dt
    torque = min(share * mass * -world.settings.gravity[1] * radius, most)
    if torque > 0.0:
        world.add_force(body, (0.0, 0.0), math.copysign(torque, -spin))


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
