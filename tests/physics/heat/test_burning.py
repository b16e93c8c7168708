"""Radiation, things that burn, fronts."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.effects import EffectSet
from game.physics.heat import STEFAN_BOLTZMANN, BurningBodies, BurningFront, Fuel, cooled
from game.physics.heat.effects import CONDUCTION, CONVECTION, HEAT, RADIATION, SMOULDERING
from game.physics.heat.exact import (
    fisher_speed,
    fisher_speed_on_grid,
    ignition_speed,
    self_heating_limit,
)
from game.physics.heat.nodes import BOILING, OF_FUEL, RADIATED, STEAM, STEAM_HEAT, STEAM_KG, WATER_HEAT


def test_an_ember_cools_as_the_fourth_power():
    """617.4595407491472 K after 60 s from 1100 K; 629.9605249474364 K after 100 s into empty space."""
    assert cooled(1100.0, 300.0, 2e-11, 60.0) == pytest.approx(617.4595407491472, rel=1e-13)
    assert cooled(1000.0, 0.0, 1e-11, 100.0) == pytest.approx(629.9605249474364, rel=1e-14)


@pytest.mark.parametrize("start", [1.0, 250.0, 299.999, 300.0, 300.001, 900.0, 1e6])
def test_however_long_the_step_it_goes_one_way_and_never_past_the_ambient(start):
    last = start
    for dt in (1e-9, 1e-3, 1.0, 10.0, 1e3, 1e6, 1e12):  # b T³ dt up to 1e19
        now = cooled(start, 300.0, 1e-11, dt)
        assert min(start, 300.0) <= now <= max(start, 300.0)
        assert abs(now - 300.0) <= abs(last - 300.0) + 1e-9
        last = now
    assert last == pytest.approx(300.0, abs=1e-9)


def test_many_steps_of_cooling_are_one():
    many = 1400.0
    for _ in range(100):
        many = cooled(many, 300.0, 2e-11, 0.6)
    assert many == pytest.approx(cooled(1400.0, 300.0, 2e-11, 60.0), rel=1e-12)
    warming = 100.0
    for _ in range(100):
        warming = cooled(warming, 300.0, 2e-9, 0.6)
    assert warming == pytest.approx(cooled(100.0, 300.0, 2e-9, 60.0), rel=1e-12)
    short = 1400.0
    for _ in range(1000):  # so short that a series takes the place of Newton's steps
        short = cooled(short, 300.0, 2e-11, 0.005)
    assert short == pytest.approx(cooled(1400.0, 300.0, 2e-11, 5.0), rel=1e-9)  # 1e-12 a step
    slope = (cooled(500.0, 300.0, 1e-11, 1e-3) - 500.0) / 1e-3
    assert slope == pytest.approx(-1e-11 * (500.0**4 - 300.0**4), rel=1e-5)


def row(count: int, made_of: Fuel, **given) -> BurningBodies:
    links = [(i, i + 1) for i in range(count - 1)]
    return BurningBodies(count, links, given.pop("conductances", 0.02), made_of=made_of, **given)


def books(bodies: BurningBodies) -> float:
    """What must stay the same: J in nodes, and in all that left, less what burning made."""
    given, _, _ = bodies.nodes[[9, 10, 11]]
    totals = bodies.totals
    return bodies.heat() + math.fsum(given.tolist()) + totals[RADIATED] + totals[STEAM] - totals[OF_FUEL]


def test_heat_fuel_and_water_of_burning_things_stay_in_the_books():
    made_of = Fuel(rate=0.5, kept=0.4, vapour=0.3)
    random = np.random.default_rng(5)
    bodies = row(24, made_of, rest=0.5, fuel=1e-3, water=random.uniform(0, 2e-4, 24), area=4e-4)
    bodies.temperature[:5] = 900.0
    bodies.meet_gas(random.uniform(300.0, 1200.0, 24), random.uniform(0.0, 1.0, 24))
    fuel, water, before = math.fsum(bodies.fuel), math.fsum(bodies.water), books(bodies)
    for _ in range(400):
        bodies.step(0.05)
    assert books(bodies) == pytest.approx(before, rel=1e-12)
    _given, vapour, burnt = bodies.take_given()
    assert math.fsum([*bodies.fuel, *vapour, *burnt]) == pytest.approx(fuel, rel=1e-12)
    assert bodies.totals[STEAM_KG] + math.fsum(bodies.water) == pytest.approx(water, rel=1e-12)
    assert vapour.sum() == pytest.approx(0.3 * (vapour + burnt).sum(), rel=1e-9)
    assert bodies.totals[OF_FUEL] == pytest.approx(1.6e7 * burnt.sum(), rel=1e-12)
    assert np.min(bodies.fuel) >= 0.0 and np.min(bodies.water) >= 0.0
    assert not bodies.take_given()[0].any()


def test_a_wet_thing_stays_at_373_kelvin_until_it_is_dry_and_only_then_lights():
    bodies = BurningBodies(
        1, rest=5.0, fuel=0.01, water=0.02, area=0.01, made_of=Fuel(effects=CONVECTION | SMOULDERING)
    )
    bodies.meet_gas(1000.0)
    plateau, lit_wet = 0, False
    while bodies.water[0] > 0.0:
        bodies.step(0.5)
        plateau += bodies.temperature[0] == BOILING
        lit_wet |= bool(bodies.burning()[0])
    assert plateau > 50 and not lit_wet
    needed = 0.02 * STEAM_HEAT  # given at 25 W/(m² K) over 626.85 K, after it was warmed
    assert plateau * 0.5 == pytest.approx(needed / (25.0 * 0.01 * 626.85), rel=0.03)
    while not bodies.burning()[0]:
        bodies.step(0.5)
    assert bodies.temperature[0] >= 570.0 and bodies.fuel[0] > 0.009


def test_the_heat_that_quenches():
    """5.183760e6 J take 2 kg of water from 20 °C to steam."""
    hot = BurningBodies(2, [(0, 1)], 1e3, rest=[1e5, 10.0], made_of=Fuel(effects=EffectSet([CONDUCTION])))
    hot.temperature[:] = 900.0, 293.15
    hot.wet(1, 2.0)
    before = hot.temperature[0]
    while hot.water[1] > 0.0:
        hot.step(0.01)
    taken = 1e5 * (before - hot.temperature[0])
    assert taken == pytest.approx(5_183_760.0, rel=2e-3)  # and the step's own share
    assert hot.totals[STEAM] == pytest.approx(2.0 * (STEAM_HEAT + WATER_HEAT * BOILING), rel=1e-9)


def test_a_thread_is_lit_at_the_threshold_exactly_in_one_cell_at_a_corner_and_in_two_places():
    still = Fuel(effects=EffectSet([SMOULDERING]), ignition=600.0)
    bodies = BurningBodies(
        3, rest=1.0, fuel=1e-3, temperature=[600.0, np.nextafter(600.0, 0.0), 601.0], made_of=still
    )
    assert bodies.burning().tolist() == [True, False, True]
    bodies.step(0.1)
    assert bodies.take_given()[2].tolist()[1] == 0.0 and bodies.fuel[0] < 1e-3
    made_of = Fuel(rate=2.0, kept=0.8, vapour=0.0, exchange=0.0, emissivity=0.0)
    lit = row(60, made_of, rest=0.05, fuel=1e-4, temperature=293.15)
    lit.temperature[[0, 59]] = 900.0  # at both ends
    for _ in range(3_000):
        lit.step(0.02)
        if lit.burning()[30]:
            break
    burnt = lit.fuel < 0.99e-4
    assert burnt[:20].all() and burnt[-20:].all() and np.array_equal(burnt, burnt[::-1])
    assert np.allclose(lit.temperature, lit.temperature[::-1], rtol=1e-9)


def test_fuel_that_runs_out_in_a_step_and_oxygen_below_nothing():
    bodies = BurningBodies(2, rest=1.0, fuel=[1e-3, 1e-3], temperature=900.0, made_of=Fuel(rate=1e5))
    bodies.nodes[6] = 1.0, -1e-18
    bodies.step(1.0)
    assert bodies.fuel.tolist() == [0.0, 1e-3]
    _given, vapour, burnt = bodies.take_given()
    assert (vapour + burnt).tolist() == pytest.approx([1e-3, 0.0], rel=1e-12)


def test_what_glows_beside_it_keeps_an_ember_hot():
    made_of = Fuel(effects=EffectSet([RADIATION]), emissivity=0.8)
    embers = BurningBodies(3, rest=10.0, area=0.02, temperature=1000.0, made_of=made_of)
    embers.meet_light([293.15, 800.0, 1100.0])
    for _ in range(100):
        embers.step(0.1)
    rate = 0.8 * STEFAN_BOLTZMANN * 0.02 / 10.0
    wanted = [cooled(1000.0, around, rate, 10.0) for around in (293.15, 800.0, 1100.0)]
    assert embers.temperature.tolist() == pytest.approx(wanted, rel=1e-11)
    assert embers.temperature[2] > 1000.0 > embers.temperature[1] > embers.temperature[0]
    assert embers.totals[RADIATED] == pytest.approx(10.0 * (3000.0 - embers.temperature.sum()), rel=1e-9)


def test_what_is_shone_on_dries_before_it_is_hotter_than_373_kelvin():
    wet = BurningBodies(1, rest=5.0, water=0.005, area=0.02, made_of=Fuel(effects=EffectSet([RADIATION])))
    wet.meet_light(1100.0)
    before = books(wet)
    while wet.water[0] > 0.0:
        assert wet.temperature[0] <= BOILING + 1e-9
        wet.step(0.05)
    assert books(wet) == pytest.approx(before, rel=1e-12)
    wet.step(5.0)
    assert 400.0 < wet.temperature[0] < 1100.0


def test_water_on_what_glows_takes_its_heat_at_once():
    still = Fuel(effects=EffectSet([CONVECTION]))
    ember = BurningBodies(1, rest=100.0, area=1e-9, temperature=900.0, made_of=still)
    before = ember.heat() + 0.01 * WATER_HEAT * 293.15
    ember.wet(0, 0.01)
    assert ember.heat() == pytest.approx(before, rel=1e-12)
    ember.step(0.01)
    heat = 100.0 * (900.0 - BOILING) - 0.01 * (STEAM_HEAT + WATER_HEAT * (BOILING - 293.15))
    assert ember.water[0] == 0.0 and ember.totals[STEAM_KG] == 0.01
    assert ember.temperature[0] == pytest.approx(BOILING + heat / 100.0, rel=1e-9)
    ember.wet(0, 0.1)
    ember.step(0.01)
    assert ember.temperature[0] < BOILING and ember.water[0] == pytest.approx(0.1, rel=1e-9)
    with pytest.raises(ValueError, match="kelvin"):
        ember.wet(0, 0.1, 400.0)


def test_what_is_torn_off_keeps_its_heat():
    bodies = row(10, Fuel(effects=EffectSet([CONDUCTION])), rest=1.0)
    bodies.temperature[:5] = 900.0
    bodies.tear(4)
    for _ in range(500):
        bodies.step(1.0)
    assert np.allclose(bodies.temperature[:5], 900.0, rtol=1e-12)
    assert np.allclose(bodies.temperature[5:], 293.15, rtol=1e-12)
    bodies.torn[:] = 0
    before = bodies.heat()
    for _ in range(20_000):
        bodies.step(1.0)
    assert np.allclose(bodies.temperature, 0.5 * (900.0 + 293.15), rtol=1e-6)
    assert bodies.heat() == pytest.approx(before, rel=1e-12)


def test_neighbours_never_overshoot_however_long_the_step():
    bodies = row(6, Fuel(effects=EffectSet([CONDUCTION])), rest=1e-2, conductances=5.0)
    bodies.temperature[2] = 1000.0
    assert bodies.step(0.1) >= 100
    assert np.min(bodies.temperature) >= 293.15 and np.max(bodies.temperature) <= 1000.0
    with pytest.raises(ValueError, match="dt = 100 s: expected at most"):
        bodies.step(100.0)


def test_an_effect_that_is_off_does_nothing():
    def end(effects) -> np.ndarray:
        bodies = row(8, Fuel(effects=effects), rest=0.5, fuel=1e-3, area=1e-3)
        bodies.temperature[:3] = 900.0
        bodies.meet_gas(500.0)
        for _ in range(20):
            bodies.step(0.05)
        return np.concatenate([bodies.temperature, bodies.fuel])

    everything = end(HEAT.known)
    for effect in (CONDUCTION, RADIATION, CONVECTION, SMOULDERING):
        assert not np.array_equal(everything, end(HEAT.known.without(effect)))
    nothing = end(EffectSet())
    assert nothing[:3].tolist() == [900.0] * 3 and np.all(nothing[8:] == 1e-3)


def test_burning_things_go_on_from_a_state_as_before():
    bodies = row(8, Fuel(), rest=0.5, fuel=1e-3, area=1e-3, water=1e-5, temperature=700.0)
    kept = type(bodies.state())(*(array.copy() for array in bodies.state()))
    bodies.step(0.5)
    after = bodies.nodes.copy()
    bodies.restore(kept)
    bodies.step(0.5)
    assert np.array_equal(after, bodies.nodes)


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"count": 0}, "count"),
        ({"links": [(0, 4)]}, "links"),
        ({"links": [(1, 1)]}, "itself"),
        ({"temperature": 0.0}, r"temperature\[0\]"),
        ({"rest": 0.0}, "rest"),
        ({"fuel": [0, 0, -1, 0]}, r"fuel\[2\]"),
        ({"water": math.nan}, "water"),
        ({"area": math.inf}, "area"),
        ({"conductances": -1.0, "links": [(0, 1)]}, "cond"),
    ],
)
def test_nonsense_is_refused_by_name(given, words):
    given = {"count": 4, **given}
    with pytest.raises(ValueError, match=words):
        BurningBodies(given.pop("count"), **given)


@pytest.mark.parametrize(
    "name", ["ignition", "rate", "heat", "kept", "vapour", "exchange", "emissivity", "ambient"]
)
def test_a_fuel_of_nonsense_is_refused(name):
    with pytest.raises(ValueError, match=name):
        Fuel(**{name: -1.0})


# -- fronts -----------------------------------------------------------------------------------------------


def speed_of(front: BurningFront, dt: float, first: int, second: int) -> float:
    """m/s of the place of u = 1/2 between two numbers of steps."""
    for _ in range(first):
        front.step(dt)
    start = front.place()
    for _ in range(second - first):
        front.step(dt)
    return (front.place() - start) / ((second - first) * dt)


def step_start(n: int, burnt: int) -> np.ndarray:
    values = np.zeros((1, n))
    values[:, :burnt] = 1.0
    return values


def test_a_pulled_front_as_it_is_measured_not_as_it_will_be():
    """1.8818 between 10 and 20, by D = k = 1 from a step: 2 is never measured in a short run (Bramson
    1983).
    """
    front = BurningFront(step_start(800, 120), 0.1, 1.0, 1.0)
    assert speed_of(front, 0.004, 2500, 5000) == pytest.approx(1.88180030466852, rel=5e-3)
    assert fisher_speed(1.0, 1.0) == 2.0


def test_a_pulled_front_on_a_coarse_and_on_a_fine_grid():
    """0.13395 m/s with 0.05 m and 0.05 s, 0.12576 with 0.005 and 0.0025; the continuum has 0.12649."""
    assert fisher_speed_on_grid(1e-3, 4.0, 0.05, 0.05) == pytest.approx(0.1339495018231591, rel=1e-9)
    assert fisher_speed_on_grid(1e-3, 4.0, 0.005, 0.0025) == pytest.approx(0.12576083489870624, rel=1e-9)
    assert fisher_speed(1e-3, 4.0) == pytest.approx(0.12649110640673517, rel=1e-14)
    front = BurningFront(step_start(1400, 40), 0.05, 1e-3, 4.0)
    speed = speed_of(front, 0.05, 4000, 8000)
    assert speed == pytest.approx(0.13395, rel=0.003)  # what is left is Bramson's 3 / 2 q t


@pytest.mark.parametrize(("cells", "off"), [(2, 0.011), (4, 0.003)])
def test_an_ignition_front_has_its_exact_speed(cells, off):
    """0.06 m/s by a = 0.2, D = 1e-3 m²/s, k = 20 /s; of second order in the cell."""
    assert ignition_speed(1e-3, 20.0, 0.2) == pytest.approx(0.06, rel=1e-12)
    cell = 0.01 / cells
    front = BurningFront(step_start(150 * cells, 40 * cells), cell, 1e-3, 20.0, "ignition", 0.2)
    speed = speed_of(front, 0.005 / (cells // 2) ** 2, 1000 * (cells // 2) ** 2, 1600 * (cells // 2) ** 2)
    assert speed == pytest.approx(0.06, rel=off)


def test_below_its_threshold_nothing_spreads():
    front = BurningFront(np.full((6, 6), 0.19), 0.1, 1e-3, 20.0, "ignition", 0.2)
    for _ in range(100):
        front.step(0.05)
    assert np.max(front.values) < 0.19 and math.isnan(front.place())
    spot = np.zeros((9, 9))
    spot[0, 0] = 1.0  # a corner alone is put out by all that is cold around it
    small = BurningFront(spot, 0.01, 1e-3, 20.0, "ignition", 0.2)
    for _ in range(200):
        small.step(0.02)
    assert np.max(small.values) < 1e-3


@pytest.mark.parametrize(("share", "runs_away"), [(0.98, False), (1.02, True)])
def test_self_heating_at_2_percent_on_both_sides_of_its_limit(share, runs_away):
    """0.8784576797812905 of a slab."""
    assert self_heating_limit("slab") == pytest.approx(0.8784576797812905, rel=1e-12)
    assert self_heating_limit("disc") == 2.0
    n = 24
    front = BurningFront(np.zeros((1, n)), 2.0 / n, 1.0, share * self_heating_limit("slab"), "self-heating")
    for _ in range(16_000):
        front.step(0.9 * front.explicit_limit)
        if np.max(front.values) > 10.0:
            break
    assert (np.max(front.values) > 10.0) == runs_away
    if not runs_away:
        assert np.max(front.values) < 1.2  # 1.187 is the hottest steady middle there is


@pytest.mark.parametrize(
    "given",
    [{"cell": 0.0}, {"diffusivity": -1.0}, {"rate": math.nan}, {"threshold": 2.0}, {"reaction": "none"}],
)
def test_a_front_of_nonsense_is_refused(given):
    with pytest.raises(ValueError, match=next(iter(given))):
        BurningFront(np.zeros((4, 4)), **{"cell": 0.1, "diffusivity": 1.0, "rate": 1.0, **given})
    with pytest.raises(ValueError, match="dt"):
        BurningFront(np.zeros((4, 4)), 0.1, 1.0, 1.0).step(0.1)
