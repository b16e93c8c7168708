"""What the pages of broad phases measure alike: timed steps of moving boxes, and answers beside the naive."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from time import process_time

import numpy as np

from game.physics.broadphase import (
    BroadPhase,
    BspTree,
    HierarchicalGrid,
    KineticSweep,
    NaiveBroadPhase,
    SweepAndPrune,
    UniformGrid,
)
from game.physics.broadphase.workloads import WORKLOADS, MovingBoxes, make_boxes

EXTENT = (11.2, 8.0)  # m
FILL = 0.375
OLDER: dict[str, Callable[[float], BroadPhase]] = {
    "grid": lambda size: UniformGrid((0.0, 0.0), EXTENT, 1.25 * size),
    "hierarchy": lambda size: HierarchicalGrid(),
    "sweep": lambda size: SweepAndPrune(),
}
METHODS = {**OLDER, "tree": lambda size: BspTree(), "kinetic": lambda size: KineticSweep()}


def some_boxes(kind: str, count: int, way: float) -> tuple[MovingBoxes, float]:
    """Boxes that go ``way`` sizes in a step, and the size of most of them, m."""
    boxes = make_boxes(kind, count, np.random.default_rng(3), EXTENT, FILL, 1.0)
    size = 2.0 * float(np.median(boxes.half_sizes))
    return boxes._replace(velocities=way * size * boxes.velocities), size


def steps_of(phase: BroadPhase, boxes: MovingBoxes, leap: bool, steps: int) -> Iterator[float]:
    """CPU time of each step, s; boxes go straight on, or leap."""
    rng = np.random.default_rng(4)
    ids = phase.add_boxes(boxes.lowers, boxes.uppers)
    phase.pairs()
    for step in range(1, steps + 1):
        shift = step * boxes.velocities
        if leap:
            shift = rng.random(boxes.centers.shape) * EXTENT - boxes.centers
        low, high = boxes.lowers + shift, boxes.uppers + shift
        start = process_time()
        phase.update_boxes(ids, low, high)
        phase.pairs()
        yield process_time() - start


def milliseconds(method: str, kind: str, count: int, way: float) -> float:
    """Mean CPU time of a step once boxes have been in motion for long, ms.

    ``way``: sizes in a step; 0: they leap.
    """
    boxes, size = some_boxes(kind, count, way)
    before, steps = (3, 6) if way == 0.0 else (40, 20)
    times = list(steps_of(METHODS[method](size), boxes, way == 0.0, before + steps))
    return 1e3 * float(np.mean(times[before:]))


def beside_others(method: str, kind: str, count: int, way: float) -> str:
    """Its time beside those of the older broad phases, in words; the naive up to 2000 boxes."""
    names = [method, *OLDER]
    times = [f"{name} {milliseconds(name, kind, count, way):.2g}" for name in names]
    if count <= 2000:
        boxes, _ = some_boxes(kind, count, way)
        naive = 1e3 * float(np.median(list(steps_of(NaiveBroadPhase(), boxes, way == 0.0, 4))))
        times.append(f"naive {naive:.2g}")
    return ", ".join(times) + " ms"


def differing_answers(make: Callable[[], BroadPhase]) -> tuple[int, int]:
    """Answers unlike the naive method's on all workloads, slow, fast and leaping; and all answers."""
    differ = answers = 0
    for kind in WORKLOADS:
        for way in (0.05, 1.0, 0.0):
            boxes, _ = some_boxes(kind, 150, way)
            phase, naive = make(), NaiveBroadPhase()
            for _ in zip(
                steps_of(phase, boxes, way == 0.0, 10), steps_of(naive, boxes, way == 0.0, 10), strict=True
            ):
                differ += not np.array_equal(phase.pairs(), naive.pairs())
                answers += 1
    return differ, answers
