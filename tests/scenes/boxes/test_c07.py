"""Sweep and prune beside the naive method: C07.1 to C07.6."""

from __future__ import annotations

import numpy as np

from game.physics.broadphase import HashedPairs, MatrixPairs
from game.scenes.boxes.sweep_and_prune import SweepAndPruneScene
from game.stage import SetParameter, Stage
from tests.scenes.boxes.box_stages import brute_pairs, open_level, readouts


def test_naive_and_sweep_find_the_same_in_every_step():
    stage = open_level(SweepAndPruneScene, "default")
    for _ in range(60):
        stage.run(1)
        assert stage.scene.model.compared and stage.scene.model.same
    assert stage.scene.model.pairs.tolist() == brute_pairs(stage.scene)
    stage.scene.model.sap.check()


def test_swaps_of_a_step_are_shown_beside_their_mean():
    stage = Stage(SweepAndPruneScene, parameters={"count": 600, "speed": 0.3})
    swaps, means = [], []
    for _ in range(60):
        stage.run(1)
        values = readouts(stage)
        swaps.append(values["swaps"])
        means.append(values["mean"])
    assert len(set(means)) == 1
    # successive steps of one motion are correlated: the sample counts as one sixth of its steps
    assert abs(np.mean(swaps) - means[0]) < 4.0 * np.std(swaps) / np.sqrt(10.0)
    assert any(mask.any() for mask in stage.scene.model.swapped)


def test_at_rest_nothing_swaps():
    stage = open_level(SweepAndPruneScene, "at-rest")
    stage.run(5)
    values = readouts(stage)
    assert values["swaps"] == values["mean"] == 0.0
    assert not any(mask.any() for mask in stage.scene.model.swapped)


def test_a_leap_of_all_is_finished_by_sorting_unless_that_is_switched_off():
    stage = open_level(SweepAndPruneScene, "hard-03-all-leap")
    stage.run(4)
    assert stage.scene.model.sap.resorts == 4
    assert abs(stage.scene.model.swaps / (2 * 1000 * 999) - 1.0) < 0.1
    stage.post(SetParameter("resort", False))
    stage.run(2)
    assert stage.scene.model.sap.resorts == 0
    assert abs(stage.scene.model.swaps / (2 * 1000 * 999) - 1.0) < 0.1
    assert stage.scene.model.pairs.tolist() == brute_pairs(stage.scene)


def test_pairs_are_kept_in_a_matrix_and_in_a_hash_table_where_that_is_too_small():
    stage = Stage(SweepAndPruneScene, parameters={"count": 256, "turnover": 3})
    assert isinstance(stage.scene.model.sap.manager, MatrixPairs)
    stage.run(5)
    for _ in range(3):
        stage.scene.model.add(np.full((1, 2), 2.0), np.full((1, 2), 2.5), np.zeros((1, 2)))
    assert stage.scene.model.sap.manager.greatest == 511
    stage.run(5)
    assert stage.scene.model.pairs.tolist() == brute_pairs(stage.scene)
    stage.post(SetParameter("manager", "hash"))
    assert isinstance(stage.scene.model.sap.manager, HashedPairs)
    stage.post(SetParameter("manager", "matrix"))
    stage.post(SetParameter("count", 4097))
    assert isinstance(stage.scene.model.sap.manager, HashedPairs)


def test_a_box_that_jumps_over_another_makes_no_event():
    stage = open_level(SweepAndPruneScene, "hard-08-jumping-over")
    events = 0
    for _ in range(40):
        stage.run(1)
        events += stage.scene.model.begun + stage.scene.model.ended
        assert stage.scene.model.same
    assert readouts(stage)["swaps"] >= 0.0 and events < 200


def test_the_legend_does_not_say_that_nothing_swapped_where_marks_are_not_kept():
    stage = open_level(SweepAndPruneScene, "default")
    stage.run(40)
    shown = []
    for _ in range(4):
        shown.append((readouts(stage)["swaps"], stage.scene.legend()[-1][2]))
        assert stage.step_back()
    assert all(swaps > 0 and count != "0" for swaps, count in shown)
    assert shown[0][1] != "–" and shown[-1][1] == "–"
