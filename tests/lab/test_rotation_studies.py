"""The studies of a body that turns freely: what their curves must show."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from game.lab import run_study
from game.lab.studies.rotation import Run, energy_study, rotation_study
from game.scenes.rigid_body.scene import RigidBodyScene


def few(study, knobs):
    """The study with the points whose steps are nearest to these."""
    known = sorted({setting.knob for setting in study.settings()})
    wanted = {min(known, key=lambda k: abs(np.log(k / knob))) for knob in knobs}
    return replace(study, settings=lambda: [s for s in study.settings() if s.knob in wanted])


def slope(rows):
    return np.polyfit(np.log([row.knob for row in rows]), np.log([row.error for row in rows]), 1)[0]


def test_orders_of_the_spin():
    """1, 2, 4; the exponential map is of order 1 too; the exact one is at rounding."""
    coarse = run_study(few(rotation_study, (1e-2, 6e-3, 4e-3, 2e-3)), repeats=1)
    for name, order in (("midpoint", 2.0), ("splitting", 2.0), ("rk4", 4.0)):
        assert slope(coarse.of(name)) == pytest.approx(order, abs=0.15)
    fine = run_study(few(rotation_study, (1e-3, 6e-4, 2.5e-4, 1e-4)), repeats=1)
    for name in ("explicit-euler", "exponential-map", "implicit-gyroscopic"):
        assert slope(fine.of(name)) == pytest.approx(1.0, abs=0.15)
    assert max(row.error for row in coarse.of("exact")) < 1e-12
    euler, exponential = (coarse.of(name)[0].error for name in ("explicit-euler", "exponential-map"))
    assert exponential == pytest.approx(euler, rel=0.02)
    assert coarse.of("splitting")[0].counter == coarse.of("explicit-euler")[0].counter


def test_energy_comes_to_its_bound_or_does_not_drift():
    table = run_study(few(energy_study, (1 / 10, 1 / 17, 1 / 28, 1 / 47)), repeats=1)
    for row in table.of("explicit-euler"):
        assert row.error == pytest.approx(1.02375809935205, abs=2e-3)
    assert slope(table.of("splitting")) == pytest.approx(2.0, abs=0.15)
    assert max(row.error for row in table.of("splitting")) < 1e-3
    assert min(row.error for row in table.of("implicit-gyroscopic")) > 0.4
    assert [row.knob for row in table.of("body-euler", failed=True)], "diverged, and marked"


def test_present_settings_can_be_placed_and_points_set():
    for study in rotation_study.family:
        setting = study.present({"step_length": 1 / 60, "method": "splitting"})
        trial = study.trial(setting)
        trial.reset()
        trial.run()
        assert 0.0 < trial.outcome().error < 2e-3
        for point in study.settings():
            for name, value in point.scene.items():
                RigidBodyScene.parameter(name).check(value)


def test_the_scene_stands_on_the_line_of_its_method():
    """Not on that which passes nearest: two methods may lie close together."""
    for study in (rotation_study, *rotation_study.related):
        for setting in study.settings():
            assert study.present(setting.scene).method == setting.method


@pytest.mark.parametrize("study", rotation_study.family)
def test_nothing_but_steps_is_timed(study, monkeypatch):
    """One call for all steps; the energy is looked at only afterwards, along the same steps."""
    trial = study.trial(next(iter(study.settings())))
    calls = []
    plain = trial.body.step
    monkeypatch.setattr(trial.body, "step", lambda dt, steps: (calls.append(steps), plain(dt, steps)))
    monkeypatch.setattr(Run, "energy", property(lambda _: pytest.fail("the energy is read while time runs")))
    trial.reset()
    trial.run()
    assert calls == [trial.steps]
    monkeypatch.undo()
    stood = trial.body.state.copy()
    error = trial.outcome().error
    assert error > 0.0 and np.array_equal(trial.body.state, stood)
    assert trial.outcome().error == error
