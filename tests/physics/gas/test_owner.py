"""What the owner of a gas keeps: its sides, its solids, and what it says of closed cells. No step is made."""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.gas import Gas, GasSettings
from game.physics.grid import Border, Borders, Grid


def room(**more) -> Gas:
    return Gas(Grid(10, 8, 0.1), settings=GasSettings(gravity=(0.0, 0.0)), fields=("smoke",), **more)


def parts(gas: Gas, column: int) -> tuple[np.ndarray, np.ndarray]:
    """Open parts of faces where two cells of a column are solid."""
    ny, nx = gas.grid.shape
    ax, ay = np.ones((ny, nx + 1)), np.ones((ny + 1, nx))
    ax[3:5, column : column + 2] = 0.0
    ay[3:6, column] = 0.0
    return ax, ay


def copied(state):
    return type(state)(*(array.copy() for array in state))


def test_sides_are_what_they_were_set_to():
    windy = [Borders(left=Border("inflow", (speed, 0.0)), right=Border("open")) for speed in (1.0, 2.5)]
    gas = room(borders=windy[0])
    gas.set_borders(windy[1])
    assert gas.borders == windy[1]
    assert gas.edges.velocities[0].max() == 2.5


def test_closed_cells_have_no_divergence_and_others_what_flows_out_less_what_expands():
    gas = room()
    ax, ay = parts(gas, 4)
    gas.set_open_parts(ax, ay)
    rng = np.random.default_rng(1)
    gas.u[:], gas.v[:] = rng.standard_normal(gas.u.shape), rng.standard_normal(gas.v.shape)
    gas.expansion[:] = 3.0
    u, v = gas.faces.ax * gas.u, gas.faces.ay * gas.v
    wanted = (u[:, 1:] - u[:, :-1] + v[1:] - v[:-1]) / 0.1 - 3.0
    closed = np.zeros(gas.grid.shape, bool)
    closed[3:5, 4] = True
    assert np.array_equal(gas.divergence()[closed], [0.0, 0.0])
    assert gas.divergence()[~closed] == pytest.approx(wanted[~closed], rel=1e-12, abs=1e-12)


def test_a_state_brings_its_solids_with_it():
    gas = room()
    gas.set_open_parts(*parts(gas, 2))
    kept = copied(gas.state())
    conductances = gas.solver.equation.cx.copy()
    gas.set_open_parts(*parts(gas, 6))
    assert not np.array_equal(gas.solver.equation.cx, conductances)
    gas.restore(kept)
    for found, wanted in zip((gas.faces.ax, gas.faces.ay), parts(gas, 2), strict=True):
        assert np.array_equal(found, wanted)
    assert np.array_equal(gas.solver.equation.cx, conductances)
    assert all(np.array_equal(a, b) for a, b in zip(gas.state(), kept, strict=True))
