"""Studies of all broad phases on one workload: their time, and their work, against the number of boxes.

Work has a law: tests of boxes, or swaps. Time follows it where it is spent on that.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from game.lab.studies.broadphase.slabs import slabs_study
from game.lab.studies.broadphase.steps import EXTENT, PER_STEP, SEED, Steps, boxes_of, tests_per_box
from game.lab.study import Axes, Knob, Method, Outcome, Setting, Study
from game.physics.broadphase import (
    BroadPhase,
    BspTree,
    HierarchicalGrid,
    KineticSweep,
    NaiveBroadPhase,
    SweepAndPrune,
    UniformGrid,
)
from game.physics.broadphase.workloads import make_boxes

MOST_NAIVE = 10_000
COUNT_PARAMETERS = {"workload": "equal", "fill": 0.375}
METHOD_COLORS = {  # of the theme: in studies, tables, bars, strips and curves alike
    "naive": "vermilion", "uniform": "chalk", "covering": "violet", "hierarchical": "green", "sweep": "pink",
    "bsp": "yellow", "kinetic": "amber",
}  # fmt: skip
COUNT_METHODS: dict[str, Callable[[float], BroadPhase]] = {
    "naive": lambda size: NaiveBroadPhase(),
    "uniform": lambda size: UniformGrid((0.0, 0.0), EXTENT, 1.25 * size),
    "hierarchical": lambda size: HierarchicalGrid(),
    "sweep": lambda size: SweepAndPrune(),
    "bsp": lambda size: BspTree(),
    "kinetic": lambda size: KineticSweep(),
}


def _count_trial(setting: Setting) -> Steps:
    count = round(setting.knob)
    boxes = make_boxes("equal", count, np.random.default_rng(SEED), EXTENT, 0.375, 1.0)
    size = 2.0 * float(boxes.half_sizes[0, 0])
    moving = boxes._replace(velocities=0.02 * size * boxes.velocities)
    phase = COUNT_METHODS[setting.method](size)
    return Steps(phase, moving, lambda steps: Outcome(tests_per_box(steps).error * count, steps.pairs))


def _count_settings() -> list[Setting]:
    """Ten to thirty thousand boxes; fewer for testing all pairs."""
    return [
        Setting(method, count, {}, {**COUNT_PARAMETERS, "count": int(count)}, count)
        for method in COUNT_METHODS
        for count in (10.0, 30.0, 100.0, 300.0, 1000.0, 3000.0, 10_000.0, 30_000.0)
        if method != "naive" or count <= MOST_NAIVE
    ]


work_study = Study(
    name="broad-phase-work",
    title="Broad phases: work against the number of boxes",
    error="work of a step: box tests (sweep and prune: swaps)",
    error_unit="",
    counter="pairs",
    knob=Knob("count", "boxes"),
    methods=(
        Method("naive", "naive", 2.0, color=METHOD_COLORS["naive"]),
        Method("uniform", "uniform grid", 1.0, color=METHOD_COLORS["uniform"]),
        Method("hierarchical", "hierarchical grids", 1.0, color=METHOD_COLORS["hierarchical"]),
        Method("sweep", "sweep and prune", 1.5, color=METHOD_COLORS["sweep"]),
        Method("bsp", "BSP tree", 1.0, color=METHOD_COLORS["bsp"]),
        Method("kinetic", "kinetic sweep", 1.0, color=METHOD_COLORS["kinetic"]),
    ),
    settings=_count_settings,
    trial=_count_trial,
    present=lambda parameters: Setting("hierarchical", float(parameters["count"])),
    workload=boxes_of("equal boxes, density 0.375", **COUNT_PARAMETERS),
    axes=Axes("knob", "error"),
    short="Work",
    cost=PER_STEP,
    reference="All methods find the same pairs. Boxes move 2 % of their size in a step, 1.5 overlaps each.",
    expectation="Tests grow with the square of the number where all pairs are tested, in proportion to it in "
    "grids. Swaps grow with the power 1.5: n boxes, each passing √n others as it goes a share of its size.",
)
count_study = replace(
    work_study,
    name="broad-phase-race",
    title="Broad phases: time against the number of boxes",
    methods=(
        *work_study.methods[:3],
        Method(
            "sweep",
            "sweep and prune",
            None,
            "between 1 and 1.5: sorting and listing are in proportion",
            color=METHOD_COLORS["sweep"],
        ),
        *work_study.methods[4:],
    ),
    axes=Axes("knob", "cpu"),
    short="Number",
    expectation="Time grows with the square of the number for testing all pairs, in proportion to it for "
    "grids. Sweep and prune lies between: its swaps grow with the power 1.5, the rest of its work in "
    "proportion.",
    related=(work_study, slabs_study),
)
