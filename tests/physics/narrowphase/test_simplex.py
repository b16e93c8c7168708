"""Support vertices, the closest point of a simplex, the best simplex: GJK's parts by themselves."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.narrowphase import ConvexPolygon, gjk, gjk_trace
from game.physics.narrowphase.features import Polygon
from game.physics.narrowphase.minkowski import minkowski_difference
from game.physics.narrowphase.simplex import (
    FIRST_AND_NEW,
    INSIDE,
    NEW_ONLY,
    SECOND_AND_NEW,
    best_simplex,
    closest_point,
    support_cold,
    support_hc,
    support_scan,
)
from tests.physics.narrowphase.hard_pairs import PAIRS, SQUARE, gon
from tests.physics.narrowphase.random_pairs import random_polygon


def test_climbing_finds_what_a_look_at_all_finds():
    """From every vertex, also where two are equally far (C11.H5, .H6)."""
    random = np.random.default_rng(4)
    shapes = [random_polygon(random).local for _ in range(12)] + [
        ConvexPolygon(gon(n)).local for n in (3, 90)
    ]
    for corners in shapes:
        n = len(corners)
        polygon = Polygon(corners, 0, n)
        edges = np.roll(corners, -1, axis=0) - corners
        ways = [*np.column_stack((edges[:, 1], -edges[:, 0])), *random.normal(0.0, 1.0, (10, 2)), *edges]
        for x, y in ways:
            best = (corners @ (x, y)).max()
            near = 1e-15 * math.hypot(x, y) * np.ptp(corners)
            found = [support_scan(polygon, x, y), support_cold(polygon, x, y)]
            found += [support_hc(polygon, start, x, y) for start in range(n)]
            assert (best - (corners @ (x, y))[found]).max() <= near


def test_no_direction_gives_the_vertex_one_has():
    local = ConvexPolygon(SQUARE).local
    square = Polygon(local, 0, 4)
    assert [support_hc(square, k, 0.0, 0.0) for k in range(4)] == [0, 1, 2, 3]
    assert support_hc(square, 2, math.nan, 1.0) == 2
    assert support_hc(Polygon(local, 0, 1), 0, 1.0, 1.0) == 0


@pytest.mark.parametrize(
    ("p", "q", "expected"),
    [
        ((1, 1), (1, -1), (1, 0, 0.5)),
        ((1, 1), (3, 1), (1, 1, 0.0)),
        ((3, 1), (1, 1), (1, 1, 1.0)),
        ((2, 2), (2, 2), (2, 2, 0.0)),
        ((-1, 0), (3, 0), (0, 0, 0.25)),
    ],
)
def test_closest_point_of_a_segment(p, q, expected):
    assert closest_point(*map(float, p + q)) == expected


@pytest.mark.parametrize(
    ("count", "points", "kept"),
    [
        (1, ((5, 0), (5, 0), (2, 0)), NEW_ONLY),
        (1, ((3, 1), (3, 1), (1, -2)), FIRST_AND_NEW),
        (2, ((4, 3), (4, -3), (1, 0)), NEW_ONLY),
        (2, ((2, 3), (4, -3), (-1, -1)), INSIDE),
        (2, ((2, 3), (4, -3), (-1, -3)), FIRST_AND_NEW),
        (2, ((3, 3), (4, -3), (0.5, -2)), FIRST_AND_NEW),
        (2, ((4, -3), (3, 3), (0.5, -2)), SECOND_AND_NEW),
        (2, ((1, 1), (1, -1), (-1, 0)), INSIDE),
        (2, ((1, 2), (1, -1), (0, 0)), INSIDE),  # the origin is the new corner
        (2, ((2, 2), (3, -1), (-2, -2)), INSIDE),  # on the edge from the first to the new one
    ],
)
def test_best_simplex_in_every_region(count, points, kept):
    """C11.H3: borders count as inside. Whatever is kept holds the closest point, at every scale."""
    for scale in (1.0, 2.0**-300, 2.0**300):
        flat = [scale * value for point in points for value in point]
        assert best_simplex(count, *flat) == kept


def test_the_start_is_a_corner_of_the_simplex():
    """C11.H1: every step's v belongs to the corners that it names."""
    for a, b, _ in PAIRS.values():
        first, second = ConvexPolygon(a), ConvexPolygon(b)
        _, steps = gjk_trace(first, second)
        for step in steps:
            corners = [first.vertices[i] - second.vertices[j] for i, j in step.corners]
            x, y, _ = closest_point(*corners[0], *corners[-1])
            size = np.abs(corners).max()
            assert math.dist((x, y), step.closest) <= 1e-7 * size


def test_tolerance_bounds_the_error():
    random = np.random.default_rng(2)
    for _ in range(40):
        a, b = random_polygon(random), random_polygon(random)
        exact = gjk(a, b)
        if exact.overlapping:
            continue
        for tolerance in (0.1, 1e-3, 1e-6):
            early = gjk(a, b, tolerance=tolerance)
            assert exact.distance * (1 - 1e-12) <= early.distance <= exact.distance / (1 - tolerance) + 1e-12
            assert early.iterations <= exact.iterations


def test_what_does_not_fit_is_refused():
    for options, words in (
        ({"method": "guess"}, "method"),
        ({"tolerance": 1.0}, "tolerance"),
        ({"tolerance": math.nan}, "tolerance"),
        ({"limit": 0}, "limit"),
    ):
        with pytest.raises(ValueError, match=words):
            gjk(SQUARE, SQUARE, **options)


def test_minkowski_difference_holds_all_differences():
    random = np.random.default_rng(8)
    for _ in range(20):
        a, b = random_polygon(random), random_polygon(random)
        difference = ConvexPolygon(minkowski_difference(a.vertices, b.vertices))
        found = gjk(a, b)
        origin = gjk(difference, [(0.0, 0.0)])
        assert origin.distance == pytest.approx(found.distance, rel=0, abs=1e-12)
        assert len(difference) <= len(a) + len(b)
