"""The studies of broad phases: orders and exponents as they are said to be. Times are not looked at."""

from __future__ import annotations

import numpy as np
import pytest

from game.lab.studies.broadphase.count import count_study, work_study
from game.lab.studies.broadphase.missed import meeting_times
from game.lab.studies.broadphase.slabs import slabs_study
from game.lab.studies.broadphase.speed import speed_study, swaps_study, sweep_study
from game.lab.studies.broadphase.steps import Steps
from game.lab.studies.broadphase.steps import tests_per_box as counted_tests
from game.lab.studies.broadphase.workloads import (
    cell_cost_study,
    cell_size_study,
    hierarchy_study,
    ratio_study,
)
from game.lab.study import Outcome, Study
from game.physics.broadphase.workloads import make_boxes

ALL = (
    cell_size_study,
    cell_cost_study,
    hierarchy_study,
    ratio_study,
    sweep_study,
    swaps_study,
    speed_study,
    count_study,
    work_study,
    slabs_study,
)


def test_boxes_come_to_their_places_in_motion_and_are_timed_from_there():
    """Two steps ahead of it, then the places that are stated, then as many steps as are asked for."""
    boxes = make_boxes("equal", 8, np.random.default_rng(0), (10.0, 10.0), 0.3, 1.0)
    seen = []

    class Phase:
        tests = 24

        def add_boxes(self, lowers, uppers):
            return np.arange(len(lowers))

        def update_boxes(self, ids, lowers, uppers):
            assert np.allclose(uppers - lowers, boxes.uppers - boxes.lowers)
            seen.append(float(((lowers - boxes.lowers) / boxes.velocities).mean()))

        def pairs(self):
            return [(0, 1)] * len(seen)

    steps = Steps(Phase(), boxes, counted_tests, steps=4, dt=0.5)
    steps.reset()
    assert seen == pytest.approx([-1.0, -0.5, 0.0])
    steps.run()
    assert seen[3:] == pytest.approx([0.5, 1.0, 1.5, 2.0])
    assert steps.outcome() == Outcome(24 / 8, 7)


def outcome(study: Study, method: str, knob: float) -> Outcome:
    setting = min(
        (setting for setting in study.settings() if setting.method == method),
        key=lambda setting: abs(np.log(setting.knob / knob)),
    )
    trial = study.trial(setting)
    trial.reset()
    trial.run()
    return trial.outcome()


def slope(study: Study, method: str, knobs) -> float:
    errors = [outcome(study, method, knob).error for knob in knobs]
    return float(np.polyfit(np.log(knobs), np.log(errors), 1)[0])


@pytest.mark.parametrize("study", ALL, ids=lambda study: study.name)
def test_settings_name_methods_and_parameters_that_there_are(study):
    settings = list(study.settings())
    assert {setting.method for setting in settings} == {method.name for method in study.methods}
    assert len({setting.key for setting in settings}) == len(settings)


@pytest.mark.parametrize(
    "study", [cell_size_study, hierarchy_study, sweep_study], ids=lambda study: study.name
)
def test_a_step_misses_pairs_in_proportion_and_swept_boxes_name_too_many_in_proportion(study):
    steps = [1.0 / rate for rate in (480, 240, 120, 60, 30, 16)]
    assert 0.85 <= slope(study, "end", steps) <= 1.25
    assert 0.85 <= slope(study, "swept", steps) <= 1.25
    assert outcome(study, "exact", 1.0 / 60).error == outcome(study, "exact", 0.25).error == 0.0
    assert outcome(study, "end", 0.25).failure and not outcome(study, "end", 1.0 / 240).failure


@pytest.mark.parametrize("study", [swaps_study, sweep_study], ids=lambda study: study.name)
def test_a_trial_that_is_reset_finds_the_same_again(study):
    trial = study.trial(next(iter(study.settings())))
    found = []
    for _ in range(3):
        trial.reset()
        trial.run()
        found.append(trial.outcome())
    assert found[0] == found[1] == found[2]


def test_a_scenes_setting_has_its_place():
    setting = cell_size_study.present({"step_length": 1.0 / 60.0, "swept": True})
    assert setting.method == "swept" and setting.knob == pytest.approx(1.0 / 60.0)


@pytest.mark.parametrize("study", [swaps_study, speed_study], ids=lambda study: study.name)
def test_a_scene_set_to_a_point_stands_at_that_point(study):
    """The way in a step over the size of a box, from the number of boxes, their speed and the step."""
    for setting in study.settings():
        if setting.method != "grid":
            place = study.present(setting.scene)
            assert place.method == setting.method and place.knob == pytest.approx(setting.knob)


def test_times_of_meeting():
    first, last = meeting_times(
        np.array([0.0, 0.0, 0.0]), np.array([1.0, 1.0, 1.0]),
        np.array([3.0, 0.5, 2.0]), np.array([4.0, 2.0, 3.0]), np.array([-1.0, 0.0, 0.0]),
    )  # fmt: skip
    assert first.tolist() == [2.0, -np.inf, np.inf] and last.tolist() == [4.0, np.inf, -np.inf]


def test_cost_against_cell_size_has_two_branches():
    covered = [outcome(cell_cost_study, "covered", cell).error for cell in (0.25, 1.0, 4.0, 32.0)]
    assert covered[0] > covered[1] < covered[2] < covered[3]
    assert slope(cell_cost_study, "corner", [2.0, 4.0, 8.0]) == pytest.approx(2.0, abs=0.2)
    pairs = {outcome(cell_cost_study, method, 4.0).counter for method in ("corner", "covered")}
    assert len(pairs) == 1


def test_one_grid_suffers_from_large_boxes_and_the_hierarchy_does_not():
    largest = [outcome(ratio_study, "largest", ratio) for ratio in (1.0, 32.0)]
    hierarchy = [outcome(ratio_study, "hierarchical-2", ratio) for ratio in (1.0, 32.0)]
    assert largest[1].error > 50.0 * largest[0].error
    assert hierarchy[1].error < 3.0 * hierarchy[0].error
    assert [one.counter for one in largest] == [one.counter for one in hierarchy]


def test_swaps_follow_speed_as_the_formula_says():
    for setting in speed_study.settings():
        if setting.method == "swaps" and 0.02 < setting.knob < 0.5:
            trial = speed_study.trial(setting)
            trial.reset()
            trial.run()
            assert trial.outcome().error == pytest.approx(setting.others["formula"], rel=0.1)
    assert slope(speed_study, "swaps", [0.02, 0.05, 0.1, 0.2, 0.4]) == pytest.approx(1.0, abs=0.1)


@pytest.mark.parametrize(
    ("method", "exponent"), [("naive", 2.0), ("uniform", 1.0), ("sweep", 1.5), ("bsp", 1.0), ("kinetic", 1.0)]
)
def test_work_grows_with_the_number_of_boxes_as_expected(method, exponent):
    counts = [100.0, 300.0, 1000.0, 3000.0]
    assert slope(work_study, method, counts) == pytest.approx(exponent, abs=0.15)


def test_sides_of_bounds_matter_where_boxes_are_fast():
    slow = [outcome(slabs_study, slabs, 0.01).error for slabs in ("4", "16")]
    fast = [outcome(slabs_study, slabs, 3.0).error for slabs in ("4", "8", "16")]
    assert slow[1] < slow[0] < 1.1 * slow[1]
    assert fast[0] > 1.15 * fast[1] > 1.15 * 1.15 * fast[2]
    for setting in slabs_study.settings():
        place = slabs_study.present(setting.scene)
        assert place.method == setting.method and place.knob == pytest.approx(setting.knob)
