"""What a watch says of motions that are written down: swings of a known period, whole turns, and neither."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.plates.law import SPIN, STATE, THETA, X, Y
from game.physics.plates.watch import FLUTTER, NOTHING, TUMBLE, Watch

DT = 0.01


def watched(angle, rate, seconds=20.0, fall=0.7, count=2):
    """The course of the last of some plates, of which the others stand still."""
    watch, before = Watch(count), np.zeros((STATE, count))
    for step in range(round(seconds / DT) + 1):
        time, now = step * DT, np.zeros((STATE, count))
        now[THETA, -1], now[SPIN, -1], now[Y, -1] = angle(time), rate(time), -fall * time
        now[X, -1] = 0.05 * math.sin(time)
        if step:
            watch.look(before, now, time, DT)
        before = now
    assert watch.course(0, before, seconds).regime == NOTHING
    return watch.course(count - 1, before, seconds)


@pytest.mark.parametrize(("period", "swing"), [(1.3, 0.4), (2.1, 1.1)])
def test_a_swing_has_its_period_amplitude_and_fall(period, swing):
    w = math.tau / period
    course = watched(lambda t: swing * math.sin(w * t + 0.3), lambda t: swing * w * math.cos(w * t + 0.3))
    assert course.regime == FLUTTER
    assert course.period == pytest.approx(period, rel=1e-3)
    assert course.amplitude == pytest.approx(swing, rel=1e-3)
    assert course.descent == pytest.approx(0.7, rel=1e-6)


@pytest.mark.parametrize("rate", [2.5, -4.0])
def test_a_plate_that_turns_on_and_on_tumbles(rate):
    course = watched(lambda t: rate * t + 0.2, lambda t: rate)
    assert course.regime == TUMBLE
    assert course.period == pytest.approx(math.tau / abs(rate), rel=1e-9)
    assert course.spin == pytest.approx(rate, rel=1e-9)
    assert course.descent == pytest.approx(0.7, rel=1e-9)


def test_two_swings_say_nothing_yet():
    assert watched(lambda t: math.sin(t), lambda t: math.cos(t), seconds=7.0).regime == NOTHING
