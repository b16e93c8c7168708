"""What the pages of broad phases measure alike: timed steps of moving boxes, and answers beside the naive."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from time import thread_time

import numpy as np

from game.arrays import Floats
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
from game.physics.kernels import elementwise

EXTENT = (11.2, 8.0)  # m
FILL = 0.375
LEVEL = 1.1  # times that differ by less are level
HEAPS, SPREAD = 8, 0.06  # heaps that travel, and the deviation of their boxes, in heights of the world
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
        start = thread_time()
        phase.update_boxes(ids, low, high)
        phase.pairs()
        yield thread_time() - start


def travelling(count: int, way: float) -> Callable[[int], tuple[Floats, Floats]]:
    """Boxes in heaps that each travel as one, ``way`` sizes a step, and turn back at the rim of the world.

    What it returns gives the lower and upper corners (count, 2) m at a step.
    """
    rng = np.random.default_rng(3)
    size = some_boxes("equal", count, 0.0)[1]
    world = np.array(EXTENT)
    home, angles = rng.random((HEAPS, 2)) * world, 2.0 * np.pi * rng.random(HEAPS)
    ways = way * size * np.stack([elementwise.cos(angles), elementwise.sin(angles)], axis=1)
    heap = rng.integers(0, HEAPS, count)
    places = SPREAD * EXTENT[1] * rng.standard_normal((count, 2))

    def at(step: int) -> tuple[Floats, Floats]:
        middles = world - np.abs(np.mod(home + step * ways, 2.0 * world) - world)
        low = middles[heap] + places - 0.5 * size
        return low, low + size

    return at


def mean_milliseconds(times: Iterator[float], before: int) -> float:
    """Mean of times in s, but for so many at the beginning, ms."""
    return 1e3 * float(np.mean(list(times)[before:]))


def milliseconds(method: str, kind: str, count: int, way: float) -> float:
    """Mean CPU time of a step once boxes have been in motion for some time, ms.

    ``way``: sizes in a step; 0: they leap.
    """
    boxes, size = some_boxes(kind, count, way)
    before, steps = (3, 6) if way == 0.0 else (40, 20)
    if count > 10_000:
        before, steps = (1, 2) if way == 0.0 else (12, 8)
    return mean_milliseconds(steps_of(METHODS[method](size), boxes, way == 0.0, before + steps), before)


def beside_others(method: str, kind: str, count: int, way: float) -> dict[str, float]:
    """Its time of a step (ms) beside those of the older broad phases; the naive up to 2000 boxes."""
    times = {name: milliseconds(name, kind, count, way) for name in (method, *OLDER)}
    if count <= 2000:
        boxes, _ = some_boxes(kind, count, way)
        times["naive"] = 1e3 * float(np.median(list(steps_of(NaiveBroadPhase(), boxes, way == 0.0, 4))))
    return times


def in_words(times: Mapping[str, float], whose: str) -> str:
    """Times in ms from the least on, and where one of them stands: ``whose``, the name of one."""
    order = sorted(times, key=lambda name: times[name])
    place, others = order.index(whose), [name for name in order if name != whose]
    listed = ", ".join(f"{name} {_short(times[name])}" for name in order)
    rival = others[0]
    factor = max(times[whose], times[rival]) / min(times[whose], times[rival])
    if factor < LEVEL:
        return f"{listed} ms: {whose} is level with {rival}"
    verdict, of = ("the fastest", "speed") if place == 0 else (f"number {place + 1} of {len(order)}", "time")
    return f"{listed} ms: {whose} is {verdict}, {factor:.2g} × the {of} of {rival}"


def _short(number: float) -> str:
    """Two digits, and no power of ten."""
    return f"{number:.0f}" if number >= 10.0 else f"{number:.2g}"


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
