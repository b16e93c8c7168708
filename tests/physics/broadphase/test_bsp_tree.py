"""The semi-adjusting BSP tree: what moves a little costs nothing, what leans is cut anew when that pays."""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.broadphase import BspTree
from game.physics.broadphase.workloads import WORKLOADS, make_boxes
from tests.physics.broadphase.all_phases import brute_pairs


def tree_of(kind: str = "equal", count: int = 400, seed: int = 1):
    boxes = make_boxes(kind, count, np.random.default_rng(seed), (10.0, 10.0), 0.375, 1.0)
    tree = BspTree()
    ids = tree.add_boxes(boxes.lowers, boxes.uppers)
    tree.pairs()
    return tree, ids, boxes


def depth_of(tree: BspTree) -> int:
    """The deepest leaf, found from the outside: by how often the parts halve."""
    parts = tree.leaves()
    finite = np.clip(parts[:, :4], -1.0, 11.0)
    areas = (finite[:, 2] - finite[:, 0]) * (finite[:, 3] - finite[:, 1])
    return int(np.ceil(np.log2(144.0 / areas.min())))


@pytest.mark.parametrize("kind", WORKLOADS)
def test_pairs_and_parts_on_every_workload_in_motion(kind):
    tree, ids, boxes = tree_of(kind, 300)
    center = boxes.centers.copy()
    for step in range(12):
        center = center + 0.05 * boxes.velocities * (1.0 + step)
        low, high = center - boxes.half_sizes, center + boxes.half_sizes
        tree.update_boxes(ids, low, high)
        assert np.array_equal(tree.pairs(), brute_pairs(ids, low, high))
        tree.check()


def test_leaves_cover_the_plane_and_hold_few():
    tree, _, _ = tree_of(count=1000)
    parts = tree.leaves()
    points = np.random.default_rng(2).uniform(-3.0, 13.0, (500, 2))
    inside = (
        (parts[:, None, 0] <= points[:, 0]) & (points[:, 0] < parts[:, None, 2])
        & (parts[:, None, 1] <= points[:, 1]) & (points[:, 1] < parts[:, None, 3])
    )  # fmt: skip
    assert np.all(inside.sum(axis=0) == 1)
    assert parts[:, 4].max() <= 20 and 60 < len(parts) < 500


def test_a_box_that_stays_between_the_cuts_costs_nothing_and_one_that_crosses_is_put_in_anew():
    tree, ids, boxes = tree_of()
    before = tree.work
    tree.update_boxes(ids, boxes.lowers + 1e-9, boxes.uppers + 1e-9)
    tree.pairs()
    assert tree.work.repairs - before.repairs < 5  # only one that lies on a cut may cross it
    far = boxes.lowers.copy()
    far[7] = (20.0, 20.0)
    tree.update_boxes(ids, far, far + boxes.uppers - boxes.lowers)
    assert 1 <= tree.work.repairs - before.repairs < 10
    assert tree.query_point((20.0, 20.0)).tolist() == [7]
    tree.check()


def test_a_swarm_that_gathers_has_its_part_cut_anew_in_time_but_not_at_once():
    tree, ids, boxes = tree_of(count=800)
    half = np.full((800, 2), 0.01)
    start, goal = boxes.centers, 1.0 + 0.08 * boxes.centers  # all draw together into one corner
    moved = []
    for step in range(200):
        part = min(step / 60.0, 1.0)
        center = (1.0 - part) * start + part * goal
        tree.update_boxes(ids, center - half, center + half)
        assert np.array_equal(tree.pairs(), brute_pairs(ids, center - half, center + half)) or step % 20
        moved.append(tree.work.moved)
    assert moved[5] == 0  # a lean that has just begun does not pay
    assert 800 <= moved[-1] < 40 * 800  # it was cut anew, and not in every step
    assert moved[-1] == moved[-20]  # then it is at rest
    assert depth_of(tree) < 30
    tree.check()


def test_leaves_that_empty_are_merged():
    tree, ids, _ = tree_of(count=600)
    many = len(tree.leaves())
    tree.remove_boxes(ids[20:])
    tree.pairs()
    for _ in range(12):
        tree.update_boxes(ids[:20], *(np.array([tree.box(i)[k] for i in ids[:20]]) for k in (0, 1)))
        tree.pairs()
    assert tree.work.merges > 0 and len(tree.leaves()) < many / 4
    tree.check()


def test_boxes_that_all_lie_on_each_other_end_in_one_leaf():
    tree = BspTree()
    tree.add_boxes(np.zeros((60, 2)), np.ones((60, 2)))
    assert len(tree.pairs()) == 60 * 59 // 2
    assert len(tree.leaves()) == 1
    tree.check()


def test_churn_does_not_use_up_more_and_more_room():
    tree, ids, boxes = tree_of(count=300)
    rng = np.random.default_rng(3)
    sizes = boxes.uppers - boxes.lowers
    for _ in range(20):
        low = rng.uniform(0.0, 9.0, (300, 2))
        tree.update_boxes(ids, low, low + sizes)
        tree.pairs()
    room = tree.memory()
    for _ in range(150):
        low = rng.uniform(0.0, 9.0, (300, 2))
        tree.update_boxes(ids, low, low + sizes)
        tree.pairs()
    assert tree.memory() <= 2 * room
    tree.check()
