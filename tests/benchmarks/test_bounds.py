"""What bounding volumes cost: building, querying, against shapely in one run.

python -m pytest tests/benchmarks/test_bounds.py --benchmark-enable
"""

from __future__ import annotations

import pytest

from game.lab.benchmarks.bounds import (
    APART,
    PLACES,
    SEGMENTS,
    coast,
    coast_query,
    overlaps,
    shapely_box,
    shapely_distance,
    shapely_meetings,
)
from game.physics.bounds import FITS, KINDS, build_tree, minimal_obb, nearest


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


@pytest.mark.parametrize("coherent", [False, True], ids=["anew", "with a front"])
@pytest.mark.parametrize("kind", KINDS)
def test_query(benchmark, kind, coherent):
    benchmark.group = "64 queries of two coasts of 1024 segments that touch"
    query = coast_query(kind)
    benchmark.extra_info["volume tests"] = benchmark(overlaps, query, coherent)
    query.check()


def test_query_with_shapely(benchmark):
    """The peer answers whether prepared outlines meet at all, which is less."""
    pytest.importorskip("shapely")
    benchmark.group = "64 queries of two coasts of 1024 segments that touch"
    theirs = benchmark(shapely_meetings())
    query = coast_query("obb")
    for place, meets in zip(PLACES, theirs, strict=True):
        query.run(place)
        assert (query.crossing_count > 0) == meets


@pytest.mark.parametrize("kind", KINDS)
def test_nearest(benchmark, kind):
    benchmark.group = "distance of two coasts of 1024 segments"
    query = coast_query(kind)
    found = benchmark(nearest, query.tree_a, query.tree_b, APART)
    assert found.distance > 0.0


def test_nearest_with_shapely(benchmark):
    pytest.importorskip("shapely")
    benchmark.group = "distance of two coasts of 1024 segments"
    distance = benchmark(shapely_distance())
    query = coast_query("obb")
    assert nearest(query.tree_a, query.tree_b, APART).distance == pytest.approx(distance, rel=1e-9)


def test_minimal_box(benchmark):
    benchmark.group = "least box of 1024 points"
    assert benchmark(minimal_obb, coast(1)).area > 0.0


def test_minimal_box_with_shapely(benchmark):
    pytest.importorskip("shapely")
    benchmark.group = "least box of 1024 points"
    assert benchmark(shapely_box()).area == pytest.approx(minimal_obb(coast(1)).area, rel=1e-9)
