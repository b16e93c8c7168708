"""Broad-phase scenes: what their words claim is so, and no accepted level ends in an error."""

from __future__ import annotations

import numpy as np
import pytest

from game.levels import LevelError, parse_level
from game.scenes.boxes.race import BroadPhaseRace
from game.scenes.boxes.uniform_grid import UniformGridScene
from game.scenes.boxes.view.column import Column
from game.stage import Choice, SetEffect, SetParameter, Stage
from tests.scenes.boxes.box_stages import SCENES, brute_pairs, drag, level_id, open_level


def stage_with(scene_type, boxes: str) -> Stage:
    text = f'scene = "{scene_type.name}"\n[content]\nboxes = [{boxes}]\n'
    return Stage(scene_type, level=parse_level(text, scene_type.name, scene_type.content_type))


def test_the_pair_that_shares_many_cells_shares_hundreds_all_the_time():
    stage = open_level(UniformGridScene, "hard-06-many-cells-shared")
    for _ in range(120):
        both = set(stage.scene.model.grid.cells_of(0)) & set(stage.scene.model.grid.cells_of(1))
        assert len(both) >= 200
        assert [0, 1] in stage.scene.model.pairs.tolist()
        stage.run(1)


def heads(stage: Stage, monkeypatch) -> list[tuple[str, str]]:
    from game.app.stagehand.headless import picture_of_stage, prepare

    prepare()
    written: list[tuple[str, str]] = []
    monkeypatch.setattr(Column, "head", lambda self, words, remark="": written.append((words, remark)))
    picture_of_stage(stage, (640, 360), "dark")
    return written


def test_one_manager_alone_is_not_said_to_agree(monkeypatch):
    stage = open_level(UniformGridScene, "default")
    stage.run(2)
    assert ("Pair managers", "same answers") in heads(stage, monkeypatch)
    stage.post(SetEffect("matrix-pairs", False))
    stage.run(1)
    assert ("Pair managers", "not compared") in heads(stage, monkeypatch)
    stage.post(SetEffect("hashed-pairs", False))
    stage.run(1)
    assert stage.scene.model.same and not stage.scene.model.compared


def test_answers_that_differ_are_told_by_the_grid_scene_and_the_race():
    for scene_type in (UniformGridScene, BroadPhaseRace):
        scene = Stage(scene_type, parameters={"count": 50}).scene
        first = scene.model.answers[0]
        lost = first._replace(begun=np.array([[0, 1]]), ended=np.empty((0, 2), dtype=np.int64))
        scene.model.answers = [lost, lost._replace(begun=np.array([[0, 2]]))]
        assert not (scene.model.same if scene_type is UniformGridScene else scene.model.managers_agree())
        scene.model.answers = [lost, lost]
        assert scene.model.same if scene_type is UniformGridScene else scene.model.managers_agree()


def test_a_lone_contestant_of_the_race_agrees_with_nobody():
    stage = Stage(BroadPhaseRace, parameters={"count": 50})
    assert stage.scene.model.managers_agree() is True
    stage.post(SetParameter("count", 5000))
    stage.run(1)
    assert stage.scene.model.managers_agree() is None


def test_the_managers_are_told_in_turn_so_that_none_is_always_first(monkeypatch):
    stage = open_level(UniformGridScene, "default")
    order: list[str] = []
    for name in ("matrix", "hashed"):
        manager = getattr(stage.scene.model, name)
        told = manager.set_pairs
        monkeypatch.setattr(manager, "set_pairs", lambda p, n=name, t=told: (order.append(n), t(p)))
    stage.run(2)
    assert sorted(order[:2]) == sorted(order[2:]) == ["hashed", "matrix"]
    assert order[0] != order[2]


@pytest.mark.parametrize("scene_type", SCENES, ids=level_id)
@pytest.mark.parametrize(
    "box", ["{ lower = [1.0, 1.0], upper = [1e308, 2.0] }", "{ lower = [-1.7e308, 1.0], upper = [2.0, 2.0] }"]
)
def test_a_corner_so_far_out_that_sizes_overflow_is_refused_in_one_line(scene_type, box):
    with pytest.raises(LevelError, match=r"content: boxes\[1\]: (lower|upper) .* within 1e\+300 m") as error:
        stage_with(scene_type, "{ lower = [0.0, 0.0], upper = [1.0, 1.0] }, " + box)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("scene_type", SCENES, ids=level_id)
@pytest.mark.parametrize("growth", [1e6, -1e6, 40.0])
def test_wide_and_endless_boxes_grow_and_are_dragged_without_an_error(scene_type, growth):
    ends = ((-1e300, 1e300), (1.0, 1e300), (-np.inf, 2.0), (1.0, 2.0), (-np.inf, np.inf))
    rows = ", ".join(
        f"{{ lower = [{a!r}, 1.0], upper = [{b!r}, 2.0], velocity = [{growth}, 1.0], growth = {growth} }}"
        for a, b in ends
    )
    stage = stage_with(scene_type, rows)
    for _ in range(5):
        drag(stage, (1.5, 1.5), (3.0, 4.0))
        stage.run(3)
        drag(stage, (9.0, 7.0), (10.0, 7.5))
    assert stage.fault is None
    alive = stage.scene.model.boxes.ids
    assert (stage.scene.model.boxes.lowers[alive] <= stage.scene.model.boxes.uppers[alive]).all()
    assert stage.scene.model.pairs.tolist() == brute_pairs(stage.scene)


@pytest.mark.parametrize("scene_type", SCENES, ids=level_id)
def test_parameters_that_make_random_boxes_are_idle_where_a_level_lists_them(scene_type):
    listed = stage_with(scene_type, "{ lower = [1.0, 1.0], upper = [2.0, 2.0] }")
    making = {"workload", "fill", "ratio", "share"} & set(scene_type.declared_parameters())
    if scene_type is BroadPhaseRace:
        making.discard("workload")  # which also says that boxes leap
    for name in making:
        assert "lists its boxes" in listed.scene.why_idle(name)
        parameter, now = scene_type.parameter(name), listed.scene.values[name]
        others = parameter.options if isinstance(parameter, Choice) else (1.5 * parameter.default,)
        other = next(value for value in others if value != now)
        before = listed.digest()
        listed.post(SetParameter(name, other))
        assert listed.digest() == before  # so it is rightly called idle
    assert not listed.scene.why_idle("speed") and not listed.scene.why_idle("count")


@pytest.mark.parametrize("scene_type", SCENES, ids=level_id)
def test_the_heavy_tails_parameters_act_where_there_is_one(scene_type):
    if "ratio" not in scene_type.declared_parameters():
        return
    for workload, idle in (("heavy-tail", ()), ("power-law", ("share",)), ("lattice", ("ratio", "share"))):
        scene = Stage(scene_type, parameters={"workload": workload, "count": 50}).scene
        assert tuple(name for name in ("ratio", "share") if scene.why_idle(name)) == idle
    assert not scene.why_idle("fill")


@pytest.mark.parametrize(
    ("name", "count", "parameter"),
    [
        ("c06", 4097, "manager"),
        ("c06", 4001, "cells"),
        ("c07", 1501, "axes"),
        ("broad-phase-race", 4001, "naive"),
    ],
)
def test_what_is_left_out_for_the_number_of_boxes_is_idle_with_the_number_named(name, count, parameter):
    scene_type = next(s for s in SCENES if s.name == name)
    scene = Stage(scene_type, parameters={"count": count, "fill": 0.01}).scene
    assert str(count - 1)[-3:] in scene.why_idle(parameter)
    assert not Stage(scene_type, parameters={"count": 50}).scene.why_idle(parameter)
