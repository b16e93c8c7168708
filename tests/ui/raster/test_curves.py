"""Thinned curves: every point left out is within the tolerance of the line that stays."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.ui.raster.curves import thinned

HEIGHTS = st.lists(st.floats(-100, 100), min_size=1, max_size=60)


@given(HEIGHTS, st.sampled_from([0.05, 0.15, 1.0]))
def test_what_is_left_out_lies_within_the_tolerance(heights, tolerance):
    points = np.column_stack((np.arange(len(heights)) * 0.36, heights))
    kept = thinned(points, tolerance)
    assert kept[0] == pytest.approx(points[0]) and kept[-1] == pytest.approx(points[-1])
    line = np.interp(points[:, 0], kept[:, 0], kept[:, 1])
    assert np.abs(line - points[:, 1]).max() <= 2.0 * tolerance + 1e-9


def test_straight_curves_need_two_points_and_spikes_stay():
    x = np.linspace(0, 100, 500)
    assert len(thinned(np.column_stack((x, 3 * x + 1)))) == 2
    spike = np.column_stack((x, np.where(np.arange(500) == 250, 40.0, 0.0)))
    kept = thinned(spike)
    assert len(kept) <= 6 and kept[:, 1].max() == 40.0


def test_breaks_are_kept():
    x = np.arange(9.0)
    y = np.array([0, 0, 0, math.nan, 1, 1, 1, math.inf, 2.0])
    kept = thinned(np.column_stack((x, y)))
    assert kept[:, 0].tolist() == [0, 2, 3, 4, 6, 7, 8]


def test_steps_straight_up_and_repeated_times():
    points = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 5.0], [1.0, 9.0], [2.0, 9.0]])
    assert thinned(points)[:, 1].max() == 9.0
    assert len(thinned(np.empty((0, 2)))) == 0
