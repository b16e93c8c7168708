"""The studies of skinning and inverse kinematics: what their curves must show."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from game.lab import measure, run_study
from game.lab.analysis import fit_order
from game.lab.studies.animation.inverse_kinematics import (
    dead_point_study,
    full_reach_study,
    out_of_reach_study,
    present_reaching,
    reaching_study,
)
from game.lab.studies.animation.skinning import (
    BEND,
    area_off,
    collapse_study,
    curled,
    joints_study,
    present_influences,
    skinning_study,
    thickness_lost,
)


def few(study, methods, knobs=None):
    """The study with some methods, and the points whose knobs are nearest to these."""

    def settings():
        chosen = [s for s in study.settings() if s.method in methods]
        kept = []
        for setting in chosen:
            own = [s.knob for s in chosen if s.method == setting.method]
            if knobs is None or setting.knob in [min(own, key=lambda k: abs(math.log(k / x))) for x in knobs]:
                kept.append(setting)
        return kept

    return replace(study, settings=settings)


def test_the_points_lie_on_both_sides_of_the_chain_all_along_it():
    _, points = curled()
    assert points.min(axis=0) == pytest.approx((-0.05, -0.12), abs=0.01)
    assert points.max(axis=0) == pytest.approx((1.05, 0.12), abs=0.01)


def test_errors_fall_with_every_influence():
    table = run_study(few(skinning_study, ("linear", "rotor")), repeats=1)
    for name in ("linear", "rotor"):
        errors = [row.error for row in table.of(name)]
        assert len(errors) == 12
        assert all(b <= a for a, b in pairwise(errors))
        assert errors[0] > 0.01
        assert errors[-1] < 1e-15


def test_the_numpy_way_gives_the_same_points():
    table = run_study(few(skinning_study, ("linear", "numpy"), (3,)), repeats=1)
    linear, numpy = table.of("linear")[0], table.of("numpy")[0]
    assert linear.error == pytest.approx(numpy.error, rel=1e-12)


def test_matrices_lose_by_cos_half_the_bend_and_rotors_keep():
    lost = []
    for degrees in (5, 30, 60, 90, 120, 150, 175):
        bend = math.radians(degrees)
        assert thickness_lost(bend, "linear") == pytest.approx(1.0 - math.cos(bend / 2), abs=1e-13)
        assert thickness_lost(bend, "rotor") < 1e-13
        lost.append(area_off(bend, "linear"))
        assert lost[-1] > 50 * area_off(bend, "rotor")
    assert lost == sorted(lost)
    table = run_study(collapse_study, repeats=1)
    assert fit_order(table.of("linear"), collapse_study.floor) == pytest.approx(2.0, abs=0.15)


def test_joints_that_share_a_bend_lose_as_the_square_less():
    table = run_study(joints_study, repeats=1)
    for row in table.of("linear"):
        assert row.error == pytest.approx(1.0 - math.cos(BEND / row.knob / 2), abs=1e-12)
    assert max(row.error for row in table.of("rotor")) < 1e-12
    assert fit_order(table.of("linear"), 1e-13, over="counter") == pytest.approx(2.0, abs=0.15)


def test_buss_is_cheaper_than_the_fixed_step_and_damping_than_both():
    table = run_study(few(reaching_study, ("gradient", "buss", "damped", "fabrik"), (10, 30, 100)), repeats=1)
    at = {(row.method, min((10, 30, 100), key=lambda k: abs(k - row.knob))): row.error for row in table}
    assert at["damped", 10] < 1e-9
    assert at["fabrik", 30] < 1e-9
    assert at["buss", 30] < 1e-4
    assert at["gradient", 100] > at["buss", 30]
    for name in ("gradient", "buss"):
        assert at[name, 10] > at[name, 30] > at[name, 100]


def test_at_full_reach_progress_is_only_one_over_k():
    table = run_study(
        few(full_reach_study, ("gradient", "buss", "ccd", "damped"), (2_000, 5_000, 9_000, 20_000)), repeats=1
    )
    for name in ("gradient", "buss", "ccd"):
        rows = table.of(name)
        slope = np.polyfit(np.log([r.knob for r in rows]), np.log([r.error for r in rows]), 1)[0]
        assert slope == pytest.approx(-1.0, abs=0.15)
    assert min(row.error for row in table.of("damped")) < 1e-9


def test_a_dead_point_is_left_by_all():
    table = run_study(few(dead_point_study, [m.name for m in dead_point_study.methods], (1, 2000)), repeats=1)
    for method in dead_point_study.methods:
        first, last = table.of(method.name)
        assert first.error > 1.3
        assert last.error < 1e-9


def test_out_of_reach_only_fixed_damping_thrashes():
    names = [m.name for m in out_of_reach_study.methods]
    table = run_study(few(out_of_reach_study, names, (2000,)), repeats=1)
    for row in table:
        assert row.failed == (row.method == "damped-fixed")
        if not row.failed:
            assert row.error < 1e-9


def test_the_scene_is_found_on_its_curves():
    setting = present_reaching({"method": "damped", "adaptive": True, "iterations": 20})
    assert measure(reaching_study, setting, repeats=1).error < 1e-9
    assert present_reaching({"method": "damped", "adaptive": False, "iterations": 5}).method == "damped-fixed"
    setting = present_influences({"blend": "rotor", "influences": 4})
    assert 0.0 < measure(skinning_study, setting, repeats=1).error < 0.1
