"""What accuracy costs for a column of boxes: how far it sinks, by solver and substeps."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from game.lab.studies.qualities import quality_marks
from game.lab.study import Knob, Method, Outcome, Setting, Study, Trial, Workload
from game.lab.trials import Computation
from game.naming import words_of
from game.physics.kernels import elementary
from game.physics.solids import SOLVERS, TIERS, SolidSettings, SolidWorld, box
from game.physics.solids.effects import USUAL

BOXES, SECONDS, STEP = 10, 2.0, 1.0 / 60.0
SUBSTEPS = (1, 2, 4, 8, 12, 16, 24, 32, 48, 64)
FALLEN = 0.5  # m, of the top: the column stands no more


def stack_trial(setting: Setting) -> Trial:
    """A column of unit boxes on the ground: how far its top is from where rigid boxes would have it."""
    substeps = int(setting.knob)

    def begin() -> SolidWorld:
        world = SolidWorld(
            SolidSettings(effects=USUAL.without("sleep"), solver=setting.method, substeps=substeps)
        )
        world.add_body(box(100.0, 2.0), (0.0, -1.0), kind="fixed")
        for k in range(BOXES):
            world.add_body(box(1.0, 1.0), (0.0, 0.5 + k))
        return world

    def work(world: SolidWorld) -> SolidWorld:
        for _ in range(round(SECONDS / STEP)):
            world.step(STEP)
        return world

    def judge(world: SolidWorld) -> Outcome:
        x, y = world.bodies.positions[BOXES].tolist()  # of the top box: the ground is body 0
        sunk = elementary.hypot(y - (BOXES - 0.5), x)
        return Outcome(sunk, substeps * round(1.0 / STEP), "it has fallen" if sunk > FALLEN else "")

    return Computation(SECONDS, begin, work, judge)


def _settings() -> list[Setting]:
    return [
        Setting(name, float(n), scene={"solver": name, "tier": "own", "substeps": n}, weight=float(n))
        for n in SUBSTEPS
        for name in SOLVERS
    ]


def _present(parameters: Mapping[str, Any]) -> Setting:
    substeps = TIERS.get(str(parameters["tier"]), int(parameters["substeps"]))
    return Setting(str(parameters["solver"]), float(substeps))


def _race_settings() -> list[Setting]:
    return [
        replace(
            setting, scene={"setup": "stack", "tier": "own", "substeps": int(setting.knob), "iterations": 1}
        )
        for setting in _settings()
    ]


stack_study = Study(
    name="stack",
    title="A column of ten boxes",
    error=f"the top's distance from its place after {SECONDS:g} s",
    error_unit="m",
    counter="substeps a second",
    knob=Knob("substeps", "substeps", parts=True),
    methods=tuple(Method(name, words_of(name)) for name in SOLVERS),
    settings=_settings,
    trial=stack_trial,
    reference="rigid boxes do not sink.",
    expectation="Soft contacts sink by the inverse square of their frequency, which goes with the substeps.",
    present=_present,
    workload=Workload("a column of ten boxes"),
    mark=quality_marks("soft-step"),
)

race_study = replace(
    stack_study,
    name="solver-race",
    settings=_race_settings,
    present=None,
    no_place="No mark: your scene runs several solvers at once; each has its own curve.",
)
