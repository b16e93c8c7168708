"""Shapes of convex parts: what is refused, and what is measured of them."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.narrowphase.depth import PRESETS, Shape, preset

SQUARE = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]


@pytest.mark.parametrize(
    ("parts", "words"),
    [
        ([], "parts: expected 1 to 24"),
        ([SQUARE, SQUARE[::-1]], "part 1: goes clockwise"),
        ([[(0, 0), (1, 0)]], "part 0: expected 3 to 64 corners"),
        ([[(0, 0), (1, 0), "x"]], "part 0: expected rows"),
        ([[(0, 0), (1, 0), (math.nan, 1)]], "part 0: corner 2 is not finite"),
        ([[(0, 0), (2, 0), (0.5, 0.5), (0, 2)]], "part 0: not convex at corner 2"),
        ([[(0, 0), (1, 0), (1, 0), (0, 1)]], "part 0: corners 1 and the next coincide"),
        ([[(0, 0), (1, 0), (2, 0)]], "part 0: "),
        (
            [[(math.cos(0.8 * math.pi * k), math.sin(0.8 * math.pi * k)) for k in range(5)]],
            "part 0: goes round",
        ),
        ([[(0, 0), (1e60, 0), (0, 1e60)]], "part 0: its extent"),
        ([SQUARE, [(0.5, 0.5), (2, 0.5), (2, 2)]], "part 1: overlaps part 0"),
    ],
)
def test_what_is_no_shape_is_refused_by_part_and_reason(parts, words):
    with pytest.raises(ValueError, match=words):
        Shape(parts)


def test_area_centroid_and_gyration_of_a_square_cut_in_two():
    whole = Shape([np.array(SQUARE) + np.array((5.0, -3.0))])
    halves = Shape([[(5, -3), (5.5, -3), (5.5, -2), (5, -2)], [(5.5, -3), (6, -3), (6, -2), (5.5, -2)]])
    for shape in (whole, halves):
        assert shape.area == pytest.approx(1.0)
        assert shape.centroid == pytest.approx((5.5, -2.5))
        assert shape.gyration == pytest.approx(math.sqrt(1.0 / 6.0))
        assert shape.reaches == pytest.approx(math.sqrt(0.5))


@pytest.mark.parametrize("name", PRESETS)
def test_the_object_norm_is_the_mean_square_displacement_of_points(name):
    shape = preset(name, 1.3, 0.7)
    x, y, angle = 0.3, -0.2, 0.8
    inside = []
    generator = np.random.default_rng(5)
    for part in shape.placed(0.0, 0.0, 0.0):
        for k in range(1, len(part) - 1):  # triangles, by area
            u, v = part[k] - part[0], part[k + 1] - part[0]
            count = max(20, round(40_000 * abs(u[0] * v[1] - u[1] * v[0]) / shape.area))
            s = generator.random((count, 2))
            s[s.sum(axis=1) > 1.0] = 1.0 - s[s.sum(axis=1) > 1.0]
            inside.append(part[0] + s[:, :1] * u + s[:, 1:] * v)
    points = np.concatenate(inside)
    c, s_ = math.cos(angle), math.sin(angle)
    moved = points @ np.array(((c, s_), (-s_, c))) + (x, y)
    mean = math.sqrt(float(np.mean(np.sum((moved - points) ** 2, axis=1))))
    assert shape.norm(x, y, angle) == pytest.approx(mean, rel=0.02)


def test_unknown_presets_and_sizes_are_refused():
    with pytest.raises(ValueError, match="expected one of"):
        preset("moon")
    with pytest.raises(ValueError, match="size, flat"):
        preset("bar", 0.0)
