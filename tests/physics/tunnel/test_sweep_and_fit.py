"""Averages, plans of a sweep with their mirror images, fits."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.tunnel import Sweep, SweepPlan, fit_plate, fit_series, outline_of, shape_named
from game.physics.tunnel.averages import Average, Mean
from game.physics.tunnel.sweep import ANGLE, CHECK, DONE, DRAG, LIFT, with_images

WEDGE = outline_of([(-0.5, 0.0), (0.5, -0.2), (0.5, 0.2)])  # mirrored, not turned
ESS = outline_of([(-0.5, -0.1), (0.4, -0.3), (0.5, 0.1), (-0.4, 0.3)])  # turned, not mirrored
ODD = outline_of([(-0.5, 0.0), (0.5, -0.2), (0.3, 0.3)])


def reading(drag, lift, moment=0.0, book=0.0):
    """Pressure has all but a tenth, which is friction."""
    return np.array([drag - 0.1, lift, moment, 0.1, 0.0, 0.0, drag + book, lift, moment])


def test_an_average_leaves_out_what_settles_and_tells_spread_and_beat():
    average, dt = Average(4.0, 10.0), 0.02
    for k in range(701):
        time = (k + 1) * dt
        early = 50.0 if time < 3.9 else 0.0
        swing = math.sin(2.0 * math.pi * 0.4 * time)
        average.take(reading(2.0 + early, 0.3 * swing + 0.05, 0.01, book=0.1), dt)
    assert average.done and average.progress == 1.0
    mean = average.mean(unit=0.5)
    assert mean.wall[0] == pytest.approx(2.0) and mean.book[0] == pytest.approx(2.1)
    assert mean.wall[1] == pytest.approx(0.05, abs=0.003)
    assert mean.spread[1] == pytest.approx(0.3 / math.sqrt(2.0), rel=0.02)
    assert mean.spread[0] == pytest.approx(0.0, abs=1e-6)
    assert mean.strouhal == pytest.approx(0.2, rel=1e-3)
    assert mean.seconds == pytest.approx(10.0, abs=0.03)


def test_an_average_that_still_drifts_says_so():
    average = Average(1.0, 4.0)
    for k in range(500):
        average.take(reading(0.01 * (k + 1), 0.0), 0.01)
    # 0.25 for a quarter of the time: halves of the window differ by 2, half of which is 1
    assert average.mean().drift == pytest.approx(1.0, rel=0.01)
    assert average.mean().strouhal == 0.0


def test_before_it_has_settled_nothing_is_told():
    average = Average(1.0, 4.0)
    average.take(reading(9.0, 9.0), 0.5)
    assert not average.settled and average.mean() == Mean((0.0,) * 3, (0.0,) * 3, (0.0,) * 3, 0.0, 0.0, 0.0)
    average.clear()
    assert average.progress == 0.0


@pytest.mark.parametrize(
    ("outline", "first", "last", "count"),
    [
        (shape_named("plate"), 0.0, 90.0, 7),
        (WEDGE, 0.0, 180.0, 13),
        (ESS, -75.0, 90.0, 12),
        (ODD, -165.0, 180.0, 24),
    ],
)
def test_a_plan_measures_what_symmetry_leaves_open(outline, first, last, count):
    fitted, checks = SweepPlan(24, 3).measured(outline)
    assert np.degrees(fitted[[0, -1]]) == pytest.approx((first, last)) and len(fitted) == count
    assert np.diff(np.degrees(fitted)) == pytest.approx(np.full(count - 1, 15.0))
    assert len(checks) == 3 and len(np.unique(checks)) == 3
    off = np.degrees(checks) / 7.5
    assert off == pytest.approx(np.round(off)) and (np.round(off) % 2 == 1).all()
    assert (checks > fitted[0]).all() and (checks < fitted[-1]).all()
    everything, _ = SweepPlan(24, 0, symmetry=False).measured(outline)
    assert len(everything) == 24


@pytest.mark.parametrize(
    "plan", [SweepPlan(10), SweepPlan(0), SweepPlan(100), SweepPlan(24, -1), SweepPlan(True)]
)
def test_a_plan_that_is_none_is_refused(plan):
    with pytest.raises(ValueError, match=r"angles|checks"):
        plan.measured(ODD)


def test_a_sweep_goes_from_angle_to_angle_and_ends():
    sweep = Sweep()
    angle, seen = sweep.begin(shape_named("plate"), SweepPlan(8, 1)), []
    while angle is not None:
        seen.append(math.degrees(angle))
        assert sweep.running
        a = math.radians(seen[-1])
        angle = sweep.keep(
            Mean((1.0 - math.cos(2 * a), math.sin(2 * a), 0.0), (0.1,) * 3, (9.0,) * 3, 0.0, 0.2, 1.0)
        )
    assert seen == pytest.approx([0.0, 45.0, 90.0, 67.5])
    assert sweep.complete and not sweep.running
    assert len(sweep.measured()) == 3 and len(sweep.measured(True)) == 1
    assert sweep.table[:, DONE].all() and sweep.table[3, CHECK] == 1.0
    sweep.clear()
    assert not sweep.complete and not len(sweep.table)


def rows_of(angles, values):
    rows = np.zeros((len(angles), 14))
    rows[:, ANGLE], rows[:, DRAG : DRAG + 3] = angles, values
    return rows


def test_images_go_round_the_whole_turn_with_the_right_signs():
    fitted, _ = SweepPlan(24, 0).measured(shape_named("plate"))
    values = np.stack([1.4 - np.cos(2 * fitted), 1.2 * np.sin(2 * fitted), 0.3 * np.sin(2 * fitted)], axis=1)
    angles, all_values = with_images(rows_of(fitted, values), shape_named("plate"))
    assert len(angles) == 24 and np.diff(np.degrees(angles)) == pytest.approx(np.full(23, 15.0))
    assert all_values[:, 0] == pytest.approx(1.4 - np.cos(2 * angles))
    assert all_values[:, 1] == pytest.approx(1.2 * np.sin(2 * angles), abs=1e-12)
    assert all_values[:, 2] == pytest.approx(0.3 * np.sin(2 * angles), abs=1e-12)
    fitted, _ = SweepPlan(24, 0).measured(WEDGE)
    values = np.stack([np.cos(fitted), np.sin(fitted), -np.sin(3 * fitted)], axis=1)
    angles, all_values = with_images(rows_of(fitted, values), WEDGE)
    assert len(angles) == 24 and all_values[:, 1] == pytest.approx(np.sin(angles), abs=1e-12)
    assert all_values[:, LIFT - DRAG + 1] == pytest.approx(-np.sin(3 * angles), abs=1e-12)


def test_a_series_finds_the_series_that_it_is_given():
    angles = 2.0 * np.pi * np.arange(24) / 24.0
    wanted = np.array([[1.0, 0.2, 0.1, -0.7, 0.05], [0.0, 0.1, 0.4, 0.3, 1.1], [0.0, 0.0, 0.2, 0.0, 0.25]])
    basis = np.stack(
        [np.ones(24), np.cos(angles), np.sin(angles), np.cos(2 * angles), np.sin(2 * angles)], axis=1
    )
    values = basis @ wanted.T
    found = fit_series(angles, values, 4)
    assert found.coefficients[:, :5] == pytest.approx(wanted, abs=1e-12)
    assert found.coefficients[:, 5:] == pytest.approx(np.zeros((3, 4)), abs=1e-12)
    assert found.residual == pytest.approx(np.zeros(3), abs=1e-12)
    assert found.at(0.3)[0] == pytest.approx(
        wanted @ [1.0, math.cos(0.3), math.sin(0.3), math.cos(0.6), math.sin(0.6)]
    )
    low = fit_series(angles, values, 1)
    assert low.residual[0] == pytest.approx(math.sqrt(0.5 * (0.49 + 0.0025)))
    assert low.error(angles, values) == pytest.approx(low.residual)
    assert not low.error([], np.zeros((0, 3))).any()


def test_a_series_asks_for_no_more_than_there_are_angles():
    angles = 2.0 * np.pi * np.arange(6) / 6.0
    assert fit_series(np.concatenate([angles, angles]), np.ones((12, 3)), 9).order == 2
    for bad, order in ((angles[:2], 1), (angles, -1), (angles, 17), (angles, True)):
        with pytest.raises(ValueError, match=r"angles|order"):
            fit_series(bad, np.ones((len(bad), 3)), order)
    with pytest.raises(ValueError, match="finite"):
        fit_series(angles, np.full((6, 3), np.nan), 1)


def test_the_plates_law_finds_its_own_numbers_and_keeps_drag_from_pushing():
    angles = 2.0 * np.pi * np.arange(24) / 24.0
    values = np.stack([1.4 - 1.0 * np.cos(2 * angles), 1.2 * np.sin(2 * angles), 0.0 * angles], axis=1)
    found = fit_plate(angles, values)
    assert (found.drag, found.drag_turn, found.glide) == pytest.approx((1.4, 1.0, 1.2))
    assert found.residual == pytest.approx((0.0, 0.0), abs=1e-12)
    values[:, 0] -= 0.5
    kept = fit_plate(angles, values)
    assert kept.drag == pytest.approx(1.0) and kept.residual[0] == pytest.approx(0.1)
    with pytest.raises(ValueError, match="angles"):
        fit_plate(angles[:1], values[:1])
