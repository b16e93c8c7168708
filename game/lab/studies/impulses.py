"""What accuracy costs for colliding spheres: time steps against the event-driven run, piles against overlap.

Impacts: a step that finds a collision by overlap finds it late, by up to a step. So the error is of first
order whatever the integrator. Divided at the impact times, and with flight along parabolas, a step of any
length is exact. Piles: how deep discs overlap at rest, for each position correction and number of sweeps.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from game.lab.ranges import counts_between
from game.lab.study import Knob, Method, Outcome, Setting, Study, Workload
from game.physics.fields import GRAVITY
from game.physics.rigid.effects import WINDOW
from game.physics.spheres.collisions import CollidingSpheres
from game.physics.spheres.effects import COLLISIONS, IMPACT_TIMES, USUAL
from game.physics.spheres.settings import CORRECTIONS, material_tables, surroundings_of
from game.physics.spheres.smooth_spheres import SmoothSpheres
from game.physics.spheres.spheres import SphereBodies
from game.physics.spheres.state import CollisionState

FLIGHT_S = 0.7
FASTEST_STEP, SLOWEST_STEP = 1.0 / 2000.0, 0.1  # s, as the scene allows
BOX = (-2.0, 0.0, 2.0, 3.0)
PLACES = ((-1.3, 0.9), (0.2, 1.4), (1.2, 2.2), (-0.6, 2.3))
SPEEDS = ((2.0, 1.0), (-0.5, 0.5), (-1.0, -0.3), (0.3, -0.2))
RADII = (0.3, 0.4, 0.25, 0.3)
G = 9.81
ABSURD = 10.0  # m or parts of the energy, beyond which a run counts as diverged
PILE_COLUMNS, PILE_ROWS, PILE_RADIUS = 8, 12, 0.43
PILE_S, FRAME = 4.0, 1.0 / 60.0


class Run:
    """A world that is stepped for so long from the same start."""

    def __init__(
        self,
        world: CollidingSpheres,
        dt: float,
        steps: int,
        error: Callable[[CollidingSpheres], float],
        work: Callable[[CollidingSpheres], int],
    ) -> None:
        self.simulated_s = dt * steps
        self.world, self.dt, self.steps = world, dt, steps
        parts: Any = [part.copy() for part in world.state()]
        self.start = CollisionState(*parts)
        self.error, self.work = error, work
        self.parts = 0

    def reset(self) -> None:
        self.world.restore(self.start)

    def run(self) -> None:
        self.parts = 0
        for _ in range(self.steps):
            self.world.step(self.dt)
            self.parts += self.world.parts

    def outcome(self) -> Outcome:
        error = self.error(self.world)
        sane = math.isfinite(error) and error < ABSURD
        return Outcome(error, self.parts * self.work(self.world), "" if sane else "diverged")


# -- impacts --------------------------------------------------------------------------------------------

IMPACTS: dict[str, tuple[str, bool]] = {
    "explicit": ("explicit-euler", False),
    "semi-implicit": ("semi-implicit", False),
    "parabola": ("exact-flight", False),
    "explicit-impacts": ("explicit-euler", True),
    "semi-implicit-impacts": ("semi-implicit", True),
    "parabola-impacts": ("exact-flight", True),
}


def falling_spheres(scheme: str, whole: bool) -> CollidingSpheres:
    """Four smooth elastic spheres that fall in a box."""
    effects = COLLISIONS | WINDOW | GRAVITY
    return CollidingSpheres(
        SphereBodies(PLACES, RADII, SPEEDS),
        surroundings_of(BOX),
        material_tables(1.0, 0.0),
        effects=effects.with_(IMPACT_TIMES) if whole else effects,
        scheme=scheme,
        gravity=G,
        correction="none",
    )


def exact_flight() -> SmoothSpheres:
    """The same from impact to impact, at the end."""
    run = SmoothSpheres(PLACES, SPEEDS, RADII, gravity=G, window=BOX)
    run.fly(FLIGHT_S)
    return run


def place_error(world: CollidingSpheres) -> float:
    """Farthest sphere from its exact place, m."""
    off = world.bodies.state.positions - exact_flight().positions
    return math.sqrt(float((off * off).sum(axis=1).max()))


def energy_error(world: CollidingSpheres) -> float:
    """Change of energy, a part of what there was."""
    energy = falling_spheres("explicit-euler", False).totals().energy
    return abs(world.totals().energy / energy - 1.0)


def impact_trial(setting: Setting) -> Run:
    """Four spheres for FLIGHT_S at the setting's step."""
    scheme, whole = IMPACTS[setting.method]
    steps = max(1, round(FLIGHT_S / setting.knob))
    pairs = len(RADII) * (len(RADII) - 1) // 2
    return Run(falling_spheres(scheme, whole), FLIGHT_S / steps, steps, place_error, lambda world: pairs)


def energy_trial(setting: Setting) -> Run:
    """The same, for its energy."""
    run = impact_trial(setting)
    run.error = energy_error
    return run


def impact_settings() -> list[Setting]:
    """Steps of 1/28 to 1/570 s, many of them: errors after collisions are saw-toothed."""
    return [
        Setting(
            name, FLIGHT_S / n, {},
            {"scheme": scheme, "impact-times": whole,
             "step_length": min(max(FLIGHT_S / n, FASTEST_STEP), SLOWEST_STEP), "substeps": 1}, 5.0 + n,
        )
        for n in counts_between(20, 400, 60)
        for name, (scheme, whole) in IMPACTS.items()
    ]  # fmt: skip


def present_impacts(parameters: Mapping[str, Any]) -> Setting:
    """Where a scene with these parameters stands."""
    h = float(parameters["step_length"]) / float(parameters["substeps"])
    way = str(parameters["scheme"]), bool(parameters["impact-times"])
    method = next(name for name, taken in IMPACTS.items() if taken == way)
    scene = {"scheme": way[0], "impact-times": way[1]}
    return Setting(method, min(max(h, FASTEST_STEP), SLOWEST_STEP), {}, scene)


# -- piles ----------------------------------------------------------------------------------------------


def pile(correction: str, iterations: int) -> CollidingSpheres:
    """A heap of discs in a box, that falls together and comes to rest."""
    random = np.random.default_rng(7)
    i = np.arange(PILE_COLUMNS * PILE_ROWS)
    shift = random.uniform(-0.05, 0.05, (len(i), 2))
    places = np.stack((0.5 + i % PILE_COLUMNS, 0.5 + i // PILE_COLUMNS), axis=1) + shift
    bodies = SphereBodies(
        places, np.full(len(i), PILE_RADIUS), inertias=np.full(len(i), 0.5 * (PILE_RADIUS * PILE_RADIUS))
    )
    return CollidingSpheres(
        bodies,
        surroundings_of((0.0, 0.0, float(PILE_COLUMNS), 3.0 * PILE_ROWS)),
        material_tables(0.0, 0.5),
        effects=USUAL,
        scheme="semi-implicit",
        correction=correction,
        iterations=iterations,
        passes=max(1, iterations // 3),
        path="planar",
    )


def pile_trial(setting: Setting) -> Run:
    """Until it is at rest."""
    correction = str(setting.scene["correction"])
    iterations = max(1, round(setting.knob))
    steps = round(PILE_S / FRAME)
    sweeps = iterations + (iterations // 3 if correction in ("split", "projection") else 0)
    return Run(pile(correction, iterations), FRAME, steps, lambda world: world.overlap(), lambda _: sweeps)


def pile_settings() -> list[Setting]:
    """1 to 60 sweeps for each correction."""
    return [
        Setting(
            name, n, {},
            {"correction": name, "iterations": n, "passes": max(1, n // 3)} if name in ("split", "projection")
            else {"correction": name, "iterations": n}, 20.0 + n,
        )
        for n in (1, 2, 3, 5, 8, 12, 20, 35, 60)
        for name in CORRECTIONS
    ]  # fmt: skip


def present_pile(parameters: Mapping[str, Any]) -> Setting:
    """Where a scene with these parameters stands."""
    correction = str(parameters["correction"])
    return Setting(correction, float(parameters["iterations"]), {}, {"correction": correction})


_METHODS = (
    Method("explicit", "explicit Euler, overlap", 1.0, "as the course has it"),
    Method("semi-implicit", "semi-implicit, overlap", 1.0),
    Method("parabola", "parabola, overlap", 1.0, "flight is exact, collisions come late"),
    Method(
        "explicit-impacts", "explicit Euler, impact times", 1.0, "collisions in time, flight is not exact"
    ),
    Method("semi-implicit-impacts", "semi-implicit, impact times", 1.0),
    Method("parabola-impacts", "parabola, impact times", None, "exact, at any step"),
)

pile_study = Study(
    name="c13-pile",
    title="Colliding spheres: a pile at rest",
    error="deepest overlap of 96 discs of radius 0.43 m after 4 s",
    error_unit="m",
    counter="sweeps over all contacts",
    knob=Knob("iterations", "sweeps a step", parts=True),
    methods=(
        Method("none", "no correction"),
        Method("baumgarte", "Baumgarte", None, "pushes, and so adds energy"),
        Method("soft", "soft contacts", None, "a damped spring, then relaxed"),
        Method("split", "split impulses"),
        Method("projection", "projection"),
    ),
    settings=pile_settings,
    trial=pile_trial,
    reference="discs do not overlap; the slop of 0.0043 m is left to them.",
    short="Pile",
    expectation="Without correction overlap stays; the others come down to the slop with enough sweeps.",
    floor=4.3e-3,
    present=present_pile,
    workload=Workload("96 discs in a box"),
)

ENERGY_NOTES = {  # of methods of which no order is expected
    "parabola": "keeps energy, however late a collision is found",
    "explicit-impacts": "an impact comes before the gravity of its part of a step, and so is off by up to "
    "2 g dt, as chance has it: their sum is too ragged to have an order over this range",
}

energy_study = Study(
    name="c13-energy",
    title="Colliding spheres: energy of elastic impacts",
    error="change of energy after 0.7 s, a part of it",
    error_unit="",
    counter="tests of pairs",
    knob=Knob("step_length", "time step", "s"),
    methods=tuple(
        replace(method, order=None, note=ENERGY_NOTES[method.name]) if method.name in ENERGY_NOTES else method
        for method in _METHODS
    ),
    settings=impact_settings,
    trial=energy_trial,
    reference="nothing is lost.",
    short="Energy",
    expectation="Falling is a matter of the scheme, colliding one of the time: only both keep energy.",
    envelope=True,
    present=present_impacts,
    workload=Workload("four spheres"),
)

impact_study = Study(
    name="c13",
    title="Colliding spheres: against the event-driven run",
    short="Impacts",
    error="farthest of four spheres from its exact place after 0.7 s",
    error_unit="m",
    counter="tests of pairs",
    knob=Knob("step_length", "time step", "s"),
    methods=_METHODS,
    settings=impact_settings,
    trial=impact_trial,
    reference="smooth spheres from impact to impact, by quadratics.",
    expectation=(
        "All that find collisions by overlap are of first order, even with exact flight. With impact times "
        "and parabolas a step of any length is exact."
    ),
    envelope=True,
    floor=1e-11,
    present=present_impacts,
    workload=Workload("four spheres"),
    related=(energy_study, pile_study),
)
