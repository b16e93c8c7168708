"""What key-frames cost: a million samples against numpy and scipy in one run; lines, lengths, easing.

python -m pytest tests/benchmarks/test_animation_curves.py --benchmark-enable
"""

from __future__ import annotations

import numpy as np
import pytest

from game.lab.benchmarks.animation import KEYS, SAMPLES, by_interp, keys, moments
from game.physics.animation import CubicBezier, Easing, Keyframes


def times_for(benchmark, order="in order"):
    """A million times, for the benchmark only; a few where it only has to run."""
    return moments(SAMPLES if benchmark.enabled else 1_000, order == "at random")


@pytest.mark.parametrize("order", ["in order", "at random"])
@pytest.mark.parametrize("name", ["nearest", "linear", "spline"])
def test_a_million_samples(benchmark, name, order):
    """16 keys of place and angle; the goal is 10 ms."""
    benchmark.group = f"a million samples, 16 keys of 3 numbers, {order}"
    at = times_for(benchmark, order)
    track = Keyframes(*keys(), name)
    out = np.empty((len(at), 3))
    benchmark(track.sample, at, out)
    assert np.array_equal(out[:5], track.sample(at[:5]))


@pytest.mark.parametrize("order", ["in order", "at random"])
def test_a_million_samples_of_many_keys(benchmark, order):
    benchmark.group = f"a million samples, 512 keys of 3 numbers, {order}"
    at = times_for(benchmark, order)
    track = Keyframes(*keys(512), "spline")
    out = np.empty((len(at), 3))
    benchmark(track.sample, at, out)
    assert np.isfinite(out).all()


@pytest.mark.parametrize("order", ["in order", "at random"])
def test_a_million_samples_with_numpy(benchmark, order):
    """Linear, column by column: numpy.interp."""
    benchmark.group = f"a million samples, 16 keys of 3 numbers, {order}"
    at = times_for(benchmark, order)
    found = benchmark(by_interp, at)
    mine = Keyframes(*keys()).sample(at[:100])
    assert np.abs(np.array(found).T[:100] - mine).max() < 1e-12


@pytest.mark.parametrize("order", ["in order", "at random"])
def test_a_million_samples_with_scipy(benchmark, order):
    interpolate = pytest.importorskip("scipy.interpolate")
    benchmark.group = f"a million samples, 16 keys of 3 numbers, {order}"
    at = times_for(benchmark, order)
    times, values = keys()
    found = benchmark(interpolate.CubicSpline(times, values), at)
    assert np.abs(found[:100] - Keyframes(times, values, "spline").sample(at[:100])).max() < 1e-12


def test_keys_made_ready(benchmark):
    """What a drag of one of 16 keys costs before anything is drawn."""
    benchmark.group = "once"
    assert len(benchmark(lambda: Keyframes(*keys(), "spline"))) == KEYS


@pytest.mark.parametrize("how", ["adaptive", "even"])
def test_lines(benchmark, how):
    benchmark.group = "a curve as lines, off by 0.1 mm"
    curve = CubicBezier([(0, 0), (6, 0), (6.3, 0.6), (0.5, 0.8)])
    chain = benchmark(curve.flatten, 1e-4, how)
    benchmark.extra_info["lines"] = len(chain) - 1
    assert len(chain) > 10


def test_a_thousand_equal_ways(benchmark):
    benchmark.group = "once"
    curve = CubicBezier([(0, 0), (0.3, 2), (5, 2), (5.2, -1)])
    ways = np.linspace(0.0, curve.length, 1000)
    there = benchmark(curve.parameter_at, ways)
    assert np.abs(curve.length_to(there) - ways).max() < 1e-12


def test_a_million_times_eased(benchmark):
    benchmark.group = "once"
    at = times_for(benchmark)
    eased = benchmark(Easing("ease"), at)
    assert np.all(np.diff(eased) >= 0.0)
