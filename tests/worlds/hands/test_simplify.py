"""A drawn line keeps its ends and its farthest points; what is left out lies within the tolerance."""

import numpy as np
import pytest

from game.worlds.hands.curves import simplified

TOLERANCE = 0.05


def distances(points, line):
    """Of each point to the nearest part of a line of straight parts."""
    a, way = line[:-1], np.diff(line, axis=0)
    share = np.einsum("nkj,kj->nk", points[:, None] - a, way) / np.maximum((way * way).sum(axis=1), 1e-300)
    foot = a + np.clip(share, 0.0, 1.0)[:, :, None] * way
    return np.linalg.norm(points[:, None] - foot, axis=2).min(axis=1)


def test_a_corner_is_all_that_is_left_of_two_straight_lines():
    along = np.linspace(0.0, 1.0, 9)[:, None]
    points = np.vstack([along * (2.0, 0.0), (2.0, 0.0) + along[1:] * (0.0, 1.0)])
    assert simplified(points, TOLERANCE).tolist() == [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0]]


def test_of_three_points_the_middle_one_counts():
    assert len(simplified(np.array([[0.0, 0.0], [1.0, 0.06], [2.0, 0.0]]), TOLERANCE)) == 3
    assert len(simplified(np.array([[0.0, 0.0], [1.0, 0.04], [2.0, 0.0]]), TOLERANCE)) == 2


@pytest.mark.parametrize("corner", [1, 2, 4, 7, 8])
def test_the_farthest_point_is_the_one_that_is_kept(corner):
    points = np.column_stack((np.arange(10.0), np.zeros(10)))
    points[corner, 1] = 0.06
    points[5, 1] = -0.04
    kept = simplified(points, TOLERANCE)
    assert [0.0, 0.0] in kept.tolist() and [9.0, 0.0] in kept.tolist()
    assert points[corner].tolist() in kept.tolist()
    assert (distances(points, kept) <= TOLERANCE).all()


def test_a_stroke_that_comes_back_to_its_beginning_keeps_its_far_end():
    turn = np.linspace(0.0, 2.0 * np.pi, 61)
    points = np.column_stack((np.cos(turn), np.sin(turn)))
    points[-1] = points[0]
    kept = simplified(points, TOLERANCE)
    assert 6 <= len(kept) <= 20
    assert (distances(points, kept) <= TOLERANCE).all()


@pytest.mark.parametrize("seed", range(5))
def test_a_wild_stroke_is_followed_within_the_tolerance(seed):
    points = np.cumsum(np.random.default_rng(seed).normal(0.0, 0.04, (200, 2)), axis=0)
    kept = simplified(points, TOLERANCE)
    assert len(kept) < len(points) and (kept[[0, -1]] == points[[0, -1]]).all()
    assert (distances(points, kept) <= TOLERANCE + 1e-12).all()
