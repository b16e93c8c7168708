"""What the studies of broad phases share: the world, boxes that move in it, and steps of a broad phase."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from game.lab.study import Outcome, Workload
from game.physics.broadphase import BroadPhase, SweepAndPrune
from game.physics.broadphase.workloads import MovingBoxes, make_boxes

SEED = 20
EXTENT = (11.2, 8.0)  # m, the world of the scenes
PER_STEP = "CPU time for one step"


def geometric(first: float, last: float, count: int) -> list[float]:
    """Values from first to last, evenly spread in the logarithm, to six digits."""
    return [float(f"{value:.6g}") for value in np.geomspace(first, last, count)]


def boxes_of(words: str, **values: Any) -> Workload:
    """The workload of a scene whose random boxes have these parameters."""

    def own(parameters: Mapping[str, Any]) -> str:
        if parameters["listed"]:
            return "the boxes of its level"
        if not parameters["box-motion"]:
            return "boxes that stand still"
        found = [
            _IN_WORDS[name](parameters[name])
            for name, value in values.items()
            if parameters[name] != value
            and (isinstance(value, str) or not math.isclose(parameters[name], value, rel_tol=0.01))
        ]
        return ", ".join(found)

    return Workload(words, own)


_IN_WORDS: dict[str, Callable[[Any], str]] = {
    "workload": lambda name: f"another kind of boxes ({name})",
    "count": lambda count: f"{count:g} boxes",
    "fill": lambda fill: f"a density of {fill:.3g}",
    "speed": lambda speed: f"a speed of {speed:.3g} m/s",
    "share": lambda share: f"{100.0 * share:.2g} % large ones",
    "cell": lambda cell: f"cells of {cell:.3g} sizes",
    "storage": lambda name: "boxes in all cells they cover" if name == "covered" else "boxes in one cell",
}


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
        for step in (-2, -1, 0):  # boxes are in motion when they are timed
            shift = step * self.dt * self.boxes.velocities
            self.phase.update_boxes(self.ids, self.boxes.lowers + shift, self.boxes.uppers + shift)
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


def box_size(count: int, fill: float) -> float:
    """Side (m) of so many equal boxes of the studies' world."""
    return 2.0 * float(make_boxes("equal", count, np.random.default_rng(SEED), EXTENT, fill).half_sizes[0, 0])
