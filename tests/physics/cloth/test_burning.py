"""A cloth's heat: the books close, fronts go as fast as their law says, what is treated or wet does not
burn.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.lab.studies.fire.cloth import Strip
from game.physics.cloth import Cloth, Fabric, Flame, GasAt, Hanging, creeping_speed
from game.physics.cloth.charring import MADE, MATCH, RADIATED, STEAM, TO_GAS, TOTALS
from game.physics.cloth.layout import BEGAN, CHAR, FUEL, HOT, SALT, WATER
from game.physics.heat.effects import CONDUCTION, CONVECTION, HEAT, RADIATION, SMOULDERING
from game.physics.heat.exact import fisher_speed_on_grid
from game.physics.heat.nodes import BOILING

SMALL = Hanging(width=0.4, height=0.2, span=0.4, top=0.5)
DT = 1.0 / 60.0
CELL, DEEP = 0.05, 0.06


def gas_cells(ny: int = 12, nx: int = 8) -> np.ndarray:
    cells = np.zeros((ny, nx, 4))
    cells[..., 0], cells[..., 2] = 293.15, 0.27
    return cells


def gas_at(capacity: float = 1212.0, pilot: float = 0.4) -> GasAt:
    volume = CELL * CELL * DEEP
    return GasAt(-0.2, 0.0, CELL, capacity * volume, volume, 0.27, 1.3, 700.0, pilot, 1.5e7, 0.06)


def burn(
    cloth: Cloth, seconds: float, cells: np.ndarray | None = None, gas: GasAt | None = None, **more
) -> None:
    cells = gas_cells() if cells is None else cells
    still = np.zeros(cells.shape[:2])
    for _ in range(round(seconds / DT)):
        cloth.heat(DT, cells, still, gas or gas_at(), **more)
        cloth.others[0] += DT


def excess(cells: np.ndarray, gas: GasAt) -> float:
    return gas.capacity * math.fsum((cells[..., 0] - 293.15).ravel().tolist())


def test_the_books_of_cloth_and_gas_close_to_rounding():
    cloth, cells, gas = Cloth(20, Fabric(), SMALL), gas_cells(), gas_at()
    salt = np.zeros(cloth.patches.shape[1:])
    salt[:, 10:24] = 1.0
    cloth.write(salt)
    cloth.patches[WATER, :6] = 0.05
    cloth.patches[HOT, :, 12:16] = 900.0
    first = cloth.warmth()
    burn(cloth, 4.0, cells, gas, flame=Flame(0.1, 0.4, 0.03, 1450.0, 150.0, 1.0))
    made, match = cloth.totals[MADE], cloth.totals[MATCH]
    gained = cloth.warmth() - first + cloth.totals[TO_GAS] + cloth.totals[RADIATED] + cloth.totals[STEAM]
    assert made > 100.0 and match > 10.0 and cloth.totals[STEAM] > 10.0
    assert gained == pytest.approx(made + match, rel=1e-11)
    assert excess(cells, gas) == pytest.approx(cloth.totals[TO_GAS], rel=1e-11)


def test_what_burns_takes_its_oxygen_and_leaves_vapour_and_char():
    cloth, cells, gas = Cloth(20, Fabric(retardant=1.0), SMALL), gas_cells(), gas_at(pilot=0.0)
    cloth.patches[HOT] = 1000.0
    mass, oxygen = cloth.mass(), cells[..., 2].sum()
    burn(cloth, 0.5, cells, gas)
    area = cloth.size * cloth.size
    char = float(cloth.patches[CHAR].sum()) * area
    gone = mass - cloth.mass() + char
    vapour, burnt = cloth.totals[6], cloth.totals[5]
    assert gone > 0.0 and char == pytest.approx(0.55 * gone, rel=1e-9)
    assert vapour == pytest.approx(0.3 * gone, rel=1e-9) and burnt == pytest.approx(0.15 * gone, rel=1e-9)
    used = (oxygen - cells[..., 2].sum()) * gas.volume
    assert used == pytest.approx(1.3 * 0.8 * burnt, rel=1e-9)
    assert cells[..., 1].sum() * gas.volume == pytest.approx(vapour, rel=1e-9)


def test_without_oxygen_only_what_brings_its_own_burns():
    fuel = []
    for salted in (False, True):
        cloth, cells = Cloth(8, Fabric(effects=SMOULDERING | CONDUCTION), SMALL), gas_cells()
        cells[..., 2] = 0.0
        cloth.write(np.full(cloth.patches.shape[1:], float(salted)))
        cloth.patches[HOT] = 1000.0
        burn(cloth, 1.0, cells)
        fuel.append(float(cloth.patches[FUEL].mean()))
    assert fuel[0] == pytest.approx(0.25 * math.exp(-0.2 * 0.22), rel=1e-6)
    assert fuel[1] == pytest.approx(0.25 * math.exp(-0.85 * 0.62), rel=1e-6)


def test_vapour_that_leaves_what_glows_begins_to_burn():
    made = []
    for hot in (650.0, 750.0):
        cloth, cells = Cloth(8, Fabric(effects=SMOULDERING | CONDUCTION), SMALL), gas_cells()
        cloth.write(np.ones(cloth.patches.shape[1:]))
        cloth.patches[HOT] = hot
        burn(cloth, DT, cells)
        made.append((float(cells[..., 3].sum()), float(cells[..., 0].max())))
    assert made[0][0] == 0.0 < made[1][0] and made[1][1] > made[0][1] > 293.15


@pytest.mark.parametrize(("meshes", "within"), [(32, 0.15), (96, 0.055)])
def test_a_front_goes_as_fast_as_its_law_says(meshes, within):
    strip = Strip("ignition", meshes)
    strip.run(20.0, DT)
    assert strip.speed() == pytest.approx(strip.fabric.front_speed(lossless=True), rel=within)


def test_a_finer_front_is_nearer_to_its_law():
    off = []
    for meshes in (24, 48, 96):
        strip = Strip("ignition", meshes)
        strip.run(20.0, DT)
        off.append(1.0 - strip.speed() / strip.fabric.front_speed(lossless=True))
    assert off[0] > off[1] > off[2] > 0.0 and off[1] < 0.65 * off[0] and off[2] < 0.65 * off[1]


def test_fishers_front_is_below_its_speed_by_three_halves_of_one_over_time():
    """c(t) = 2 sqrt(D r) - 3/2 sqrt(D / r) / t + ... (Bramson 1983)."""
    strip = Strip("fisher", 96)
    strip.run(25.0, DT)
    fabric = strip.fabric
    late = fisher_speed_on_grid(fabric.diffusivity, fabric.salted.rate, strip.cloth.size, DT)
    began = strip.cloth.patches[BEGAN, 0]
    came = np.flatnonzero(began > 12.0)
    speed = (came[-1] - came[0]) * strip.cloth.size / (began[came[-1]] - began[came[0]])
    mean = 0.5 * (began[came[0]] + began[came[-1]])
    expected = late - 1.5 * math.sqrt(fabric.diffusivity / fabric.salted.rate) / mean
    assert speed == pytest.approx(expected, rel=0.02) and speed < 0.97 * late


def test_a_front_with_losses_goes_as_its_law_says():
    """Gas that stays cold takes heat in proportion: h of the law."""
    fabric = Fabric(
        effects=CONDUCTION | SMOULDERING | CONVECTION, exchange=30.0, stirred=0.0,
        salted=Fabric().salted._replace(oxygen=1.0),
    )  # fmt: skip
    cloth = Cloth(128, fabric, Hanging(width=0.8, height=0.8 / 128, span=0.8))
    cloth.write(np.ones(cloth.patches.shape[1:]))
    cloth.patches[HOT, :, :14] = 1500.0
    cells = gas_cells()
    gas = GasAt(-0.2, 0.0, CELL, 1e12, 1e12, 0.27, 1.3, 1e6, 0.0, 0.0, 0.0)
    still = np.zeros(cells.shape[:2])
    for _ in range(round(22.0 / DT)):
        cloth.heat(DT, cells, still, gas)
        cloth.others[0] += DT
    came = np.flatnonzero(cloth.patches[BEGAN, 0] > 8.0)
    began = cloth.patches[BEGAN, 0]
    speed = (came[-1] - came[0]) * cloth.size / (began[came[-1]] - began[came[0]])
    start = (500.0 - 293.15) / fabric.rise
    law = creeping_speed(fabric.diffusivity, fabric.salted.rate, start, 60.0 / 350.0)
    assert law < 0.95 * creeping_speed(fabric.diffusivity, fabric.salted.rate, start)
    assert speed == pytest.approx(law, rel=0.05)


def test_the_closed_form():
    free = creeping_speed(2e-4, 0.62, 0.2)
    assert free == pytest.approx(2.0 * math.sqrt(2e-4 * 0.62), rel=1e-12)
    losses = [creeping_speed(2e-4, 0.62, 0.2, loss) for loss in (0.0, 1e-9, 0.02, 0.05)]
    assert losses[0] == pytest.approx(losses[1], rel=1e-6) and losses == sorted(losses, reverse=True)
    assert creeping_speed(2e-4, 0.62, 0.2, 0.5) == 0.0
    for arguments in ((0.0, 1.0, 0.2), (1.0, -1.0, 0.2), (1.0, 1.0, 1.0), (1.0, 1.0, 0.2, math.nan)):
        with pytest.raises(ValueError, match="expected"):
            creeping_speed(*arguments)


def test_what_a_cloth_loses_as_it_takes_fire():
    fabric = Fabric(emissivity=0.5, exchange=10.0)
    shone = 0.5 * 5.670374419e-8 * (500.0**4 - 293.15**4)
    assert fabric.loss() == pytest.approx(2.0 * (shone + 10.0 * 206.85) / (206.85 * 350.0), rel=1e-12)
    start = 206.85 / fabric.rise
    law = creeping_speed(2e-4, 0.62, start, fabric.loss())
    assert fabric.front_speed() == pytest.approx(law, rel=1e-9) and law < fabric.front_speed(True)


@pytest.mark.parametrize(("retardant", "spreads"), [(1.0, False), (0.0, True)])
def test_treated_cloth_goes_out_and_bare_cotton_burns(retardant, spreads):
    cloth = Cloth(20, Fabric(retardant=retardant), SMALL)
    cloth.patches[HOT, 6:14, 16:24] = 1200.0
    gas = gas_at()
    burn(cloth, 12.0, gas=gas._replace(capacity=1e3 * gas.capacity, volume=1e3 * gas.volume))  # air enough
    assert (cloth.totals[8] > 0.0) == spreads
    burnt = 1.0 - float(cloth.patches[FUEL].mean()) / 0.25
    assert burnt > 0.4 if spreads else burnt < 0.12


def test_wet_cloth_does_not_burn_before_its_water_is_gone():
    cloth = Cloth(10, Fabric(), SMALL)
    cloth.write(np.ones(cloth.patches.shape[1:]))
    cloth.patches[WATER] = 0.05
    cloth.patches[HOT, :, 0] = 1400.0
    cloth.patches[WATER, :, 0] = 0.0
    for _ in range(300):
        burn(cloth, DT)
        wet = cloth.patches[WATER] > 0.0
        assert np.all(cloth.patches[HOT][wet] <= BOILING + 1e-9)
        assert np.all(cloth.patches[FUEL][wet] == 0.25)
    assert cloth.steam() > 0.0 and np.any(~wet[:, 1:])


def test_water_cools_at_once_and_keeps_the_heat():
    cloth = Cloth(10, Fabric(), SMALL)
    cloth.patches[HOT] = 350.0
    before = cloth.warmth()
    poured = cloth.pour((0.0, 0.4), 0.1, 0.2)
    assert poured == pytest.approx(0.2 * math.pi * 0.01 / 2.0, rel=0.05) == cloth.water()
    assert cloth.warmth() == pytest.approx(before, rel=1e-12) and cloth.patches[HOT].min() < 330.0


def test_a_match_never_warms_beyond_its_flame():
    cloth = Cloth(10, Fabric(effects=CONDUCTION | RADIATION), SMALL)
    burn(cloth, 30.0, flame=Flame(0.0, 0.4, 0.05, 900.0, 5e4, 1.0))
    assert 700.0 < cloth.patches[HOT].max() <= 900.0 + 1e-9


def test_effects_off_leave_out_what_they_are():
    results = []
    for left_out in (None, CONDUCTION, RADIATION, CONVECTION, SMOULDERING):
        effects = HEAT.known if left_out is None else HEAT.known.without(left_out)
        cloth, cells = Cloth(8, Fabric(effects=effects), SMALL), gas_cells()
        cloth.patches[HOT, 2:4, 2:4] = 900.0
        burn(cloth, 0.5, cells)
        results.append(
            (cloth.totals[RADIATED], cells[..., 0].max(), cloth.patches[HOT, 0, 0], cloth.totals[MADE])
        )
    assert results[2][0] == 0.0 < results[0][0]
    assert results[1][2] < results[0][2] and results[4][3] == 0.0 < results[0][3]
    # without convection what burns still warms the gas, but less than an ember that gives its heat away
    assert results[3][1] < results[0][1]


def test_a_step_that_is_too_long_for_conduction_is_cut():
    coarse = Cloth(40, Fabric(effects=CONDUCTION | SMOULDERING), SMALL)
    coarse.patches[HOT, :, 10] = 450.0
    coarse.heat(2.0, gas_cells(), np.zeros((12, 8)), gas_at())
    assert coarse.patches[HOT].min() >= 293.15 and coarse.patches[HOT].max() < 450.0


@pytest.mark.parametrize(
    "wrong",
    [{"dry": 0.0}, {"capacity": math.nan}, {"kept": 1.1}, {"retardant": -0.1}, {"reaction": "slow"},
     {"salted": Fabric().salted._replace(vapour=0.7, char=0.4)}, {"bare": Fabric().bare._replace(rate=-1.0)}],
)  # fmt: skip
def test_nonsense_is_refused(wrong):
    with pytest.raises(ValueError, match=next(iter(wrong))):
        Fabric(**wrong)


def test_the_speed_of_a_front_is_that_of_the_times_at_which_it_came():
    cloth = Cloth(20, Fabric(), SMALL)
    rows, columns = cloth.patches.shape[1:]
    cloth.write(np.ones((rows, columns)))
    x = (np.arange(columns) + 0.5) * cloth.size
    y = (np.arange(rows) + 0.5) * cloth.size
    cloth.others[0] = 12.0
    cloth.patches[BEGAN] = 10.0 + (0.6 * x[None, :] + 0.8 * y[:, None]) / 0.08
    assert cloth.front(12.0) == pytest.approx(0.08, rel=1e-9)
    cloth.patches[BEGAN, :, :20] = 10.0  # heated all at once: no front
    assert cloth.front(12.0) == pytest.approx(0.08, rel=1e-9)
    cloth.patches[SALT] = 0.0
    assert math.isnan(cloth.front(12.0))
    assert len(cloth.totals) == TOTALS
