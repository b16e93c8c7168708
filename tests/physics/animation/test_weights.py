"""Weights from distances: naive twin, thresholds, truncation, and what is refused."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from game.physics.animation.skeleton import Skeleton, chain_skeleton
from game.physics.animation.weights import (
    WeightError,
    bind_given,
    bind_weights,
    distances_to_bones,
    invert_frames,
)

EPS = 2.0**-52
place = st.tuples(st.floats(-3, 3), st.floats(-3, 3))


def figure():
    return Skeleton([-1, 0, 1, 0], [1.0, 0.8, 0.5, 0.9], [0.3, 0.5, -0.7, -1.0])


def naive_distances(skeleton, point):
    """One by one, by projection on the segment."""
    distances = []
    for a, b in zip(skeleton.bases, skeleton.ends, strict=True):
        d = b - a
        t = min(max(float((point - a) @ d) / float(d @ d), 0.0), 1.0)
        distances.append(float(np.linalg.norm(point - a - t * d)))
    return np.array(distances)


@given(place, st.floats(0.05, 5.0), st.floats(0.5, 8.0))
def test_weights_are_those_of_the_naive_twin(point, threshold, falloff):
    skeleton = figure()
    binding = bind_weights(skeleton, [point], threshold, falloff, 4)
    distances = naive_distances(skeleton, np.array(point))
    least = float(distances.min())
    assume(abs(least / threshold - 1.0) > 1e-6)
    weights = binding.dense()[0]
    if least > threshold:
        assert sorted(weights.tolist()) == [0.0, 0.0, 0.0, 1.0]
        assert distances[weights == 1.0][0] <= least + 1e-12
    else:
        parts = least / np.maximum(distances, 1e-300) if least > 0.0 else (distances == 0.0).astype(float)
        raw = np.where(distances < threshold, parts**falloff - (least / threshold) ** falloff, 0.0)
        assert np.allclose(weights, raw / raw.sum(), rtol=0, atol=1e-8)
    assert abs(math.fsum(binding.weights[0]) - 1.0) <= 4 * EPS
    binding.check()


@given(place)
def test_fewer_influences_are_the_largest_made_whole(point):
    skeleton = figure()
    whole = bind_weights(skeleton, [point], 9.0, 2.0, 4).dense()[0]
    for k in (1, 2, 3):
        kept = bind_weights(skeleton, [point], 9.0, 2.0, k).dense()[0]
        assert np.count_nonzero(kept) <= k
        chosen = kept > 0
        assert whole[chosen].min() >= whole[~chosen].max() - EPS
        assert np.allclose(kept[chosen], whole[chosen] / whole[chosen].sum(), rtol=0, atol=8 * EPS)


def test_weights_go_to_nought_at_the_threshold_without_a_jump():
    skeleton = Skeleton([-1, -1], [1.0, 1.0], offsets=[(0.0, 0.0), (0.0, 1.0)])
    heights = 0.45 + np.linspace(-1e-6, 1e-6, 9)
    points = np.column_stack([np.full(9, 0.5), heights])
    weights = bind_weights(skeleton, points, 0.55, 2.0).dense()[:, 1]
    assert weights[-1] < 1e-4
    assert np.abs(np.diff(weights)).max() < 1e-5


def test_a_distance_to_a_bone_without_length_is_one_to_a_point():
    skeleton = Skeleton([-1], [0.0], offsets=[(1.0, 2.0)])
    d = distances_to_bones(np.array([[4.0, 6.0]]), skeleton.bases, skeleton.ends)
    assert d[0, 0] == 5.0


def test_given_weights_are_cut_and_made_whole():
    skeleton = chain_skeleton([1.0] * 4)
    binding = bind_given(skeleton, [(0.0, 0.0)], [[4.0, 1.0, 3.0, 0.5]], influences=2)
    assert binding.bones.tolist() == [[0, 2]]
    assert np.allclose(binding.weights, [[4 / 7, 3 / 7]], rtol=0, atol=2 * EPS)


@pytest.mark.parametrize(
    ("weights", "words"),
    [
        ([[1.0, -0.1]], "0 or more"),
        ([[math.nan, 1.0]], "0 or more"),
        ([[math.inf, 1.0]], "0 or more"),
        ([[0.0, 0.0]], "point 0 has none"),
        ([[1.0]], "shape"),
    ],
)
def test_weights_that_are_none_are_refused(weights, words):
    with pytest.raises(WeightError, match=words):
        bind_given(chain_skeleton([1.0, 1.0]), [(0.0, 0.0)], weights)


@pytest.mark.parametrize(
    ("points", "settings", "words"),
    [
        ([], {}, "points"),
        ([(0.0, math.nan)], {}, "finite"),
        ([(0.0, 1e300)], {}, "finite"),
        ([(0.0, 1.0)], {"threshold": 0.0}, "threshold"),
        ([(0.0, 1.0)], {"threshold": math.nan}, "threshold"),
        ([(0.0, 1.0)], {"falloff": 0.0}, "falloff"),
        ([(0.0, 1.0)], {"falloff": math.nan}, "falloff"),
        ([(0.0, 1.0)], {"influences": 0}, "influences"),
    ],
)
def test_what_cannot_be_bound_is_refused(points, settings, words):
    with pytest.raises(WeightError, match=words):
        bind_weights(chain_skeleton([1.0, 1.0]), points, **settings)


@given(place, st.floats(-9, 9), st.floats(0.1, 5.0), st.floats(0.1, 5.0))
def test_frames_are_inverted(at, angle, wide, high):
    c, s = math.cos(angle), math.sin(angle)
    frame = np.array([[[c * wide, -s * high, at[0]], [s * wide, c * high, at[1]], [0.0, 0.0, 1.0]]])
    assert np.allclose(invert_frames(frame)[0] @ frame[0], np.eye(3), rtol=0, atol=1e-12)


def test_of_equal_weights_the_first_bones_are_kept():
    """In their order; and what follows nobody else names the first bone."""
    skeleton = chain_skeleton([1.0] * 4)
    for given_weights, influences, bones in (
        ([1.0, 1.0, 1.0, 1.0], 2, [0, 1]),
        ([1.0, 2.0, 1.0, 2.0], 3, [1, 3, 0]),
        ([0.0, 0.0, 5.0, 0.0], 3, [2, 0, 0]),
    ):
        binding = bind_given(skeleton, [(0.0, 0.0)], [given_weights], influences=influences)
        assert binding.bones.tolist() == [bones]
