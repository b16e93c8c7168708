"""What skinning and inverse kinematics cost, against numpy and against each other.

python -m pytest tests/benchmarks/test_animation_skeleton.py --benchmark-enable
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.animation import BLENDS, IK_METHODS, Skinner, Solver, bind_weights, chain_skeleton

POINTS, BONES = 100_000, 15
SKINNING = "100 000 points, 15 bones"
REACHING = "one solution to 1 µm, 15 bones of 1 m in all"


@pytest.fixture(scope="module")
def posed():
    rng = np.random.default_rng(1)
    skeleton = chain_skeleton(np.full(BONES, 1.0 / BONES), rng.uniform(-0.3, 0.3, BONES))
    binding = bind_weights(skeleton, rng.uniform(-0.2, 1.0, (POINTS, 2)), 0.3)
    skeleton.pose(rng.uniform(-0.5, 0.5, BONES))
    return skeleton, binding


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
    points = np.column_stack([binding.points, np.ones(POINTS)])

    def work():
        palette = np.einsum("nij,njk->nik", skeleton.world, binding.inverse)[:, :2]
        blended = np.einsum("vk,vkij->vij", binding.weights, palette[binding.bones])
        return np.einsum("vij,vj->vi", blended, points)

    moved = benchmark(work)
    assert np.allclose(moved, Skinner(binding)(skeleton.world), rtol=0, atol=1e-12)


def test_binding(benchmark, posed):
    benchmark.group = "weights of 100 000 points"
    skeleton, binding = posed
    benchmark.pedantic(bind_weights, (skeleton, binding.points, 0.3), rounds=5, warmup_rounds=1)


@pytest.mark.parametrize("method", IK_METHODS)
def test_reaching(benchmark, method):
    """The median of targets within 0.9 of the reach; extra_info says how many iterations."""
    benchmark.group = REACHING
    rng = np.random.default_rng(3)
    skeleton = chain_skeleton(np.full(BONES, 1.0 / BONES))
    solver = Solver(skeleton, 0, BONES - 1)
    start = rng.uniform(-0.3, 0.3, BONES)
    skeleton.pose(start)
    radii, turns = 0.9 * np.sqrt(rng.random(101)), rng.uniform(-math.pi, math.pi, 101)
    targets = np.column_stack([radii * np.cos(turns), radii * np.sin(turns)])
    counts = solver.solve_each(targets, method, 1e-6, 20_000).iterations
    typical = targets[np.argsort(counts, kind="stable")[50]]
    benchmark.extra_info["iterations"] = int(np.median(counts))

    def begin():
        skeleton.pose(start)
        return (typical, method, 1e-6, 20_000), {}

    found = benchmark.pedantic(solver.solve, setup=begin, rounds=300, warmup_rounds=3)
    assert found.error <= 1e-6


def test_a_hundred_targets_at_once(benchmark):
    benchmark.group = "100 targets, 15 bones, FABRIK"
    rng = np.random.default_rng(3)
    skeleton = chain_skeleton(np.full(BONES, 1.0 / BONES), rng.uniform(-0.3, 0.3, BONES))
    solver = Solver(skeleton, 0, BONES - 1)
    radii, turns = 0.8 * np.sqrt(rng.random(100)), rng.uniform(-math.pi, math.pi, 100)
    targets = np.column_stack([radii * np.cos(turns), radii * np.sin(turns)])
    found = benchmark(solver.solve_each, targets, "fabrik")
    assert np.median(found.errors) <= 1e-6
