"""The polytopes of EPA's walk: each holds the origin and grows, wherever GJK has begun."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from game.physics.narrowphase import ConvexPolygon, Feature, certify, epa, epa_trace, vclip
from game.physics.narrowphase.minkowski import minkowski_difference
from tests.physics.narrowphase.random_pairs import random_polygon


def corners_of(a, b, step):
    """Corners (n, 2) of a polytope, m."""
    return np.array([a.vertices[i] - b.vertices[j] for i, j in step.corners])


def area_of(corners):
    x, y = (corners - corners[0]).T
    return 0.5 * float((x * np.roll(y, -1) - y * np.roll(x, -1)).sum())


def depths_outside(corners, points):
    """How far points (m, 2) lie outside of a convex polygon, counterclockwise, m; 0 or less inside."""
    edges = np.roll(corners, -1, axis=0) - corners
    normals = np.column_stack((edges[:, 1], -edges[:, 0])) / np.hypot(*edges.T)[:, None]
    return ((points[:, None] - corners[None]) * normals[None]).sum(axis=2).max(axis=1)


def check_walk(a, b, start):
    """All that a walk of EPA has to be; returns how many corners it dropped."""
    found, simplexes, growth = epa_trace(a, b, start)
    if found.distance >= 0.0:
        assert not growth or found.distance == 0.0
        return 0
    assert growth and found.distance == pytest.approx(vclip(a, b).distance, rel=1e-9, abs=1e-14)
    if simplexes and simplexes[-1].kept == "inside":
        assert {*simplexes[-1].corners, simplexes[-1].support} == set(growth[0].corners)
    tiny = 1e-13 * float(np.ptp(minkowski_difference(a.vertices, b.vertices), axis=0).max())
    before = None
    for step in growth:
        corners = corners_of(a, b, step)
        assert len(set(step.corners)) == len(corners) >= 2
        assert depths_outside(corners, np.zeros((1, 2)))[0] <= tiny, "the origin is outside"
        if before is not None:
            assert area_of(corners) > area_of(before)
            assert depths_outside(corners, before).max() <= tiny, "it does not hold the one before"
        before = corners
    assert [step.grows for step in growth] == [True] * (len(growth) - 1) + [False]
    assert growth[-1].height == pytest.approx(-found.distance, rel=1e-9, abs=tiny)
    certify(a, b, found)
    return sum(sum(step.dropped) for step in growth)


@settings(max_examples=60, deadline=None)
@given(st.integers(0, 2**32 - 1))
def test_every_polytope_holds_the_origin_and_the_one_before(seed):
    random = np.random.default_rng(seed)
    a = random_polygon(random, 9)
    b = random_polygon(random, 9)
    way = a.vertices.mean(axis=0) - b.vertices.mean(axis=0) + 0.1 * random.normal(size=2)
    b = ConvexPolygon(b.vertices + way)
    assert check_walk(a, b, None) >= 0
    for _ in range(6):
        features = [Feature.of(int(random.integers(2 * len(shape)))) for shape in (a, b)]
        assert check_walk(a, b, tuple(features)) >= 0


def test_inner_corners_are_dropped_and_the_triangle_of_gjk_is_kept():
    """From all features of two polygons: some triangles have corners within the difference."""
    angle = 2 * np.pi * np.arange(7) / 7
    a = ConvexPolygon(np.column_stack((np.cos(angle), np.sin(angle))))
    b = ConvexPolygon(0.8 * np.column_stack((np.cos(angle[:5] * 1.4), np.sin(angle[:5] * 1.4))) + (0.3, 0.2))
    dropped = [
        check_walk(a, b, (Feature.of(i), Feature.of(j))) for i in range(2 * len(a)) for j in range(2 * len(b))
    ]
    assert max(dropped) >= 1 and min(dropped) == 0


def test_the_origin_on_a_corner_within_the_difference_is_a_beginning_too():
    """Two squares, a vertex of one on a vertex of the other, which lies inside: v is 0 at once."""
    square = np.array([(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)])
    a, b = ConvexPolygon(square), ConvexPolygon(square)
    check_walk(a, b, (Feature("vertex", 0), Feature("vertex", 0)))
    assert epa(a, b, (Feature("vertex", 0), Feature("vertex", 0))).distance == pytest.approx(-2.0)
