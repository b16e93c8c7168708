"""Detection among 20,100 triangles with self-collision; run with ``--benchmark-enable``. Goal: below 5 ms.

Beside it scipy's k-d tree (build, and for each triangle the vertices within its circle): candidates alone, of
which none is tested yet.
"""

from __future__ import annotations

import numpy as np
import pytest

from game.lab.studies.deformables import pile_of
from game.physics.deformables import MeshCollider, mean_edge

BLOBS, RINGS, TABLE = 134, 5, 65_521


def _pile(benchmark):
    return pile_of(BLOBS, RINGS) if benchmark.enabled else pile_of(6, 3)


@pytest.mark.parametrize("cell", [0.5, 1.0, 2.0])
def test_a_detection(benchmark, cell):
    store, points = _pile(benchmark)
    collider = MeshCollider(store, cell * mean_edge(store, points), TABLE)
    benchmark(collider.find, points)
    benchmark.extra_info["contacts"] = len(collider.contact_keys)
    assert len(collider.contact_keys) > 10 and len(collider.crossing_keys) > 10


def test_candidates_of_a_tree(benchmark):
    tree = pytest.importorskip("scipy.spatial").cKDTree
    store, points = _pile(benchmark)
    corners = store.topology.triangles

    def candidates():
        places = points[corners]
        middles = places.mean(axis=1)
        far = np.sqrt(((places - middles[:, None]) ** 2).sum(axis=2)).max(axis=1)
        return tree(points).query_ball_point(middles, far)

    assert len(benchmark(candidates)) == len(corners)
