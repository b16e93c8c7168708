"""What comes in is cleaned at the door; what is not convex is refused, and its hull offered."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from game.physics.narrowphase import ConvexPolygon, NonConvexError, convex_hull, gjk, vclip
from tests.physics.narrowphase.hard_pairs import SQUARE, gon

STAR = [(math.cos(t), math.sin(t)) for t in np.arange(5) * 0.8 * math.pi]


def test_duplicates_flat_corners_and_orientation():
    polygon = ConvexPolygon(
        [(-1, 1), (0, 1), (1, 1), (1, 1), (1, 0.5), (1, -1), (1 + 1e-14, -1), (-1, -1), (-1, 1)]
    )
    assert polygon.vertices.tolist() == [[-1, 1], [-1, -1], [1, -1], [1, 1]]
    assert polygon.source.tolist()[0] == 0
    assert polygon.area == 4.0
    polygon.check()
    assert not polygon.vertices.flags.writeable
    with pytest.raises(ValueError, match="read-only"):
        polygon.vertices[0] = 5.0


@pytest.mark.parametrize(
    ("points", "count"),
    [
        ([(3, 4)], 1),
        ([(3, 4), (3, 4)], 1),
        ([(0, 0), (2, 1)], 2),
        ([(0, 0), (2, 1), (1, 0.5)], 2),
        ([(0, 0), (2, 2), (1, 1), (3, 3), (-1, -1)], 2),
        ([(0, 0), (0, 1), (0, 3)], 2),
        ([(0, 0), (10, 0), (10, 1e-9)], 3),
        (gon(1000), 1000),
        ([(1e8 + x, 1e8 + y) for x, y in gon(64)], 64),
    ],
)
def test_points_segments_slivers_and_many_corners(points, count):
    polygon = ConvexPolygon(points)
    assert len(polygon) == count
    assert len(ConvexPolygon(list(reversed(points)))) == count
    ends = np.sort(polygon.vertices, axis=0)
    assert np.array_equal(ends[[0, -1]], np.sort(np.array(points, dtype=float), axis=0)[[0, -1]])


@pytest.mark.parametrize(
    "points",
    [
        [(0, 0), (2, 0), (1, 0.5), (2, 2), (0, 2)],
        [(0, 0), (1, 1), (1, 0), (0, 1)],
        [(0, 0), (2, 0), (2, 2), (1, 1e-6), (0, 2)],
        STAR,
        [*SQUARE, *SQUARE],
        [(0, 0), (4, 0), (4, 1), (2, -1), (0, 1)],
    ],
    ids=("dent", "bow", "notch", "star", "twice round", "crossed"),
)
def test_what_is_not_convex_is_refused_with_its_hull(points):
    for way in (points, list(reversed(points))):
        with pytest.raises(NonConvexError, match="not convex at vertex") as caught:
            ConvexPolygon(way)
        hull = caught.value.hull
        hull.check()
        assert all(hull.holds(x, y) for x, y in points)
        given_points = {tuple(map(float, point)) for point in points}
        assert {tuple(corner) for corner in hull.vertices.tolist()} <= given_points
        assert 0 <= caught.value.vertex < len(points)
    with pytest.raises(NonConvexError):
        gjk(points, SQUARE)
    with pytest.raises(NonConvexError):
        vclip(SQUARE, points)


@pytest.mark.parametrize(
    ("points", "words"),
    [
        ([], "at least one point"),
        ([(1, 2, 3)], "at least one point"),
        ([1, 2], "at least one point"),
        ("abc", "rows of two numbers"),
        ([(0, 0), (1, math.nan)], "point 1 is not finite"),
        ([(0, 0), (math.inf, 0)], "point 1 is not finite"),
        ([(0, 0), (1e300, 0), (0, 1)], "within 1e"),
        ([(0, 0), (1e-300, 0), (0, 1e-300)], "larger than"),
        ([(0, 0), (5e-324, 0)], "larger than"),
    ],
)
def test_absurd_outlines_are_named(points, words):
    """Not finite, too few, too large or too small."""
    for measure in (ConvexPolygon, convex_hull, lambda p: gjk(p, SQUARE), lambda p: vclip(SQUARE, p)):
        with pytest.raises(ValueError, match=words):
            measure(points)


def test_any_kind_of_array_will_do():
    """Equal numbers of different types give equal answers."""
    wanted = gjk(SQUARE, [(3, 0), (4, 1), (4, -1)])
    other = np.array([(3, 0), (4, 1), (4, -1)])
    wide = np.zeros((3, 4), dtype=np.float32)
    wide[:, ::2] = other
    locked = other.astype(float)
    locked.flags.writeable = False
    for kind in (other, other.astype(np.float32), wide[:, ::2], locked, np.asfortranarray(other), 0 + other):
        assert gjk(SQUARE, kind) == wanted
    assert vclip(SQUARE, [(3, -0.0), (4, 1), (4, -1)])[:5] == wanted[:5]


def test_moved():
    square = ConvexPolygon(SQUARE)
    moved = square.moved(1.0, 2.0, 0.5 * math.pi)
    assert np.allclose(moved.vertices, [(2, 1), (2, 3), (0, 3), (0, 1)], rtol=0, atol=1e-15)
    assert np.array_equal(square.moved(3.0, 0.0).vertices, np.add(square.vertices, (3.0, 0.0)))
    moved.check()
    for bad in ((math.nan, 0.0, 0.0), (0.0, math.inf, 0.0), (0.0, 0.0, math.nan)):
        with pytest.raises(ValueError, match="finite"):
            square.moved(*bad)


coordinates = st.integers(-9, 9)


@settings(max_examples=80, deadline=None, derandomize=True)
@given(st.lists(st.tuples(coordinates, coordinates), min_size=1, max_size=12))
def test_hull_holds_all_points_and_is_convex(points):
    hull = convex_hull(points)
    hull.check()
    assert all(hull.holds(x, y) for x, y in points)
    again = ConvexPolygon(hull.vertices)
    assert np.array_equal(again.vertices, hull.vertices)
    assert np.array_equal(np.array(points, dtype=float)[hull.source], hull.vertices)


@pytest.mark.parametrize("size", [1.0, 2.0**-200, 2.0**200])
@pytest.mark.parametrize(("apart", "count"), [(2.0**-42, 4), (2.0**-41, 4), (2.0**-39, 5), (2.0**-38, 5)])
def test_vertices_nearer_than_two_to_the_minus_forty_are_one(apart, count, size):
    """Of the extent; farther apart they are two, though both stand out far beyond what counts as flat."""
    corners = [(0, 0), (1, 0), (1 + apart, 1 - apart), (1, 1), (0, 1)]
    for points in (corners, corners[::-1]):
        assert len(ConvexPolygon(size * np.array(points))) == count
