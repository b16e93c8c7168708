"""The studies of the fountain: what they measure and what their curves must show."""

from __future__ import annotations

import numpy as np
import pytest

from game.lab import run_study
from game.lab.studies.particles import (
    SHOWN,
    bounce_study,
    exact_bounce,
    free_flight_study,
    present_bounce,
)


def few(study, every):
    """The study with every so many of its points."""
    from dataclasses import replace

    by_knob = sorted({setting.knob for setting in study.settings()})[::every]
    return replace(study, settings=lambda: [s for s in study.settings() if s.knob in by_knob])


def test_reference_of_the_bounce():
    known = (3.65777553100942, 0.202285803307705, 2.13691894914877, -4.67085708677009)
    assert np.allclose(exact_bounce(), known, rtol=0, atol=1e-12)


def test_free_flight_shows_the_orders():
    table = run_study(few(free_flight_study, 4), repeats=1)
    for method in free_flight_study.methods:
        rows = sorted(table.of(method.name), key=lambda row: row.counter)
        errors = np.array([row.error for row in rows])
        if method.order is None:
            assert errors.max() < 8 * 6000 * 2.0**-52 * 8  # roundings of 6000 steps
            continue
        good = errors > 1e-12
        slope = -np.polyfit(np.log([row.counter for row in rows])[good], np.log(errors[good]), 1)[0]
        assert slope == pytest.approx(method.order, abs=0.2)


def test_the_bounce_shows_what_handling_an_impact_is_worth():
    """At the finest steps: step end first order for all, root far below."""
    table = run_study(few(bounce_study, 6), repeats=1)
    best = {name: min(row.error for row in table.of(name)) for name in (m.name for m in bounce_study.methods)}
    assert min(best[f"{name}/end"] for name, contact, _ in SHOWN if contact == "end") > 1e-5
    assert max(best["verlet/chord"], best["rk4/chord"]) < 1e-5
    assert best["rk4/root"] < 1e-12
    assert all(row.cpu_s > 0.0 for row in table)


def test_the_present_setting_of_the_scene_can_be_placed():
    setting = present_bounce({"method": "midpoint", "contact": "root", "step_length": 1 / 240, "rate": 3.0})
    trial = bounce_study.trial(setting)
    trial.reset()
    trial.run()
    assert trial.outcome().error < 1e-3
    assert trial.outcome().failure == ""
