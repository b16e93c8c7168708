"""Racks: places, order, symmetry, gaps."""

import math

import numpy as np
import pytest

from game.billiards.table.rack import BALL_RADIUS, eight_ball_rack, nine_ball_rack
from game.billiards.table.table import Table

TABLE = Table.pool()


def _gaps(positions, radius):
    first, second = np.triu_indices(len(positions), 1)
    delta = positions[first] - positions[second]
    return np.sqrt((delta**2).sum(axis=1)) - 2.0 * radius


def test_eight_ball_rack_touches_and_is_exactly_symmetric():
    rack = eight_ball_rack(TABLE, BALL_RADIUS)
    assert rack.shape == (16, 2)
    gaps = _gaps(rack, BALL_RADIUS)
    assert gaps.min() > -1e-15 and (gaps < 1e-15).sum() == 30
    assert {(TABLE.width - x, y) for x, y in rack.tolist()} == {(x, y) for x, y in rack.tolist()}


@pytest.mark.parametrize("seed", [None, 0, 1, 2, 3])
def test_eight_ball_rack_keeps_the_rules(seed):
    rack = eight_ball_rack(TABLE, BALL_RADIUS, gap=1e-4, seed=seed)
    middle = (0.5 * TABLE.width, 0.75 * TABLE.length + 2.0 * (2.0 * BALL_RADIUS + 1e-4) * math.sqrt(0.75))
    assert np.hypot(*(rack[8] - middle)) <= 5.1e-5
    back = [ball for ball in range(1, 16) if rack[ball, 1] > rack[1:, 1].max() - BALL_RADIUS]
    left, right = min(back, key=lambda b: rack[b, 0]), max(back, key=lambda b: rack[b, 0])
    assert (left < 8) != (right < 8)
    assert tuple(rack[0]) == (0.5 * TABLE.width, 0.25 * TABLE.length)


def test_seeded_racks_repeat_differ_and_do_not_overlap():
    same = [eight_ball_rack(TABLE, BALL_RADIUS, 1e-4, seed=7) for _ in range(2)]
    assert np.array_equal(*same)
    assert not np.array_equal(same[0], eight_ball_rack(TABLE, BALL_RADIUS, 1e-4, seed=8))
    for seed in range(50):
        assert _gaps(eight_ball_rack(TABLE, BALL_RADIUS, 1e-4, seed=seed), BALL_RADIUS).min() > -1e-15


def test_nine_ball_rack():
    rack = nine_ball_rack(TABLE, BALL_RADIUS)
    assert rack.shape == (10, 2)
    assert tuple(rack[1]) == (0.5 * TABLE.width, 0.75 * TABLE.length)
    assert np.allclose(rack[9], rack[1:].mean(axis=0), rtol=0.0, atol=1e-15)
    assert (np.abs(_gaps(rack, BALL_RADIUS)) < 1e-15).sum() == 16
    seeded = nine_ball_rack(TABLE, BALL_RADIUS, seed=5)
    assert np.array_equal(seeded[[1, 9]], rack[[1, 9]]) and not np.array_equal(seeded, rack)


@pytest.mark.parametrize(
    ("radius", "gap"), [(0.0, 0.0), (-1.0, 0.0), (math.nan, 0.0), (0.03, -1e-9), (0.03, math.inf), (0.2, 0.0)]
)
def test_absurd_racks_are_refused(radius, gap):
    with pytest.raises(ValueError, match="rack"):
        eight_ball_rack(TABLE, radius, gap)
