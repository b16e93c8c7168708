"""What accuracy costs for solids on joints: a lever with a hinged weight, whose energy nothing takes away."""

from __future__ import annotations

from game.lab.studies.motion import KnownMotion, motion_study
from game.lab.study import Method, Study
from game.naming import words_of
from game.physics.solids import Disc, Material, SolidSettings, SolidWorld, box

SECONDS = 1.0  # until the weight is at its lowest
LONG, SHORT, HANG, WEIGHT = 5.6, 1.4, 1.1, 12000.0  # m: both arms, hinge to weight; kg
SOLVERS = ("soft-step", "sequential-impulses")


def energy_gained(solver: str, dt: float, steps: int) -> float:
    """Of a level lever that is let go: what its energy has changed by, as a part of the weight's m g l."""
    world = SolidWorld(SolidSettings(solver=solver, substeps=1))
    anchor = world.add_body(Disc(0.01, material=Material(mask=0, category=0)), kind="fixed")
    length = LONG + SHORT
    beam = box(length, 0.3, material=Material(300.0 / (0.3 * length), mask=0))
    arm = world.add_body(beam, (SHORT - 0.5 * length, 0.0))
    weight = world.add_body(box(1.8, 1.8, material=Material(WEIGHT / 3.24, mask=0)), (SHORT, -HANG))
    world.add_joint("pin", anchor, arm, (0.0, 0.0))
    world.add_joint("pin", arm, weight, (SHORT, 0.0))
    before = world.energy().total
    for _ in range(steps):
        world.step(dt)
    return (world.energy().total - before) / (WEIGHT * 9.81 * SHORT)


def swings_study(name: str) -> Study:
    """For a scene of levers on pins, with the parameters ``solver`` and ``step_length``."""
    return motion_study(
        name, "Energy of a lever on pins", energy_gained,
        tuple(Method(solver, words_of(solver), None) for solver in SOLVERS),
        KnownMotion("a lever of 7 m with a weight of 12 t", SECONDS, 0.0, "of m g l"),
        choice="solver", reference="nothing rubs, so energy is kept.",
    )  # fmt: skip
