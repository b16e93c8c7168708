"""What bounding volumes cost: building, querying, against shapely in one run.

python -m pytest tests/benchmarks/test_bounds.py --benchmark-enable
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.bounds import FITS, KINDS, Query, build_tree, minimal_obb, nearest

SEGMENTS = 1024


def coast(seed, segments=SEGMENTS):
    """A closed rough line."""
    rng = np.random.default_rng(seed)
    angle = 2 * np.pi * np.arange(segments) / segments
    radius = np.ones(segments)
    for k in range(2, 60):
        radius += 0.25 / k * rng.uniform(0.3, 1) * np.sin(k * angle + rng.uniform(0, 7))
    return radius[:, None] * np.column_stack((np.cos(angle), np.sin(angle)))


@pytest.mark.parametrize("fit", FITS)
@pytest.mark.parametrize("kind", KINDS)
def test_build(benchmark, kind, fit):
    benchmark.group = "tree over 1024 segments, one in a leaf"
    points = coast(1)
    tree = benchmark(build_tree, points, kind, 1, closed=True, fit=fit)
    assert len(tree) == 2 * SEGMENTS - 1


@pytest.mark.parametrize("leaf_size", [1, 4, 16])
def test_build_with_larger_leaves(benchmark, leaf_size):
    benchmark.group = "tree over 1024 segments, by the size of a leaf"
    tree = benchmark(build_tree, coast(1), "obb", leaf_size, closed=True)
    assert tree.segments == SEGMENTS


def pair(kind, fit="search"):
    a, b = (build_tree(coast(seed), kind, 2, closed=True, fit=fit) for seed in (1, 2))
    return Query(a, b)


PLACES = [(1.9 + 0.2 * math.cos(0.02 * i), 0.2 * math.sin(0.02 * i)) for i in range(64)]


@pytest.mark.parametrize("coherent", [False, True], ids=["anew", "with a front"])
@pytest.mark.parametrize("kind", KINDS)
def test_query(benchmark, kind, coherent):
    benchmark.group = "64 queries of two coasts of 1024 segments that touch"
    query = pair(kind)

    def ask():
        tests = 0
        for place in PLACES:
            query.run(place, coherent=coherent)
            tests += query.volume_tests
        return tests

    benchmark.extra_info["volume tests"] = benchmark(ask)
    query.check()


def test_query_with_shapely(benchmark):
    """The peer answers whether prepared outlines meet at all, which is less."""
    shapely = pytest.importorskip("shapely")
    benchmark.group = "64 queries of two coasts of 1024 segments that touch"
    a, b = (shapely.LinearRing(coast(seed)) for seed in (1, 2))
    shapely.prepare(a)
    moved = [shapely.transform(b, lambda xy, place=place: xy + place) for place in PLACES]

    def ask():
        return [bool(shapely.intersects(a, other)) for other in moved]

    theirs = benchmark(ask)
    query = pair("obb")
    for place, meets in zip(PLACES, theirs, strict=True):
        query.run(place)
        assert (query.crossing_count > 0) == meets


@pytest.mark.parametrize("kind", KINDS)
def test_nearest(benchmark, kind):
    benchmark.group = "distance of two coasts of 1024 segments"
    query = pair(kind)
    found = benchmark(nearest, query.tree_a, query.tree_b, (3.0, 0.4))
    assert found.distance > 0.0


def test_nearest_with_shapely(benchmark):
    shapely = pytest.importorskip("shapely")
    benchmark.group = "distance of two coasts of 1024 segments"
    a, b = shapely.LinearRing(coast(1)), shapely.LinearRing(coast(2) + np.array((3.0, 0.4)))
    distance = benchmark(shapely.distance, a, b)
    query = pair("obb")
    assert nearest(query.tree_a, query.tree_b, (3.0, 0.4)).distance == pytest.approx(distance, rel=1e-9)


def test_minimal_box(benchmark):
    benchmark.group = "least box of 1024 points"
    assert benchmark(minimal_obb, coast(1)).area > 0.0


def test_minimal_box_with_shapely(benchmark):
    shapely = pytest.importorskip("shapely")
    benchmark.group = "least box of 1024 points"
    points = coast(1)
    found = benchmark(lambda: shapely.minimum_rotated_rectangle(shapely.MultiPoint(points)))
    assert found.area == pytest.approx(minimal_obb(points).area, rel=1e-9)
