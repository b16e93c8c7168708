"""What accuracy costs for floors that fall on each other: the time until the last one is struck."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from game.lab.studies.qualities import quality_marks
from game.lab.study import Knob, Method, Outcome, Setting, Study, Trial, Workload
from game.lab.trials import computation
from game.naming import words_of
from game.physics.accretion import strike_times
from game.physics.solids import TIERS, Material, SolidSettings, SolidWorld, box

FLOORS, HEIGHT, THICK, STEP_S = 10, 3.0, 0.4, 1.0 / 60.0
FALL_S = 3.5
COUNTS = (1, 2, 4, 8, 12, 16, 24, 32, 64)
SOLVERS = ("soft-step", "sequential-impulses")


def fall_of(settings: SolidSettings, floors: int = FLOORS, step: float = STEP_S) -> tuple[float, float]:
    """s until the last of so many floors is struck by those above, and by the law.

    Floors hang without weight until they are struck, so nothing else than their mass resists.
    """
    world = SolidWorld(settings)
    stuff = Material(1000.0, 0.5)
    plates = [
        world.add_body(
            box(10.0, THICK, material=stuff), (0.0, -HEIGHT * k), gravity_scale=1.0 if k == 0 else 0.0
        )
        for k in range(floors)
    ]
    law = strike_times(1.0, [1.0] * (floors - 1), HEIGHT - THICK)[-1]
    rows, last = world.bodies, plates[-1]
    while world.time < 4.0 * law:
        world.step(step)
        shapes, begun = world.contacts_begun()
        for pair, (_, _, _, _, when) in zip(
            world.shapes.bodies[shapes].tolist(), begun.tolist(), strict=True
        ):
            if last in pair:
                return float(world.time - step + when), law
        for plate in plates[1:]:
            if rows.gravity_scales[plate] == 0.0 and rows.velocities[plate, 1] < -1e-6:
                rows.gravity_scales[plate] = 1.0
    return 4.0 * law, law


def collapse_trial(setting: Setting) -> Trial:
    """A fall, from its start each time: relative error of the time."""
    substeps = int(setting.scene["substeps"])
    settings = SolidSettings(solver=setting.method, substeps=substeps, iterations=1)
    return computation(
        FALL_S,
        lambda: fall_of(settings),
        lambda times: Outcome(max(abs(times[0] / times[1] - 1.0), 1e-9), round(substeps * FALL_S / STEP_S)),
    )


def collapse_settings() -> list[Setting]:
    """1 to 64 substeps."""
    return [
        Setting(name, float(n), {}, {"solver": name, "tier": "own", "substeps": n}, 10.0 + n)
        for n in COUNTS
        for name in SOLVERS
    ]


def present_collapse(parameters: Mapping[str, Any]) -> Setting:
    """Where a scene with these parameters stands: its solver and substeps."""
    substeps = TIERS.get(str(parameters["tier"]), int(parameters["substeps"]))
    solver = str(parameters["solver"])
    return Setting(
        solver if solver in SOLVERS else "present",
        float(substeps),
        {},
        {"solver": solver, "substeps": substeps},
    )


collapse_study = Study(
    name="a08",
    title="Floors that fall on each other",
    error="relative error of the time until the last floor is struck",
    error_unit="",
    counter="substeps",
    knob=Knob("substeps", "substeps", parts=True),
    methods=tuple(Method(name, words_of(name), None) for name in SOLVERS),
    settings=collapse_settings,
    trial=collapse_trial,
    reference="momentum, floor by floor",
    expectation="Floors overlap a little before they are stopped, and are struck at the end of a substep.",
    present=present_collapse,
    workload=Workload("ten floors"),
    mark=quality_marks("soft-step"),
)
