"""The studies of key-framing: what their curves must show."""

from __future__ import annotations

from dataclasses import replace

import pytest

from game.lab import run_study
from game.lab.analysis import fit_order, out_of_order
from game.lab.studies.animation.keyframing import (
    METHODS,
    key_times,
    keyframing_study,
    uneven_study,
)
from game.lab.studies.animation.keyframing_paths import line_study, present_lines, spread_study


def fewer(study, knobs):
    """The study at some of its knobs."""
    chosen = [setting for setting in study.settings() if setting.knob in knobs]
    return replace(study, settings=lambda: chosen)


@pytest.mark.parametrize(("study", "column"), [(keyframing_study, 1), (uneven_study, 2)])
def test_orders_of_all_methods(study, column):
    table = run_study(fewer(study, (32.0, 64.0, 128.0, 256.0, 512.0)), repeats=1)
    for method in study.methods:
        expected = METHODS[method.name][column]
        order = fit_order(table.of(method.name), over="counter")
        assert expected - 0.15 <= order <= expected + 0.25, method.name
        assert out_of_order(table.of(method.name)) == []
        assert method.order == expected


def test_keys_are_even_or_one_to_three_apart():
    assert key_times(4, False).tolist() == [0.0, 0.25, 0.5, 0.75, 1.0]
    assert key_times(4, True).tolist() == [0.0, 0.125, 0.5, 0.625, 1.0]


def test_lines_keep_their_tolerance_and_halving_needs_fewer():
    table = run_study(fewer(line_study, [s.knob for s in line_study.settings()][8:18]), repeats=1)
    for row in table:
        assert row.error <= row.knob * (1.0 + 1e-6)
    for even, adaptive in zip(table.of("even"), table.of("adaptive"), strict=True):
        assert adaptive.counter <= 0.75 * even.counter
    assert fit_order(table.of("even"), over="counter") == pytest.approx(2.0, abs=0.15)


def test_equal_ways_by_table_and_by_newton():
    table = run_study(spread_study, repeats=1)
    assert fit_order(table.of("table"), over="counter") == pytest.approx(2.0, abs=0.2)
    assert table.of("newton")[0].error < 1e-13
    assert table.of("even")[0].error > 0.1


def test_present_settings_can_be_placed_and_points_set():
    for study in (keyframing_study, uneven_study):  # of another motion than the scene's
        assert study.place({"interpolation": "linear"}) == (None, study.no_place)
    trial = line_study.trial(present_lines({"tolerance": 0.01}))
    trial.reset()
    trial.run()
    assert trial.outcome().error <= 0.01
