"""Neighbours: three searches against the naive one, in whatever order particles come."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from game.physics.particle_fluids import SEARCHES, NeighbourSearch


def naive(place, support):
    count = len(place)
    pairs = set()
    for i in range(count):
        for j in range(i + 1, count):
            dx, dy = place[i] - place[j]
            if dx * dx + dy * dy < support * support:
                pairs.add((i, j))
    return pairs


@pytest.mark.parametrize("method", SEARCHES)
@settings(max_examples=40, deadline=None)
@given(
    st.lists(st.tuples(st.floats(-3.0, 3.0), st.floats(-3.0, 3.0)), max_size=40),
    st.floats(0.05, 2.0),
)
def test_a_search_finds_the_naive_pairs(method, points, support):
    place = np.array(points, dtype=np.float64).reshape(-1, 2)
    search = NeighbourSearch(support, method)
    search.find(place)
    assert search.sets() == naive(place, support)


@pytest.mark.parametrize("method", SEARCHES)
def test_clusters_corners_and_places_far_out(method):
    random = np.random.default_rng(5)
    place = np.concatenate([
        random.uniform(0.0, 0.1, (500, 2)), np.full((3, 2), 0.05), [[1e12, 0.0], [1e12, 0.05]],
        [[-1e12, 1e12]], np.stack([np.arange(20) * 0.1, np.zeros(20)], axis=1),
    ])  # fmt: skip
    search = NeighbourSearch(0.1, method)
    for _ in range(2):  # the second time there is room
        pairs = search.find(place)
        assert search.sets() == naive(place, 0.1)
    assert pairs.start[-1] == len(naive(place, 0.1))


@pytest.mark.parametrize("method", SEARCHES)
def test_pairs_know_their_gap_and_direction(method):
    place = np.random.default_rng(6).uniform(0.0, 1.0, (200, 2))
    search = NeighbourSearch(0.2, method)
    pairs = search.find(place)
    first = np.repeat(np.arange(200), np.diff(pairs.start))
    apart = search.place[first] - search.place[pairs.other[: len(first)]]
    assert pairs.gap[: len(first), None] * pairs.unit[: len(first)] == pytest.approx(apart, abs=1e-15)
    assert np.array_equal(search.place, place[search.order])
    assert sorted(search.order.tolist()) == list(range(200))


def test_what_is_refused():
    for support in (0.0, -1.0, float("nan"), float("inf"), 1e-320):
        with pytest.raises(ValueError, match="support"):
            NeighbourSearch(support)
    with pytest.raises(ValueError, match="method"):
        NeighbourSearch(1.0, "tree")
    with pytest.raises(ValueError, match="particle 1 is at"):
        NeighbourSearch(1.0).find(np.array([[0.0, 0.0], [np.nan, 0.0]]))
