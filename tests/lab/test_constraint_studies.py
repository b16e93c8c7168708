"""The studies of rigid links and springs: what their curves must show."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from game.lab import run_study
from game.lab.studies.constraints import present_stretch, stretch_study, swing_study
from game.lab.studies.springs import present_spring, spring_study


def few(study, knobs):
    """The study with the points whose knobs are nearest to these."""
    known = sorted({setting.knob for setting in study.settings()})
    wanted = {min(known, key=lambda k: abs(np.log(k / knob))) for knob in knobs}
    return replace(study, settings=lambda: [s for s in study.settings() if s.knob in wanted])


def slope(rows):
    rows = sorted(rows, key=lambda row: row.counter)
    return -np.polyfit(np.log([row.counter for row in rows]), np.log([row.error for row in rows]), 1)[0]


def test_n_sweeps_against_n_substeps_at_equal_work():
    table = run_study(few(stretch_study, (5, 20, 80)), repeats=1)
    assert slope(table.of("substeps")) == pytest.approx(2.0, abs=0.02)
    assert slope(table.of("iterations")) == pytest.approx(1.0, abs=0.25)
    assert max(row.error for row in table.of("direct")) < 1e-12
    at_work = {row.method: row for row in table if row.knob == max(r.knob for r in table)}
    assert at_work["iterations"].counter == at_work["substeps"].counter
    assert at_work["substeps"].error < 0.05 * at_work["iterations"].error


def test_the_step_decides_how_a_chain_swings():
    table = run_study(few(swing_study, (6, 25, 100)), repeats=1)
    assert slope(table.of("euler")) == pytest.approx(1.0, abs=0.15)
    assert slope(table.of("bdf2")) == pytest.approx(2.0, abs=0.15)
    assert slope(table.of("bdf2-direct")) == pytest.approx(2.0, abs=0.15)
    assert abs(slope(table.of("euler-sweeps"))) < 0.1


def test_only_compliance_converges_to_a_spring():
    table = run_study(few(spring_study, (1e-2, 2e-3, 4e-4, 1e-4)), repeats=1)
    assert slope(table.of("xpbd-bdf2")) == pytest.approx(2.0, abs=0.2)
    assert slope(table.of("xpbd")) == pytest.approx(1.0, abs=0.25)
    for name in ("pbd", "pbd-even"):
        assert min(row.error for row in table.of(name)) > 0.02


def test_too_much_over_relaxation_is_marked_where_it_fails():
    failed = [row for row in run_study(few(stretch_study, (1, 2)), repeats=1) if row.failed]
    assert failed
    assert all(row.method == "over-relaxed" for row in failed)


def test_present_settings_can_be_placed():
    rigid = {"substeps": 4, "iterations": 20, "relaxation": 1.0, "solver": "gauss-seidel"}
    trial = stretch_study.trial(present_stretch(rigid))
    trial.reset()
    trial.run()
    assert 0.0 < trial.outcome().error < 0.1
    soft = {"model": "xpbd", "scheme": "bdf2", "iterations": 2, "step_length": 1 / 60, "substeps": 4}
    trial = spring_study.trial(present_spring(soft))
    trial.reset()
    trial.run()
    assert trial.outcome().error < 0.05
