"""Studies of solids: quick ones of each law, and what their settings mean."""

from __future__ import annotations

from dataclasses import replace

import pytest

from game.lab import run_study
from game.lab.studies.dominoes import LONGEST_S, STEP_S, DominoTrial
from game.lab.studies.loops import EXACT, SMOOTH, comes_round
from game.lab.studies.solids.laws import FRAME, LAWS
from game.lab.studies.solids.race import STUDIES, USES, LawTrial, law_study, present_solver, race_study
from game.lab.study import Outcome, Setting
from game.physics.solids import SOLVERS, SolidSettings


def of(study, methods):
    """The study with some of its methods' points."""
    return replace(study, settings=lambda: [s for s in study.settings() if s.method in methods])


def test_a_trial_counts_the_sweeps_of_all_frames_and_names_its_failure():
    law = LAWS["slope"]._replace(seconds=2.5, measure=lambda settings: 0.125)
    trial = LawTrial(law, SolidSettings(), 8)
    assert trial.simulated_s == 2.5
    trial.run()
    assert trial.outcome() == Outcome(0.125, round(2.5 * 8 / FRAME), "")

    def refuse(settings):
        raise ValueError("no")

    for measure, failure in ((refuse, "refused"), (lambda settings: 1e9, "diverged")):
        trial = LawTrial(law._replace(measure=measure), SolidSettings(), 8)
        trial.run()
        assert trial.outcome().failure == failure
    assert LawTrial(law, SolidSettings(), 8).outcome().failure == "diverged"  # it has not run


@pytest.mark.parametrize("law", ["slope", "slide-to-roll", "rolling"])
def test_substeps_divide_the_error_of_what_moves(law):
    table = run_study(of(law_study(LAWS[law], 16), ("soft-step",)), repeats=1)
    rows = sorted(table.of("soft-step"), key=lambda row: row.knob)
    assert rows[-1].error < 0.2 * rows[0].error


def test_the_referee_stands_where_sweeps_sink():
    study = law_study(LAWS["heavy-on-light"], 1)
    table = run_study(of(study, ("soft-step", "complementarity", "shock")), repeats=1)
    errors = {row.method: row.error for row in table}
    assert errors["complementarity"] < 1e-6
    assert errors["shock"] < 1e-6
    assert errors["soft-step"] > 0.1


def test_two_rods_need_substeps_only():
    table = run_study(of(law_study(LAWS["double-rod"], 32), ("soft-step", "impulses-sweeps")), repeats=1)
    most = max(row.knob for row in table)
    errors = {row.method: row.error for row in table if row.knob == most}
    assert errors["soft-step"] < 0.2 * errors["impulses-sweeps"]


def test_a_wave_of_dominoes_is_simulated_until_the_last_but_one_is_struck():
    trial = DominoTrial(Setting("soft-step", STEP_S / 4, {}, {}))
    trial.run()
    found = trial.outcome()
    assert found.error < 0.1
    assert 1.0 < trial.simulated_s < 0.9 * LONGEST_S
    assert found.counter == 4 * round(trial.simulated_s / STEP_S)


def test_every_solver_takes_part_and_can_be_placed():
    assert {use.solver for use in USES.values()} == set(SOLVERS)
    assert len(race_study.family) == len(LAWS) == len(STUDIES) == 8
    for name, use in USES.items():
        assert present_solver(use.settings(16)).method == name
    assert present_solver({"solver": "xpbd", "substeps": 3, "iterations": 2}).method == "present"


def test_the_referee_is_not_asked_for_too_many_points():
    assert "complementarity" not in {setting.method for setting in STUDIES["dominoes"].settings()}


def test_a_disc_on_a_smooth_track_comes_round_from_the_exact_drop_on():
    found = [comes_round(SMOOTH, 100, 4, share * EXACT) for share in (0.5, 0.97, 1.03, 1.5)]
    assert found == [False, False, True, True]
