"""A ball that is put onto another or over the edge lies where there is space, as near as it goes."""

import math

import numpy as np
import pytest

from game.billiards.table.carom import BALL_RADIUS, CAROM_LENGTH, CAROM_WIDTH, fits
from game.scenes.carom.model import free_place

PLACES = np.array([(0.3, 0.3), (0.7, 1.4), (1.1, 2.2)])


def test_where_there_is_space_it_lies_as_it_is_put():
    assert free_place(PLACES, 0, 0.5, 0.9) == (0.5, 0.9)


@pytest.mark.parametrize("turn", np.linspace(0.0, 2.0 * math.pi, 9))
@pytest.mark.parametrize("share", [0.2, 1.0, 1.9])
def test_on_another_ball_it_is_moved_straight_away_until_they_touch(turn, share):
    x = PLACES[1, 0] + share * BALL_RADIUS * math.cos(turn)
    y = PLACES[1, 1] + share * BALL_RADIUS * math.sin(turn)
    found = np.subtract(free_place(PLACES, 0, x, y), PLACES[1])
    assert math.hypot(*found) == pytest.approx(2.0 * BALL_RADIUS, rel=1e-6)
    assert found == pytest.approx(2.0 * BALL_RADIUS * np.array((math.cos(turn), math.sin(turn))), abs=1e-6)


def test_in_the_very_middle_of_another_it_goes_aside():
    assert free_place(PLACES, 0, *PLACES[1]) == pytest.approx((0.7 + 2.0 * BALL_RADIUS, 1.4), abs=1e-6)


@pytest.mark.parametrize(("x", "y"), [(-1.0, 0.9), (9.0, 0.9), (0.5, -1.0), (0.5, 9.0), (9.0, 9.0)])
def test_over_the_edge_it_lies_at_the_cushion(x, y):
    found = free_place(PLACES, 0, x, y)
    assert found == (
        min(max(x, BALL_RADIUS), CAROM_WIDTH - BALL_RADIUS),
        min(max(y, BALL_RADIUS), CAROM_LENGTH - BALL_RADIUS),
    )
    now = PLACES.copy()
    now[0] = found
    assert fits(now)
