"""What a query of two convex polygons costs: GJK and V-Clip cold and warm, beside shapely.

python -m pytest tests/benchmarks/test_narrowphase.py --benchmark-enable

Each round measures 1000 pairs that are apart; divide by 1000. The warm ones turn by 0.01 from round to round.
"""

from __future__ import annotations

import numpy as np
import pytest

from game.lab.benchmarks.narrowphase import SIZES, Workload, shapely_distances
from game.physics.narrowphase import ConvexPolygon, gjk, gjk_batch, vclip


@pytest.mark.parametrize("corners", SIZES)
@pytest.mark.parametrize("method", ["gjk-cold", "gjk-warm", "vclip-cold", "vclip"])
def test_queries(benchmark, method, corners):
    benchmark.group = f"{corners} vertices, 1000 pairs"
    found = benchmark(Workload(corners).ask, method)
    assert found.distance.min() > 0.0


@pytest.mark.parametrize("corners", SIZES)
def test_shapely(benchmark, corners):
    pytest.importorskip("shapely")
    if not benchmark.enabled:
        pytest.skip("the peer is measured only with --benchmark-enable")
    benchmark.group = f"{corners} vertices, 1000 pairs"
    work = Workload(corners)
    apart = benchmark(shapely_distances(corners))
    mine = gjk_batch(*work.sets, None, *work.poses[0]).distance
    assert np.abs(apart - mine).max() < 1e-12


@pytest.mark.parametrize("method", (gjk, vclip), ids=lambda method: method.__name__)
def test_one_query_from_python(benchmark, method):
    benchmark.group = "one query, 64 vertices"
    work = Workload(64)
    first, second = ConvexPolygon(work.points[0]), ConvexPolygon(work.points[1]).moved(2.5, 0.3, 0.2)
    found = method(first, second)
    assert benchmark(method, first, second, found).distance == pytest.approx(found.distance, abs=1e-14)
