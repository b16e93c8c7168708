"""Studies of grids: what a step costs against the size of cells, and against the ratio of box sizes."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from game.lab.studies.broadphase.missed import missed_pairs_study
from game.lab.studies.broadphase.steps import (
    EXTENT,
    PER_STEP,
    SEED,
    Steps,
    boxes_of,
    geometric,
    tests_per_box,
)
from game.lab.study import Axes, Knob, Method, Setting, Study
from game.physics.broadphase import BroadPhase, CoveringGrid, HierarchicalGrid, UniformGrid
from game.physics.broadphase.workloads import MovingBoxes, make_boxes

# -- cell size

CELL_BOXES = 3000
CELL_PARAMETERS = {"workload": "equal", "count": CELL_BOXES, "fill": 0.1}


def _cell_trial(setting: Setting) -> Steps:
    boxes = make_boxes("equal", CELL_BOXES, np.random.default_rng(SEED), EXTENT, 0.1, 0.0)
    size = float(boxes.uppers[0, 0] - boxes.lowers[0, 0])
    moving = boxes._replace(velocities=boxes.velocities + 0.02 * size)
    kind = UniformGrid if setting.method == "corner" else CoveringGrid
    return Steps(kind((0.0, 0.0), EXTENT, setting.knob * size), moving, tests_per_box)


cell_cost_study = Study(
    name="c05-cell-size",
    title="Uniform grid: cost against cell size",
    error="box tests for each box",
    error_unit="",
    counter="pairs",
    knob=Knob("cell", "cell over box size"),
    methods=(
        Method("corner", "a box in one cell"),
        Method("covered", "a box in all cells it covers"),
    ),
    settings=lambda: [
        Setting(method, cell, {}, {**CELL_PARAMETERS, "cell": cell, "storage": method}, 1.0)
        for method in ("corner", "covered")
        for cell in geometric(0.25, 32.0, 15)
    ],
    trial=_cell_trial,
    present=lambda parameters: Setting(str(parameters["storage"]), float(parameters["cell"])),
    workload=boxes_of("3000 equal boxes, density 0.1", **CELL_PARAMETERS),
    axes=Axes("knob", "cpu"),
    short="Cell size",
    cost=PER_STEP,
    reference="Pairs are the same at every cell size: errors are none. The curve is cost.",
    expectation="Time against cell size is a U: small cells cost entries, (1 + size/cell)² where all "
    "covered cells are entered, large ones cost tests, as the square of the cell. Covered cells are best at "
    "2 to 6 sizes, one cell for each box at 1 to 1.5.",
)
cell_size_study = missed_pairs_study(
    "c05", "Uniform grid", lambda size: UniformGrid((0.0, 0.0), EXTENT, 2.0 * size), (cell_cost_study,),
    cell=2.0, storage="corner",
)  # fmt: skip


# -- size ratio

RATIO_BOXES, RATIO_LARGE = 3000, 20
RATIO_PARAMETERS = {
    "workload": "heavy-tail", "count": RATIO_BOXES, "fill": 0.05, "share": RATIO_LARGE / RATIO_BOXES,
}  # fmt: skip


def _ratio_boxes(ratio: float) -> MovingBoxes:
    boxes = make_boxes(
        "heavy-tail",
        RATIO_BOXES,
        np.random.default_rng(SEED),
        EXTENT,
        0.05,
        0.0,
        ratio,
        RATIO_LARGE / RATIO_BOXES,
    )
    return boxes._replace(velocities=boxes.velocities + 0.02 * float(boxes.half_sizes.min()))


def _ratio_trial(setting: Setting) -> Steps:
    boxes = _ratio_boxes(setting.knob)
    small, large = 2.0 * float(boxes.half_sizes.min()), 2.0 * float(boxes.half_sizes.max())
    phases: dict[str, Callable[[], BroadPhase]] = {
        "largest": lambda: UniformGrid((0.0, 0.0), EXTENT, min(large, EXTENT[1])),
        "tuned": lambda: UniformGrid((0.0, 0.0), EXTENT, math.sqrt(small * large)),
    }
    if setting.method in phases:
        return Steps(phases[setting.method](), boxes, tests_per_box)
    return Steps(HierarchicalGrid(int(setting.method.split("-")[1])), boxes, tests_per_box)


ratio_study = Study(
    name="c06-size-ratio",
    title="Hierarchical grids: cost against the ratio of sizes",
    error="box tests for each box",
    error_unit="",
    counter="pairs",
    knob=Knob("ratio", "large over small"),
    methods=(
        Method("largest", "one grid, cell of the largest box"),
        Method("tuned", "one grid, geometric mean"),
        Method("hierarchical-2", "hierarchy, cells double"),
        Method("hierarchical-4", "hierarchy, four times"),
        Method("hierarchical-8", "hierarchy, eight times"),
    ),
    settings=lambda: [
        Setting(method, ratio, {}, {**RATIO_PARAMETERS, "ratio": ratio}, 1.0)
        for method in ("largest", "tuned", "hierarchical-2", "hierarchical-4", "hierarchical-8")
        for ratio in geometric(1.0, 256.0, 9)
    ],
    trial=_ratio_trial,
    present=lambda parameters: Setting(
        f"hierarchical-{parameters['step_ratio']}", float(parameters["ratio"])
    ),
    workload=boxes_of("3000 boxes, 20 of them large, density 0.05", **RATIO_PARAMETERS),
    axes=Axes("knob", "cpu"),
    short="Size ratio",
    cost=PER_STEP,
    reference="Pairs are the same for all methods: errors are none. The curve is cost.",
    expectation="Twenty large boxes among three thousand small ones: a grid whose cells fit the largest "
    "box tests small boxes against each other. The hierarchy is never far from the best, and "
    "needs no tuning.",
)
hierarchy_study = missed_pairs_study(
    "c06", "Hierarchical grids", lambda size: HierarchicalGrid(), (ratio_study,)
)
