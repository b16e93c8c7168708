"""What skinning and inverse kinematics cost, against numpy and against each other.

python -m pytest tests/benchmarks/test_animation_skeleton.py --benchmark-enable
"""

from __future__ import annotations

import numpy as np
import pytest

from game.lab.benchmarks.animation import MOST, TOLERANCE, posed_skin, reach
from game.lab.studies.animation.skinning import by_numpy
from game.physics.animation import BLENDS, IK_METHODS, Skinner, bind_weights

SKINNING = "100 000 points, 15 bones"
REACHING = "one solution to 1 µm, 15 bones of 1 m in all"


@pytest.fixture(scope="module")
def posed():
    return posed_skin()


@pytest.mark.parametrize("blend", BLENDS)
def test_skinning(benchmark, posed, blend):
    benchmark.group = SKINNING
    skeleton, binding = posed
    skinner = Skinner(binding)
    moved = benchmark(skinner, skeleton.world, blend)
    assert np.all(np.isfinite(moved))


def test_skinning_with_numpy(benchmark, posed):
    """Matrices by einsum: the same points."""
    benchmark.group = SKINNING
    skeleton, binding = posed
    moved = benchmark(by_numpy(skeleton, binding))
    assert np.allclose(moved, Skinner(binding)(skeleton.world), rtol=0, atol=1e-12)


def test_binding(benchmark, posed):
    benchmark.group = "weights of 100 000 points"
    skeleton, binding = posed
    benchmark.pedantic(bind_weights, (skeleton, binding.points, 0.3), rounds=5, warmup_rounds=1)


@pytest.mark.parametrize("method", IK_METHODS)
def test_reaching(benchmark, method):
    """The median of targets within 0.9 of the reach; extra_info says how many iterations."""
    benchmark.group = REACHING
    solver, start, targets = reach(101)
    counts = solver.solve_each(targets, method, TOLERANCE, MOST).iterations
    typical = targets[np.argsort(counts, kind="stable")[50]]
    benchmark.extra_info["iterations"] = int(np.median(counts))

    def begin():
        solver.skeleton.pose(start)
        return (typical, method, TOLERANCE, MOST), {}

    found = benchmark.pedantic(solver.solve, setup=begin, rounds=300, warmup_rounds=3)
    assert found.error <= 1e-6


def test_a_hundred_targets_at_once(benchmark):
    benchmark.group = "100 targets, 15 bones, FABRIK"
    solver, _, targets = reach(100, 0.8)
    found = benchmark(solver.solve_each, targets, "fabrik")
    assert np.median(found.errors) <= 1e-6
