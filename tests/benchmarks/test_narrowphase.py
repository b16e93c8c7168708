"""What a query of two convex polygons costs: GJK cold and warm, V-Clip with coherence, beside shapely.

python -m pytest tests/benchmarks/test_narrowphase.py --benchmark-enable

Each round measures 1000 pairs that are apart; divide by 1000. The warm ones turn by 0.01 from round to round.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.narrowphase import ConvexPolygon, PolygonSet, gjk, gjk_batch, vclip, vclip_batch

PAIRS, SHAPES, TURN = 1_000, 40, 0.01
SIZES = (8, 64, 512)


class Workload:
    """Pebbles in random places, none overlapping; poses for 16 rounds."""

    def __init__(self, corners):
        random = np.random.default_rng(corners)
        shapes = []
        for _ in range(SHAPES):
            turns = (np.arange(corners) + random.uniform(-0.3, 0.3, corners)) * (2.0 * math.pi / corners)
            shapes.append(np.column_stack((np.cos(turns), random.uniform(0.5, 1.0) * np.sin(turns))))
        self.points = shapes
        self.which = random.integers(0, SHAPES, (2, PAIRS))
        self.sets = [PolygonSet([shapes[k] for k in row]) for row in self.which]
        far, around = random.uniform(2.05, 4.0, PAIRS), random.uniform(0.0, 2.0 * math.pi, PAIRS)
        self.places = np.column_stack((far * np.cos(around), far * np.sin(around)))
        self.angles = random.uniform(0.0, 2.0 * math.pi, (2, PAIRS))
        self.poses = [[self.pose(k, side) for side in (0, 1)] for k in range(16)]
        self.round = 0
        self.features = np.full((PAIRS, 2), -1, dtype=np.int64)

    def pose(self, k, side):
        angles = self.angles[side] + (TURN if side else -TURN) * k
        return np.column_stack((self.places * side, np.cos(angles), np.sin(angles)))

    def next_poses(self):
        self.round += 1
        k = self.round % 30
        return self.poses[k if k < 16 else 30 - k]

    def world(self, k):
        poses = self.poses[k]
        return [
            [
                np.array(self.points[which]) @ np.array([[c, s], [-s, c]]) + (x, y)
                for which, (x, y, c, s) in zip(self.which[side], poses[side].tolist(), strict=True)
            ]
            for side in (0, 1)
        ]


@pytest.mark.parametrize("corners", SIZES)
def test_gjk_cold(benchmark, corners):
    benchmark.group = f"{corners} vertices, 1000 pairs"
    work = Workload(corners)

    def cold():
        work.features[:] = -1
        return gjk_batch(*work.sets, None, *work.next_poses(), work.features)

    found = benchmark(cold)
    assert found.distance.min() > 0.0


@pytest.mark.parametrize("corners", SIZES)
def test_gjk_warm(benchmark, corners):
    benchmark.group = f"{corners} vertices, 1000 pairs"
    work = Workload(corners)
    found = benchmark(lambda: gjk_batch(*work.sets, None, *work.next_poses(), work.features))
    assert found.distance.min() > 0.0


@pytest.mark.parametrize("corners", SIZES)
def test_vclip_with_coherence(benchmark, corners):
    benchmark.group = f"{corners} vertices, 1000 pairs"
    work = Workload(corners)
    found = benchmark(lambda: vclip_batch(*work.sets, None, *work.next_poses(), work.features))
    assert found.distance.min() > 0.0


@pytest.mark.parametrize("corners", SIZES)
def test_shapely(benchmark, corners):
    shapely = pytest.importorskip("shapely")
    if not benchmark.enabled:
        pytest.skip("the peer is measured only with --benchmark-enable")
    benchmark.group = f"{corners} vertices, 1000 pairs"
    work = Workload(corners)
    first, second = (np.array([shapely.Polygon(p) for p in side], dtype=object) for side in work.world(0))
    apart = benchmark(shapely.distance, first, second)
    mine = gjk_batch(*work.sets, None, *work.poses[0]).distance
    assert np.abs(apart - mine).max() < 1e-12


@pytest.mark.parametrize("method", (gjk, vclip), ids=lambda method: method.__name__)
def test_one_query_from_python(benchmark, method):
    benchmark.group = "one query, 64 vertices"
    work = Workload(64)
    first, second = ConvexPolygon(work.points[0]), ConvexPolygon(work.points[1]).moved(2.5, 0.3, 0.2)
    found = method(first, second)
    assert benchmark(method, first, second, found).distance == pytest.approx(found.distance, abs=1e-14)
