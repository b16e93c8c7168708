"""Boxes as solids of a gas: their distances against a naive sum over corners and edges."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.worlds.members.boxes import Boxes, box_rows


def boxes(*given):
    found = Boxes()
    places, turns, halves = zip(*given, strict=True)
    directions = np.array([(math.cos(turn), math.sin(turn)) for turn in turns])
    found.rows = box_rows(np.array(places), directions, np.array(halves))
    return found


def naive(point, place, turn, halves):
    x, y = np.array(point) - place
    a = abs(math.cos(turn) * x + math.sin(turn) * y) - halves[0]
    b = abs(math.cos(turn) * y - math.sin(turn) * x) - halves[1]
    return math.hypot(max(a, 0.0), max(b, 0.0)) + min(max(a, b), 0.0)


def test_distances_to_the_nearest_of_turned_boxes():
    given = (((0.2, 0.1), 0.4, (0.3, 0.05)), ((-0.4, 0.3), -1.1, (0.2, 0.1)), ((0.0, -0.5), 0.0, (0.5, 0.02)))
    points = np.random.default_rng(3).uniform(-1.0, 1.0, (400, 2))
    found = boxes(*given).sample(points)
    each = np.array([[naive(point, *one) for one in given] for point in points])
    assert found.distance == pytest.approx(each.min(axis=1), abs=1e-12)
    assert (found.body == each.argmin(axis=1)).all() and np.min(found.distance) < 0.0


def test_what_has_moved_is_told_from_what_has_not():
    one = boxes(((0.0, 0.0), 0.3, (0.2, 0.05)))
    assert not one.differ(one.rows.copy(), 0.01)
    for column, change in ((0, 0.02), (1, -0.02), (3, 0.1), (4, 0.02), (5, -0.02)):
        rows = one.rows.copy()
        rows[0, column] += change
        assert one.differ(rows, 0.01), column
        assert not one.differ(rows, 0.03)
    assert one.differ(np.zeros((0, 8)), 0.01)
