"""Which solid lies under a point: distances to boxes and discs that are turned and far from the origin."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.solids import Disc, SolidSettings, SolidWorld, box
from game.worlds.hands.grab import body_at, distance_to
from game.worlds.hands.hand import NOBODY

PLACE, TURN, HALF = (7.0, -3.0), 0.6, (0.8, 0.3)  # m, rad, m: of the box


@pytest.fixture
def world() -> SolidWorld:
    made = SolidWorld(SolidSettings())
    made.add_body(box(2.0 * HALF[0], 2.0 * HALF[1]), PLACE, TURN)
    made.add_body(Disc(0.5), (10.0, -3.0))
    return made


def of_a_box(point: np.ndarray) -> float:
    """m, in the box's own axes: beyond its sides, or as far within as its nearest side."""
    across, along = np.array((math.cos(TURN), math.sin(TURN))), np.array((-math.sin(TURN), math.cos(TURN)))
    beyond = np.abs([(point - PLACE) @ across, (point - PLACE) @ along]) - HALF
    return float(np.linalg.norm(np.maximum(beyond, 0.0)) + min(beyond.max(), 0.0))


def test_distances_to_a_box_and_a_disc_within_and_without(world: SolidWorld) -> None:
    points = np.random.default_rng(4).uniform(-1.5, 1.5, (60, 2)) + PLACE
    expected = [of_a_box(point) for point in points]
    assert min(expected) < -0.1 < 0.5 < max(expected)
    (shape,) = world.shapes_of(0).tolist()
    assert [distance_to(world, shape, tuple(point)) for point in points] == pytest.approx(expected, abs=1e-9)
    (disc,) = world.shapes_of(1).tolist()
    assert distance_to(world, disc, (10.0, -2.0)) == pytest.approx(0.5)


def test_the_body_that_a_point_is_in_comes_before_a_nearer_edge(world: SolidWorld) -> None:
    both = np.array([0, 1])
    for point, found in ((PLACE, 0), ((10.2, -3.1), 1), ((10.6, -3.0), 1), ((12.0, -3.0), NOBODY)):
        assert body_at(world, both, point, 0.3) == found
