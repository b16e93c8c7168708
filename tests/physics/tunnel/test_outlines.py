"""Outlines of the tunnel: what is taken and refused, their middle and symmetry, distances and normals."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.tunnel import SHAPES, outline_of, shape_named
from game.physics.tunnel.outlines import PlacedOutline

ELL = [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 3.0), (0.0, 3.0)]


def test_an_outline_lies_about_the_centroid_of_its_area_whichever_way_it_is_drawn():
    for points in (ELL, ELL[::-1]):
        made = outline_of(points)
        assert made.area == pytest.approx(4.0)
        assert made.chord == pytest.approx(math.sqrt(13.0))
        # two boxes: 2 x 1 about (1, 0.5) and 1 x 2 about (0.5, 2)
        assert made.corners.min(axis=0) == pytest.approx((-0.75, -1.25))
        assert not made.mirrored and not made.turned


@pytest.mark.parametrize("name", SHAPES)
def test_named_shapes_have_a_chord_of_one_and_their_own_symmetry(name):
    made = shape_named(name)
    assert made.chord == 1.0 and made.area > 0.0
    assert made.mirrored == (name in ("disc", "square", "plate"))
    assert made.turned == made.mirrored
    assert np.ptp(made.corners[:, 0]) == pytest.approx(1.0, abs=2e-3)


def test_the_aerofoil_is_naca_4412():
    """12 % thick at 30 % of the chord, camber of 4 % at 40 %."""
    made = shape_named("aerofoil")
    place = PlacedOutline(made.corners)
    column = np.stack([np.full(2001, made.corners[:, 0].min() + 0.3), np.linspace(-0.3, 0.3, 2001)], axis=1)
    inside = column[place.distances(column)[:, 0] < 0.0, 1]
    assert np.ptp(inside) == pytest.approx(0.12, abs=0.002)
    column[:, 0] = made.corners[:, 0].min() + 0.4
    inside = column[place.distances(column)[:, 0] < 0.0, 1]
    trailing = made.corners[np.argmax(made.corners[:, 0]), 1]
    assert 0.5 * (inside[0] + inside[-1]) - trailing == pytest.approx(0.04, abs=0.002)


@pytest.mark.parametrize(
    ("points", "reason"),
    [
        ([(0, 0), (1, 1), (1, 0), (0, 1)], "no area|cross"),
        ([(-0.5, -0.3), (0.5, 0.3), (0.5, -0.3), (-0.5, 0.2)], "cross"),
        ([(0, 0), (1, 0)], "shape"),
        ([(0, 0), (1, 0), (2, 0)], "no area"),
        ([(0, 0), (1, 0), (math.nan, 1)], "finite"),
        ([(0, 0), (1e-5, 0), (0, 1e-5)], "chord"),
        ([(math.cos(0.01 * k), math.sin(0.01 * k)) for k in range(600)], "corners"),
    ],
)
def test_what_is_no_outline_is_refused_in_one_line(points, reason):
    with pytest.raises(ValueError, match=reason) as caught:
        outline_of(points)
    assert "\n" not in str(caught.value)


def test_an_unknown_shape_is_refused():
    with pytest.raises(ValueError, match="expected one of"):
        shape_named("brick")


def test_an_angle_of_attack_raises_the_nose_at_the_left():
    made = shape_named("plate")
    raised = made.placed(math.radians(30.0), (2.0, 1.0))
    nose = raised[np.argmin(raised[:, 0])]
    assert nose[0] < 2.0 and nose[1] > 1.0
    assert made.width(math.radians(90.0)) == pytest.approx(1.0)
    assert made.width(0.0) == pytest.approx(0.08)


def test_distances_are_signed_and_normals_point_outwards():
    place = PlacedOutline(outline_of([(-1, -0.5), (1, -0.5), (1, 0.5), (-1, 0.5)]).corners)
    points = np.array([[0.0, 0.8], [0.0, 0.4], [2.0, 1.5], [-1.2, 0.0], [0.3, -0.5]])
    found = place.distances(points)
    assert found[:, 0] == pytest.approx([0.3, -0.1, math.sqrt(2.0), 0.2, 0.0])
    assert found[:, 1:] == pytest.approx(
        np.array([[0, 1], [0, 1], [math.sqrt(0.5), math.sqrt(0.5)], [-1, 0], [0, -1]])
    )


def test_a_bay_is_outside():
    made = outline_of(
        [
            (-0.5, -0.5),
            (0.5, -0.5),
            (0.5, -0.3),
            (-0.3, -0.3),
            (-0.3, 0.3),
            (0.5, 0.3),
            (0.5, 0.5),
            (-0.5, 0.5),
        ]
    )
    place = PlacedOutline(made.corners)
    bay = made.corners[4] + (0.3, -0.3)
    assert place.distances(bay[None])[0, 0] > 0.0
    assert place.distances((made.corners[4] + (-0.1, -0.1))[None])[0, 0] < 0.0
    sample = place.sample(bay[None])
    assert sample.body[0] == 0 and not sample.velocity.any()
