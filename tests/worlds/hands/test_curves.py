"""What a hand does to tracks: closed form on straight ones."""

import numpy as np
import pytest

from game.physics.solids.tracks import Curve
from game.worlds.hands.curves import NOBODY, bent, drawn, nearest_curve

LEVEL = Curve(np.array([[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0]]))
HIGHER = Curve(np.array([[0.0, 1.0], [3.0, 1.0]]))
SQUARE = Curve(np.array([[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]), closed=True, corner=10.0)


@pytest.mark.parametrize(
    ("point", "found"), [((1.5, 0.2), 0), ((1.5, 0.8), 1), ((1.5, 3.0), NOBODY), ((3.3, 0.1), 0)]
)
def test_the_nearest_track_is_found_between_its_points(point: tuple[float, float], found: int):
    assert nearest_curve([LEVEL, HIGHER], point, 0.5) == found


def test_only_a_closed_track_is_found_between_its_last_and_its_first_point():
    way_back = (0.05, 1.0)
    assert nearest_curve([SQUARE], way_back, 0.5) == 0
    assert nearest_curve([Curve(SQUARE.points, corner=10.0)], way_back, 0.5) == NOBODY


def test_of_two_in_reach_the_nearer_is_meant_whatever_their_order():
    assert nearest_curve([HIGHER, LEVEL], (1.0, 0.6), 2.0) == 0
    assert nearest_curve([LEVEL, HIGHER], (1.0, 0.6), 2.0) == 1


def test_points_follow_the_hand_the_nearer_the_farther():
    curve = bent(LEVEL, (1.0, 0.0), (1.5, 0.25), 2.0)
    shares = np.exp(-((np.array([1.0, 0.0, 1.0, 2.0]) / 2.0) ** 2))
    np.testing.assert_allclose(
        curve.points, np.asarray(LEVEL.points) + shares[:, None] * (0.5, 0.25), atol=1e-15
    )
    assert np.asarray(LEVEL.points)[1].tolist() == [1.0, 0.0], "the old one stays as it was"


def test_a_bent_track_stays_closed_and_keeps_its_corners():
    curve = bent(SQUARE, (0.0, 0.0), (0.1, 0.0), 1.0)
    assert (curve.closed, curve.corner) == (True, 10.0)


def test_a_path_becomes_a_track_of_as_many_points_as_it_needs():
    straight = [(0.01 * k, 0.0) for k in range(200)]
    curve = drawn(straight, 0.1)
    assert curve is not None and not curve.closed
    np.testing.assert_allclose(curve.points, [straight[0], straight[-1]])
    wave = [(0.01 * k, float(np.sin(0.1 * k))) for k in range(200)]
    free, bounded = drawn(wave, 0.1), drawn(wave, 0.1, 5)
    assert free is not None and bounded is not None
    assert len(free.points) > 5 == len(bounded.points)


@pytest.mark.parametrize("path", [[(0.0, 0.0)], [(0.0, 0.0), (0.19, 0.0)]])
def test_what_is_shorter_than_twice_the_reach_is_no_track(path: list[tuple[float, float]]):
    assert drawn(path, 0.1) is None
    assert drawn([(0.0, 0.0), (0.21, 0.0)], 0.1) is not None
