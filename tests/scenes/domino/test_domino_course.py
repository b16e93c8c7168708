"""The floor of the course: heights and slopes, beyond its ends as well."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.scenes.domino.course import floor_points, height_at
from game.scenes.domino.level import FloorEntry, PieceEntry

FLOOR = np.array([(0.0, 1.0), (2.0, 2.0), (2.0, 1.5), (4.0, 1.5), (5.0, 0.5)])  # up, a step down, level, down


@pytest.mark.parametrize(
    ("x", "height", "slope"),
    [
        (-1.0, 1.0, math.atan(0.5)), (0.0, 1.0, math.atan(0.5)), (1.0, 1.5, math.atan(0.5)),
        (2.0, 1.5, 0.0), (3.0, 1.5, 0.0), (4.25, 1.25, -math.pi / 4), (9.0, 0.5, -math.pi / 4),
    ],
)  # fmt: skip
def test_height_and_slope(x, height, slope):
    assert height_at(FLOOR, x) == pytest.approx((height, slope))


@pytest.mark.parametrize("more", [{}, {"radius": 3.0}, {"turn": 40.0}])
def test_a_piece_is_an_arc_only_with_a_radius_and_a_turn(more):
    straight = FloorEntry(start=(1.0, 2.0), pieces=(PieceEntry(run=4.0, rise=0.5, **more),))
    assert floor_points(straight).tolist() == [[1.0, 2.0], [5.0, 2.5]]


def test_an_arc_ends_where_the_circle_does():
    bend = FloorEntry(start=(1.0, 2.0), pieces=(PieceEntry(radius=3.0, turn=40.0),))
    angle = math.radians(40.0)
    points = floor_points(bend)
    assert points[-1] == pytest.approx((1.0 + 3.0 * math.sin(angle), 2.0 + 3.0 * (1.0 - math.cos(angle))))
    assert np.hypot(*(points - (1.0, 5.0)).T) == pytest.approx(3.0)


def test_a_piece_that_goes_nowhere_is_refused():
    with pytest.raises(ValueError, match=r"pieces\[0\]"):
        floor_points(FloorEntry(start=(0.0, 0.0), pieces=(PieceEntry(radius=3.0),)))
