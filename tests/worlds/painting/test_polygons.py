"""Polygons that several scenes paint: their area, and their edges moved outwards."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.worlds.painting.polygons import move_outwards, signed_area

CORNERS = np.array([(9.0, 9.0), (10.0, 20.0), (14.0, 20.0), (14.0, 23.0), (10.0, 23.0), (0.0, 0.0)])


def test_area_is_signed_by_the_sense_of_the_corners():
    assert signed_area(CORNERS, 1, 5) == pytest.approx(12.0)
    assert signed_area(np.ascontiguousarray(CORNERS[::-1]), 1, 5) == pytest.approx(-12.0)
    skewed = np.array([(1.0, 1.0), (4.0, 2.0), (2.0, 6.0)])
    assert signed_area(skewed, 0, 3) == pytest.approx(0.5 * (3.0 * 5.0 - 1.0 * 1.0))


@pytest.mark.parametrize("turned", [False, True])
def test_edges_lie_outside_whatever_the_sense(turned):
    places = np.ascontiguousarray(CORNERS[::-1]) if turned else CORNERS
    moved = np.zeros((4, 2))
    move_outwards(places, 1, 5, 0.5, moved)
    outwards = np.sign(places[1:5] - (12.0, 21.5))
    away = (moved - places[1:5]) * outwards
    assert (away > 0.0).all()
    assert np.hypot(*away.T) == pytest.approx(0.5)
    assert math.copysign(1.0, signed_area(places, 1, 5)) == (-1.0 if turned else 1.0)
