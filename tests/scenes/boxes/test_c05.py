"""Uniform grid and pair managers: C05.1 to C05.6."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.broadphase import CoveringGrid, HashedPairs, MatrixPairs, UniformGrid
from game.scenes.boxes.model.managers import MOST_IN_MATRIX
from game.scenes.boxes.uniform_grid import UniformGridScene
from game.stage import SetEffect, SetParameter, Stage
from tests.scenes.boxes.box_stages import brute_pairs, open_level, readouts


def test_random_boxes_have_random_velocities_and_another_seed_gives_others():
    stages = [Stage(UniformGridScene, seed=seed) for seed in (0, 0, 1)]
    same, again, other = (stage.scene.model.boxes for stage in stages)
    assert np.array_equal(same.lowers, again.lowers) and np.array_equal(same.velocities, again.velocities)
    assert not np.array_equal(same.lowers, other.lowers)
    assert len(np.unique(same.velocities[:, 0])) == 500


def test_the_grid_is_a_dense_matrix_that_follows_boxes_in_the_cell_size_asked_for():
    stage = open_level(UniformGridScene, "default")
    scene = stage.scene
    for storage, kind in (("corner", UniformGrid), ("covered", CoveringGrid)):
        stage.post(SetParameter("storage", storage))
        assert type(scene.model.grid) is kind
        for cell in (0.25, 2.0, 32.0):
            stage.post(SetParameter("cell", cell))
            stage.run(2)
            assert scene.model.grid.cell == pytest.approx(cell * scene.model.size)
            assert scene.model.grid.loads().shape == (scene.model.grid.rows, scene.model.grid.columns)
            assert scene.model.pairs.tolist() == brute_pairs(scene)
    assert scene.model.grid.columns == math.ceil(11.2 / scene.model.grid.cell)


def test_both_managers_hold_the_same_pairs_and_are_timed_side_by_side():
    stage = open_level(UniformGridScene, "default")
    scene = stage.scene
    assert isinstance(scene.model.matrix, MatrixPairs) and isinstance(scene.model.hashed, HashedPairs)
    begun = ended = 0
    first = len(scene.model.pairs)
    for _ in range(120):
        stage.run(1)
        assert np.array_equal(scene.model.matrix.pairs(), scene.model.hashed.pairs())
        assert readouts(stage)["answers differ"] == 0.0
        begun += scene.model.begun
        ended += scene.model.ended
    assert first + begun - ended == len(scene.model.pairs) == len(scene.model.hashed)
    assert begun > 50
    values = readouts(stage)
    assert all(values[name] > 0.0 for name in ("grid", "matrix", "hash"))


def test_a_manager_that_is_switched_off_costs_nothing_and_comes_back_right():
    stage = open_level(UniformGridScene, "default")
    stage.run(5)
    stage.post(SetEffect("matrix-pairs", False))
    stage.run(5)
    assert math.isnan(readouts(stage)["matrix"])
    stage.post(SetEffect("hashed-pairs", False))
    stage.run(30)
    assert (stage.scene.model.begun, stage.scene.model.ended) == (0, 0)
    stage.post(SetEffect("matrix-pairs", True))
    stage.post(SetEffect("hashed-pairs", True))
    stage.run(1)
    assert stage.scene.model.begun < 20 and readouts(stage)["answers differ"] == 0.0
    assert np.array_equal(stage.scene.model.matrix.pairs(), stage.scene.model.pairs)


def test_the_matrix_is_left_out_where_it_would_be_too_large_and_comes_back():
    stage = open_level(UniformGridScene, "default")
    stage.post(SetParameter("count", MOST_IN_MATRIX + 1))
    assert stage.scene.model.matrix is None
    stage.run(2)
    assert len(stage.scene.model.hashed) == len(stage.scene.model.pairs)
    assert math.isnan(readouts(stage)["matrix"])
    fresh = Stage(UniformGridScene, parameters={"count": MOST_IN_MATRIX})
    assert fresh.scene.model.matrix is not None and fresh.scene.model.matrix.capacity == MOST_IN_MATRIX


def test_the_matrix_grows_with_the_ids():
    stage = Stage(UniformGridScene, parameters={"count": 256})
    scene = stage.scene
    assert scene.model.matrix is not None and scene.model.matrix.capacity == 256
    before = scene.model.matrix.pairs()
    corners = -100.0 - np.repeat(np.arange(44.0)[:, None], 2, axis=1)  # apart from all others
    scene.model.add(corners, corners + 0.5, np.zeros((44, 2)))
    scene.model.pair_up()
    assert scene.model.matrix.capacity == 512
    assert np.array_equal(scene.model.matrix.pairs(), before)
    assert scene.model.compared and scene.model.same and scene.model.begun == scene.model.ended == 0


def test_a_managers_time_is_the_mean_over_both_turns_so_that_it_does_not_jump():
    scene = open_level(UniformGridScene, "default").scene
    scene.model.watch.clear()
    for _ in range(10):
        for name, seconds in (("matrix, first", 4.0), ("matrix, second", 2.0), ("hash, first", 5.0)):
            scene.model.watch.add(name, seconds)
    assert scene.model.manager_s("matrix") == 3.0 and scene.model.manager_s("hash") == 5.0
    scene.effects_changed()
    assert math.isnan(scene.model.manager_s("matrix"))


@pytest.mark.parametrize("level", ["hard-05-all-in-one-place", "default", "heap"])
def test_the_scale_of_loads_names_the_fullest_cell_if_it_is_beyond_the_end(level):
    stage = open_level(UniformGridScene, level)
    stage.run(3)
    most = int(stage.scene.model.grid.loads().max())
    (scale,) = [count for mark, _, count in stage.scene.legend() if mark.startswith("scale")]
    _, full, *beyond = scale.split(" ", 2)
    assert beyond == ([f"most {most}"] if most > float(full) else [])
    assert beyond or level != "hard-05-all-in-one-place"
