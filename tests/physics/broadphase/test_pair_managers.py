"""Both pair managers against a Python set, and their events against the difference of two sets."""

from __future__ import annotations

import itertools
import random

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.physics.broadphase import HashedPairs, MatrixPairs
from game.physics.broadphase.pair_table import MASK, hash_pair, triangular_index

CAPACITY = 12


def both():
    return MatrixPairs(CAPACITY), HashedPairs()


def ordered(pairs) -> list[list[int]]:
    return sorted([min(p), max(p)] for p in pairs)


pair = st.tuples(st.integers(0, CAPACITY - 1), st.integers(0, CAPACITY - 1)).filter(lambda p: p[0] != p[1])
operation = st.one_of(
    st.tuples(st.just("add"), pair),
    st.tuples(st.just("remove"), pair),
    st.tuples(st.just("add_pairs"), st.lists(pair, max_size=30)),
    st.tuples(st.just("remove_pairs"), st.lists(pair, max_size=30)),
    st.tuples(st.just("set_pairs"), st.lists(pair, max_size=60)),
    st.tuples(st.just("remove_box"), st.integers(0, CAPACITY - 1)),
    st.tuples(st.just("clear")),
    st.tuples(st.just("take_events")),
)


@given(st.lists(operation, max_size=40))
def test_any_script_leaves_the_pairs_and_events_of_a_set(operations):
    managers = both()
    now: set[frozenset[int]] = set()
    before: set[frozenset[int]] = set()
    for what, *words in [*operations, ("take_events",)]:
        if what == "take_events":
            for manager in managers:
                events = manager.take_events()
                assert events.begun.tolist() == ordered(now - before)
                assert events.ended.tolist() == ordered(before - now)
            before = set(now)
        else:
            answers = {
                getattr(manager, what)(*(words[0] if what in ("add", "remove") else words))
                for manager in managers
            }
            named = frozenset(words[0]) if what in ("add", "remove") else None
            if what == "add":
                assert answers == {named not in now}
                now.add(named)
            elif what == "remove":
                assert answers == {named in now}
                now.discard(named)
            elif what == "add_pairs":
                now |= set(map(frozenset, words[0]))
            elif what == "remove_pairs":
                now -= set(map(frozenset, words[0]))
            elif what == "set_pairs":
                now = set(map(frozenset, words[0]))
            elif what == "remove_box":
                now = {p for p in now if words[0] not in p}
            else:
                now = set()
        for manager in managers:
            manager.check()
            assert manager.pairs().tolist() == ordered(now)
            assert len(manager) == len(now)
            assert all(
                (tuple(p) in manager) == (frozenset(p) in now)
                for p in itertools.combinations(range(CAPACITY), 2)
            )


def test_the_triangular_index_numbers_all_pairs_without_gap():
    n = 37
    places = [triangular_index(i, j, n) for i in range(n) for j in range(i + 1, n)]
    assert places == list(range(n * (n - 1) // 2))


@pytest.mark.parametrize("make", [lambda: MatrixPairs(5), HashedPairs])
@pytest.mark.parametrize("words", [(1, 1), (0.5, 1), ("a", 1), (True, 2), (None, 1), (0, 2**40)])
def test_what_is_no_pair_is_refused(make, words):
    manager = make()
    manager.add(0, 3)
    for call in (manager.add, manager.remove):
        with pytest.raises(ValueError):
            call(*words)
    assert words not in manager
    assert manager.pairs().tolist() == [[0, 3]]


@pytest.mark.parametrize("make", [lambda: MatrixPairs(5), HashedPairs])
@pytest.mark.parametrize("pairs", [[[1, 1]], [[0, 1], [2, 2]], [[0.5, 1.0]], [[0, 1, 2]], [[0, 2**40]]])
def test_many_pairs_are_taken_all_or_none(make, pairs):
    manager = make()
    for call in (manager.add_pairs, manager.set_pairs, manager.remove_pairs):
        with pytest.raises(ValueError):
            call(pairs)
    assert len(manager) == 0


def test_a_matrix_has_rows_for_its_ids_only():
    manager = MatrixPairs(5)
    assert manager.capacity == 5
    for words in ((0, 5), (-1, 2)):
        with pytest.raises(ValueError, match="expected ids from 0 to 4"):
            manager.add(*words)
    for capacity in (1, 0, -3, 2.5, None):
        with pytest.raises(ValueError, match="capacity"):
            MatrixPairs(capacity)
    with pytest.raises(ValueError, match=r"18\.6 GiB, at most 1"):
        MatrixPairs(100_000)


def test_a_hash_table_never_loses_a_pair_whatever_the_keys():
    generator = random.Random(4)
    lattices = [
        [(a * step, b * step) for a in range(40) for b in range(a + 1, 40)] for step in (1, 64, 1024, 65536)
    ]
    negative = [(-a, b) for a in range(1, 40) for b in range(1, 40)]
    for keys in [*lattices, negative]:
        manager = HashedPairs()
        manager.add_pairs(keys)
        assert manager.pairs().tolist() == ordered(keys)
        manager.check()
        assert manager.probes() < 2.0
        gone = set(generator.sample(keys, len(keys) // 2))
        for key in gone:
            assert manager.remove(*key)
        assert manager.pairs().tolist() == ordered(set(keys) - gone)
        manager.check()


def test_deletion_closes_the_gaps_of_colliding_chains():
    manager = HashedPairs()
    mask = int(manager.table.numbers[MASK])
    colliding = [(1, b) for b in range(2, 2000) if hash_pair(1, b) & mask in (mask, 0)][:12]
    for gone in itertools.combinations(colliding, 3):
        manager.set_pairs(colliding)
        assert len(manager.table.where) == mask + 1
        for key in gone:
            manager.remove(*key)
        manager.check()
        assert manager.pairs().tolist() == ordered(set(colliding) - set(gone))


def test_the_table_is_never_more_than_half_full_and_grows_by_doubling():
    manager = HashedPairs()
    sizes = set()
    for b in range(1, 3000):
        manager.add(0, b)
        sizes.add(len(manager.table.where))
        assert 2 * len(manager) <= len(manager.table.where)
    assert sorted(sizes) == [32 * 2**k for k in range(len(sizes))]


def test_both_managers_tell_the_same_events_while_boxes_move():
    from game.physics.broadphase import UniformGrid
    from game.physics.broadphase.workloads import make_boxes

    moving = make_boxes("equal", 200, np.random.default_rng(2), speed=0.02)
    grid = UniformGrid((0, 0), (1, 1), 0.05)
    ids = grid.add_boxes(moving.lowers, moving.uppers)
    managers = MatrixPairs(200), HashedPairs()
    begun = ended = 0
    for frame in range(50):
        grid.update_boxes(
            ids, moving.lowers + frame * moving.velocities, moving.uppers + frame * moving.velocities
        )
        events = []
        for manager in managers:
            manager.set_pairs(grid.pairs())
            events.append(manager.take_events())
        assert all(np.array_equal(a, b) for a, b in zip(*events, strict=True))
        begun += len(events[0].begun)
        ended += len(events[0].ended)
        assert begun - ended == len(managers[0]) == len(grid.pairs())
    assert ended > 100
