"""Gas that burns: the reactant of which there is less, books that close, expansion, radiation."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.combustion import Flames, GasFuel, checked_cells
from game.physics.combustion.effects import COMBUSTION, EXPANSION, FLAMES, SOOT_LOSS
from game.physics.effects import EffectSet
from game.physics.heat import cooled
from game.physics.heat.effects import RADIATION

COLUMNS = (2, 0, 3, 1)  # of five fields, in an order of their own


def gas(
    ny: int = 6, nx: int = 7, temperature: float = 900.0, fuel: float = 0.02, oxygen: float = 0.27
) -> np.ndarray:
    cells = np.zeros((ny, nx, 5))
    cells[..., 2], cells[..., 0], cells[..., 3] = temperature, fuel, oxygen
    return cells


@pytest.mark.parametrize(
    ("fuel", "burnt", "rise", "ratio"),
    [
        (0.5, 0.34285714285714286, 308.57142857142856, 2.0526059306547113),  # the air is used up
        (0.02, 0.02, 18.0, 1.061402012621525),  # the fuel is
    ],
)
@pytest.mark.parametrize("dt", [0.01, 1e3])
def test_a_sealed_room_burns_what_there_is_less_of(fuel, burnt, rise, ratio, dt):
    """1.2 kg of oxygen, 3.5 kg for a kg of fuel, 45 MJ/kg, and a room that takes 50 kJ/K, from 293.15 K."""
    made_of = GasFuel(
        effects=FLAMES | EXPANSION, ignition=293.0, rate=5.0, oxygen=3.5, heat=4.5e7, capacity=5e4, soot=0.0
    )
    room = Flames(COLUMNS, 0.25, made_of)  # 16 cells are a m³
    cells = gas(4, 4, 293.15, fuel, 1.2)
    for _ in range(1 if dt > 1.0 else 1_000):
        room.step(cells, dt, np.zeros((4, 4)))
    books = room.books_now()
    assert books.burnt == pytest.approx(burnt, rel=1e-12)
    assert np.mean(cells[..., 2]) - 293.15 == pytest.approx(rise, rel=1e-9)
    assert room.pressure_ratio(cells) == pytest.approx(ratio, rel=1e-9)
    assert np.min(cells) >= 0.0


def test_the_books_of_fuel_oxygen_heat_and_soot_close():
    random = np.random.default_rng(11)
    cells = gas()
    cells[..., 2] = random.uniform(300.0, 1500.0, (6, 7))
    cells[..., 0] = random.uniform(0.0, 0.05, (6, 7))
    cells[..., 3] = random.uniform(0.0, 0.3, (6, 7))
    flames = Flames(COLUMNS, 0.1, GasFuel(soot_rate=3.0))
    heat, fuel, oxygen, soot = flames.contents(cells)
    source, volume = np.zeros((6, 7)), 0.01
    for _ in range(500):
        flames.step(cells, 0.01, source)
    now, books = flames.contents(cells), flames.books_now()
    size = 1212.0 * 900.0 * volume * 42
    assert abs(heat + books.released - books.radiated - now[0]) < 1e-12 * size
    assert now[1] + books.burnt == pytest.approx(fuel, rel=1e-12)
    assert now[2] + books.used == pytest.approx(oxygen, rel=1e-12)
    assert now[3] + books.soot_gone - books.soot_made == pytest.approx(soot, abs=1e-12 * fuel)
    assert books.used == pytest.approx(3.5 * books.burnt, rel=1e-12)
    assert books.burnt > 0.0 and books.radiated > 0.0 and books.soot_gone > 0.0
    assert np.min(cells) >= 0.0


def test_it_lights_at_the_threshold_exactly_at_a_corner_and_in_one_cell():
    cells = gas(temperature=np.nextafter(600.0, 0.0))
    cells[0, 0, 2] = cells[3, 3, 2] = 600.0
    flames = Flames(COLUMNS, 0.1, GasFuel(effects=EffectSet([FLAMES])))
    flames.step(cells, 0.1, np.zeros((6, 7)))
    changed = np.argwhere(cells[..., 0] < 0.02).tolist()
    assert changed == [[0, 0], [3, 3]] and flames.alight == 2
    assert flames.power == pytest.approx(flames.books_now().released / 0.1, rel=1e-12)
    assert flames.fiercest == pytest.approx(4.5e7 * 0.02 * -math.expm1(-3.0) / 0.1, rel=1e-12)


def test_a_rounding_below_nothing_burns_nothing():
    cells = gas(oxygen=-1e-19)
    cells[0, 0, 0], cells[0, 0, 3] = -1e-19, 0.2
    flames = Flames(COLUMNS, 0.1, GasFuel(effects=EffectSet([FLAMES])))
    before = cells.copy()
    flames.step(cells, 0.1, np.zeros((6, 7)))
    assert np.array_equal(cells, before) and flames.alight == 0


def test_what_is_warmed_wants_room_and_what_cools_gives_it_back():
    cells, source = gas(), np.full((6, 7), 0.5)
    warming = Flames(COLUMNS, 0.1, GasFuel(effects=FLAMES | EXPANSION))
    warming.step(cells, 0.02, source)
    assert np.allclose(source - 0.5, (cells[..., 2] / 900.0 - 1.0) / 0.02, rtol=1e-12) and np.all(
        source > 0.5
    )
    cells, source = gas(fuel=0.0), np.zeros((6, 7))
    Flames(COLUMNS, 0.1, GasFuel(effects=RADIATION | EXPANSION)).step(cells, 0.02, source)
    assert np.all(source < 0.0)


def test_hot_gas_cools_as_the_fourth_power_and_the_more_so_with_soot():
    cells = gas(fuel=0.0, temperature=1400.0)
    cells[:, 0, 1] = 1e-3
    Flames(COLUMNS, 0.1, GasFuel(effects=EffectSet([RADIATION]))).step(cells, 0.5, np.zeros((6, 7)))
    assert cells[2, 2, 2] == pytest.approx(cooled(1400.0, 293.15, 2e-11, 0.5), rel=1e-12)
    assert cells[2, 0, 2] == pytest.approx(cooled(1400.0, 293.15, 2e-11 + 1e-11, 0.5), rel=1e-12)
    for hot in (1e6, 293.15, 1e-3):
        cells = gas(fuel=0.0, temperature=hot)
        Flames(COLUMNS, 0.1, GasFuel(effects=EffectSet([RADIATION]))).step(cells, 1e9, np.zeros((6, 7)))
        assert np.allclose(cells[..., 2], 293.15, rtol=1e-9)


def test_an_effect_that_is_off_does_nothing():
    def end(effects) -> np.ndarray:
        cells, source = gas(), np.zeros((6, 7))
        cells[..., 1] = 1e-4
        Flames(COLUMNS, 0.1, GasFuel(soot_rate=2.0, effects=effects)).step(cells, 0.05, source)
        return np.concatenate([cells.ravel(), source.ravel()])

    everything = end(COMBUSTION.known)
    for effect in (FLAMES, EXPANSION, RADIATION, SOOT_LOSS):
        assert not np.array_equal(everything, end(COMBUSTION.known.without(effect)))


@pytest.mark.parametrize(
    "name", ["ignition", "rate", "oxygen", "heat", "capacity", "soot", "glow", "ambient"]
)
def test_a_gas_of_nonsense_is_refused(name):
    for wrong in (-1.0, math.nan, math.inf):
        with pytest.raises(ValueError, match=name):
            GasFuel(**{name: wrong})
    with pytest.raises(ValueError, match="soot"):
        GasFuel(soot=1.5)


def test_bad_cells_and_steps_are_refused_by_name():
    flames = Flames(COLUMNS, 0.1)
    for dt in (0.0, math.nan):
        with pytest.raises(ValueError, match="dt"):
            flames.step(gas(), dt, np.zeros((6, 7)))
    with pytest.raises(ValueError, match="belong"):
        flames.step(gas(), 0.1, np.zeros((7, 6)))
    with pytest.raises(ValueError, match="columns"):
        Flames((0, 0, 1, 2), 0.1)
    with pytest.raises(ValueError, match="cell"):
        Flames(COLUMNS, 0.0)
    for k, value, words in ((2, math.nan, "temperature"), (2, 0.0, "temperature"), (0, -1.0, "fuel")):
        cells = gas()
        cells[3, 4, k] = value
        with pytest.raises(ValueError, match=rf"{words}\[3, 4\]"):
            checked_cells(cells, COLUMNS)
    checked_cells(gas(), COLUMNS)
