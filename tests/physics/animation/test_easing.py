"""Timing curves and how a motion is played: easing and constant speed."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from game.physics.animation import CONSTANT_SPEED, EASING, EASINGS, Easing, Keyframes, Playback
from game.physics.animation.easing import STEEPEST, bezier_at, solve_timing

PARTS = np.linspace(0, 1, 201)


def test_known_values():
    at = [0.1, 0.25, 0.5, 0.75]
    ease = [0.0947963057160432, 0.408510591355396, 0.802403387584857, 0.960458978348974]
    in_out = [0.0197224535483112, 0.12916193104732, 0.5, 0.87083806895268]
    assert np.abs(Easing("ease")(at) - ease).max() < 1e-14
    assert np.abs(Easing("ease-in-out")(at) - in_out).max() < 1e-14


@settings(max_examples=80, deadline=None)
@given(st.floats(0, 1), st.floats(0, 1), st.floats(0, 1))
def test_time_is_met(x1, x2, x):
    """|x(s) - x| <= 1e-12 also where the slope vanishes."""
    s = solve_timing(x1, x2, x)
    assert 0.0 <= s <= 1.0
    assert abs(bezier_at(x1, x2, s) - x) <= 1e-12


def test_steep_and_flat_curves():
    for handles in ((0, 0, 1, 1), (0, 1, 0, 1), (1, 0, 1, 0), (1, 0, 0, 1), (0, 5, 1, -4), (1, 1, 0, 0)):
        easing = Easing(handles)
        y = easing(PARTS)
        assert (y[0], y[-1]) == (0.0, 1.0)
        assert np.isfinite(y).all()
        slope = easing.slope(PARTS)
        assert np.abs(slope).max() <= STEEPEST
    assert Easing((1, 0, 0, 1)).slope(0.5) == STEEPEST
    assert np.abs(Easing((0, 0, 1, 1))(PARTS) - PARTS).max() < 1e-14


def test_slopes_are_derivatives():
    for name in EASINGS:
        easing, step = Easing(name), 1e-6
        at = PARTS[5:-5]
        differences = (easing(at + step) - easing(at - step)) / (2 * step)
        assert np.abs(easing.slope(at) - differences).max() < 1e-6


@pytest.mark.parametrize("wrong", ["quick", (0, 0, 1), (1.1, 0, 1, 1), (0, 0, -0.1, 1), (0, math.nan, 1, 1)])
def test_what_turns_back_is_refused(wrong):
    with pytest.raises(ValueError, match="easing"):
        Easing(wrong)


def three_keys(name="spline"):
    return Keyframes([0.0, 0.2, 1.0], [(0, 0, 0), (3, 1, 1), (4, -1, 2)], name)


def test_nothing_switched_on_is_plain_sampling():
    track = three_keys()
    play = Playback(track, easing=Easing("swing"))
    assert np.array_equal(play.sample(PARTS), track.sample(PARTS))
    wide = Playback(track, begin=-1.0, end=1.0)
    assert np.array_equal(wide.sample(PARTS), track.sample(2.0 * PARTS - 1.0))


@pytest.mark.parametrize("name", ["linear", "spline", "centripetal", "flat"])
def test_equal_ways_in_equal_times(name):
    play = Playback(three_keys(name), effects=CONSTANT_SPEED | EASING)
    places = play.sample(np.linspace(0, 1, 2001))[:, :2]
    ways = np.linalg.norm(np.diff(places, axis=0), axis=1)
    assert play.path is not None
    assert play.path.length - ways.max() <= ways.sum() <= play.path.length  # a chord may cut a corner
    assert np.abs(play.speed(PARTS) - play.path.length).max() < 1e-12
    assert np.ptp(np.sort(ways)[1:]) < 2e-3 * ways.mean()
    assert np.array_equal(play.sample([0.0, 1.0]), play.track.values[[0, -1]])


def test_eased_speed_is_the_speed_of_the_samples():
    for effects in (EASING | EASING, EASING | CONSTANT_SPEED):
        play = Playback(three_keys(), easing=Easing("ease"), effects=effects)
        at, step = PARTS[3:-3], 1e-6
        way = (play.sample(at + step) - play.sample(at - step))[:, :2] / (2 * step)
        assert np.abs(np.linalg.norm(way, axis=1) - play.speed(at)).max() < 1e-4


def test_heading_is_the_way_of_the_samples():
    play = Playback(three_keys(), effects=CONSTANT_SPEED | EASING)
    at, step = PARTS[3:-3], 1e-6
    way = (play.sample(at + step) - play.sample(at - step))[:, :2]
    assert np.abs(np.sin(play.heading(at) - np.arctan2(way[:, 1], way[:, 0]))).max() < 1e-5
    assert Playback(Keyframes([0.5], [(1, 2, 3)])).heading(PARTS).tolist() == [0.0] * 201


def test_nothing_moves():
    still = Playback(Keyframes([0.0, 1.0], [(1, 1), (1, 1)]), effects=CONSTANT_SPEED | EASING)
    assert still.sample(PARTS).tolist() == [[1.0, 1.0]] * 201
    assert still.speed(PARTS).tolist() == [0.0] * 201
    single = Playback(Keyframes([0.5], [(1.0, 2.0)]), effects=CONSTANT_SPEED | EASING)
    assert single.sample(0.3).tolist() == [1.0, 2.0]
    assert single.speed(0.3) == 0.0
    steps = Playback(three_keys("nearest"), effects=CONSTANT_SPEED | EASING)
    assert np.array_equal(steps.sample(PARTS), steps.track.sample(PARTS))
