"""Studies of sweep and prune: swaps and time against how far boxes go in a step."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from game.lab.studies.broadphase.missed import missed_pairs_study
from game.lab.studies.broadphase.steps import (
    EXTENT,
    PER_STEP,
    SEED,
    Steps,
    box_size,
    boxes_of,
    geometric,
    tests_per_box,
)
from game.lab.study import Axes, Knob, Method, Outcome, Setting, Study
from game.physics.broadphase import SweepAndPrune, UniformGrid
from game.physics.broadphase.workloads import expected_swaps, make_boxes

SPEED_BOXES, SPEED_FILL, SPEED_STEP = 1000, 0.1, 1.0 / 60.0  # of the world, s
SPEED_PARAMETERS = {"workload": "equal", "count": SPEED_BOXES, "fill": SPEED_FILL}


def _swaps_over_formula(steps: Steps) -> Outcome:
    """Swaps of a step for each box."""
    return Outcome(steps.swaps / steps.steps / len(steps.ids), steps.swaps)


def _speed_trial(setting: Setting) -> Steps:
    boxes = make_boxes("equal", SPEED_BOXES, np.random.default_rng(SEED), EXTENT, SPEED_FILL, 1.0)
    size = box_size(SPEED_BOXES, SPEED_FILL)
    moving = boxes._replace(velocities=setting.knob * size * boxes.velocities)
    if setting.method == "grid":
        return Steps(UniformGrid((0.0, 0.0), EXTENT, 1.25 * size), moving, tests_per_box)
    return Steps(SweepAndPrune(resort=setting.method == "resort"), moving, _swaps_over_formula)


def _speed_settings(methods: Sequence[str]) -> Sequence[Setting]:
    size = box_size(SPEED_BOXES, SPEED_FILL)
    points = []
    for method in methods:
        for share in geometric(0.005, 8.0, 11):
            formula = expected_swaps(SPEED_BOXES, share * size, EXTENT) / SPEED_BOXES
            scene = {
                **SPEED_PARAMETERS, "resort": method == "resort",
                "step_length": SPEED_STEP, "speed": share * size / SPEED_STEP,
            }  # fmt: skip
            points.append(Setting(method, share, {"formula": formula}, scene, 1.0))
    return points


def _present_speed(parameters: Mapping[str, Any]) -> Setting:
    """How far the scene's boxes go in a step, in their size."""
    size = box_size(int(parameters["count"]), float(parameters["fill"]))
    return Setting("swaps", float(parameters["speed"]) * float(parameters["step_length"]) / size)


def _present_sorting(parameters: Mapping[str, Any]) -> Setting:
    """The same, with or without sorting again."""
    return replace(_present_speed(parameters), method="resort" if parameters["resort"] else "swaps")


swaps_study = Study(
    name="c07-swaps",
    title="Sweep and prune: swaps against speed",
    error="swaps (grid: tests) for each box and step",
    error_unit="",
    counter="swaps",
    knob=Knob("speed", "way in a step over box size"),
    methods=(
        Method("swaps", "swaps", 1.0),
        Method("grid", "tests of a uniform grid"),
    ),
    settings=partial(_speed_settings, ("swaps", "grid")),
    trial=_speed_trial,
    present=_present_speed,
    workload=boxes_of("1000 equal boxes, density 0.1", **SPEED_PARAMETERS),
    axes=Axes("knob", "error"),
    short="Swaps",
    cost=PER_STEP,
    reference="Column formula: 2 n (8/π²) v Δt (1/W + 1/H), swaps for each box, for slow isotropic motion.",
    expectation="Swaps grow in proportion to the way in a step. A grid does not mind the speed.",
)
speed_study = replace(
    swaps_study,
    name="c07-speed",
    title="Sweep and prune: cost against speed",
    short="Speed",
    methods=(
        Method("swaps", "swaps alone"),
        Method("resort", "sorted again where that is cheaper"),
        Method("grid", "uniform grid beside it"),
    ),
    settings=partial(_speed_settings, ("swaps", "resort", "grid")),
    present=_present_sorting,
    axes=Axes("knob", "cpu"),
    reference="Pairs are the same for all methods: errors are none. The curve is cost.",
    expectation="Time grows with the swaps, in proportion to the way in a step, until it is cheaper to sort "
    "again. A grid does not mind the speed.",
)
sweep_study = missed_pairs_study(
    "c07", "Sweep and prune", lambda size: SweepAndPrune(), (swaps_study, speed_study)
)
