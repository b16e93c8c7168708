"""Studies whose parameter counts parts, and the plates: each order that is fitted is the one expected."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.lab import run_study, summarise
from game.lab.studies.levitation import trap_study
from game.lab.studies.loops import CORNERS, SMOOTH, loop_study
from game.lab.studies.plates import FINEST, fallen, plate_study


@pytest.mark.parametrize("study", [trap_study, loop_study, plate_study], ids=lambda study: study.name)
def test_the_order_fitted_is_the_one_expected(study):
    for line in summarise(run_study(study, repeats=1)):
        if line.expected is not None:
            assert line.order == pytest.approx(line.expected, abs=0.25)
        else:
            assert math.isnan(line.order)


def test_a_grain_that_is_thrown_out_is_told_as_failed():
    table = run_study(trap_study, repeats=1)
    assert [row.knob for row in table if row.failed] == [4.0]
    assert max(row.error for row in table if not row.failed) < 1e-4


def test_chords_with_corners_come_round_from_no_height_and_a_smooth_curve_from_the_exact_one():
    table = run_study(loop_study, repeats=1)
    assert all(row.failed and "not round" in row.failure for row in table.of(CORNERS, failed=None))
    errors = {row.knob: row.error for row in table.of(SMOOTH)}
    assert errors[200.0] < 1e-4 and errors[20.0] < 5e-3


def test_the_reference_of_the_plates_is_as_good_as_their_page_says():
    assert float(np.max(np.abs(fallen("rk4", FINEST) - fallen("rk4", FINEST // 2)))) < 1e-12
    assert "agree to 1e-12" in plate_study.reference
