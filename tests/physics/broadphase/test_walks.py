"""What is retold of one box, or of one step, is what the structures did."""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.broadphase import (
    CoveringGrid,
    HashedPairs,
    HierarchicalGrid,
    MatrixPairs,
    SweepAndPrune,
    UniformGrid,
)
from game.physics.broadphase.walks.hash import DOWN, OWN, UP
from game.physics.broadphase.walks.swap import ALIKE, BEGINS, walk_swaps
from game.physics.broadphase.workloads import make_boxes


def boxes_of(kind, count, seed, fill=0.3):
    made = make_boxes(kind, count, np.random.default_rng(seed), (8.0, 6.0), fill, ratio=9.0, share=0.1)
    return made.lowers, made.uppers


def hits(phase, box, candidates):
    x0, y0, x1, y1 = phase.boxes[box]
    low_x, low_y, high_x, high_y = phase.boxes[list(candidates)].reshape(-1, 4).T
    meet = (low_x <= x1) & (x0 <= high_x) & (low_y <= y1) & (y0 <= high_y)
    return (
        {(min(box, c), max(box, c)) for c in np.array(candidates)[meet].tolist()}
        if len(candidates)
        else set()
    )


@pytest.mark.parametrize("kind", ["equal", "heavy-tail", "clustered", "line"])
@pytest.mark.parametrize(
    "make",
    [
        lambda: UniformGrid((0.0, 0.0), (8.0, 6.0), 2.0),
        lambda: UniformGrid((0.0, 0.0), (8.0, 6.0), 0.15),
        lambda: HierarchicalGrid(),
        lambda: HierarchicalGrid(8),
    ],
    ids=["near", "far", "ratio 2", "ratio 8"],
)
def test_the_candidates_of_all_boxes_are_the_tests_made_and_hold_every_pair_once(kind, make):
    phase = make()
    phase.add_boxes(*boxes_of(kind, 60, 3))
    phase.remove_boxes([4, 17, 59])
    pairs = {tuple(pair) for pair in phase.pairs().tolist()}
    told, tests = [], 0
    for box in phase.ids().tolist():
        for visit in phase.visits(box):
            tests += len(visit.candidates)
            told += hits(phase, box, visit.candidates)
    assert tests == phase.tests
    assert set(told) == pairs
    if not (isinstance(phase, HierarchicalGrid)):  # rows that share a bucket hit twice; one is not kept
        assert len(told) == len(pairs)


def test_in_a_covering_grid_each_test_is_told_by_both_boxes_and_cells_are_those_covered():
    grid = CoveringGrid((0.0, 0.0), (8.0, 6.0), 0.4)
    grid.add_boxes(*boxes_of("heavy-tail", 40, 5))
    grid.pairs()
    visits = {box: grid.visits(box) for box in grid.ids().tolist()}
    assert sum(len(v.candidates) for list_ in visits.values() for v in list_) == 2 * grid.tests
    for box, list_ in visits.items():
        assert [v.cells[0] for v in list_] == grid.cells_of(box)


def test_hierarchical_visits_go_up_or_down_and_chains_hold_every_box_once():
    grid = HierarchicalGrid()
    lowers = np.array([[0.1 * i, 0.1] for i in range(12)] + [[0.0, 0.0], [5.0, 5.0]])
    grid.add_boxes(lowers, lowers + np.array([[0.2, 0.2]] * 12 + [[0.5, 0.5]] * 2))
    down = {visit.way for visit in grid.visits(12)}
    assert down == {OWN, DOWN} and {visit.way for visit in grid.visits(0)} == {OWN}
    grid.remove_boxes(np.arange(2, 12))
    up = {visit.way for visit in grid.visits(0)}
    assert up == {OWN, UP}
    tables = grid.tables()
    for level, count in grid.levels():
        chains = tables.chains(level)
        assert sum(map(len, chains)) == count
        for bucket, chain in enumerate(chains):
            for box in chain:
                assert tables.bucket(level, *tables.cell(level, *grid.boxes[box, :2])) == bucket


def test_places_in_matrix_and_table():
    rng = np.random.default_rng(2)
    matrix, hashed = MatrixPairs(40), HashedPairs()
    pairs = {tuple(sorted(rng.choice(40, 2, replace=False).tolist())) for _ in range(90)}
    for manager in (matrix, hashed):
        manager.add_pairs(np.array(sorted(pairs)))
    triangle = [(i, j) for i in range(40) for j in range(i + 1, 40)]
    looks = []
    for pair in pairs:
        assert triangle[matrix.place(*reversed(pair))] == pair
        chain = hashed.chain(*pair)
        slots = [int(hashed.table.where[place]) - 1 for place in chain]
        assert all(slot >= 0 for slot in slots)
        found = [tuple(hashed.table.slots[slot, :2].tolist()) for slot in slots]
        assert found[-1] == pair and pair not in found[:-1]
        looks.append(len(chain))
    assert np.mean(looks) == pytest.approx(hashed.probes())
    absent = next(pair for pair in triangle if pair not in pairs)
    assert hashed.table.where[hashed.chain(*absent)[-1]] == 0
    with pytest.raises(ValueError, match="a box makes no pair with itself"):
        hashed.chain(3, 3)


@pytest.mark.parametrize("seed", range(4))
def test_swaps_one_by_one_are_as_many_as_counted_and_lead_to_the_events(seed):
    rng = np.random.default_rng(seed)
    lowers, uppers = boxes_of("equal", 24, seed, fill=0.6)
    sap = SweepAndPrune(resort=False)
    ids = sap.add_boxes(lowers, uppers)
    sap.pairs()
    sap.manager.take_events()
    for _ in range(12):
        before = {tuple(pair) for pair in sap.pairs().tolist()}
        ends = [[part.tolist() for part in sap.end_points(axis)[1:]] for axis in range(2)]
        count = sap.swaps
        step = rng.normal(0.0, 0.2, lowers.shape)
        lowers, uppers = lowers + step, uppers + step
        sap.update_boxes(ids, lowers, uppers)
        swaps = [
            swap
            for axis in range(2)
            for swap in walk_swaps(list(zip(*ends[axis], strict=True)), sap.boxes.tolist(), axis)
        ]
        assert len(swaps) == sap.swaps - count
        now = set(before)
        for swap in swaps:
            pair = (min(swap.mover, swap.other), max(swap.mover, swap.other))
            if swap.result == BEGINS:
                now.add(pair)
            elif swap.result != ALIKE and swap.mover_upper:
                now.discard(pair)
        assert now == {tuple(pair) for pair in sap.pairs().tolist()}
