"""Blending for the picture: exact at its ends, by the short way, not across births and jumps."""

from __future__ import annotations

import math

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

from game.stage import blend, blend_angles, blend_quaternions, jumped

EPS = 2.0**-52
alphas = st.floats(0.0, 1.0, exclude_max=True)
points = hnp.arrays(np.float64, (4, 2), elements=st.floats(-1e3, 1e3))
angles = hnp.arrays(np.float64, 5, elements=st.floats(-50.0, 50.0))


def rotation(angle: float, axis: np.ndarray) -> np.ndarray:
    return np.array([[math.cos(angle / 2), *(math.sin(angle / 2) * axis)]])


@given(points, points, alphas)
def test_a_blend_lies_between(before: np.ndarray, now: np.ndarray, alpha: float) -> None:
    middle = blend(before, now, alpha)
    slack = 8 * EPS * 1e3
    assert (middle >= np.minimum(before, now) - slack).all()
    assert (middle <= np.maximum(before, now) + slack).all()
    assert np.array_equal(blend(before, now, 0.0), before)


@given(points, points, alphas, st.floats(0.0, 2e3))
def test_jumps_show_the_newer(before: np.ndarray, now: np.ndarray, alpha: float, limit: float) -> None:
    jumps = jumped(before, now, limit)
    middle = blend(before, now, alpha, jumps)
    assert np.array_equal(middle[jumps], now[jumps])
    assert np.array_equal(middle[~jumps], blend(before, now, alpha)[~jumps])
    for jump, a, b in zip(jumps, before, now, strict=True):
        if abs(math.dist(a, b) - limit) > 16 * EPS * 4e3:
            assert jump == (math.dist(a, b) > limit)


@given(angles, angles, alphas)
def test_angles_turn_by_no_more_than_half(before: np.ndarray, now: np.ndarray, alpha: float) -> None:
    middle = blend_angles(before, now, alpha)
    assert (np.abs(middle - before) <= alpha * math.pi + 1e-12).all()
    whole = blend_angles(before, now, 1.0)
    turns = (whole - now) / (2.0 * math.pi)
    assert np.allclose(turns, np.round(turns), atol=1e-12)


@given(
    st.floats(-3.0, 3.0),
    st.floats(-3.1, 3.1),
    alphas,
    st.sampled_from([1.0, -1.0]),
    st.tuples(st.floats(-1, 1), st.floats(-1, 1), st.floats(0.1, 1)),
)
def test_quaternions_turn_evenly_by_the_short_way(start, turn, alpha, sign, direction) -> None:
    axis = np.array(direction) / math.sqrt(sum(x * x for x in direction))
    before, now = rotation(start, axis), sign * rotation(start + turn, axis)
    middle = blend_quaternions(before, now, alpha)[0]
    expected = rotation(start + alpha * turn, axis)[0]
    assert abs(abs(float(middle @ expected)) - 1.0) < 1e-12
    assert abs(float(middle @ middle) - 1.0) < 1e-12


def test_quaternions_that_cancel_show_the_newer() -> None:
    zero = np.zeros((1, 4))
    now = np.array([[1.0, 0.0, 0.0, 0.0]])
    assert np.isfinite(blend_quaternions(zero, now, 0.5)).all()
    assert np.array_equal(blend_quaternions(zero, now, 0.0), now)


def test_births_and_deaths_show_the_newer() -> None:
    now = np.ones((3, 2))
    for function in (blend, blend_angles, blend_quaternions):
        shown = function(np.zeros((2, 2)), now, 0.5)
        assert np.array_equal(shown, now)
        assert shown is not now


def test_jumps_of_angles_and_quaternions() -> None:
    jumps = np.array([True, False])
    assert blend_angles(np.zeros(2), np.ones(2), 0.5, jumps).tolist() == [1.0, 0.5]
    before = np.repeat(rotation(0.0, np.array([0.0, 0.0, 1.0])), 2, axis=0)
    now = np.repeat(rotation(1.0, np.array([0.0, 0.0, 1.0])), 2, axis=0)
    middle = blend_quaternions(before, now, 0.5, jumps)
    assert np.array_equal(middle[0], now[0])
    assert not np.array_equal(middle[1], now[1])
