"""Densities carried in flux form: sums, sides, walls, and a translation that is known exactly."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.gas import Gas, GasSettings
from game.physics.gas.densities import carry_densities
from game.physics.grid import Border, Borders, Grid


def carried(gas: Gas, density: np.ndarray, surrounding: float, dt: float) -> float:
    """One density (ny, nx), which is written; what left."""
    column = density[..., None].copy()
    (left,) = carry_densities(gas, column, np.array([surrounding]), dt).tolist()
    density[:] = column[..., 0]
    return left


def windy(kind: str, n: int = 24) -> Gas:
    """A wind of 1 m/s along x between an inflow and a side of a kind, a square meter."""
    borders = Borders(Border("inflow", (1.0, 0.0)), Border(kind), Border("wall"), Border("wall"))
    gas = Gas(Grid(n, n, 1.0 / n), borders, fields=("temperature",))
    gas.u[:] = 1.0
    return gas


def stirred(parts: bool, n: int = 24) -> Gas:
    """A shut box that is stirred, with a solid partly across its cells or without."""
    gas, rng = Gas(Grid(n, n, 1.0 / n), fields=("temperature",)), np.random.default_rng(4)
    gas.u[:, 1:-1], gas.v[1:-1] = rng.normal(size=(n, n - 1)), rng.normal(size=(n - 1, n))
    if parts:
        ax, ay = np.ones((n, n + 1)), np.ones((n + 1, n))
        ax[8:14, 9:16] = ay[9:14, 9:15] = 0.0
        ax[7, 9:16], ay[8, 9:15] = 0.3, 0.6
        gas.set_open_parts(ax, ay)
    gas.step(0.02)
    return gas


@pytest.mark.parametrize("parts", [False, True])
@pytest.mark.parametrize("expands", [False, True])
def test_the_sum_stays_in_a_shut_box(parts, expands):
    gas = stirred(parts)
    if expands:
        gas.expansion[2, 3] = 30.0
    density = np.random.default_rng(1).random(gas.grid.shape)
    total = math.fsum(density.reshape(-1).tolist())
    for _ in range(20):
        gas.step(0.02)
        assert carried(gas, density, 0.0, 0.02) == 0.0
    assert math.fsum(density.reshape(-1).tolist()) == pytest.approx(total, rel=1e-13)
    assert density.min() > -1e-12


def test_what_leaves_through_a_side_is_what_is_missing():
    gas = windy("open")
    x, _ = gas.grid.centres()
    density = np.exp(-(((x - 0.7) / 0.1) ** 2))
    total = float(np.sum(density)) / 24**2
    left = sum(carried(gas, density, 0.0, 0.05) for _ in range(10))
    assert 0.5 * total < left <= total
    assert left + float(np.sum(density)) / 24**2 == pytest.approx(total, rel=1e-12)


def test_air_from_outside_brings_what_surrounds():
    """0.2 m of it come in at 1 m/s in 0.2 s, through a side 1 m high: 3 times 0.2."""
    gas, density = windy("open"), np.zeros((24, 24))
    left = carried(gas, density, 3.0, 0.2)
    assert left == pytest.approx(-0.6, rel=1e-12)
    assert float(np.sum(density)) / 24**2 == pytest.approx(0.6, rel=1e-12)


def test_a_wind_moves_it_by_second_order():
    """By half a meter; the limiter costs a little at the top (van Leer 1974)."""
    off = []
    for n in (64, 128, 256):
        gas = windy("open", n)
        x, _ = gas.grid.centres()
        density = np.exp(-(((x - 0.25) / 0.08) ** 2))
        for _ in range(16):
            carried(gas, density, 0.0, 0.5 / 16)
        off.append(float(np.mean(np.abs(density - np.exp(-(((x - 0.75) / 0.08) ** 2))))))
    assert off[1] < off[0] / 2.8 and off[2] < off[1] / 2.8 and off[2] < 0.01


def test_what_expands_becomes_thin():
    """A cell that grows at 5 1/s amid gas of the same density keeps, of it, exp(-5 dt)."""
    gas, density = stirred(False), np.ones((24, 24))
    gas.u[:], gas.v[:] = 0.0, 0.0
    h = gas.grid.cell
    gas.u[:, :] = 2.5 * (np.arange(25) - 12.0)[None] * h
    gas.v[:, :] = 2.5 * (np.arange(25) - 12.0)[:, None] * h
    carried(gas, density, 0.0, 0.02)
    assert density[8:16, 8:16] == pytest.approx(np.full((8, 8), math.exp(-0.1)), rel=3e-4)


def test_several_are_carried_as_each_alone_is():
    gas, rng = windy("open"), np.random.default_rng(6)
    both = rng.random((24, 24, 2))
    alone = both.copy()
    left = carry_densities(gas, both, np.array([0.0, 0.4]), 0.1)
    for k, outside in enumerate((0.0, 0.4)):
        assert carried(gas, alone[..., k], outside, 0.1) == left[k]
    assert np.array_equal(both, alone)


def test_a_gas_whose_fields_are_carried_elsewhere_leaves_them():
    """But not its velocities, nor what flows of their momentum through the sides."""
    settings = GasSettings(carries_fields=False)
    gas = Gas(Grid(24, 24, 1.0 / 24), windy("open").borders, settings, fields=("temperature",))
    gas.u[:], gas.scalars[:, 6] = 1.0, 400.0
    gas.u[12, 6] = 1.5
    before = gas.scalars.copy()
    gas.keep_books()
    gas.step(0.02)
    assert np.array_equal(gas.scalars, before) and gas.u[12, 6] != 1.5
    assert np.all(np.abs(gas.ledger.fields.rows) < 1e-12) and np.max(np.abs(gas.ledger.momentum.open)) < 1e-12
