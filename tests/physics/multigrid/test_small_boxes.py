"""Every solver of the pressure on a few cells with a solid among them, against numpy's least squares."""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.grid.borders import INFLOW, NO_SLIP, OPEN, PERIODIC, WALL
from game.physics.multigrid import SOLVERS, PressureSolver

NY, NX = 6, 8
KINDS = {"box": (WALL, NO_SLIP, WALL, WALL), "tunnel": (INFLOW, OPEN, WALL, OPEN), "torus": (PERIODIC,) * 4}


def matrix(solver, joined):
    """Row by row of cells, written cell by cell: what flows out for the pressures of its neighbours."""
    e, a = solver.equation, np.zeros((NY * NX, NY * NX))
    for j in range(NY):
        for i in range(NX):
            for c, m, n in ((e.cx[j, i], j, i - 1), (e.cx[j, i + 1], j, i + 1),
                            (e.cy[j, i], j - 1, i), (e.cy[j + 1, i], j + 1, i)):  # fmt: skip
                a[j * NX + i, j * NX + i] += c
                if joined or (0 <= m < NY and 0 <= n < NX):
                    a[j * NX + i, m % NY * NX + n % NX] -= c
    return a


@pytest.mark.parametrize("sides", KINDS)
@pytest.mark.parametrize("method", SOLVERS)
def test_the_pressure_solves_its_equation(sides, method):
    solver = PressureSolver(NX, NY, np.array(KINDS[sides]))
    ax, ay = np.ones((NY, NX + 1)), np.ones((NY + 1, NX))
    ax[2:4, 3:6], ay[2:5, 3:5] = 0.0, 0.0  # two by two cells
    ax[1, 6] = 0.35
    solver.set_faces(ax, ay)
    b = np.random.default_rng(5).standard_normal((NY, NX))
    b[2:4, 3:5] = 0.0
    a = matrix(solver, sides == "torus")
    free = np.ones((NY, NX), bool)
    free[2:4, 3:5] = False
    right = b.copy()
    if sides != "tunnel":  # nothing comes in or goes out: the mean is taken out of b, and of p
        right[free] -= b[free].mean()
    want = np.linalg.lstsq(a, right.ravel(), rcond=None)[0].reshape(NY, NX)
    want -= 0.0 if sides == "tunnel" else want[free].mean()
    solver.equation.b[:] = b
    turns = {"multigrid": 30, "v-cycles": 40, "conjugate-gradients": 80}.get(method, 2_000)
    found = solver.solve(method, turns, 1e-9)
    assert found.after <= 1e-9
    assert solver.pressure[free] == pytest.approx(want[free], abs=1e-7)
