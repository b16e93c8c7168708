"""The studies of V-Clip and GJK: what their curves must show."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from game.lab import run_study
from game.lab.studies.narrowphase.distance import (
    FRAMES,
    PAIRS,
    coherence_settings,
    gjk_study,
    present_tolerance,
    vclip_study,
)
from game.lab.studies.narrowphase.support import support_study

QUERIES = PAIRS * FRAMES


def few(study, knobs):
    return replace(study, settings=lambda: [s for s in study.settings() if s.knob in knobs])


def counters(table, method):
    return {row.knob: row.counter for row in table.of(method)}


def test_error_is_bounded_by_the_tolerance_and_falls_to_rounding_in_few_steps():
    table = run_study(few(gjk_study, (1e-1, 1e-3, 1e-6, 1e-14)), repeats=1)
    for n in (8, 64, 512):
        rows = {row.knob: row for row in table.of(f"corners-{n}")}
        assert all(row.error <= 4.0 * row.knob for row in rows.values() if row.knob > 1e-12)
        assert rows[1e-14].error < 1e-14
        assert rows[1e-14].counter - rows[1e-1].counter < 4.5 * QUERIES  # for 13 more digits
        assert rows[1e-14].counter < 8.0 * QUERIES


def test_with_coherence_steps_do_not_grow_with_the_vertices():
    """The error is that of the polygons, of second order in their sides."""
    sides = {n: 2.0 * math.pi / n for n in (8, 64, 512)}
    table = run_study(few(vclip_study, sides.values()), repeats=1)
    for method in vclip_study.methods:
        errors = {row.knob: row.error for row in table.of(method.name)}
        slope = np.polyfit(np.log(list(errors)), np.log(list(errors.values())), 1)[0]
        assert slope == pytest.approx(2.0, abs=0.15)
        assert all(error <= 0.25 * side * side for side, error in errors.items())
    small, large = (
        {n: counters(table, name)[side] for n, side in sides.items()}
        for name in ("vclip-small", "vclip-large")
    )
    assert small[512] < 1.6 * small[8]
    slope = np.polyfit(np.log([64, 512]), np.log([large[64], large[512]]), 1)[0]
    assert slope == pytest.approx(1.0, abs=0.2)
    gjk = counters(table, "gjk-large")
    assert gjk[sides[512]] < 3.0 * gjk[sides[8]]


def test_every_way_finds_the_farthest_vertex():
    table = run_study(few(support_study, (4, 64, 1024)), repeats=1)
    assert max(row.error for row in table) < 1e-15
    near, scan = counters(table, "climb-near"), counters(table, "scan")
    assert near[1024] < 0.05 * scan[1024]
    assert near[4] > 0.7 * scan[4]


def test_the_present_setting_is_measured():
    trial = gjk_study.trial(present_tolerance({"exponent": -3.0, "method": "scan", "corners": 64.0}))
    trial.reset()
    trial.run()
    assert trial.outcome().error < 4e-3
    assert len(coherence_settings()) == 45
