"""The sorts of pairs against Python's own sort."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from game.physics.broadphase.ordering import PairSorter, sort_by_first


@given(st.lists(st.tuples(st.integers(0, 2**20), st.integers(0, 2**20)), max_size=200), st.integers(0, 10))
def test_pairs_come_out_sorted_whatever_the_greatest_id(pairs, spare_bits):
    sorter = PairSorter()
    sorter.reserve(len(pairs))
    sorter.keys[: len(pairs)] = [a << 32 | b for a, b in pairs]
    top = (max(map(max, pairs), default=0) << spare_bits) + 1
    assert sorter.sorted(len(pairs), top).tolist() == [list(pair) for pair in sorted(pairs)]


@given(st.integers(1, 40), st.integers(0, 400), st.integers(0, 1), st.integers(0, 2**32 - 1))
def test_dense_ids_are_sorted_however_many_partners_one_has(ids, count, few, seed):
    """By first ids where all have few, by digits where one has many; the same sorter again and again."""
    sorter, random = PairSorter(), np.random.default_rng(seed)
    for _ in range(2):
        pairs = random.integers(0, ids, (count, 2)) * random.integers(few, 2, (count, 1))
        sorter.reserve(count)
        sorter.keys[:count] = pairs[:, 0] << 32 | pairs[:, 1]
        assert sorter.sorted(count, ids).tolist() == sorted(pairs.tolist())


def test_one_box_with_all_the_pairs_is_no_square_of_their_number():
    """A floor under 20,000 boxes, met last first: insertion alone would move keys 10^8 times."""
    sorter, count = PairSorter(), 20_000
    sorter.reserve(count)
    sorter.keys[:count] = np.arange(count, 0, -1)
    spare, places = np.empty(count, dtype=np.int64), np.empty(count + 1, dtype=np.int32)
    assert not sort_by_first(sorter.keys, count, spare, places, np.empty((count, 2), dtype=np.int64))
    for _ in range(2):
        sorter.keys[:count] = np.arange(count, 0, -1)
        assert np.array_equal(sorter.sorted(count, count + 1)[:, 1], np.arange(1, count + 1))


def test_boxes_with_few_partners_are_sorted_by_their_first_ids():
    random, count = np.random.default_rng(5), 3_000
    pairs = random.integers(0, 2_000, (count, 2))
    keys = pairs[:, 0] << 32 | pairs[:, 1]
    spare, places = np.empty(count, dtype=np.int64), np.empty(2_000, dtype=np.int32)
    found = np.empty((count, 2), dtype=np.int64)
    assert sort_by_first(keys, count, spare, places, found)
    assert found.tolist() == sorted(pairs.tolist())


def test_greatest_ids_need_larger_counters():
    sorter = PairSorter()
    pairs = [(2**30 - 2, 2**30 - 1), (5, 2**29), (5, 2**30 - 1), (0, 1)]
    sorter.keys[:4] = [a << 32 | b for a, b in pairs]
    assert sorter.sorted(4, 2**30).tolist() == [list(pair) for pair in sorted(pairs)]
    assert sorter.memory() == 2 * 64 * 8 + 4 * 2**15 * 8 + 64 * 4 + 64 * 2 * 8
    assert np.array_equal(sorter.sorted(0, 1), np.empty((0, 2), dtype=np.int64))
