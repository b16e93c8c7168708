"""The studies of colliding spheres: what their curves must show."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from game.lab import run_study
from game.lab.analysis import fit_order
from game.lab.studies.impulses import (
    energy_study,
    exact_flight,
    impact_study,
    pile_study,
    present_impacts,
    present_pile,
)
from game.lab.study import Row

LATE = ("explicit", "semi-implicit", "parabola")  # collisions by overlap


def few(study, wanted):
    return replace(study, settings=lambda: [s for s in study.settings() if wanted(s)])


@pytest.fixture(scope="module")
def impacts():
    """Rows of the study, each run once; not timed."""
    rows = []
    for setting in impact_study.settings():
        if setting.knob > (1 / 60 if setting.method == "parabola-impacts" else 0.0):
            trial = impact_study.trial(setting)
            trial.run()
            rows.append(Row(setting.method, setting.knob, *trial.outcome()[:1], 0.0, 0, "", {}, {}))
    return rows


def test_the_run_has_impacts_between_spheres_and_with_walls():
    assert 5 <= exact_flight().impacts <= 30


@pytest.mark.parametrize("method", [*LATE, "explicit-impacts", "semi-implicit-impacts"])
def test_late_collisions_and_eulers_flight_are_of_first_order(impacts, method):
    rows = [row for row in impacts if row.method == method]
    assert fit_order(rows, envelope=True) == pytest.approx(1.0, abs=0.15)


def test_parabolas_with_impact_times_are_exact(impacts):
    assert max(row.error for row in impacts if row.method == "parabola-impacts") < 1e-11
    assert np.median([row.error for row in impacts if row.method == "parabola"]) > 1e-3


def test_only_both_together_keep_energy():
    table = run_study(few(energy_study, lambda s: s.knob > 1 / 60), repeats=1)
    assert max(row.error for row in table.of("parabola-impacts")) < 1e-11
    for method in (*LATE, "explicit-impacts", "semi-implicit-impacts"):
        assert max(row.error for row in table.of(method)) > 1e-6


def test_piles_and_their_overlap():
    table = run_study(few(pile_study, lambda s: s.knob in (3, 20)), repeats=1)
    at = {(row.method, row.knob): row.error for row in table}
    for method in ("split", "projection"):
        assert at[method, 20] < 0.0086 < 0.5 * at["none", 20]
        assert at[method, 20] <= at[method, 3]


def test_present_settings_can_be_placed():
    from game.scenes.spheres.scene import SphereCollisions

    values = {name: knob.default for name, knob in SphereCollisions.declared_parameters().items()}
    values["impact-times"] = True
    for study, present in ((impact_study, present_impacts), (pile_study, present_pile)):
        setting = present(values)
        assert setting.knob > 0
        trial = study.trial(setting)
        trial.reset()


@pytest.mark.parametrize("study", [impact_study, energy_study])
def test_a_point_is_taken_whole(study):
    """A scene of several substeps that takes a point stands on that point, and not beside it."""
    for setting in study.settings():
        taken = {"substeps": 5, "scheme": "explicit-euler", "impact-times": True, **setting.scene}
        place = study.present(taken)
        assert place.method == setting.method
        assert place.knob == pytest.approx(setting.knob, rel=1e-12)
        assert place.scene == {name: setting.scene[name] for name in ("scheme", "impact-times")}
