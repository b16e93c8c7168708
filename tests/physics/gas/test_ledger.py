"""The books of the gas room: every row is found for itself, and together they explain what changed."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from game.physics.gas import ADVECTIONS, USUAL, Gas, GasSettings
from game.physics.gas.ledger import (
    CARRIED_THROUGH,
    CARRYING,
    DRAG,
    FORCES,
    HELD,
    SCHEME,
    SIDES,
    SOLIDS,
    SOURCES,
    SPREAD_THROUGH,
    THROUGH,
)
from game.physics.grid import Border, Borders, Grid
from tests.physics.grid.shapes import Disc

EPS = 2.220446049250313e-16
SEALED = Borders()
WIND = Borders(Border("inflow", (1.0, 0.0)), Border("open"), Border("wall"), Border("open"))
OPEN = Borders(*(Border("open") for _ in range(4)))
KEPT = ("smoke", "temperature")


def warm_gas(borders: Borders, **settings) -> Gas:
    """24 by 16 cells with a hot, smoky patch and a disc in the way, a few steps on."""
    chosen = GasSettings(viscosity=1e-3, diffusivity=1e-3, turns=12, tolerance=1e-10, smoke_weight=0.1)
    gas = Gas(Grid(24, 16, 1 / 16), borders, replace(chosen, **settings), fields=("smoke", "temperature"))
    gas.field("temperature")[3:7, 4:9] = 350.0
    gas.field("smoke")[3:7, 4:9] = 1.0
    gas.rates[2, 5, 1], gas.rates[9, 9, 0] = 40.0, 0.3
    gas.set_solids(Disc((0.9, 0.55), 0.17))
    gas.keep_books()
    for _ in range(5):
        gas.step(0.02)
    return gas


def closes(gas: Gas) -> bool:
    """The books of fields are open at most by 4 N eps of the sum of all terms."""
    book = gas.ledger.fields
    content = np.array([gas.total(name) for name in gas.fields])
    terms = np.sum(np.abs(book.rows), axis=0) + content
    return bool(np.all(np.abs(book.open) <= 4.0 * gas.grid.nx * gas.grid.ny * EPS * terms))


@pytest.mark.parametrize("borders", [SEALED, WIND, OPEN], ids=["sealed", "wind", "open"])
@pytest.mark.parametrize("advection", ADVECTIONS)
def test_the_rows_explain_the_change(borders, advection):
    """All but the scheme's own row are computed from what acts; what is left open is rounding."""
    gas = warm_gas(borders, advection=advection)
    book, fields = gas.ledger.momentum, gas.ledger.fields
    scale = float(np.max(np.abs(book.rows)))
    assert scale > 1e-4 and np.max(np.abs(book.open)) < 1e-12 * scale * gas.grid.nx * gas.grid.ny
    assert closes(gas)
    assert book.rows[FORCES, 1] > 1e-5 and abs(book.rows[SOLIDS]).max() > 1e-6
    assert np.all(book.between == 0.0) and np.all(fields.between == 0.0)


@pytest.mark.parametrize("borders", [SEALED, WIND], ids=["sealed", "wind"])
def test_in_flux_form_the_scheme_has_no_row_of_its_own(borders):
    """4 N eps of the sum of terms, heat and smoke alike, with a solid, sources and spreading."""
    gas = warm_gas(borders, conservative=KEPT)
    for _ in range(30):
        gas.step(0.02)
        rows = gas.ledger.fields.rows
        content = np.array([gas.total(name) for name in gas.fields])
        terms = np.abs(rows).sum(axis=0) + content
        assert np.all(np.abs(rows[SCHEME]) <= 4.0 * 24 * 16 * EPS * terms)
    assert (abs(rows[CARRIED_THROUGH, 1]) > 1e-3) == (borders is WIND)


def test_without_flux_form_the_scheme_tells_what_it_lost():
    gas = warm_gas(SEALED)
    rows = gas.ledger.fields.rows
    assert 1e-9 < abs(rows[SCHEME, 0]) < 0.1 * gas.total("smoke")
    assert rows[CARRIED_THROUGH, 0] == 0.0 and rows[SPREAD_THROUGH, 0] == 0.0
    h2 = gas.grid.cell**2
    assert rows[SOURCES] == pytest.approx([0.02 * 0.3 * h2, 0.02 * 40.0 * h2])


def test_pressure_on_solids_is_what_the_loads_say():
    """Steady gas of no viscosity: the step's push on the gas is the loads' reaction."""
    gas = warm_gas(WIND, viscosity=0.0, advection="linear")
    force = np.sum([load.force for load in gas.loads(density=1.0)], axis=0)
    assert gas.ledger.momentum.rows[SOLIDS] == pytest.approx(-0.02 * force, rel=1e-9)


def test_a_uniform_lift_in_a_closed_box_is_held_by_its_sides():
    """Gravity on warm gas everywhere: forces and the sides' pressure are opposite, nothing moves."""
    gas = Gas(Grid(16, 16, 1 / 16), settings=GasSettings(turns=40, tolerance=1e-13), fields=("temperature",))
    gas.field("temperature")[:] = 303.15
    gas.keep_books()
    for _ in range(3):
        gas.step(0.01)
    rows = gas.ledger.momentum.rows
    lift = 0.01 * 9.81 * (10.0 / 293.15) * (15 / 16)  # no force moves what lies on the sides
    assert rows[FORCES, 1] == pytest.approx(lift, rel=1e-9)
    assert rows[SIDES, 1] == pytest.approx(-lift, rel=1e-6) and abs(rows[CARRYING, 1]) < 1e-9


def test_a_uniform_wind_carries_as_much_out_as_in():
    borders = Borders(Border("inflow", (1.0, 0.0)), Border("open"), Border("periodic"), Border("periodic"))
    gas = Gas(Grid(16, 8, 1 / 8), borders, GasSettings(gravity=(0.0, 0.0)), fields=("smoke",))
    gas.u[:] = 1.0
    gas.field("smoke")[2:5, 5:9] = 1.0
    gas.keep_books()
    for _ in range(3):
        gas.step(0.05)
    assert np.max(np.abs(gas.ledger.momentum.rows)) < 1e-12
    for _ in range(60):
        gas.step(0.05)
    assert gas.total("smoke") < 1e-6


def test_momentum_and_smoke_leave_with_the_wind():
    """A quicker stream than the one that comes in: what goes out is its momentum flux, rho u² less u² in."""
    borders = Borders(Border("inflow", (1.0, 0.0)), Border("open"), Border("periodic"), Border("periodic"))
    gas = Gas(Grid(16, 8, 1 / 8), borders, GasSettings(effects=USUAL, gravity=(0.0, 0.0)), fields=("smoke",))
    gas.u[:] = 1.0
    gas.u[:, 1:] = 3.0
    gas.v[:] = 0.5
    gas.scalars[:] = 2.0
    gas.keep_books()
    gas.step(0.01)
    rows, fields = gas.ledger.momentum.rows, gas.ledger.fields.rows
    assert rows[THROUGH] == pytest.approx([0.01 * (1.0 - 9.0), 0.01 * 0.5 * (1.0 - 3.0)])
    assert fields[CARRIED_THROUGH, 0] == pytest.approx(-0.01 * 3.0 * 2.0)


def test_momentum_leaves_upwards_as_well():
    """The same from the bottom to the top: what goes out there takes the velocity along with it, too."""
    periodic, up = Border("periodic"), Border("inflow", (0.0, 1.0))
    borders = Borders(periodic, periodic, up, Border("open"))
    gas = Gas(Grid(8, 16, 1 / 8), borders, GasSettings(gravity=(0.0, 0.0)), fields=("smoke",))
    gas.v[0], gas.v[1:], gas.u[:] = 1.0, 3.0, 0.5
    gas.keep_books()
    gas.step(0.01)
    rows = gas.ledger.momentum.rows
    assert rows[THROUGH] == pytest.approx([0.01 * 0.5 * (1.0 - 3.0), 0.01 * (1.0 - 9.0)])


def test_plates_drag_the_gas_by_their_shear():
    """Couette: at the steady state one plate gives what the other takes; a moving start gives nu U t / d."""
    borders = Borders(
        Border("periodic"), Border("periodic"), Border("no-slip"), Border("no-slip", (1.0, 0.0))
    )
    settings = GasSettings(viscosity=0.01, gravity=(0.0, 0.0), turns=12, tolerance=1e-10, centring=0.5)
    gas = Gas(Grid(4, 16, 1 / 16), borders, settings, fields=("smoke",))
    gas.keep_books()
    gas.step(0.01)
    first = gas.ledger.momentum
    assert first.change[0] == pytest.approx(first.rows[DRAG, 0], rel=1e-9) and first.rows[DRAG, 0] > 0.0
    # gas at rest: a parabola through the wall and two cells leaves it with 8/3 of the speed over a cell
    steepest = 0.01 * 0.01 * 0.25 * 16 * 8.0 / 3.0
    assert 0.9 * steepest < first.rows[DRAG, 0] < steepest
    gas.u[:] = (np.arange(16) + 0.5)[:, None] / 16
    gas.jolt()
    for _ in range(4):
        gas.step(0.01)
    assert abs(gas.ledger.momentum.rows[DRAG, 0]) < 1e-9


def test_what_is_done_between_steps_and_what_sides_hold():
    gas = Gas(
        Grid(8, 8, 1 / 8), settings=GasSettings(gravity=(0.0, 0.0), advection="linear"), fields=("smoke",)
    )
    gas.keep_books()
    gas.step(0.01)
    gas.u[:, 1:-1] += 0.1
    gas.scalars[2, 2] += 3.0
    gas.step(0.01)
    book, fields = gas.ledger.momentum, gas.ledger.fields
    assert book.between == pytest.approx([0.1 * 7 / 8, 0.0], abs=1e-14)
    assert fields.between == pytest.approx([3.0 / 64])
    assert abs(book.rows[HELD, 0]) > 0.0 and gas.ledger.momentum.change[0] < 0.0
    state = type(gas.state())(*(array.copy() for array in gas.state()))
    gas.restore(state)
    assert gas.ledger.momentum is None and gas.ledger.fields is None
    gas.step(0.01)
    assert np.all(gas.ledger.fields.between == 0.0)
    gas.keep_books(False)
    assert gas.ledger is None and math.isfinite(gas.energy())


def test_books_change_nothing_of_the_flow():
    one, other = warm_gas(WIND, prime=True), warm_gas(WIND, prime=True)
    other.keep_books(False)
    for _ in range(5):
        one.step(0.02)
        other.step(0.02)
    assert all(np.array_equal(a, b) for a, b in zip(one.state(), other.state(), strict=True))
