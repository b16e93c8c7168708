"""The study of the kinetic sweep's bounds: false pairs and time, against how far boxes go in a step."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

import numpy as np

from game.lab.studies.broadphase.steps import EXTENT, PER_STEP, SEED, Steps, box_size, boxes_of
from game.lab.study import Axes, Knob, Method, Outcome, Setting, Study
from game.physics.broadphase import KineticSweep
from game.physics.broadphase.kinetic.kinetic_sweep import SLABS
from game.physics.broadphase.workloads import MovingBoxes, make_boxes

BOXES, FILL, STEP, STEPS = 1000, 0.1, 1.0 / 60.0, 40  # of the world, s
PARAMETERS = {"workload": "equal", "count": BOXES, "fill": FILL}


@cache
def _boxes() -> MovingBoxes:
    return make_boxes("equal", BOXES, np.random.default_rng(SEED), EXTENT, FILL, 1.0)


def _false_pairs(steps: Steps) -> Outcome:
    """Candidates that do not overlap, for each box; the counter is events, after the last step."""
    phase = steps.phase
    assert isinstance(phase, KineticSweep)
    return Outcome(phase.false_pairs / len(steps.ids), phase.events)


def _trial(setting: Setting) -> Steps:
    boxes = _boxes()
    moving = boxes._replace(velocities=setting.knob * box_size(BOXES, FILL) * boxes.velocities)
    return Steps(KineticSweep(int(setting.method)), moving, _false_pairs, STEPS)


def _settings() -> list[Setting]:
    size = box_size(BOXES, FILL)
    return [
        Setting(
            str(slabs), share, {},
            {**PARAMETERS, "slabs": str(slabs), "step_length": STEP, "speed": share * size / STEP}, 1.0,
        )
        for slabs in SLABS
        for share in (0.01, 0.03, 0.1, 0.3, 1.0, 3.0)
    ]  # fmt: skip


def _present(parameters: Mapping[str, Any]) -> Setting:
    """How far the scene's boxes go in a step, in their size."""
    size = box_size(int(parameters["count"]), float(parameters["fill"]))
    way = float(parameters["speed"]) * float(parameters["step_length"])
    return Setting(str(parameters["slabs"]), way / size)


slabs_study = Study(
    name="broad-phase-slabs",
    title="Kinetic sweep: false pairs against speed",
    error="false pairs for each box",
    error_unit="",
    counter="events",
    knob=Knob("speed", "way in a step over box size"),
    methods=tuple(Method(str(slabs), f"{slabs} sides") for slabs in SLABS),
    settings=_settings,
    trial=_trial,
    present=_present,
    workload=boxes_of("1000 equal boxes, density 0.1", **PARAMETERS),
    axes=Axes("knob", "error"),
    short="Sides",
    cost=PER_STEP,
    reference="All find the same pairs. A bound lasts until it is a size longer, four steps at least.",
    expectation="Slow boxes are alike, whatever their speed: a bound is a size longer than its box. Beyond "
    "a quarter of a size in a step bounds grow with the speed. Those with more sides let fewer "
    "false pairs through, as the slab across the motion lies the nearer.",
)
