"""Sweep and prune: swaps are inversions, and sorting again gives what swapping gives."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.physics.broadphase import HashedPairs, MatrixPairs, SweepAndPrune
from game.physics.broadphase.endpoints import merge_sort
from game.physics.broadphase.workloads import MEAN_COSINE_DIFFERENCE, expected_swaps, make_boxes


def inversions(values) -> int:
    """Pairs in the wrong order, counted one by one."""
    return sum(int((np.asarray(values[:i]) > value).sum()) for i, value in enumerate(values))


@given(st.lists(st.one_of(st.integers(-3, 3).map(float), st.floats(-1e9, 1e9)), max_size=120))
def test_merge_sort_counts_the_inversions(numbers):
    assert swaps_of_merge_sort(numbers) == inversions(numbers)


@given(st.lists(st.integers(0, 9).map(float), max_size=90))
def test_merge_sort_counts_the_inversions_of_an_order_that_is_nearly_right(shifts):
    numbers = [i + shift for i, shift in enumerate(shifts)]
    assert swaps_of_merge_sort(numbers) == inversions(numbers)


def swaps_of_merge_sort(numbers) -> int:
    """What it counts; values and codes are in order then, and equal ones in the order they had."""
    values, codes = np.array(numbers, dtype=float), np.arange(len(numbers), dtype=np.int32)
    spare = values.copy(), codes.copy()
    swaps = merge_sort(values, codes, len(numbers), *spare)
    assert values.tolist() == sorted(numbers)
    assert np.asarray(numbers)[codes].tolist() == values.tolist()
    ties = values[1:] == values[:-1]
    assert (codes[1:] > codes[:-1])[ties].all()
    return swaps


@pytest.mark.parametrize("resort", [True, False])
def test_swaps_of_a_step_are_the_inversions_of_the_order_before(resort):
    generator = np.random.default_rng(1)
    sap = SweepAndPrune(resort=resort)
    lowers = generator.random((90, 2))
    ids = sap.add_boxes(lowers, lowers + 0.1)
    for spread in (0.001, 0.01, 0.1, 3.0, 30.0):
        order = [sap.end_points(axis) for axis in range(2)]
        lowers = lowers + generator.standard_normal((90, 2)) * spread
        uppers = lowers + 0.1
        expected = sum(
            inversions(np.where(upper, uppers[who, axis], lowers[who, axis]))
            for axis, (_, who, upper) in enumerate(order)
        )
        before = sap.swaps
        sap.update_boxes(ids, lowers, uppers)
        assert sap.swaps - before == expected
        sap.check()
    assert (sap.resorts > 0) == resort


def test_the_step_after_a_leap_is_sorted_at_once_until_boxes_are_calm_again():
    generator = np.random.default_rng(8)
    n = 400
    sap, swapping = SweepAndPrune(), SweepAndPrune(resort=False)
    lowers = generator.random((n, 2))
    for phase in (sap, swapping):
        ids = phase.add_boxes(lowers, lowers + 0.02)
    for spread, again in ((3.0, 1), (3.0, 2), (1e-5, 3), (1e-5, 3), (3.0, 4)):
        lowers = lowers + generator.standard_normal((n, 2)) * spread
        for phase in (sap, swapping):
            phase.update_boxes(ids, lowers, lowers + 0.02)
        assert sap.resorts == again
        assert sap.swaps == swapping.swaps
        assert np.array_equal(sap.pairs(), swapping.pairs())
        events = [phase.manager.take_events() for phase in (sap, swapping)]
        assert all(np.array_equal(mine, other) for mine, other in zip(*events, strict=True))
        sap.check()
    assert swapping.resorts == 0


def test_one_box_moved_by_itself_swaps_as_often_as_in_a_bulk_update():
    generator = np.random.default_rng(12)
    lowers = generator.random((60, 2))
    sizes = np.full((60, 2), 0.1)
    single, bulk = SweepAndPrune(), SweepAndPrune()
    ids = bulk.add_boxes(lowers, lowers + sizes)
    single.add_boxes(lowers, lowers + sizes)
    for box in (0, 59, 7, 7, 30, 31, 32):
        lowers[box] = generator.random(2) * 1.5 - 0.25
        sizes[box] = generator.random(2) * 0.5
        single.update_box(box, lowers[box], lowers[box] + sizes[box])
        bulk.update_boxes(ids, lowers, lowers + sizes)
        assert single.swaps == bulk.swaps
        assert np.array_equal(single.pairs(), bulk.pairs())
    assert bulk.swaps > 200


def test_the_mean_number_of_swaps_is_as_derived():
    angles = np.random.default_rng(2).random((2, 1_000_000)) * 2.0 * math.pi
    difference = np.abs(np.cos(angles[0]) - np.cos(angles[1]))
    assert abs(difference.mean() - MEAN_COSINE_DIFFERENCE) < 4.0 * difference.std() / 1000.0
    n, step, frames = 1000, 2e-4, 40
    boxes = make_boxes("equal", n, np.random.default_rng(4), fill=0.1, speed=step)
    sap = SweepAndPrune()
    ids = sap.add_boxes(boxes.lowers, boxes.uppers)
    counts = []
    for frame in range(1, frames + 1):
        before = sap.swaps
        shift = frame * boxes.velocities
        sap.update_boxes(ids, boxes.lowers + shift, boxes.uppers + shift)
        counts.append(sap.swaps - before)
    assert math.isclose(expected_swaps(n, step), 648.455575310962, rel_tol=1e-12)
    # successive frames of one motion are correlated: the sample counts as one tenth of its frames
    assert abs(np.mean(counts) - expected_swaps(n, step)) < 4.0 * np.std(counts) / math.sqrt(frames / 10)


def test_events_come_from_the_manager():
    sap = SweepAndPrune(MatrixPairs(10))
    a, b = sap.add_box((0, 0), (1, 1)), sap.add_box((2, 0), (3, 1))
    assert [len(events) for events in sap.manager.take_events()] == [0, 0]
    sap.update_box(a, (1.5, 0), (2.5, 1))
    assert sap.manager.take_events().begun.tolist() == [[a, b]]
    sap.update_box(a, (0, 0), (1, 1))
    sap.update_box(a, (1.5, 0), (2.5, 1))
    assert [len(events) for events in sap.manager.take_events()] == [0, 0]
    sap.remove_box(b)
    assert sap.manager.take_events().ended.tolist() == [[a, b]]


def test_a_pair_manager_that_is_in_use_or_too_small_is_refused():
    used = HashedPairs()
    used.add(0, 1)
    with pytest.raises(ValueError, match="empty pair manager"):
        SweepAndPrune(used)
    sap = SweepAndPrune(MatrixPairs(3))
    sap.add_boxes(np.zeros((3, 2)), np.ones((3, 2)))
    with pytest.raises(ValueError, match="takes at most 3 ids"):
        sap.add_box((0, 0), (1, 1))
    assert len(sap) == 3
    sap.check()


def test_more_changes_than_fit_the_notes_are_handed_on_in_parts():
    n = 300
    sap = SweepAndPrune(resort=False)
    x = np.arange(n, dtype=float)[:, None] * 10.0
    ids = sap.add_boxes(np.hstack([x, x * 0.0]), np.hstack([x + 1.0, x * 0.0 + 1.0]))
    assert len(sap.pairs()) == 0
    sap.update_boxes(ids, np.zeros((n, 2)), np.ones((n, 2)))
    assert len(sap.pairs()) == n * (n - 1) // 2
    sap.update_boxes(ids, np.hstack([-x, x * 0.0]), np.hstack([1.0 - x, x * 0.0 + 1.0]))
    assert len(sap.pairs()) == 0
    sap.check()


@pytest.mark.parametrize("resort", [True, False])
def test_few_boxes_are_moved_one_by_one_to_the_same_pairs(resort):
    """Far fewer than all: each is moved by itself; the pairs are those of sweeping again."""
    generator = np.random.default_rng(4)
    lowers = generator.random((400, 2)) * 10.0
    sap = SweepAndPrune(resort=resort)
    ids = sap.add_boxes(lowers, lowers + 0.5)
    for _ in range(5):
        chosen = generator.choice(400, 3, replace=False)
        lowers[chosen] += generator.uniform(-1.0, 1.0, (3, 2))
        sap.update_boxes(ids[chosen], lowers[chosen], lowers[chosen] + 0.5)
        again = SweepAndPrune()
        again.add_boxes(lowers, lowers + 0.5)
        assert np.array_equal(sap.pairs(), again.pairs())
        sap.check()
    before = sap.pairs()
    for call, message in (
        (lambda: sap.update_boxes(ids[:2], lowers[:1], lowers[:1] + 0.5), "ids: 2 ids for 1 boxes"),
        (lambda: sap.update_boxes([401], lowers[:1], lowers[:1] + 0.5), "401"),
        (lambda: sap.update_boxes(ids[:1], lowers[:1], lowers[:1] - 0.5), "upper|lower"),
    ):
        with pytest.raises(ValueError, match=message):
            call()
    assert np.array_equal(sap.pairs(), before)


def test_another_manager_takes_over_the_pairs_without_events():
    lowers = np.array([(0.0, 0.0), (0.5, 0.5), (5.0, 5.0)])
    sap = SweepAndPrune(HashedPairs())
    ids = sap.add_boxes(lowers, lowers + 1.0)
    matrix = MatrixPairs(8)
    sap.use_manager(matrix)
    assert sap.pairs().tolist() == matrix.pairs().tolist() == [[0, 1]]
    begun, ended = matrix.take_events()
    assert len(begun) == len(ended) == 0
    sap.update_box(int(ids[2]), (1.5, 1.5), (2.0, 2.0))
    assert sap.pairs().tolist() == [[0, 1], [1, 2]]
    for useless in (matrix, MatrixPairs(2)):
        with pytest.raises(ValueError, match="an empty pair manager for 3 ids"):
            sap.use_manager(useless)
