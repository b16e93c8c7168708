"""The liquid as a member: what it meets, what comes in and goes out, what is heard of it."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.effects import EffectSet
from game.physics.fields import GRAVITY
from game.physics.grid.layout import Grid
from game.physics.liquid.effects import LIQUID
from game.physics.solids import Material, box
from game.stage import Param, Parameters
from game.worlds.members import solids
from game.worlds.members.solids import Solids
from game.worlds.members.water import DENSITY, Mouths, Roar, Water

GRID = Grid(40, 24, 0.05)
DT = 1.0 / 60.0


class Chosen(Parameters):
    """What the members read."""

    tier = solids.choose_quality()
    substeps = solids.choose_substeps(8)
    gravity = Param(9.81, 0.0, 30.0, unit="m/s²")


def chosen(gravity: float = 9.81) -> Parameters:
    return Chosen({"tier": "play", "substeps": 4, "gravity": gravity})


def filled(depth: float = 0.5, listens: bool = False) -> Water:
    water = Water(GRID, chosen(), LIQUID.known, listens=listens)
    water.liquid.add(water.liquid.lattice((0.0, 0.0), (2.0, depth)))
    water.begin()
    return water


def test_the_settings_are_the_parameters_own() -> None:
    parameters = chosen(gravity=3.7)
    water = Water(GRID, parameters, LIQUID.known)
    assert water.liquid.settings.gravity == 3.7
    water.change_effects(EffectSet([GRAVITY]))
    assert water.liquid.effects == EffectSet([GRAVITY])


def test_water_that_begins_is_measured() -> None:
    assert filled().start == pytest.approx(1.0, rel=0.02)


def test_a_box_floats_as_deep_as_it_is_heavy() -> None:
    """Archimedes: half as dense as water, half of it is under the surface."""
    parameters, world = chosen(), Solids(chosen(), LIQUID.known)
    water = Water(GRID, parameters, LIQUID.known, world)
    body = world.world.add_body(box(0.4, 0.4, material=Material(0.5 * DENSITY)), (1.0, 0.5), restless=True)
    water.meet()
    water.liquid.add(water.liquid.lattice((0.0, 0.0), (2.0, 0.5)))
    water.begin()
    for _ in range(240):
        water.step(DT)
        world.step(DT)
    water.measure()
    level = (water.liquid.count * water.liquid.area + 0.5 * 0.4 * 0.4) / 2.0
    assert float(world.world.bodies.positions[body, 1]) == pytest.approx(level, abs=0.05)


def test_a_tap_gives_what_its_mouth_lets_through() -> None:
    water = Water(GRID, chosen(), LIQUID.known)
    mouths = Mouths(water)
    assert mouths.add_tap((1.0, 1.0), (0.0, -1.0), 0.1) == ""
    for _ in range(30):
        mouths.step(DT)
        water.step(DT)
    given = (water.liquid.account[0] + water.liquid.account[2]) * water.liquid.area
    assert given == pytest.approx(0.1 * 30 * DT, abs=water.liquid.area)
    mouths.running, before = False, water.liquid.account[0]
    mouths.step(DT)
    assert water.liquid.account[0] == before


def test_a_drain_takes_what_is_in_it_and_counts_it() -> None:
    water = filled()
    mouths = Mouths(water, most=1)
    assert mouths.add_drain((1.0, 0.25), 0.2) == ""
    assert mouths.add_drain((1.5, 0.25), 0.2) == "There are 1 drains already."
    before = water.liquid.count
    mouths.step(DT)
    gone = before - water.liquid.count
    assert mouths.flow[2] == gone
    assert gone * water.liquid.area == pytest.approx(math.pi * 0.04, rel=0.05)


def test_a_drop_falls_only_where_there_is_air() -> None:
    water = filled()
    assert water.let_fall((1.0, 0.25), 0.1) == 0
    made = water.let_fall((1.0, 0.9), 0.1, (0.0, -2.0))
    assert made * water.liquid.area == pytest.approx(math.pi * 0.01, rel=0.1)
    assert np.all(water.liquid.speeds[-made:] == (0.0, -2.0))


def test_what_is_stirred_goes_along_near_the_hand() -> None:
    water = filled()
    water.stir((0.5, 0.25), (1.0, 0.0), 0.1)
    speeds, places = water.liquid.speeds, water.liquid.places
    near = np.hypot(*(places - (0.5, 0.25)).T) < 0.05
    assert speeds[near, 0].min() > 0.7 and np.abs(speeds[places[:, 0] > 1.2]).max() < 1e-9


def test_still_water_is_silent_and_a_drop_is_a_splash() -> None:
    """The blow is no more than the drop had, and where and as fast as it fell."""
    water = filled(listens=True)
    roar = Roar(water)
    for _ in range(20):
        water.step(DT)
        roar.step(DT)
        assert water.blow.energy == 0.0 and not roar.due
    made = water.let_fall((1.2, 0.9), 0.12, (0.0, -4.0))
    energy = 0.5 * DENSITY * water.liquid.area * made * (16.0 + 2.0 * 9.81 * 0.4)
    splashes, given = [], 0.0
    for _ in range(20):
        water.step(DT)
        roar.step(DT)
        given += water.blow.energy
        if roar.due:
            splashes.append((water.blow.x, water.blow.speed, roar.splash(100.0)))
    assert splashes and splashes[0][0] == pytest.approx(1.2, abs=0.1)
    assert 3.0 < splashes[0][1] < 6.0 and splashes[0][2] > 0.5
    assert 0.2 * energy < given < energy
    assert roar.heard(100.0, 1.0, 1.0)[0].kind == "water"


def test_a_restored_member_goes_on_alike() -> None:
    water = filled(listens=True)
    roar = Roar(water)
    water.let_fall((1.2, 0.9), 0.12, (0.0, -4.0))
    for _ in range(5):
        water.step(DT)
        roar.step(DT)
    kept = [*(np.copy(one) for one in water.state()[0]), roar.state()[0].copy()]
    state = type(water.liquid.state())(*kept[:-1])

    def go_on() -> bytes:
        for _ in range(5):
            water.step(DT)
            roar.step(DT)
        return water.liquid.places.tobytes() + roar.loud.tobytes()

    first = go_on()
    water.restore(iter([state]))
    roar.restore(iter([kept[-1]]))
    assert go_on() == first
