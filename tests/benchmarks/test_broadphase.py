"""Broad phases beside what a Python programmer can install; run with ``--benchmark-enable``.

A step is update and all pairs, sorted. Nothing here fails by time: the ratios are printed and read.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.lab.benchmarks import measure_scenario
from game.lab.benchmarks.broadphase import OVERLAPS, PHASES, SCENARIOS, Workload, stepper
from game.physics.broadphase import HashedPairs, MatrixPairs, SweepAndPrune


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


@pytest.mark.parametrize("count", [1_000, 10_000, 100_000])
def test_ratios_to_peers(benchmark, count):
    """One line a size: median times of a step, and how many times longer the peers take, in one run."""
    if not benchmark.enabled:
        pytest.skip("measured only")
    chosen = [scenario for scenario in SCENARIOS if scenario.name.endswith(f"-{count}")]
    for scenario in chosen:
        measured = measure_scenario(scenario, 15 if count < 100_000 else 5)
        ratios = {name: measured.ratio(name) for name in measured.peers}
        print(
            f"\n{scenario.title}: {1e3 * measured.median_s:.3g} ms", {n: round(r) for n, r in ratios.items()}
        )
        benchmark.extra_info.update({f"{scenario.name} {name}": ratio for name, ratio in ratios.items()})
    benchmark.pedantic(chosen[0].prepare(), rounds=5)
