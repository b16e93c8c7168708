"""Single kernels of a gas on fields that are linear, where their answers are known."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.gas import Gas, GasSettings
from game.physics.gas.tracing import trace
from game.physics.gas.viscosity import add_laplacian, steepest
from game.physics.grid import Borders, Grid
from game.physics.grid.borders import NO_SLIP, PERIODIC, WALL, Edges
from game.physics.grid.ghosts import X, fill_velocity_ghosts
from game.physics.grid.layout import PAD
from tests.physics.grid.shapes import Disc


@pytest.mark.parametrize("slope", [(3.0, 0.0), (0.0, -2.0), (1.5, 4.0)])
def test_an_even_rise_of_pressure_pushes_a_disc_with_its_area(slope):
    """-grad p times the area that the faces close (summation by parts); the torque is that of the centre."""
    radius, h, density = 0.31, 0.05, 1.2
    gas = Gas(Grid(30, 24, h), settings=GasSettings(gravity=(0.0, 0.0)), fields=("smoke",))
    centre = np.array([0.7, 0.62])
    gas.set_solids(Disc(centre, radius))
    x, y = gas.grid.centres()
    gas.pressure[:] = 5.0 + slope[0] * x + slope[1] * y
    (load,) = gas.loads(density=density)
    closed = h * h * np.sum(1.0 - gas.faces.ax), h * h * np.sum(1.0 - gas.faces.ay)
    wanted = [-density * rise * area for rise, area in zip(slope, closed, strict=True)]
    assert load.force == pytest.approx(wanted, rel=1e-9, abs=1e-9)
    assert closed == pytest.approx((math.pi * radius**2,) * 2, rel=0.02)
    turning = centre[0] * load.force[1] - centre[1] * load.force[0]
    assert load.torque == pytest.approx(turning, abs=0.02 * abs(turning) + 0.02)


def traced(w, scale, side=WALL, straight=False):
    shift = np.zeros_like(w)
    trace(w, scale, np.full(4, side), straight, shift)
    return shift


@pytest.mark.parametrize(
    ("kind", "rows", "share"), [(WALL, 12, 0.97), (NO_SLIP, 12, 0.97), (NO_SLIP, 4, 1.0)]
)
def test_what_viscosity_does_lies_in_the_spectrum_that_its_iteration_is_made_for(kind, rows, share):
    """Eigenvalues of -h² laplace of u (periodic along x): real, above 0, just below `steepest`."""
    columns = 9
    edges = Edges(np.array([PERIODIC, PERIODIC, kind, kind]), np.zeros((4, 12, 2)))
    size = rows * (columns - 1)
    matrix = np.empty((size, size))
    for k in range(size):
        field = np.zeros((rows, columns))
        field.flat[[(k // (columns - 1)) * columns + k % (columns - 1)]] = 1.0
        field[:, -1] = field[:, 0]  # the seam is one face
        padded = np.zeros((rows + 2 * PAD, columns + 2 * PAD))
        padded[PAD:-PAD, PAD:-PAD] = field
        fill_velocity_ghosts(padded, X, edges)
        out = np.zeros((rows, columns))
        add_laplacian(padded, np.ones_like(padded), -1.0, out)
        matrix[:, k] = out[:, :-1].ravel()
    found = np.linalg.eigvals(matrix)
    assert np.max(np.abs(found.imag)) < 1e-9 and np.min(found.real) > -1e-9
    along = 4.0  # the periodic way's own largest one
    most = np.max(found.real) - along + 0.5 * steepest(edges.kinds)
    bound = steepest(edges.kinds) * (1.0 + 1e-9)
    assert share * steepest(edges.kinds) * (1.0 - 1e-9) < most < bound


def test_ways_in_a_turning_gas_follow_the_midpoint_rule():
    ny, nx, scale, turn = 9, 11, 0.7, 0.4
    j, i = np.mgrid[0:ny, 0:nx].astype(float)
    x, y = i - 5.0, j - 4.0
    w = turn * np.stack([-y, x], axis=2)
    middle = (slice(3, 6), slice(3, 8))
    half = 0.5 * scale * turn
    wanted = scale * turn * np.stack([-(y - half * x), x + half * y], axis=2)  # v at r - v dt / 2
    assert traced(w, scale)[middle] == pytest.approx(wanted[middle], rel=1e-12, abs=1e-12)
    assert traced(w, scale, straight=True)[middle] == pytest.approx(scale * w[middle], rel=1e-12)


def test_ways_end_on_walls_and_go_on_where_sides_are_joined():
    w = np.zeros((4, 6, 2))
    w[..., 0] = 3.0
    behind = np.minimum(3.0, np.arange(6.0) + 0.5)  # back to the wall, half a cell beyond the first centre
    assert traced(w, 1.0)[..., 0] == pytest.approx(np.tile(behind, (4, 1)))
    assert traced(w, 1.0, PERIODIC)[..., 0] == pytest.approx(3.0)


def test_maccormack_carries_a_smooth_field_far_better_than_linear_interpolation():
    """Two steps of 0.4 cells in an even wind around a torus: the wave moves as it is."""
    n, dt, errors = 24, 0.4 / 24, {}
    for advection in ("linear", "maccormack"):
        settings = GasSettings(gravity=(0.0, 0.0), advection=advection)
        gas = Gas(Grid(n, 4, 1.0 / n), Borders.all("periodic"), settings, fields=("smoke",))
        gas.u[:] = 1.0
        x, _ = gas.grid.centres()
        gas.field("smoke")[:] = np.sin(2.0 * math.pi * x)
        for _ in range(2):
            gas.step(dt)
        errors[advection] = np.abs(gas.field("smoke") - np.sin(2.0 * math.pi * (x - 2.0 * dt))).mean()
    assert errors["maccormack"] < 0.25 * errors["linear"]
