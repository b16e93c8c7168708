"""The radix sort of pairs against Python's own sort."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from game.physics.broadphase.ordering import PairSorter


@given(st.lists(st.tuples(st.integers(0, 2**20), st.integers(0, 2**20)), max_size=200), st.integers(0, 10))
def test_pairs_come_out_sorted_whatever_the_greatest_id(pairs, spare_bits):
    sorter = PairSorter()
    sorter.reserve(len(pairs))
    sorter.keys[: len(pairs)] = [a << 32 | b for a, b in pairs]
    top = (max(map(max, pairs), default=0) << spare_bits) + 1
    assert sorter.sorted(len(pairs), top).tolist() == [list(pair) for pair in sorted(pairs)]


def test_greatest_ids_need_larger_counters():
    sorter = PairSorter()
    pairs = [(2**30 - 2, 2**30 - 1), (5, 2**29), (5, 2**30 - 1), (0, 1)]
    sorter.keys[:4] = [a << 32 | b for a, b in pairs]
    assert sorter.sorted(4, 2**30).tolist() == [list(pair) for pair in sorted(pairs)]
    assert sorter.memory() == 2 * 64 * 8 + 4 * 2**15 * 8
    assert np.array_equal(sorter.sorted(0, 1), np.empty((0, 2), dtype=np.int64))
