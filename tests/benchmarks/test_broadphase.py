"""Broad phases beside what a Python programmer can install; run with ``--benchmark-enable``.

A step is update and all pairs, sorted. Nothing here fails by time: the ratios are printed and read.
"""

from __future__ import annotations

import math
from time import perf_counter

import numpy as np
import pytest

from game.physics.broadphase import HashedPairs, HierarchicalGrid, MatrixPairs, SweepAndPrune, UniformGrid
from game.physics.broadphase.workloads import make_boxes

FRAMES = 8
OVERLAPS = 1.5  # of a box, mean


class Workload:
    """Frames of moving boxes: 2 % of the smallest box in a step."""

    def __init__(self, kind: str, count: int):
        boxes = make_boxes(kind, count, np.random.default_rng(1), fill=OVERLAPS / 4.0, speed=1.0)
        self.size = 2.0 * float(boxes.half_sizes.min())
        step = 0.02 * self.size * boxes.velocities
        self.frames = [(boxes.lowers + i * step, boxes.uppers + i * step) for i in range(FRAMES)]
        self.ids = np.arange(count)
        self._next = 0

    def frame(self):
        self._next = (self._next + 1) % (2 * FRAMES - 2)  # there and back, so that all motion is slow
        return self.frames[self._next if self._next < FRAMES else 2 * FRAMES - 2 - self._next]


def stepper(phase, workload):
    phase.add_boxes(*workload.frames[0])

    def step():
        phase.update_boxes(workload.ids, *workload.frame())
        return phase.pairs()

    step()
    return step


PHASES = {
    "grid": lambda size: UniformGrid((0.0, 0.0), (1.0, 1.0), 1.1 * size),
    "hierarchical": lambda size: HierarchicalGrid(),
    "sweep": lambda size: SweepAndPrune(),
}


@pytest.mark.parametrize("count", [1_000, 10_000, 100_000])
@pytest.mark.parametrize("kind", ["equal", "heavy-tail"])
@pytest.mark.parametrize("name", PHASES)
def test_a_step(benchmark, name, kind, count):
    if not benchmark.enabled and count > 1_000:
        pytest.skip("measured only")
    workload = Workload(kind, count)
    pairs = benchmark(stepper(PHASES[name](workload.size), workload))
    assert len(pairs) == pytest.approx(OVERLAPS / 2.0 * count, rel=0.2)


def test_a_leap_of_eight_thousand_boxes(benchmark):
    count = 8_000 if benchmark.enabled else 500
    generator = np.random.default_rng(3)
    size = math.sqrt(0.1 / count)
    places = [generator.random((count, 2)) * (1.0 - size) for _ in range(4)]
    sap = SweepAndPrune()
    ids = sap.add_boxes(places[0], places[0] + size)
    turn = iter(range(1, 1 << 30))

    def leap():
        lowers = places[next(turn) % 4]
        sap.update_boxes(ids, lowers, lowers + size)
        return sap.pairs()

    assert len(benchmark(leap)) > 0
    assert sap.resorts > 0


@pytest.mark.parametrize("make", [lambda: MatrixPairs(2_000), HashedPairs], ids=["matrix", "hash"])
def test_a_pair_manager_takes_over_the_pairs_of_a_step(benchmark, make):
    generator = np.random.default_rng(2)
    pairs = np.unique(np.sort(generator.integers(0, 2_000, (3_000, 2)), axis=1), axis=0)
    pairs = pairs[pairs[:, 0] < pairs[:, 1]]
    manager = make()
    turns = iter(range(1 << 30))

    def renew():
        manager.set_pairs(pairs[next(turns) % 2 :: 2] if benchmark.enabled else pairs)
        return manager.take_events()

    benchmark(renew)
    manager.check()


def _kd_tree(workload):
    spatial = pytest.importorskip("scipy.spatial")

    def step():
        lowers, uppers = workload.frame()
        tree = spatial.cKDTree(0.5 * (lowers + uppers))
        return len(tree.query_pairs(workload.size, p=np.inf, output_type="ndarray"))

    return step


def _str_tree(workload):
    shapely = pytest.importorskip("shapely")

    def step():
        lowers, uppers = workload.frame()
        boxes = shapely.box(lowers[:, 0], lowers[:, 1], uppers[:, 0], uppers[:, 1])
        found = shapely.STRtree(boxes).query(boxes)
        return int((found[0] < found[1]).sum())

    return step


def _pymunk(workload):
    pymunk = pytest.importorskip("pymunk")
    space = pymunk.Space()
    bodies = []
    for (x0, y0), (x1, y1) in zip(*(corners.tolist() for corners in workload.frames[0]), strict=True):
        body = pymunk.Body(1.0, 1.0)
        body.position = 0.5 * (x0 + x1), 0.5 * (y0 + y1)
        shape = pymunk.Poly.create_box(body, (x1 - x0, y1 - y0))
        shape.filter = pymunk.ShapeFilter(group=0)
        space.add(body, shape)
        bodies.append(body)
    space.on_collision(begin=lambda arbiter, space, data: False) if hasattr(space, "on_collision") else None
    return lambda: space.step(1e-9)


def _median_s(call, repeats: int) -> float:
    call()
    times = []
    for _ in range(repeats):
        began = perf_counter()
        call()
        times.append(perf_counter() - began)
    return sorted(times)[repeats // 2]


@pytest.mark.parametrize("count", [1_000, 10_000, 100_000])
def test_ratios_to_peers(benchmark, count):
    """One line a size: median times of a step, and how many times longer the peers take, in one run."""
    if not benchmark.enabled:
        pytest.skip("measured only")
    workload = Workload("equal", count)
    repeats = 15 if count < 100_000 else 5
    ours = {name: _median_s(stepper(make(workload.size), workload), repeats) for name, make in PHASES.items()}
    peers = {}
    for name, make in (("scipy", _kd_tree), ("shapely", _str_tree), ("pymunk", _pymunk)):
        if name == "pymunk" and count > 10_000:
            continue
        peers[name] = _median_s(make(workload), repeats if name != "pymunk" else 3)
    best = ours["grid"]
    words = [f"{name} {1e3 * time:.3g} ms" for name, time in ours.items()]
    words += [f"{name} {1e3 * time:.3g} ms ({time / best:.0f} x the grid)" for name, time in peers.items()]
    print(f"\n{count} boxes: " + ", ".join(words))
    benchmark.extra_info.update({name: time / best for name, time in peers.items()})
    benchmark.pedantic(stepper(PHASES["grid"](workload.size), workload), rounds=repeats)
