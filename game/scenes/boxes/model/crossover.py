"""What the broad phases cost against the number of boxes, and where one overtakes another.

Times are for the picture alone: nothing that is computed depends on them, and no state holds them.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from time import perf_counter

import numpy as np

from game.physics.broadphase import BroadPhase
from game.physics.broadphase.workloads import MovingBoxes
from game.physics.kernels import elementary

COUNTS = (8, 16, 32, 64, 128, 256, 512, 1024, 2048)  # boxes, at which the crossover is looked for
STEPS, FIRST = 7, 3  # steps that are timed, and those before them
Curve = Mapping[int, float]  # number of boxes to s a step


class CostCurves:
    """Times of a step by method and number: measured on the way, or by the search for a crossover.

    seen: what the scene has run with. swept: what `find` has measured. Both: method to `Curve`.
    """

    def __init__(self) -> None:
        self.seen: dict[str, dict[int, float]] = {}
        self.swept: dict[str, dict[int, float]] = {}

    def clear(self) -> None:
        """Forget all: boxes are made in another way."""
        self.seen, self.swept = {}, {}

    def note(self, method: str, count: int, seconds: float) -> None:
        """The scene runs with so many boxes, at so much a step."""
        if math.isfinite(seconds) and seconds > 0.0:
            self.seen.setdefault(method, {})[count] = seconds

    def note_swept(self, method: str, count: int, seconds: float) -> None:
        """A measurement of the search for the crossover."""
        self.swept.setdefault(method, {})[count] = seconds


def crossing(slow: Curve, fast: Curve) -> float:
    """The number of boxes from which on ``fast`` costs less than ``slow``, for all larger numbers of both.

    Between two numbers it is found by straight lines in the logarithms. NaN if ``fast`` never stays below;
    the least number if it always is.
    """
    counts = sorted(set(slow) & set(fast))
    lead = [elementary.log(slow[n] / fast[n]) for n in counts]
    behind = [i for i, value in enumerate(lead) if value <= 0.0]
    if not counts or (behind and behind[-1] == len(counts) - 1):
        return math.nan
    if not behind:
        return float(counts[0])
    i = behind[-1]
    part = -lead[i] / (lead[i + 1] - lead[i])
    return counts[i] * elementary.pow(counts[i + 1] / counts[i], part)


def cost_of_a_step(phase: BroadPhase, boxes: MovingBoxes, dt: float) -> float:
    """Least time of a step of ``dt`` s, s: update and all pairs. The least is freest of what interrupts."""
    lowers, uppers, move = boxes.lowers, boxes.uppers, boxes.velocities * dt
    ids = phase.add_boxes(lowers, uppers)
    least = math.inf
    for step in range(FIRST + STEPS):
        lowers, uppers = lowers + move, uppers + move
        began = perf_counter()
        phase.update_boxes(ids, lowers, uppers)
        phase.pairs()
        if step >= FIRST:
            least = min(least, perf_counter() - began)
    return least


def overtakings(curves: Mapping[str, Curve], slow: str, others: Sequence[str]) -> dict[str, float]:
    """From which number of boxes on each of the others costs less than ``slow``; NaN where it never does."""
    return {
        name: crossing(curves[slow], curves[name]) for name in others if name in curves and slow in curves
    }


def typical_size(boxes: MovingBoxes) -> float:
    """Median size of boxes, m."""
    return float(np.median(2.0 * boxes.half_sizes[:, 0]))
