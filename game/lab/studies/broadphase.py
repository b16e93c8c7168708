"""Studies of what broad phases cost: against cell size, size ratio, speed, and number of boxes."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from game.lab.studies.broadphase_missed import EXTENT, SEED, missed_pairs_study
from game.lab.study import Axes, Knob, Method, Outcome, Setting, Study
from game.physics.broadphase import (
    BroadPhase,
    CoveringGrid,
    HierarchicalGrid,
    NaiveBroadPhase,
    SweepAndPrune,
    UniformGrid,
)
from game.physics.broadphase.workloads import MovingBoxes, expected_swaps, make_boxes

Array = NDArray[np.float64]
PER_STEP = "CPU time for one step"


def _geometric(first: float, last: float, count: int) -> list[float]:
    return [float(f"{value:.6g}") for value in np.geomspace(first, last, count)]


# -- cost of a step: a workload that moves, and a broad phase


class Steps:
    """Steps of moving boxes through a broad phase; the outcome is what ``judge`` makes of it."""

    def __init__(
        self,
        phase: BroadPhase,
        boxes: MovingBoxes,
        judge: Callable[[Steps], Outcome],
        steps: int = 5,
        dt: float = 1.0,
    ):
        self.phase, self.boxes, self.judge, self.steps, self.dt = phase, boxes, judge, steps, dt
        self.simulated_s = float(steps)
        self.ids = phase.add_boxes(boxes.lowers, boxes.uppers)
        self.pairs = 0
        self.swaps = 0

    def reset(self) -> None:
        self.phase.update_boxes(self.ids, self.boxes.lowers, self.boxes.uppers)
        self.phase.pairs()
        self.swaps = self.phase.swaps if isinstance(self.phase, SweepAndPrune) else 0

    def run(self) -> None:
        for step in range(1, self.steps + 1):
            shift = step * self.dt * self.boxes.velocities
            self.phase.update_boxes(self.ids, self.boxes.lowers + shift, self.boxes.uppers + shift)
            self.pairs = len(self.phase.pairs())

    def outcome(self) -> Outcome:
        if isinstance(self.phase, SweepAndPrune):
            self.swaps = self.phase.swaps - self.swaps
        return self.judge(self)


def tests_per_box(steps: Steps) -> Outcome:
    """Box tests of a step for each box; of sweep and prune, swaps."""
    work = steps.swaps / steps.steps if isinstance(steps.phase, SweepAndPrune) else float(steps.phase.tests)
    return Outcome(work / len(steps.ids), steps.pairs)


# -- cell size

CELL_BOXES = 3000


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
        Setting(method, cell, {}, {"cell": cell, "storage": method}, 1.0)
        for method in ("corner", "covered")
        for cell in _geometric(0.25, 32.0, 15)
    ],
    trial=_cell_trial,
    present=lambda parameters: Setting(str(parameters["storage"]), float(parameters["cell"])),
    axes=Axes("knob", "cpu"),
    short="Cell size",
    cost=PER_STEP,
    reference="Pairs are the same at every cell size: errors are none. The curve is cost.",
    expectation="Time against cell size is a U: small cells cost entries, (1 + size/cell)^2 where all "
    "covered cells are entered, large ones cost tests, as the square of the cell. Covered cells are best at "
    "2 to 6 sizes, one cell for each box at 1 to 1.5.",
)
cell_size_study = missed_pairs_study(
    "c05", "Uniform grid", lambda size: UniformGrid((0.0, 0.0), EXTENT, 2.0 * size), (cell_cost_study,)
)


# -- size ratio

RATIO_BOXES, RATIO_LARGE = 3000, 20


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
        Setting(method, ratio, {}, {"ratio": ratio, "workload": "heavy-tail"}, 1.0)
        for method in ("largest", "tuned", "hierarchical-2", "hierarchical-4", "hierarchical-8")
        for ratio in _geometric(1.0, 256.0, 9)
    ],
    trial=_ratio_trial,
    present=lambda parameters: Setting(
        f"hierarchical-{parameters['step_ratio']}", float(parameters["ratio"])
    ),
    axes=Axes("knob", "cpu"),
    short="Size ratio",
    cost=PER_STEP,
    reference="Pairs are the same for all methods: errors are none. The curve is cost.",
    expectation="Twenty large boxes among three thousand small ones: a grid whose cells fit the largest box "
    "tests small boxes against each other; the hierarchy is never far from the best, and needs no tuning.",
)
hierarchy_study = missed_pairs_study(
    "c06", "Hierarchical grids", lambda size: HierarchicalGrid(), (ratio_study,)
)


# -- speed

SPEED_BOXES = 1000


def _swaps_over_formula(steps: Steps) -> Outcome:
    """Swaps of a step for each box."""
    return Outcome(steps.swaps / steps.steps / len(steps.ids), steps.swaps)


def _speed_trial(setting: Setting) -> Steps:
    boxes = make_boxes("equal", SPEED_BOXES, np.random.default_rng(SEED), EXTENT, 0.1, 1.0)
    size = float(boxes.uppers[0, 0] - boxes.lowers[0, 0])
    moving = boxes._replace(velocities=setting.knob * size * boxes.velocities)
    if setting.method == "grid":
        return Steps(UniformGrid((0.0, 0.0), EXTENT, 1.25 * size), moving, tests_per_box)
    return Steps(SweepAndPrune(resort=setting.method == "resort"), moving, _swaps_over_formula)


def _speed_settings(methods: Sequence[str]) -> Sequence[Setting]:
    boxes = make_boxes("equal", SPEED_BOXES, np.random.default_rng(SEED), EXTENT, 0.1)
    size = 2.0 * float(boxes.half_sizes[0, 0])
    points = []
    for method in methods:
        for share in _geometric(0.005, 8.0, 11):
            formula = expected_swaps(SPEED_BOXES, share * size, EXTENT) / SPEED_BOXES
            points.append(Setting(method, share, {"formula": formula}, {"resort": method == "resort"}, 1.0))
    return points


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
    axes=Axes("knob", "error"),
    short="Swaps",
    cost=PER_STEP,
    reference="Column formula: 2 n (8/pi^2) v dt (1/W + 1/H), swaps for each box, for slow isotropic motion.",
    expectation="Swaps grow in proportion to the way in a step. A grid does not mind the speed.",
)
speed_study = replace(
    swaps_study,
    name="c07-speed",
    title="Sweep and prune: cost against speed",
    short="Speed",
    methods=(
        Method("swaps", "swaps alone"),
        Method("resort", "sorted anew where that is cheaper"),
        Method("grid", "uniform grid beside it"),
    ),
    settings=partial(_speed_settings, ("swaps", "resort", "grid")),
    axes=Axes("knob", "cpu"),
    reference="Pairs are the same for all methods: errors are none. The curve is cost.",
    expectation="Time grows with the swaps, in proportion to the way in a step, until it is cheaper to sort "
    "anew. A grid does not mind the speed.",
)
sweep_study = missed_pairs_study(
    "c07", "Sweep and prune", lambda size: SweepAndPrune(), (swaps_study, speed_study)
)


# -- number of boxes

MOST_NAIVE = 3000
COUNT_METHODS: dict[str, Callable[[float], BroadPhase]] = {
    "naive": lambda size: NaiveBroadPhase(),
    "uniform": lambda size: UniformGrid((0.0, 0.0), EXTENT, 1.25 * size),
    "hierarchical": lambda size: HierarchicalGrid(),
    "sweep": lambda size: SweepAndPrune(),
}


def _count_trial(setting: Setting) -> Steps:
    count = round(setting.knob)
    boxes = make_boxes("equal", count, np.random.default_rng(SEED), EXTENT, 0.375, 1.0)
    size = 2.0 * float(boxes.half_sizes[0, 0])
    moving = boxes._replace(velocities=0.02 * size * boxes.velocities)
    phase = COUNT_METHODS[setting.method](size)
    return Steps(phase, moving, lambda steps: Outcome(tests_per_box(steps).error * count, steps.pairs))


count_study = Study(
    name="broad-phase-race",
    title="Broad phases: work against the number of boxes",
    error="box tests (sweep and prune: swaps) of a step",
    error_unit="",
    counter="pairs",
    knob=Knob("count", "boxes"),
    methods=(
        Method("naive", "naive", 2.0),
        Method("uniform", "uniform grid", 1.0),
        Method("hierarchical", "hierarchical grids", 1.0),
        Method("sweep", "sweep and prune", 1.5),
    ),
    settings=lambda: [
        Setting(method, count, {}, {"count": int(count)}, count)
        for method in COUNT_METHODS
        for count in (10.0, 30.0, 100.0, 300.0, 1000.0, 3000.0, 10_000.0, 30_000.0)
        if method != "naive" or count <= MOST_NAIVE
    ],
    trial=_count_trial,
    present=lambda parameters: Setting("hierarchical", float(parameters["count"])),
    axes=Axes("knob", "cpu"),
    short="Number",
    cost=PER_STEP,
    reference="All methods find the same pairs. Boxes move 2 % of their size in a step, 1.5 overlaps each.",
    expectation="Time grows with the square of the number for testing all pairs, in proportion to it for "
    "grids. The swaps of sweep and prune grow with the power 1.5 at a fixed speed in box sizes; its time "
    "follows as far as swaps, and not the sorting and listing, are what it is spent on.",
)
