"""The studies of the wind tunnel: what their curves must show."""

from __future__ import annotations

from dataclasses import replace

import pytest

from game.lab import run_study
from game.lab.studies.flow.wind_tunnel import drag_study, fit_study, window_study


def test_more_cells_bring_both_ways_nearer_to_the_drag_that_is_known():
    few = replace(drag_study, settings=lambda: [s for s in drag_study.settings() if s.knob in (5.0, 10.0)])
    table = run_study(few, repeats=1)
    for name, most in (("book", 0.02), ("wall", 0.06)):
        coarse, fine = table.of(name)
        assert fine.error < most and fine.error < coarse.error
    assert table.of("book")[1].error < table.of("wall")[1].error


def test_a_series_learns_from_more_angles_and_the_plates_law_does_not():
    table = run_study(fit_study, repeats=1)
    series = {row.knob: row.error for row in table.of("series")}
    plate = {row.knob: row.error for row in table.of("plate")}
    assert series[24.0] < series[12.0] < 0.7 * series[8.0] < 0.3 * series[4.0]
    assert series[24.0] < 0.5 * plate[24.0]
    assert plate[24.0] == pytest.approx(plate[12.0], rel=0.05)


def test_a_longer_window_errs_less():
    table = run_study(window_study, repeats=1)
    errors = [row.error for row in table.of("mean")]
    assert errors[-1] < 0.3 * errors[0] and errors[0] < 0.05


def test_the_scene_has_its_place_among_the_points():
    setting, _ = drag_study.place({"measure": "wall", "cells": 10})
    assert setting is not None and (setting.method, setting.knob) == ("wall", 10.0)
