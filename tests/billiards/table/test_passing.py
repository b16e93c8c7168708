"""Pairs that pass through each other within a step, against many small steps."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from game.billiards.table.passing import COLUMNS, FIRST, FIRST_PLACE, SECOND, SECOND_PLACE, find_passed

PLACE = st.floats(-3.0, 3.0)
BOTH = np.ones(2, dtype=np.bool_)


def passed_of(before, now, radii, free=BOTH, rows=8):
    found = np.zeros((rows, COLUMNS))
    count = find_passed(np.array(before), np.array(now), np.array(radii), free, found)
    return found[: min(count, rows)], count


@given(st.lists(PLACE, min_size=8, max_size=8), st.floats(0.05, 1.0), st.floats(0.05, 1.0))
def test_as_many_small_steps_see_it(numbers, r, s):
    before, now = np.array(numbers).reshape(2, 2, 2)
    shares = np.linspace(0.0, 1.0, 2001)[:, None]
    gaps = (before[1] - before[0]) + shares * ((now[1] - now[0]) - (before[1] - before[0]))
    distances = np.sqrt((gaps * gaps).sum(axis=1))
    assume(abs(float(distances.min()) - (r + s)) > 0.01)
    seen_only_between = distances.min() < r + s and min(distances[0], distances[-1]) >= r + s
    found, count = passed_of(before, now, [r, s])
    assert count == seen_only_between
    if count:
        assert tuple(found[0, [FIRST, SECOND]]) == (0, 1)
        nearest = found[0, SECOND_PLACE] - found[0, FIRST_PLACE]
        assert float(np.sqrt(nearest @ nearest)) == pytest.approx(float(distances.min()), abs=0.01)


def test_who_overlaps_at_an_end_is_no_secret():
    assert passed_of([(0.0, 0.0), (1.0, 0.0)], [(0.0, 0.0), (-4.0, 0.0)], [1.0, 1.0])[1] == 0
    assert passed_of([(0.0, 0.0), (4.0, 0.0)], [(0.0, 0.0), (-1.0, 0.0)], [1.0, 1.0])[1] == 0


def test_only_free_balls_count_and_all_are_counted_beyond_the_rows():
    before = [(0.0, 0.0), (10.0, 0.0), (20.0, 0.0), (-10.0, 0.0)]
    now = [(0.0, 0.0), (-10.0, 0.0), (-20.0, 0.0), (-10.0, 0.0)]
    free = np.array([True, True, True, False])
    found, count = passed_of(before, now, [1.0] * 4, free, rows=1)
    assert count == 3 and len(found) == 1
    assert tuple(found[0]) == (0.0, 1.0, 0.0, 0.0, 0.0, 0.0)


def test_touching_by_rounding_is_not_passing():
    assert passed_of([(0.0, 0.0), (-5.0, 2.0)], [(0.0, 0.0), (5.0, 2.0)], [1.0, 1.0])[1] == 0
    assert passed_of([(0.0, 0.0), (-5.0, 1.999)], [(0.0, 0.0), (5.0, 1.999)], [1.0, 1.0])[1] == 1
