"""The study of balls on tracks: exact where it can be, of second order where it cannot."""

from __future__ import annotations

import pytest

from game.lab import fit_order, measure
from game.lab.studies.marbles import (
    INCLINE,
    RACE,
    ROUND,
    STEP_S,
    incline_error,
    loop_error,
    marble_study,
    present_marbles,
    race_error,
)

pytestmark = pytest.mark.compiled


def test_what_is_measured_is_what_theory_says() -> None:
    assert incline_error(STEP_S) < 1e-12
    assert race_error(STEP_S) < 5e-5
    assert loop_error(STEP_S / 4) < 1e-4


def test_the_race_is_of_second_order() -> None:
    settings = [one for one in marble_study.settings() if one.method == RACE]
    rows = [measure(marble_study, one, repeats=1) for one in settings]
    assert fit_order(rows) == pytest.approx(2.0, abs=0.2)
    assert {one.method for one in marble_study.settings()} == {INCLINE, RACE, ROUND}


def test_where_a_scene_stands() -> None:
    found = present_marbles({"tier": "own", "substeps": 4, "step_length": STEP_S})
    assert (found.method, found.knob) == (RACE, STEP_S / 4)
    assert present_marbles({"tier": "film", "substeps": 4, "step_length": STEP_S}).knob == STEP_S / 24
