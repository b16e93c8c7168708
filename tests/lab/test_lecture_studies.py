"""The studies of the lecture's table: orders, formulae, failures, scenes."""

import dataclasses
import math

import numpy as np
import pytest

from game.billiards.lecture.settings import lecture_settings
from game.lab.analysis import fit_order, summarise
from game.lab.runner import measure, measure_present, run_study
from game.lab.studies.billiards.lecture_breaks import (
    LONGEST,
    SHORTEST,
    missed_hits_study,
    rack_study,
    symmetry_study,
)
from game.lab.studies.billiards.lecture_table import lecture_table_study, two_ball_study
from game.lab.studies.billiards.missed_hits import HIT_SHOTS
from game.lab.study import Setting


def part_of(study, wanted):
    """The study with some of its settings."""
    settings = [setting for setting in study.settings() if wanted(setting)]
    return dataclasses.replace(study, settings=lambda: settings, related=())


STEPPED = ("lecture", "exact-walls", "substeps", "automatic")


@pytest.fixture(scope="module")
def two_ball_table():
    return run_study(part_of(two_ball_study, lambda s: s.method in STEPPED), repeats=1)


@pytest.mark.parametrize("method", STEPPED)
def test_one_collision_is_of_first_order(two_ball_table, method):
    rows = two_ball_table.of(method)
    assert max(row.knob for row in rows) > 16 * min(row.knob for row in rows)
    order = fit_order(rows, two_ball_study.floor, envelope=True, over="counter")
    assert 0.85 <= order <= 1.15
    assert min(row.error for row in rows) > 1e3 * 2.0**-52


def test_steps_that_jump_over_the_ball_are_marked(two_ball_table):
    failed = two_ball_table.of("lecture", failed=True)
    assert {row.failure for row in failed} == {"passes through a ball"}
    assert not two_ball_table.of("automatic", failed=True)


@pytest.mark.slow
def test_carom_is_of_first_order_beyond_its_failures():
    study = part_of(lecture_table_study, lambda s: s.method == "lecture" and s.others["passes"] == 1)
    table = run_study(study, repeats=1)
    (line, *_) = summarise(table)
    assert 0.8 < line.order < 1.4
    assert {row.failure for row in table if row.failed} == {
        "passes through a ball",
        "hits a ball that it should pass",
    }


def test_carom_event_by_event_is_exact_and_has_three_events():
    row = measure(lecture_table_study, Setting("events", 1.0), repeats=1)
    assert row.error < 1e-12
    assert row.counter == 3


def test_each_point_opens_its_scene():
    for setting in lecture_table_study.settings()[::50]:
        if setting.method != "events":
            knobs = {name: value for name, value in setting.scene.items() if name != "step_length"}
            assert lecture_settings(**knobs).passes == knobs["passes"]
            assert setting.scene["step_length"] == min(max(setting.knob, SHORTEST), LONGEST)


def test_present_setting_of_the_scene_is_placed_with_losses_left_out():
    parameters = {
        "step_length": 1 / 4000,
        "order": "pairwise",
        "substeps": 2.0,
        "passes": 1.0,
        "rule": "scaled",
        "bounce": 0.5,
        "aim_line": True,
    }
    row = measure_present(lecture_table_study, parameters, repeats=1)
    assert row.method == "present"
    assert row.knob == 1 / 4000
    assert math.isfinite(row.error)


def test_share_of_hits_missed_follows_the_formula():
    points = part_of(missed_hits_study, lambda s: 40.0 < 1.0 / s.knob < 300.0)
    table = run_study(points, repeats=1)
    assert len(table) >= 9
    for row in table:
        expected = row.others["formula"]
        bound = 4.0 * math.sqrt(expected * (1.0 - expected) / HIT_SHOTS) + 1.0 / HIT_SHOTS
        assert abs(row.error - expected) < bound


def test_pressed_rack_is_parted_by_one_joint_pass():
    table = run_study(rack_study, repeats=1)
    joint = [row.error for row in table.of("joint")]
    assert max(joint) < 1e-12
    pairwise = {row.knob: row.error for row in table.of("pairwise", failed=None)}
    assert pairwise[1] > 0.05 > pairwise[5]
    assert pairwise[50] < 1e-8
    steps = np.diff(np.log([pairwise[n] for n in (10, 20, 30, 40, 50)]))
    assert steps.max() < -2.0  # a constant factor each ten passes


def test_symmetric_break_is_symmetric_jointly_and_never_pair_by_pair():
    table = run_study(part_of(symmetry_study, lambda s: s.knob > 1 / 500), repeats=1)
    assert [row.error for row in table.of("joint")] == [0.0] * 4
    assert len(table.of("pairwise", failed=True)) == 4


def test_main_study_leads_to_the_others():
    assert [study.name for study in lecture_table_study.related] == [
        "lecture-two-balls",
        "lecture-missed-hits",
        "lecture-pressed-rack",
        "lecture-symmetric-break",
    ]


def test_a_step_longer_than_the_shot_is_taken_once():
    """At the least one: of half a second for 0.7 s one as well, and of 0.45 s two."""
    for length, steps in ((5.0, 1), (0.5, 1), (0.45, 2)):
        assert two_ball_study.trial(Setting("lecture", length, {"passes": 1})).steps == steps
