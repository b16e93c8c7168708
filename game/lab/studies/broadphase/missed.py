"""The study of pairs missed between steps: what tests once a step overlook, and what swept ones cost."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.lab.studies.broadphase.steps import EXTENT, SEED, boxes_of
from game.lab.study import Knob, Method, Outcome, Setting, Study
from game.physics.broadphase import BroadPhase
from game.physics.broadphase.workloads import MovingBoxes, make_boxes

MISS_BOXES, MISS_S, MISS_SPEED = 400, 0.5, 4.0  # boxes, s, m/s
MISS_PARAMETERS = {"workload": "equal", "count": MISS_BOXES, "fill": 0.05, "speed": MISS_SPEED}
MISS_RATES = (960, 480, 240, 120, 60, 30, 16, 8, 4)  # steps/s


def meeting_times(
    low_a: Floats, high_a: Floats, low_b: Floats, high_b: Floats, speed: Floats
) -> tuple[Floats, Floats]:
    """First and last time at which intervals overlap; b moves at ``speed`` against a. Never: inf, -inf.

    All (n,), m and m/s. Closed intervals: what touches overlaps.
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        one, other = (low_a - high_b) / speed, (high_a - low_b) / speed
    first, last = np.minimum(one, other), np.maximum(one, other)
    still = speed == 0.0
    meet = (low_a <= high_b) & (low_b <= high_a)
    return (
        np.where(still, np.where(meet, -np.inf, np.inf), first),
        np.where(still, np.where(meet, np.inf, -np.inf), last),
    )


def pairs_that_meet(
    boxes: MovingBoxes, a: NDArray[np.int64], b: NDArray[np.int64], seconds: float
) -> NDArray[np.bool_]:
    """Which pairs (a[k], b[k]) of boxes in straight motion overlap at some time from 0 to ``seconds``."""
    begin, end = np.zeros(len(a)), np.full(len(a), seconds)
    for axis in range(2):
        low, high, velocity = boxes.lowers[:, axis], boxes.uppers[:, axis], boxes.velocities[:, axis]
        first, last = meeting_times(low[a], high[a], low[b], high[b], velocity[b] - velocity[a])
        begin, end = np.maximum(begin, first), np.minimum(end, last)
    return begin <= end


@lru_cache(maxsize=1)
def _miss_workload() -> tuple[MovingBoxes, NDArray[np.int64]]:
    """The boxes, and keys n a + b of all pairs that truly meet."""
    boxes = make_boxes("equal", MISS_BOXES, np.random.default_rng(SEED), EXTENT, 0.05, MISS_SPEED)
    a, b = np.triu_indices(MISS_BOXES, 1)
    meet = pairs_that_meet(boxes, a, b, MISS_S)
    return boxes, a[meet] * MISS_BOXES + b[meet]


class PairsOverTime:
    """Boxes in straight motion, tested step by step; error: wrong pairs, missed or false, over true ones."""

    simulated_s = MISS_S

    def __init__(self, make: Callable[[float], BroadPhase], method: str, dt: float):
        self.boxes, self.true = _miss_workload()
        self.make, self.method, self.dt = make, method, dt
        self.steps = round(MISS_S / dt)
        self.reset()

    def reset(self) -> None:
        size = float(self.boxes.uppers[0, 0] - self.boxes.lowers[0, 0])
        self.phase = self.make(size)
        self.ids = self.phase.add_boxes(self.boxes.lowers, self.boxes.uppers)
        self.found = [self.phase.pairs()]
        self.tests = 0

    def run(self) -> None:
        low, high, velocity = self.boxes.lowers, self.boxes.uppers, self.boxes.velocities
        for step in range(self.steps):
            before, after = step * self.dt * velocity, (step + 1) * self.dt * velocity
            if self.method == "end":
                self.phase.update_boxes(self.ids, low + after, high + after)
            else:
                self.phase.update_boxes(
                    self.ids, low + np.minimum(before, after), high + np.maximum(before, after)
                )
            pairs = self.phase.pairs()
            if self.method == "exact":
                there = MovingBoxes(self.boxes.centers + before, self.boxes.half_sizes, velocity)
                pairs = pairs[pairs_that_meet(there, pairs[:, 0], pairs[:, 1], self.dt)]
            self.found.append(pairs)
            self.tests += len(pairs)

    def outcome(self) -> Outcome:
        pairs = np.concatenate(self.found)
        found = np.unique(pairs[:, 0] * MISS_BOXES + pairs[:, 1])
        missed = len(np.setdiff1d(self.true, found))
        false = len(np.setdiff1d(found, self.true))
        share = missed / len(self.true)
        return Outcome(
            (missed + false) / len(self.true), self.tests, "misses every other pair" if share >= 0.5 else ""
        )


def missed_pairs_study(
    name: str,
    title: str,
    make: Callable[[float], BroadPhase],
    related: tuple[Study, ...] = (),
    **structure: Any,
) -> Study:
    """The study of pairs missed between steps with a broad phase; ``make`` takes the size of the boxes, m.

    ``structure``: what the scene's parameters are if it pairs boxes up in the same way.
    """
    alike = {**MISS_PARAMETERS, **structure}

    def settings() -> Sequence[Setting]:
        return [
            Setting(
                method,
                1.0 / rate,
                {},
                {**alike, "step_length": 1.0 / rate, "swept": method != "end"},
                float(rate),
            )
            for method in ("end", "swept", "exact")
            for rate in MISS_RATES
        ]

    def present(parameters: Mapping[str, Any]) -> Setting:
        step = float(parameters["step_length"])
        steps = max(round(MISS_S / step), 1)
        return Setting("swept" if parameters["swept"] else "end", MISS_S / steps, {}, dict(parameters))

    return Study(
        name=f"{name}-missed-pairs",
        title=f"{title}: pairs missed between steps",
        error="wrong pairs, missed or false, over true ones",
        error_unit="",
        counter="pairs listed",
        knob=Knob("step_length", "step", "s"),
        methods=(
            Method("end", "end of the step", 1.0),
            Method("swept", "swept boxes", 1.0),
            Method("exact", "swept, exact times"),
        ),
        settings=settings,
        trial=lambda setting: PairsOverTime(make, setting.method, setting.knob),
        reference="straight motion: intervals of time in which a pair overlaps on each axis, in closed form.",
        expectation="Tested at the end of a step, boxes that only cut a corner are missed, in proportion to "
        "the step. Swept boxes miss none and name some that do not touch. Testing times of overlap of the "
        "few swept pairs is exact at any step: that is what a swept test costs.",
        present=present,
        workload=boxes_of("400 equal boxes at 4 m/s, density 0.05", **alike),
        short="Missed pairs",
        related=related,
    )
