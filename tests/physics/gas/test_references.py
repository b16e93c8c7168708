"""The gas against closed forms and figures of the literature."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.special import j0, j1

from game.physics.gas import Gas, GasSettings
from game.physics.grid import Border, Borders, Grid

STILL = GasSettings(gravity=(0.0, 0.0))
EXACT = replace(STILL, turns=30, tolerance=1e-11, centring=0.5, prime=True)


def taylor_green(grid, time, wind, nu=0.0):
    """u, v on faces: Taylor and Green's eddies carried along by a wind."""
    k, left = 2.0 * math.pi, math.exp(-8.0 * math.pi**2 * nu * time)
    found = []
    for number, (x, y) in enumerate((grid.u_places(), grid.v_places())):
        a, b = k * (x - wind[0] * time), k * (y - wind[1] * time)
        turn = np.sin(a) * np.cos(b) if number == 0 else -np.cos(a) * np.sin(b)
        found.append(wind[number] + left * turn)
    return found


def error_of(n, advection, wind, nu=0.0, time=0.4, cfl=1.3):
    """L2 error of u after a time, at a Courant number."""
    grid = Grid(n, n, 1.0 / n)
    settings = replace(EXACT, advection=advection, viscosity=nu)
    gas = Gas(grid, Borders.all("periodic"), settings, fields=("smoke",))
    gas.u[:], gas.v[:] = taylor_green(grid, 0.0, wind)
    steps = max(1, round(time * n * (1.0 + wind[0]) / cfl))
    for _ in range(steps):
        gas.step(time / steps)
    return float(np.sqrt(np.mean((gas.u - taylor_green(grid, time, wind, nu)[0]) ** 2)))


@pytest.mark.parametrize(
    ("advection", "wind", "low", "high"),
    [
        ("time-centred", (1.0, 0.5), 1.9, 2.3), ("time-centred", (0.0, 0.0), 1.9, 4.0),
        ("maccormack", (1.0, 0.5), 0.85, 1.15), ("linear", (1.0, 0.5), 0.7, 1.15),
        ("cubic", (1.0, 0.5), 0.8, 1.15),
    ],
)  # fmt: skip
def test_order_on_eddies_that_stand_and_move(advection, wind, low, high):
    """Only the time-centred step is of second order when the eddies move."""
    cells = (48, 96) if advection == "time-centred" else (32, 64)
    coarse, fine = (error_of(n, advection, wind) for n in cells)
    assert low < math.log2(coarse / fine) < high


def test_viscous_eddies_fade_at_the_known_rate():
    """nu 0.01, t 1: speed 0.4540407, energy 0.206153 (exp(-2 nu k² t))."""
    grid = Grid(32, 32, 1.0 / 32)
    gas = Gas(grid, Borders.all("periodic"), replace(EXACT, viscosity=0.01), fields=("smoke",))
    gas.u[:], gas.v[:] = taylor_green(grid, 0.0, (0.0, 0.0))
    start = gas.energy()
    for _ in range(40):
        gas.step(1.0 / 40)
    assert np.max(np.abs(gas.u)) == pytest.approx(0.4540407, rel=0.01)
    assert gas.energy() / start == pytest.approx(0.206153, rel=0.01)


@pytest.mark.parametrize(("q", "least"), [(0.5, 0.97), (0.52, 0.93)])
def test_a_dipole_keeps_its_energy(q, least):
    """Lamb's dipole (k a = 3.831706) over 2.5 radii; MacCormack keeps far less."""
    kept = {name: _dipole(name, q) for name in ("time-centred", "maccormack")}
    assert kept["time-centred"] > least and kept["maccormack"] < kept["time-centred"] - 0.05


def _dipole(advection, q):
    n, a = 64, 0.2
    k = 3.8317059702075125 / a
    grid = Grid(n, n, 1.0 / n)
    x, y = grid.nodes()
    x, y = x - 0.4, y - 0.5
    r = np.maximum(np.hypot(x, y), 1e-12)
    stream = np.where(r < a, -2.0 * j1(k * r) / (k * j0(k * a)) * y / r, a * a * y / (r * r) - y) + y
    settings = replace(EXACT, advection=advection, centring=q)
    gas = Gas(grid, Borders.all("wall"), settings, fields=("smoke",))
    gas.u[:], gas.v[:] = np.diff(stream, axis=0) * n, -np.diff(stream, axis=1) * n
    gas.u[:, 0] = gas.u[:, -1] = gas.v[0] = gas.v[-1] = 0.0
    gas.step(1e-6)  # the walls
    start = gas.energy()
    dt = 1.5 / n / 2.5
    for _ in range(round(0.5 / dt)):
        gas.step(dt)
    return gas.energy() / start


def channel(bottom, top, force, nu=0.01, n=16):
    borders = Borders(Border("periodic"), Border("periodic"), bottom, top)
    gas = Gas(Grid(4, n, 1.0 / n), borders, replace(EXACT, viscosity=nu), fields=("smoke",))
    gas.force[:, :, 0] = force
    for _ in range(100):
        gas.step(0.1)
    return gas


def test_a_plate_drags_the_gas_as_the_series_says():
    """Couette flow from rest: 0.2627563 half way at t = 10."""
    gas = channel(Border("no-slip"), Border("no-slip", (1.0, 0.0)), 0.0)
    assert 0.5 * float(gas.u[7, 2] + gas.u[8, 2]) == pytest.approx(0.26275627, rel=0.01)
    assert np.max(np.abs(gas.v)) < 1e-9


def test_a_force_drives_a_channel_as_the_series_says():
    """Poiseuille flow from rest under 0.08 m/s²: 0.6153525 in the middle at t = 10."""
    gas = channel(Border("no-slip"), Border("no-slip"), 0.08)
    top = 1.125 * gas.u[8, 2] - 0.125 * gas.u[9, 2]  # the parabola's top, from two points beside it
    assert float(top) == pytest.approx(0.61535251, rel=0.01)


def test_a_parabola_between_two_walls_stays_as_it_is():
    """Poiseuille's flow under its force, f y (1 - y) / (2 nu): exact on any cells, moving walls or not."""
    nu, force, speed = 0.01, 0.08, 0.3
    for n in (4, 16):
        borders = Borders(
            Border("periodic"), Border("periodic"), Border("no-slip"), Border("no-slip", (speed, 0.0))
        )
        gas = Gas(Grid(4, n, 1.0 / n), borders, replace(EXACT, viscosity=nu), fields=("smoke",))
        gas.force[:, :, 0] = force
        _, y = gas.grid.u_places()
        gas.u[:] = exact = 0.5 * force / nu * y * (1.0 - y) + speed * y
        for _ in range(50):
            gas.step(0.1)
        assert np.max(np.abs(gas.u - exact)) < 1e-4 * float(np.max(exact))  # what the iteration leaves


def test_numerical_spread_of_linear_interpolation():
    """f (1 - f) h² / (2 dt) of variance a second: 0.00125 m²/s at a Courant number of 1/2."""
    borders = Borders(Border("periodic"), Border("periodic"))
    gas = Gas(Grid(200, 4, 0.01), borders, replace(STILL, advection="linear"), fields=("smoke",))
    gas.u[:] = 0.5
    gas.field("smoke")[:, 100] = 1.0
    x = gas.grid.centres()[0][0] - 1.005
    for _ in range(100):
        gas.step(0.01)
    shape = gas.field("smoke")[0]
    middle = float(np.sum(x * shape))
    assert middle == pytest.approx(0.5, rel=1e-9)
    spread = float(np.sum((x - middle) ** 2 * shape))
    assert spread / 2.0 == pytest.approx(0.00125, rel=1e-6)


def kovasznay(n, steps):
    """Behind a row of rods at Re 40 (Kovasznay 1948), inflow left, outflow right: L2 error of u."""
    nu = 1.0 / 40.0
    lam = 20.0 - math.sqrt(400.0 + 4.0 * math.pi**2)
    k = 2.0 * math.pi
    grid = Grid(n, n, 1.0 / n, (-0.5, -0.5))
    x, y = grid.u_places()
    want_u = 1.0 - np.exp(lam * x) * np.cos(k * y)
    x, y = grid.v_places()
    want_v = lam / k * np.exp(lam * x) * np.sin(k * y)
    _, y = grid.centres()
    given = np.stack(
        [
            1.0 - math.exp(-0.5 * lam) * np.cos(k * y[:, 0]),
            lam / k * math.exp(-0.5 * lam) * np.sin(k * y[:, 0]),
        ],
        1,
    )
    borders = Borders(Border("inflow", given), Border("open"), Border("periodic"), Border("periodic"))
    gas = Gas(
        grid, borders, replace(EXACT, viscosity=nu, prime=False, turns=8, tolerance=1e-7), fields=("smoke",)
    )
    gas.u[:], gas.v[:] = want_u, want_v
    for _ in range(steps):
        gas.step(0.5 / n)
    inner = slice(0, 3 * n // 4)
    return float(np.sqrt(np.mean((gas.u - want_u)[:, inner] ** 2))), float(np.max(np.abs(gas.divergence())))


def test_kovasznay_flow_through_an_outflow():
    (coarse, _), (fine, left) = kovasznay(24, 150), kovasznay(48, 300)
    assert fine < 1e-3 and math.log2(coarse / fine) > 1.5 and left < 1e-4


@pytest.mark.parametrize(("re", "within"), [(100, 0.024)])
def test_the_eddy_in_a_cavity(re, within):
    """Speeds on the centre lines against two extrapolated discretisations; 32 x 32 cells."""
    n = 32
    borders = Borders(*(Border("no-slip") for _ in range(3)), Border("no-slip", (1.0, 0.0)))
    gas = Gas(Grid(n, n, 1.0 / n), borders, replace(STILL, viscosity=1.0 / re), fields=("smoke",))
    for _ in range(600):
        gas.step(1.0 / n)
    found = gas.u[:, n // 2].min(), gas.v[n // 2].max(), gas.v[n // 2].min()
    assert found == pytest.approx((-0.21404412, 0.17957535, -0.25380594), rel=within)


def test_the_eddy_converges_in_the_second_order():
    """The worst of the three extremes at Re 100, from 16 to 48 cells, 1.2 % off with straight lines."""
    errors = []
    for n in (16, 48):
        borders = Borders(*(Border("no-slip") for _ in range(3)), Border("no-slip", (1.0, 0.0)))
        settings = replace(STILL, viscosity=0.01)
        gas = Gas(Grid(n, n, 1.0 / n), borders, settings, fields=("smoke",))
        for _ in range(16 * n):
            gas.step(1.0 / n)
        middle = gas.u[:, n // 2].min(), gas.v[n // 2].max(), gas.v[n // 2].min()
        known = (-0.21404412, 0.17957535, -0.25380594)
        errors.append(max(abs(a / b - 1.0) for a, b in zip(middle, known, strict=True)))
    assert math.log(errors[0] / errors[1]) / math.log(3.0) > 1.9 and errors[1] < 0.0095


def test_heavy_on_light_grows_at_the_known_rate():
    """Rayleigh-Taylor over a smooth layer 0.08 m thick: 1.955235 1/s (viscous, tanh)."""
    n, delta, k = 48, 0.08, 2.0 * math.pi
    borders = Borders(Border("periodic"), Border("periodic"))
    settings = GasSettings(
        gravity=(0.0, -1.0), ambient=1.0, viscosity=1e-3, diffusivity=1e-3, turns=6, tolerance=1e-8
    )
    gas = Gas(Grid(n, n, 1.0 / n), borders, settings, fields=("temperature",))
    _, y = gas.grid.centres()
    gas.field("temperature")[:] = 1.0 - np.tanh((y - 0.5) / delta)  # hot (light) below
    x, y = gas.grid.v_places()
    gas.v[:] = 1e-4 * np.cos(k * x) * np.sin(math.pi * y)
    found = []
    for step in range(180):
        gas.step(0.01)
        if step in (119, 179):
            found.append(float(np.max(np.abs(np.fft.rfft(gas.v[n // 2])[1]))))
    assert math.log(found[1] / found[0]) / 0.6 == pytest.approx(1.955235, rel=0.06)


def _growth_of_rolls(rayleigh: float, dt: float, n: int = 16, time: float = 30.0) -> float:
    """Rate 1/s, in the second half of the time, at which rolls grow in a layer heated from below.

    Free sides (no stress, given temperatures), a layer 1 m high, a roll as wide as it turns most easily.
    """
    wide = round(2.0 * math.sqrt(2.0) * n)
    even, mean = math.sqrt(1.0 / rayleigh), 300.0  # nu = kappa; lift is 1 m/s² for a kelvin
    settings = GasSettings(viscosity=even, diffusivity=even, gravity=(0.0, -mean), ambient=mean)
    below, above = ({"temperature": mean + side} for side in (0.5, -0.5))
    borders = Borders(
        Border("periodic"), Border("periodic"), Border("wall", scalars=below), Border("wall", scalars=above)
    )
    gas = Gas(Grid(wide, n, 1.0 / n), borders, settings.quality("film"), fields=("temperature",))
    x, y = gas.grid.centres()
    roll = np.sin(math.pi * y) * np.cos(2.0 * math.pi * n / wide * x)
    gas.field("temperature")[:] = mean + 0.5 - y + 1e-4 * roll
    steps = round(time / dt)
    for step in range(steps):
        gas.step(dt)
        if step == steps // 2 - 1:
            halfway = float(np.sum(gas.field("temperature") * roll))
    whole = float(np.sum(gas.field("temperature") * roll))
    return math.log(whole / halfway) / ((steps - steps // 2) * dt)


def critical_rayleigh(dt: float) -> float:
    """Where rolls neither grow nor shrink, by two secants."""
    low, high = 640.0, 680.0
    slow, quick = _growth_of_rolls(low, dt), _growth_of_rolls(high, dt)
    between = low - slow * (high - low) / (quick - slow)
    left = _growth_of_rolls(between, dt)
    return between - left * (between - low) / (left - slow)


def test_a_layer_heated_from_below_turns_from_its_critical_number():
    """Rayleigh 1916: 27 pi^4 / 4 between free sides; to the second order in the step."""
    coarse, middle, fine = (critical_rayleigh(dt) for dt in (0.2, 0.1, 0.05))
    assert fine == pytest.approx(27.0 * math.pi**4 / 4.0, rel=5e-3)  # of 16 cells
    assert math.log2(abs(coarse - middle) / abs(middle - fine)) > 1.8
    assert middle == pytest.approx(fine, rel=1e-3)


def test_a_source_pushes_the_gas_out_as_it_must():
    """Q = 0.2 m²/s in the middle of an open box: through every side together flows Q."""
    gas = Gas(Grid(32, 32, 1.0 / 32), Borders.all("open"), replace(STILL, turns=10, tolerance=1e-9))
    gas.expansion[14:18, 14:18] = 0.2 / (16 * gas.grid.cell**2)
    for _ in range(5):
        gas.step(0.01)
    h = gas.grid.cell
    out = (gas.u[:, -1].sum() - gas.u[:, 0].sum() + gas.v[-1].sum() - gas.v[0].sum()) * h
    assert out == pytest.approx(0.2, rel=1e-6)
    assert np.max(np.abs(gas.divergence())) < 1e-5
    assert gas.u[16, 31] == pytest.approx(-gas.u[16, 1], rel=1e-6)
