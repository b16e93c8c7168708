"""Segments: distances known, exact meeting against rational arithmetic, degenerate ones."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from game.physics.bounds import do_segments_meet, segment_distance
from game.physics.bounds.segments import SCRATCH, exact_orientation, nearest_points, orientation

KNOWN = [
    ([(0, 0), (4, 0)], [(1, 2), (3, 3)], 2.0),
    ([(0, 0), (4, 0)], [(0, 1), (4, 1)], 1.0),
    ([(0, 0), (4, 0)], [(5, 0), (7, 0)], 1.0),
    ([(0, 0), (4, 0)], [(2, -1), (2, 1)], 0.0),
    ([(0, 0), (0, 0)], [(3, 4), (3, 4)], 5.0),
    ([(0, 0), (0, 0)], [(1, -1), (1, 5)], 1.0),
    ([(0, 0), (1, 0)], [(1.5, 1), (3, 2)], 1.11803398874989),
]
lattice = st.tuples(st.integers(-3, 3), st.integers(-3, 3))
numbers = st.integers(-(10**9), 10**9).map(lambda i: i * 1e-6)
places = st.tuples(numbers, numbers)
SPARE = np.zeros(SCRATCH)


@pytest.mark.parametrize(("first", "second", "distance"), KNOWN)
def test_known_distances(first, second, distance):
    for a, b in ((first, second), (second, first), (first[::-1], second)):
        assert segment_distance(a, b) == pytest.approx(distance, rel=0, abs=1e-13)
        assert do_segments_meet(a, b) == (distance == 0.0)


def exact_sign(a, b, c):
    (ax, ay), (bx, by), (cx, cy) = ((Fraction(x), Fraction(y)) for x, y in (a, b, c))
    value = (ax - cx) * (by - cy) - (ay - cy) * (bx - cx)
    return (value > 0) - (value < 0)


def exactly_meet(p, q, r, s):
    """Closed segments with rational arithmetic."""

    def within(a, b, c):
        return all(min(a[k], b[k]) <= c[k] <= max(a[k], b[k]) for k in (0, 1))

    d = [exact_sign(r, s, p), exact_sign(r, s, q), exact_sign(p, q, r), exact_sign(p, q, s)]
    if d[0] * d[1] < 0 and d[2] * d[3] < 0:
        return True
    ends = ((d[0], r, s, p), (d[1], r, s, q), (d[2], p, q, r), (d[3], p, q, s))
    return any(side == 0 and within(a, b, c) for side, a, b, c in ends)


@settings(max_examples=150, deadline=None)
@given(lattice, lattice, lattice, lattice, st.integers(-99, 99), st.sampled_from([1.0, 0.1, 1e-8, 1e8]))
def test_meeting_is_exact(p, q, r, s, shift, scale):
    """On a lattice nearly everything touches; scaled and shifted, rounding has its chances."""
    p, q, r, s = (tuple(float(scale * (x + 0.021 * shift)) for x in point) for point in (p, q, r, s))
    assert do_segments_meet([p, q], [r, s]) == exactly_meet(p, q, r, s)
    assert do_segments_meet([s, r], [q, p]) == exactly_meet(p, q, r, s)


@settings(max_examples=100, deadline=None)
@given(places, places, st.integers(0, 999), st.integers(-3, 3))
def test_orientation_of_points_within_rounding_of_a_line(a, b, share, ulps):
    """A point computed on the line, moved by a few ulps: the sign is that of the exact determinant."""
    c = [a[0] + share / 999 * (b[0] - a[0]), a[1] + share / 999 * (b[1] - a[1])]
    if c[1] == 0.0:
        return  # the next number is a subnormal, whose products are none
    for _ in range(abs(ulps)):
        c[1] = math.nextafter(c[1], math.copysign(math.inf, ulps))
    sign = exact_sign(a, b, c)
    assert orientation(*a, *b, *c, SPARE) == sign
    value = exact_orientation(*a, *b, *c, SPARE)
    assert np.sign(value) == sign


@settings(max_examples=100, deadline=None)
@given(places, places, places, places)
def test_distance_is_symmetric_and_that_of_the_points_given(p, q, r, s):
    px, py, qx, qy = nearest_points(*p, *q, *r, *s)
    distance = segment_distance([p, q], [r, s])
    assert distance == pytest.approx(segment_distance([r, s], [p, q]), rel=1e-12, abs=1e-12)
    assert distance == pytest.approx(math.dist((px, py), (qx, qy)), rel=1e-12, abs=1e-300)
    assert (
        segment_distance([p, q], [(px, py)] * 2) <= 1e-9 and segment_distance([r, s], [(qx, qy)] * 2) <= 1e-9
    )
    along = np.linspace(0, 1, 41)[:, None]
    mine, theirs = np.array(p) + along * np.subtract(q, p), np.array(r) + along * np.subtract(s, r)
    sampled = np.sqrt(((mine[:, None] - theirs[None]) ** 2).sum(axis=2).min())
    assert distance <= sampled + 1e-9


def test_what_are_no_segments_is_refused():
    with pytest.raises(ValueError, match="two ends"):
        segment_distance([(0, 0)], [(0, 0), (1, 1)])
    with pytest.raises(ValueError, match="two ends"):
        do_segments_meet([(0, 0), (1, 1), (2, 2)], [(0, 0), (1, 1)])
    with pytest.raises(ValueError, match="first"):
        segment_distance([(0, math.nan), (1, 1)], [(0, 0), (1, 1)])
