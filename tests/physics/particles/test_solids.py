"""Round solids: what they refuse, where their surface is."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.physics.particles import Discs

number = st.floats(-50, 50)


def test_sample_of_points_about_a_moving_disc():
    discs = Discs([(1, 2)], [0.5])
    discs.carry(0, (3, -1))
    distances, normals, velocities = discs.sample([(1, 3), (1, 2), (4, 2), (1.25, 2)])
    assert np.allclose(distances, [0.5, -0.5, 2.5, -0.25], rtol=0, atol=1e-15)
    assert np.allclose(normals, [(0, 1), (0, 1), (1, 0), (1, 0)], rtol=0, atol=1e-15)
    assert np.array_equal(velocities, np.tile([3.0, -1.0], (4, 1)))


def test_no_discs_are_infinitely_far():
    distances, normals, _ = Discs().sample([(0, 0)])
    assert distances[0] == math.inf
    assert not normals.any()


@given(
    st.lists(st.tuples(number, number, st.floats(0.01, 5)), min_size=1, max_size=5), st.tuples(number, number)
)
def test_a_walk_by_the_distance_along_the_normal_ends_on_the_surface(rows, point):
    discs = Discs([row[:2] for row in rows], [row[2] for row in rows])
    distance, normal, _ = discs.sample([point])
    there = np.array(point) - distance[0] * normal[0]
    gaps = np.hypot(*(discs.centres - there).T) - discs.radii
    assert np.min(np.abs(gaps)) < 1e-12
    assert abs(np.linalg.norm(normal[0]) - 1.0) < 1e-12


@pytest.mark.parametrize(
    ("centre", "radius", "restitution", "word"),
    [
        ((math.nan, 0), 1.0, 0.5, "centre"),
        ((0, math.inf), 1.0, 0.5, "centre"),
        ((0, 0, 0), 1.0, 0.5, "centre"),
        ((0, 0), 0.0, 0.5, "radius"),
        ((0, 0), -1.0, 0.5, "radius"),
        ((0, 0), math.nan, 0.5, "radius"),
        ((0, 0), 1.0, 1.1, "restitution"),
        ((0, 0), 1.0, math.nan, "restitution"),
    ],
)
def test_absurd_discs_are_refused(centre, radius, restitution, word):
    with pytest.raises(ValueError, match=word):
        Discs().add(centre, radius, restitution)


def test_places_are_limited_and_freed():
    discs = Discs(capacity=2)
    discs.add((0, 0), 1.0)
    discs.add((5, 0), 2.0)
    with pytest.raises(ValueError, match="at most 2"):
        discs.add((9, 0), 1.0)
    discs.remove(0)
    assert len(discs) == 1
    assert discs.radii[0] == 2.0
    with pytest.raises(ValueError, match="there are 1"):
        discs.remove(1)
    for index in (-1, 1):
        with pytest.raises(ValueError, match="there are 1"):
            discs.place(index, (0.0, 0.0))
        with pytest.raises(ValueError, match="there are 1"):
            discs.carry(index, (0.0, 0.0))
    with pytest.raises(ValueError, match="radii: expected 2"):
        Discs([(0, 0), (1, 1)], [1.0])
