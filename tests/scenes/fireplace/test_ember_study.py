"""What the study of an ember compares with, and how its error falls."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from game.scenes.fireplace import study

SKIN, OPEN, ROOM, EXCHANGE, EMISSIVITY = 130.0, 0.35, 293.15, 18.0, 0.9  # J/(m² K), 1, K, W/(m² K), 1


def test_the_exact_end_is_that_of_the_equation_integrated_by_itself():
    def rate(_, kelvin):
        shining = EMISSIVITY * 5.670374419e-8 * (kelvin**4 - ROOM**4)
        return -OPEN * (shining + EXCHANGE * (kelvin - ROOM)) / SKIN

    found = solve_ivp(rate, (0.0, study.LOOKED_AT_S), [1100.0], rtol=1e-11, atol=1e-9)
    assert study.exact() == pytest.approx(float(found.y[0, -1]), abs=1e-6)


def test_the_error_halves_with_the_step():
    errors = []
    for setting in study.ember_study.settings():
        trial = study.ember_trial(setting)
        trial.reset()
        trial.run()
        errors.append(trial.outcome().error)
    assert np.array(errors[:-1]) / errors[1:] == pytest.approx(2.0, abs=0.01)
