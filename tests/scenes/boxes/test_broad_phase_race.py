"""The race: every broad phase and both managers on one workload."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.broadphase.workloads import WORKLOADS
from game.scenes.boxes.parameters import CONTESTANTS
from game.scenes.boxes.race import BroadPhaseRace
from game.stage import SetParameter, Stage
from tests.scenes.boxes.box_stages import brute_pairs, open_level, readouts


@pytest.mark.parametrize("workload", WORKLOADS)
def test_all_find_the_same_on_every_workload(workload):
    stage = Stage(
        BroadPhaseRace, parameters={"count": 200, "workload": workload, "ratio": 8.0, "share": 0.05}
    )
    scene = stage.scene
    assert tuple(scene.model.phases) == CONTESTANTS
    before = scene.model.boxes.lowers.copy()
    for _ in range(10):
        stage.run(1)
        assert all(scene.model.agree.values())
        assert all(len(manager) == len(scene.model.pairs) for manager in scene.model.managers.values())
    assert scene.model.pairs.tolist() == brute_pairs(scene)
    values = readouts(stage)
    assert all(values[name] > 0.0 for name in (*scene.model.phases, "matrix", "hash"))
    if workload == "teleport":
        assert (np.abs(scene.model.boxes.lowers - before).max(axis=1) > 0.5).mean() > 0.8
        assert values["swaps"] > 1000


def test_contestants_are_switched_off_and_one_always_stays():
    stage = Stage(BroadPhaseRace, parameters={"count": 100})
    stage.run(2)
    for name in ("naive", "uniform", "covering", "sweep", "bsp", "kinetic", "hierarchical"):
        stage.post(SetParameter(name, False))
        stage.run(1)
        assert bool(stage.scene.messages()) == (name == "hierarchical")  # all switches are off, one stays
    assert list(stage.scene.model.phases) == ["hierarchical"]
    stage.run(2)
    assert math.isnan(readouts(stage)["naive"])
    stage.post(SetParameter("sweep", True))
    stage.run(2)
    assert list(stage.scene.model.phases) == ["sweep"]
    assert stage.scene.model.pairs.tolist() == brute_pairs(stage.scene)


@pytest.mark.parametrize(
    ("uniform", "covering"), [(True, True), (True, False), (False, True), (False, False)]
)
def test_the_size_of_cells_is_idle_without_a_grid_that_has_it(uniform, covering):
    scene = Stage(BroadPhaseRace, parameters={"count": 50, "uniform": uniform, "covering": covering}).scene
    assert bool(scene.why_idle("cell")) == (not uniform and not covering)
    assert not scene.why_idle("workload")


def test_all_leaping_is_sorted_anew_in_every_step_and_so_is_a_line_that_trembles():
    def sorted_anew(workload: str) -> list[int]:
        stage = Stage(BroadPhaseRace, parameters={"count": 400, "workload": workload, "naive": False})
        counts = []
        for _ in range(30):
            stage.run(1)
            counts.append(stage.scene.model.phases["sweep"].resorts)
        return counts

    assert sorted_anew("teleport") == list(range(1, 31))
    assert sorted_anew("line") == list(range(1, 31))
    assert sorted_anew("equal")[-1] == 0


def test_what_is_too_dear_is_left_out():
    stage = open_level(BroadPhaseRace, "default")
    stage.post(SetParameter("count", 4500))
    stage.run(3)
    assert "naive" not in stage.scene.model.phases and stage.scene.model.managers["matrix"] is None
    values = readouts(stage)
    assert math.isnan(values["naive"]) and math.isnan(values["matrix"]) and values["hash"] > 0.0


@pytest.mark.parametrize("level", ["bounds", "crossfire", "no-end-no-size", "in-step", "half-leap"])
def test_what_is_hard_for_bounds_in_motion_is_answered_right(level):
    stage = open_level(BroadPhaseRace, level)
    events = []
    for _ in range(90):
        stage.run(1)
        model = stage.scene.model
        assert all(model.agree.values())
        assert model.pairs.tolist() == brute_pairs(stage.scene)
        events.append(readouts(stage)["events"])
        model.phases["kinetic"].check()
    assert 0.0 < sum(events) < 90 * len(model.boxes)
    if level == "in-step":
        assert max(events[10:]) == len(model.boxes)  # the wall
    if level == "half-leap":
        assert min(events[1:]) > 0.3 * len(model.boxes)


def test_events_and_false_pairs_are_read_and_the_sides_of_bounds_chosen():
    false = {}
    for slabs in ("4", "16"):
        stage = Stage(BroadPhaseRace, parameters={"count": 500, "speed": 30.0, "slabs": slabs})
        stage.run(30)
        values = readouts(stage)
        phase = stage.scene.model.phases["kinetic"]
        assert phase.slabs == int(slabs)
        assert values["events"] == phase.events > 0
        assert values["false pairs"] == phase.candidates - len(stage.scene.model.pairs)
        false[slabs] = values["false pairs"]
    assert false["16"] < 0.9 * false["4"]
    stage.post(SetParameter("kinetic", False))
    stage.run(1)
    assert math.isnan(readouts(stage)["events"])
    assert stage.scene.why_idle("slabs") == "The kinetic sweep is left out."
