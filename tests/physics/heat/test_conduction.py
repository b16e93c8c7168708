"""Heat on grids: closed forms, orders, limits that are refused or switched, and that no heat is lost."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.heat import HeatGrid, MeltingGrid, MeltingState, Phases
from game.physics.heat.exact import flux_rise, ignition_time, neumann_number, slab_centre, stefan_number
from game.physics.heat.grid import heat_at

SCHEMES = ("explicit", "crank-nicolson", "alternating")
# flux: exact at the steady state; what two others leave after 300 steps, in cells that conduct 1e4 times as
# well
NEARLY_STEADY = {"explicit": 1e-6, "crank-nicolson": 1e-2, "alternating": 1e-4}


def spot(n: int, size: float = 0.2, wide: float = 0.02, high: float = 100.0) -> np.ndarray:
    x = (np.arange(n) + 0.5) / n * size - 0.5 * size
    return high * np.exp(-(x[:, None] ** 2 + x[None, :] ** 2) / (2.0 * wide**2))


@pytest.mark.parametrize("scheme", SCHEMES)
def test_a_hot_spot_spreads_as_its_variance_says(scheme):
    """Height 50 of 100 K and variance 8e-4 m² after 2 s: s² = s0² + 2 D t."""
    n = 65
    grid = HeatGrid(spot(n), 0.2 / n, 1e-4, 1.0, scheme=scheme)
    steps = 128 if scheme == "explicit" else 32
    for _ in range(steps):
        grid.step(2.0 / steps)
    x = (np.arange(n) + 0.5) / n * 0.2 - 0.1
    share = grid.temperature / np.sum(grid.temperature)
    assert grid.temperature[n // 2, n // 2] == pytest.approx(50.0, rel=5e-3)
    assert np.sum(share * x[None, :] ** 2) == pytest.approx(8e-4, rel=5e-3)
    assert grid.used == scheme


@pytest.mark.parametrize("scheme", SCHEMES)
def test_no_heat_is_lost_in_an_insulated_box_nor_with_a_wall(scheme):
    random = np.random.default_rng(3)
    conductivity = 10.0 ** random.uniform(-2.0, 2.0, (9, 12))
    grid = HeatGrid(random.uniform(200.0, 900.0, (9, 12)), 0.01, conductivity, 1e3, scheme=scheme)
    before = grid.heat()
    dt = 0.9 * grid.explicit_limit * (1.0 if scheme == "explicit" else 60.0)
    for _ in range(2_000):
        grid.step(dt)
    assert grid.heat() == pytest.approx(before, rel=1e-12)
    held = HeatGrid(np.full((9, 12), 300.0), 0.01, conductivity, 1e3, {"left": 500.0, "upper": 100.0}, scheme)
    before = held.heat()
    for _ in range(200):
        held.step(0.9 * held.explicit_limit)
    assert held.heat() - before == pytest.approx(held.came[0], rel=1e-9)
    assert held.temperature[0, 0] > 300.0 > held.temperature[-1, -1]


def test_the_middle_of_a_slab_and_the_order_of_its_cells():
    """0.7723116068585908 at Fo = 0.2."""
    assert slab_centre(0.2) == pytest.approx(0.7723116068585908, rel=1e-14)
    errors = []
    for n in (11, 21, 41, 81):
        slab = HeatGrid(np.ones((1, n)), 2.0 / n, held={"left": 0.0, "right": 0.0}, scheme="explicit")
        steps = math.ceil(0.2 / (0.4 * slab.explicit_limit))
        for _ in range(steps):
            slab.step(0.2 / steps)
        errors.append(abs(slab.temperature[0, n // 2] - 0.7723116068585908))
    slopes = np.diff(np.log(errors)) / np.diff(np.log(2.0 / np.array((11, 21, 41, 81))))
    assert np.all((slopes > 1.85) & (slopes < 2.3)) and errors[-1] < 5e-3 * 0.77


@pytest.mark.parametrize(
    ("scheme", "order"), [("explicit", 1.0), ("crank-nicolson", 2.0), ("alternating", 2.0)]
)
def test_the_order_in_the_step(scheme, order):
    """A decaying wave of the grid itself: its exact rate by the difference of second order."""
    n, d = 16, 1.0 / 16
    x = (np.arange(n) + 0.5) * d
    wave = np.cos(math.pi * x)[None, :] * np.cos(2.0 * math.pi * x)[:, None]
    eigen = -(2.0 - 2.0 * math.cos(math.pi * d) + 2.0 - 2.0 * math.cos(2.0 * math.pi * d)) / d**2
    errors, steps = [], np.array((40, 80, 160, 320, 640))
    if scheme != "explicit":
        steps = steps // 8
    for count in steps.tolist():
        grid = HeatGrid(2.0 + wave, d, scheme=scheme)
        grid.fresh = 0
        for _ in range(count):
            grid.step(0.03 / count)
        errors.append(np.sqrt(np.mean((grid.temperature - 2.0 - wave * math.exp(eigen * 0.03)) ** 2)))
    slope = -np.polyfit(np.log(steps), np.log(errors), 1)[0]
    assert order - 0.15 <= slope <= order + 0.25


def test_after_a_jump_two_damped_steps_keep_crank_nicolson_from_ringing():
    def ringing(damped: int) -> float:
        start = np.full((4, 40), 300.0)
        start[:, :20] = 900.0
        grid = HeatGrid(start, 0.01, 1.0, 1.0, scheme="crank-nicolson")
        grid.fresh = damped
        for _ in range(6):
            grid.step(200.0 * grid.explicit_limit)
        return float(np.max(np.diff(grid.temperature[0])))  # it may only fall from the left to the right

    assert ringing(2) < 1e-6 and ringing(0) > 10.0


@pytest.mark.parametrize("times", [2.0, 100.0])
def test_an_explicit_step_beyond_its_limit_is_refused_or_switched(times):
    """0.25 s for 1 cm and 1e-4 m²/s; at twice that a checkerboard would grow by -3 each step."""
    refused = HeatGrid(spot(20), 0.01, 1e-4, 1.0, scheme="explicit")
    assert refused.explicit_limit == pytest.approx(0.25, rel=1e-12)
    with pytest.raises(ValueError, match=r"dt = .*stable up to 0\.25 s"):
        refused.step(times * 0.25)
    switched = HeatGrid(spot(20), 0.01, 1e-4, 1.0, scheme="explicit", beyond="switch")
    switched.step(times * 0.25)
    assert switched.used == "alternating" and np.max(switched.temperature) <= 100.0
    switched.step(0.25)
    assert switched.used == "explicit"


def test_the_growth_of_a_checkerboard_at_twice_the_limit():
    board = np.indices((24, 24)).sum(axis=0) % 2 * 2.0 - 1.0
    grid = HeatGrid(2.0 + board, 0.01, 1e-4, 1.0, scheme="explicit")
    grid.step(0.25)
    inner = (grid.temperature - 2.0)[8:16, 8:16] * board[8:16, 8:16]
    assert np.allclose(inner, 1.0 - 8.0 * 0.25, rtol=1e-12)  # -1 at the limit itself: 1 - 8 r with r = 1/4


@pytest.mark.parametrize("scheme", SCHEMES)
def test_at_a_jump_of_conductivity_the_flux_is_the_same_on_both_sides(scheme):
    k = np.ones((1, 20))
    k[:, 10:] = 1e4
    grid = HeatGrid(np.full((1, 20), 300.0), 0.05, k, 1.0, {"left": 400.0, "right": 300.0}, scheme)
    if scheme == "explicit":
        t = grid.temperature  # the steady state in closed form: resistances in a row
        resistance = np.concatenate([[0.5], 0.5 / k[0, :-1] + 0.5 / k[0, 1:], [0.5e-4]])
        t[0] = 400.0 - 100.0 * np.cumsum(resistance)[:-1] / np.sum(resistance)
        grid.step(grid.explicit_limit)
    else:
        for _ in range(300):
            grid.step(0.02 if scheme == "alternating" else 1.0)
    t = np.concatenate([[400.0], grid.temperature[0], [300.0]])
    fluxes = np.concatenate([grid.gx[0] * -np.diff(t)])
    assert np.allclose(fluxes, fluxes[0], rtol=NEARLY_STEADY[scheme])
    assert grid.temperature[0, 10] - 300.0 < 0.01


def test_two_bodies_in_touch_meet_at_the_mean_of_their_effusivities():
    """375 K for 400 K and 300 K with 1500 and 500 (J/(m² K √s))."""
    n = 200
    k, c = np.full((1, n), 1500.0), np.full((1, n), 1500.0)
    k[:, n // 2 :], c[:, n // 2 :] = 500.0, 500.0
    start = np.full((1, n), 400.0)
    start[:, n // 2 :] = 300.0
    grid = HeatGrid(start, 0.01, k, c, scheme="crank-nicolson")
    for _ in range(40):
        grid.step(1e-3)
    left, right = grid.temperature[0, n // 2 - 1 : n // 2 + 1]
    assert (1500.0 * left + 500.0 * right) / 2000.0 == pytest.approx(375.0, rel=1e-3)


def test_under_a_flux_a_thick_solid_warms_and_lights_when_it_should():
    """368.5 K after 30 s; 300 K after 19.88 s, of wood under 20 kW/m²."""
    assert flux_rise(2e4, 0.15, 750e3, 30.0) == pytest.approx(368.52709276942454, rel=1e-12)
    assert ignition_time(2e4, 0.15, 750e3, 300.0) == pytest.approx(19.880391010997908, rel=1e-12)
    cell, dt = 1e-4, 0.01
    grid = HeatGrid(np.full((1, 120), 293.0), cell, 0.15, 750e3)
    surface, lit = [], math.nan
    for step in range(3000):
        grid.temperature[0, 0] += 2e4 * dt / (750e3 * cell)
        grid.step(dt)
        surface.append(grid.temperature[0, 0] + 0.5 * cell * 2e4 / 0.15)  # at the face, half a cell farther
        if math.isnan(lit) and surface[-1] >= 593.0:
            lit = (step + 1) * dt
    assert surface[-1] - 293.0 == pytest.approx(368.527, rel=0.01)
    assert lit == pytest.approx(19.88, rel=0.02)


@pytest.mark.parametrize(
    ("ste", "number"), [(0.5, 0.4647859206462445), (0.1, 0.22001627274293786), (3.0, 0.9137512699721845)]
)
def test_a_front_melts_from_a_wall_as_stefan_found(ste, number):
    assert stefan_number(ste) == pytest.approx(number, rel=1e-12)
    wax = Phases(1.0, 1.0, 1.0, 300.0, 900.0, 100.0 / ste, 50.0, 1.0, 1.0, 1.0)
    places, errors = (20, 40), []
    for n in places:
        grid = MeltingGrid(np.full((1, n), 300.0), 1.0 / n, wax, {"left": 400.0})
        time = (0.4 / (2.0 * number)) ** 2
        for _ in range(20):
            grid.step(time / 20.0)
        errors.append(abs(grid.front_across() / 0.4 - 1.0))
    assert errors[-1] < 0.01 and errors[-1] < 0.75 * errors[0] + 1e-4


def test_water_freezes_from_a_cold_wall():
    """21.3 mm of ice in an hour at -10 °C, from water at 5 °C (Neumann)."""
    latent = 917.0 * 334e3
    number = neumann_number(263.15, 278.15, 273.15, (2.22, 1.15e-6), (0.58, 1.39e-7), latent)
    assert number == pytest.approx(0.16558907573898235, rel=1e-10)
    water = Phases(2.22 / 1.15e-6, 0.58 / 1.39e-7, 4e6, 273.15, 373.15, latent, 2e9, 2.22, 0.58, 0.6)
    n, wide = 60, 0.06
    grid = MeltingGrid(np.full((1, n), 278.15), wide / n, water, {"left": 263.15, "right": 278.15})
    for _ in range(60):
        grid.step(60.0)
    assert wide - grid.front_across() == pytest.approx(0.021308940085976533, rel=0.012)


def test_a_lump_stays_at_its_melting_point_until_the_heat_is_paid():
    """148 s, 548 s and 380.4 K: 0.1 kg of wax under 50 W."""
    wax = Phases(2000.0, 2500.0, 2500.0, 330.0, 900.0, 2e5, 1e6, 1.0, 1.0, 1.0)
    grid = MeltingGrid(np.full((2, 2), 293.0), 1.0, wax)
    times = {}
    for second in range(1, 801):
        grid.deposit(np.full((2, 2), 50.0 / 0.1))
        share = float(grid.molten[0, 0])
        if share > 0.0:
            times.setdefault("starts", second)
        if share >= 1.0:
            times.setdefault("ends", second)
        assert share in (0.0, 1.0) or grid.temperature[0, 0] == 330.0
    assert times == {"starts": 149, "ends": 548} and grid.temperature[0, 0] == pytest.approx(380.4, rel=1e-9)


def test_melting_boiling_and_freezing_in_one_step_keep_the_heat():
    stuff = Phases(1e3, 2e3, 5e2, 300.0, 400.0, 1e5, 5e5, 2.0, 1.0, 0.1)
    start = np.full((6, 6), 310.0)
    start[2, 2], start[4, 4], start[1, 4] = 5000.0, 1.0, 400.0
    grid = MeltingGrid(start, 0.1, stuff)
    before, low, high = grid.heat(), 1.0, 5000.0
    for _ in range(40):
        grid.step(5.0 * grid.explicit_limit)
        assert low <= np.min(grid.temperature) and np.max(grid.temperature) <= high
        mixed = (grid.molten > 0.0) & (grid.molten < 1.0)
        assert np.all(grid.temperature[mixed] == 300.0)
    assert grid.heat() == pytest.approx(before, rel=1e-12)
    assert np.allclose(heat_at(np.array([[299.0, 300.0, 350.0, 400.0, 500.0]]), stuff)[0],
                       (299e3, 3e5, 5e5, 6e5, 1.15e6))  # fmt: skip
    grid.deposit(np.full((6, 6), 2e5 * 0.01))
    assert grid.heat() == pytest.approx(before + 36 * 2e3, rel=1e-12)


WAX = Phases(2.0e6, 2.5e6, 2.5e6, 330.0, 900.0, 4e8, 1e9, 0.3, 0.2, 0.1)


def melting_lump() -> MeltingGrid:
    """4 by 12 cells of wax, molten from the left up to the middle of a column, solid at the right."""
    grid = MeltingGrid(np.full((4, 12), 325.0), 0.01, WAX, {"left": 380.0})
    while grid.front_across(0) < 0.055:
        grid.step(20.0)
    return grid


def test_a_melting_piece_that_is_cut_in_two_keeps_its_heat():
    """Through the cell that is half molten and beside it: each part goes on as if it were alone, bit for
    bit.
    """
    for column in (5, 6):
        grid = melting_lump()
        front = int(np.flatnonzero((grid.molten[0] > 0.0) & (grid.molten[0] < 1.0))[0])
        assert front in (5, 6) and grid.temperature[0, front] == 330.0
        before, came = grid.heat(), float(grid.came[0])
        right = np.zeros((4, 12), dtype=bool)
        right[:, column:] = True
        alone = [
            MeltingGrid(np.full((4, column), 325.0), 0.01, WAX, {"left": 380.0}),
            MeltingGrid(np.full((4, 12 - column), 325.0), 0.01, WAX),
        ]
        for part, cells in zip(alone, (~right, right), strict=True):
            part.values[:] = grid.values[cells].reshape(4, -1)
            part.look()
        own = float(np.sum(grid.values[right]))
        grid.cut(right)
        assert grid.heat() == before
        for _ in range(30):
            for one in (grid, *alone):
                one.step(20.0)
        for part, cells in zip(alone, (~right, right), strict=True):
            assert np.array_equal(grid.values[cells], part.values.ravel())
        assert float(np.sum(grid.values[right])) == pytest.approx(own, rel=1e-13)
        assert grid.heat() == pytest.approx(before + float(grid.came[0]) - came, rel=1e-12)


def test_a_piece_that_is_cut_off_above_takes_no_more_heat_from_below():
    """Cut across the flow of heat, where the hottest cell of it is still solid."""
    grid = MeltingGrid(np.full((12, 4), 325.0), 0.01, WAX, {"lower": 380.0})
    while float(np.sum(grid.molten[:, 0])) < 5.5:
        grid.step(20.0)
    above = np.zeros((12, 4), dtype=bool)
    above[8:] = True
    own = grid.values[above].copy()
    assert grid.temperature[8, 0] > grid.temperature[9, 0] + 0.01
    grid.cut(above)
    for _ in range(30):
        grid.step(20.0)
    assert float(np.sum(grid.values[above])) == pytest.approx(float(np.sum(own)), rel=1e-13)
    assert np.ptp(grid.temperature[above]) < np.ptp(own) / WAX.solid


def test_a_drop_of_one_cell_stays_as_molten_as_it_was():
    """Neither what melts beside it nor what is solid reaches it; heat that it is given is its own."""
    grid = melting_lump()
    j, front = 2, int(np.flatnonzero((grid.molten[2] > 0.0) & (grid.molten[2] < 1.0))[0])
    drop = np.zeros((4, 12), dtype=bool)
    drop[j, front] = True
    grid.cut(drop)
    share, heat, reached = float(grid.molten[j, front]), float(grid.values[j, front]), grid.front_across(0)
    for _ in range(50):
        grid.step(20.0)
    assert grid.values[j, front] == heat and grid.molten[j, front] == share
    assert grid.temperature[j, front] == 330.0 and grid.front_across(0) > reached + 1e-4
    grid.deposit(np.where(drop, (1.0 - share) * WAX.melting_heat * 1e-4, 0.0))
    assert grid.molten[j, front] == pytest.approx(1.0) and grid.temperature[j, front] == pytest.approx(330.0)


def test_a_cut_piece_goes_on_from_a_state_as_before():
    grid, other = melting_lump(), MeltingGrid(np.full((4, 12), 325.0), 0.01, WAX, {"left": 380.0})
    cells = np.zeros((4, 12), dtype=bool)
    cells[:2] = True
    cells[:, 8:] = True
    grid.cut(cells)
    kept = [array.copy() for array in grid.state()]
    other.restore(MeltingState(*kept))
    for _ in range(10):
        grid.step(20.0)
        other.step(20.0)
    assert np.array_equal(grid.values, other.values) and np.array_equal(grid.came, other.came)
    with pytest.raises(ValueError, match="piece: expected"):
        grid.cut(np.zeros((4, 4), dtype=bool))


def test_a_plate_goes_on_from_a_state_as_before():
    for grid in (
        HeatGrid(spot(8), 0.01),
        MeltingGrid(spot(8) + 250.0, 0.01, Phases(1, 1, 1, 300, 400, 9, 9, 1, 1, 1)),
    ):
        kept = type(grid.state())(*(array.copy() for array in grid.state()))
        grid.step(1e-5)
        after = grid.temperature.copy()
        grid.restore(kept)
        grid.step(1e-5)
        assert np.array_equal(after, grid.temperature)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"temperature": np.full((3, 3), math.nan)}, r"temperature\[0, 0\]"),
        ({"temperature": np.ones((1, 3))}, "temperature: expected"),
        ({"cell": 0.0}, "cell"),
        ({"conductivity": -1.0}, "conductivity"),
        ({"capacity": 0.0}, "capacity"),
        ({"held": {"top": 1.0}}, "held: 'top'"),
        ({"held": {"left": math.inf}}, "held: left"),
        ({"scheme": "magic"}, "scheme"),
        ({"beyond": "hope"}, "beyond"),
    ],
)
def test_nonsense_is_refused_by_name(arguments, words):
    given = {"temperature": np.ones((4, 4)), "cell": 0.1, **arguments}
    with pytest.raises(ValueError, match=words):
        HeatGrid(given.pop("temperature"), given.pop("cell"), **given)


def test_a_step_of_nothing_is_refused():
    for dt in (0.0, -1.0, math.nan, math.inf):
        with pytest.raises(ValueError, match="dt"):
            HeatGrid(np.ones((4, 4)), 0.1).step(dt)
    with pytest.raises(ValueError, match="at most"):
        MeltingGrid(np.ones((4, 4)), 0.1, Phases(1, 1, 1, 300, 400, 9, 9, 1, 1, 1), most_substeps=3).step(9.0)
    with pytest.raises(ValueError, match="boiling"):
        MeltingGrid(np.ones((4, 4)), 0.1, Phases(1, 1, 1, 300, 200, 9, 9, 1, 1, 1))
