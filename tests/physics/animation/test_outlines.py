"""Outlines: areas, rounding, points within."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.physics.animation.outlines import area, points_inside, rounded
from game.physics.animation.weights import WeightError

SQUARE = np.array([(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)])


@given(st.integers(3, 60), st.floats(0.1, 10.0), st.floats(-100, 100))
def test_area_of_a_regular_polygon(n, radius, x):
    turns = np.arange(n) * 2 * math.pi / n
    polygon = np.column_stack([x + radius * np.cos(turns), radius * np.sin(turns)])
    exact = 0.5 * n * radius**2 * math.sin(2 * math.pi / n)
    assert area(polygon) == pytest.approx(exact, rel=1e-12, abs=1e-11)
    assert area(polygon[::-1]) == pytest.approx(-exact, rel=1e-12, abs=1e-11)


def test_rounding_keeps_the_points_and_makes_a_circle_rounder():
    off = {}
    for n in (8, 16):
        turns = np.arange(n) * 2 * math.pi / n
        corners = np.column_stack([np.cos(turns), np.sin(turns)])
        curve = rounded(corners, 0.005)
        assert all(np.abs(curve - point).sum(axis=1).min() < 1e-15 for point in corners)
        off[n] = math.pi - area(curve)
        assert abs(off[n]) < 0.1 * (math.pi - area(corners))
    assert abs(off[16]) < off[8] / 12  # of fourth order, the polygon itself of second
    steps = np.linalg.norm(np.diff(curve, axis=0, append=curve[:1]), axis=1)
    assert steps.max() < 0.006


def test_points_inside_fill_the_area():
    outline = np.array([(0.0, 0.0), (3.0, 0.0), (3.0, 1.0), (1.0, 1.0), (1.0, 3.0), (0.0, 3.0)])
    points = points_inside(outline, 0.05)
    assert len(points) * 0.05**2 * math.sqrt(0.75) == pytest.approx(area(outline), rel=0.02)
    assert not np.any((points[:, 0] > 1.0) & (points[:, 1] > 1.0))
    assert len(points_inside(SQUARE, 1e-9)) <= 250_000
    flat = np.array([(0.0, 0.0), (1.0, 0.0), (2.0, 0.0)])  # without area, but not without columns
    assert len(points_inside(flat, 1e-9)) == 0


@pytest.mark.parametrize("spacing", [0.0, -1.0, math.nan])
def test_a_spacing_must_be_positive(spacing):
    with pytest.raises(WeightError, match="spacing"):
        points_inside(SQUARE, spacing)
    with pytest.raises(WeightError, match="spacing"):
        rounded(SQUARE, spacing)


def test_an_endless_spacing_is_refused():
    with pytest.raises(WeightError, match="spacing"):
        points_inside(SQUARE, math.inf)
