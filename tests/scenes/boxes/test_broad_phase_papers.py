"""What the pages of P01 and P03 measure: their ideas are at work in it, and verdicts follow from figures."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.broadphase import BspTree, KineticSweep, NaiveBroadPhase
from game.scenes.boxes.papers.bsp import COUNT, JOURNEY, WAYS, journey
from game.scenes.boxes.papers.measuring import EXTENT, in_words, some_boxes, steps_of, travelling


def test_heaps_travel_as_one_and_stay_about_the_world():
    at = travelling(200, 0.5)
    (low, high), (later, _) = at(0), at(3)
    assert (high > low).all() and np.allclose(high - low, (high - low)[0, 0])
    ways = np.unique(np.round(later - low, 9), axis=0)
    assert len(ways) <= 8  # one for each heap
    far = at(5000)[0]
    assert (np.median(far, axis=0) > 0.0).all() and (np.median(far, axis=0) < EXTENT).all()


@pytest.mark.parametrize("way", WAYS)
def test_a_tree_over_heaps_that_travel_is_cut_anew_in_part_only(way):
    work = {}
    for price in (0.0, 2.0, math.inf):
        tree = BspTree(price)
        list(journey(tree, way))
        work[price] = tree.work
        naive = NaiveBroadPhase()
        naive.add_boxes(*travelling(COUNT, way)(JOURNEY))
        assert np.array_equal(tree.pairs(), naive.pairs())
        tree.check()
    assert work[math.inf].moved == 0
    assert 0 < work[2.0].moved < 0.1 * COUNT * JOURNEY  # a little of it, and not nothing
    assert work[2.0].moved < work[0.0].moved


def test_a_slab_across_the_motion_leaves_fewer_candidates_of_fast_boxes():
    boxes, _ = some_boxes("equal", 300, 16.0)
    counts = []
    for slabs in (4, 8, 16):
        sweep = KineticSweep(slabs)
        list(steps_of(sweep, boxes, False, 12))
        counts.append(sweep.candidates)
    assert counts[0] > 2 * counts[1] > 2 * counts[2]


def test_the_verdict_follows_from_the_times():
    times = {"tree": 0.5, "grid": 1.0, "sweep": 12.3}
    assert in_words(times, "tree") == (
        "tree 0.5, grid 1, sweep 12 ms: tree is the fastest, 2 × the speed of grid"
    )
    assert in_words(times, "grid").endswith("grid is number 2 of 3, 2 × the time of tree")
    assert in_words({**times, "grid": 0.52}, "grid").endswith("grid is level with tree")


def test_a_price_below_nothing_is_refused():
    with pytest.raises(ValueError, match="price"):
        BspTree(-1.0)
    with pytest.raises(ValueError, match="price"):
        BspTree(math.nan)
