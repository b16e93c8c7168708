"""Studies of gas: orders, what solvers leave of divergence, what carrying smears."""

import math

import numpy as np
import pytest

from game.lab import measure
from game.lab.studies.gases.flows import behind_rods, eddies_study, rods_study
from game.lab.studies.gases.smoke import divergence_study, exact_mixing, mixed, smear_study
from game.lab.study import Setting
from game.physics.multigrid import SOLVERS


def row(study, method, knob):
    return measure(study, Setting(method, float(knob), {}), repeats=1)


@pytest.mark.parametrize(("method", "order"), [("linear", 1.0), ("cubic", 1.0), ("time-centred", 1.9)])
def test_order_behind_rods(method, order):
    """Kovasznay's flow: what is lost by taking the pressure only at the end is of first order."""
    coarse, fine = (row(rods_study, method, n).error for n in (12, 24))
    assert math.log2(coarse / fine) == pytest.approx(order, abs=0.15)


def test_the_flow_behind_rods_keeps_its_volume():
    """By differences of 1e-5 at some places."""
    x, y = np.array([-0.4, 0.1, 0.3]), np.array([0.05, -0.2, 0.4])
    d = 1e-5
    grows = (behind_rods(x + d, y)[0] - behind_rods(x - d, y)[0]) / (2.0 * d)
    rises = (behind_rods(x, y + d)[1] - behind_rods(x, y - d)[1]) / (2.0 * d)
    assert np.max(np.abs(grows)) > 0.1 and np.max(np.abs(grows + rises)) < 1e-8


def test_the_eddies_have_the_order_that_the_study_names():
    coarse, fine = (row(eddies_study, "time-centred", n).error for n in (16, 32))
    assert math.log2(coarse / fine) == pytest.approx(2.0, abs=0.25)


def test_more_turns_leave_less_divergence_and_cycles_least():
    few = {"multigrid": 1, "v-cycles": 1, "conjugate-gradients": 4, "gauss-seidel": 5, "jacobi": 5}
    more = {"multigrid": 2, "v-cycles": 2, "conjugate-gradients": 10, "gauss-seidel": 20, "jacobi": 20}
    assert set(few) == set(SOLVERS)
    left = {name: row(divergence_study, name, turns).error for name, turns in more.items()}
    for name, turns in few.items():
        assert left[name] < 0.4 * row(divergence_study, name, turns).error, name
    assert left["v-cycles"] < 0.1 * left["gauss-seidel"] < left["jacobi"]


def test_smear_falls_with_cells_and_better_interpolation():
    found = {name: [row(smear_study, name, n).error for n in (32, 64)] for name in ("linear", "cubic")}
    assert all(1.0 < fine < 0.85 * coarse for coarse, fine in found.values())
    assert found["cubic"][0] < 0.6 * found["linear"][0]


def test_mixing_of_known_layers():
    """Full and empty cells are not mixed; half full ones are by a half."""
    assert mixed(np.array([[1.0, 1.0, 0.0]])) == 0.0 and mixed(np.full((4, 4), 0.5)) == 0.5
    assert 0.005 < exact_mixing(64) < 0.6 * exact_mixing(32) + 0.01 < 0.1
