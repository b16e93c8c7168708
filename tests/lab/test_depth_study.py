"""The study of depth with rotation: what its curves must show."""

from __future__ import annotations

from dataclasses import replace

import pytest

from game.lab import run_study
from game.lab.studies.narrowphase.rotation import BOUND, GRID, SLIDE, depth_study


def test_branch_and_bound_keeps_its_tolerance_and_a_grid_is_dearer_and_worse():
    chosen = (1.0, 1e-1, 1e-2, 1e-4, 2.0 / 6.0, 2.0 / 16.0)
    table = run_study(
        replace(depth_study, settings=lambda: [s for s in depth_study.settings() if s.knob in chosen]),
        repeats=1,
    )
    bound = {row.knob: row for row in table.of(BOUND)}
    assert set(bound) == {1e-1, 1e-2, 1e-4} and all(0.0 <= row.error <= knob for knob, row in bound.items())
    counts = [bound[knob].counter for knob in (1e-1, 1e-2, 1e-4)]
    assert counts == sorted(counts) and counts[2] < 100 * counts[1]
    coarse, fine = (row for row in table.of(GRID))
    assert bound[1e-2].error < fine.error < coarse.error
    assert fine.counter > 3 * coarse.counter and fine.counter > 10 * counts[1]
    (slide,) = table.of(SLIDE)
    assert slide.error > 0.05 > bound[1e-1].error


def test_the_scenes_tolerance_is_its_place_among_the_points():
    setting, words = depth_study.place({"tolerance": 2e-3})
    assert setting is not None and setting.method == BOUND and setting.knob == pytest.approx(2e-3)
    assert "ten pairs" in words
