"""Hierarchical grids beside the naive method: C06.1 to C06.6."""

from __future__ import annotations

import math

import numpy as np

from game.physics.broadphase import HashedPairs, HierarchicalGrid, MatrixPairs, NaiveBroadPhase, UniformGrid
from game.scenes.boxes.hierarchical_grids import HierarchicalGridScene
from game.scenes.boxes.level import HEIGHT, WIDTH
from game.scenes.boxes.model.compared import MOST_NAIVE
from game.stage import SetEffect, SetParameter, Stage
from tests.scenes.boxes.box_stages import brute_pairs, click, open_level, readouts


def test_naive_and_hierarchical_find_the_same_and_are_timed():
    stage = open_level(HierarchicalGridScene, "default")
    scene = stage.scene
    assert isinstance(scene.model.grid, HierarchicalGrid) and isinstance(scene.model.naive, NaiveBroadPhase)
    for _ in range(60):
        stage.run(1)
        assert scene.model.compared and scene.model.same
    assert scene.model.pairs.tolist() == brute_pairs(scene)
    assert scene.model.naive.tests == 500 * 499 // 2 > scene.model.grid.tests
    values = readouts(stage)
    assert values["hierarchical"] > 0.0 and values["naive"] > 0.0


def test_with_half_of_the_boxes_large_one_grid_for_these_makes_fewer_tests():
    scene = open_level(HierarchicalGridScene, "half-large").scene
    sizes = scene.model.boxes.uppers - scene.model.boxes.lowers
    one = UniformGrid((0.0, 0.0), (WIDTH, HEIGHT), float(sizes.max()))
    one.add_boxes(scene.model.boxes.lowers, scene.model.boxes.uppers)
    assert one.pairs().tolist() == scene.model.pairs.tolist()
    assert one.tests < scene.model.grid.tests


def test_levels_follow_the_sizes():
    stage = open_level(HierarchicalGridScene, "default")
    assert [count for _, count in stage.scene.model.grid.levels()] == [495, 5]
    stage.post(SetParameter("ratio", 1.0))
    assert [count for _, count in stage.scene.model.grid.levels()] == [500]
    stage.post(SetParameter("ratio", 20.0))
    stage.post(SetParameter("step_ratio", "16"))
    assert stage.scene.model.grid.ratio == 16
    stage.run(3)
    assert stage.scene.model.pairs.tolist() == brute_pairs(stage.scene)


def test_pairs_are_kept_in_the_manager_asked_for():
    stage = open_level(HierarchicalGridScene, "default")
    assert isinstance(stage.scene.model.keeper, MatrixPairs)
    stage.run(3)
    stage.post(SetParameter("manager", "hash"))
    assert isinstance(stage.scene.model.keeper, HashedPairs)
    stage.run(3)
    assert np.array_equal(stage.scene.model.keeper.pairs(), stage.scene.model.pairs)
    stage.post(SetParameter("manager", "matrix"))
    stage.post(SetParameter("count", 4097))
    assert isinstance(stage.scene.model.keeper, HashedPairs)


def test_the_naive_way_is_left_out_where_it_would_take_too_long_or_is_switched_off():
    stage = open_level(HierarchicalGridScene, "default")
    stage.run(2)
    stage.post(SetEffect("naive-pairs", False))
    stage.run(1)
    assert not stage.scene.model.compared and math.isnan(readouts(stage)["naive"])
    stage.post(SetEffect("naive-pairs", True))
    click(stage, (5.0, 4.0))
    stage.run(1)
    assert stage.scene.model.compared and len(stage.scene.model.naive) == len(stage.scene.model.boxes.ids)
    large = Stage(HierarchicalGridScene, parameters={"count": MOST_NAIVE + 1})
    large.run(1)
    assert not large.scene.model.compared


def test_a_growing_box_changes_levels_and_keeps_its_pairs():
    stage = open_level(HierarchicalGridScene, "hard-04-growing")
    levels = set()
    for _ in range(12):
        stage.run(40)
        levels.add(stage.scene.model.grid.level(0))
        assert stage.scene.model.same and stage.scene.model.pairs.tolist() == brute_pairs(stage.scene)
    assert len(levels) >= 4
