"""Many small bodies in liquid, between which cells are nearly or wholly closed; and bodies at rest."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.liquid import Liquid
from game.physics.solids import Disc, SolidWorld, box
from game.physics.surfaces import SolidSurface
from tests.physics.liquid.test_bodies_in_water import DT, G, pool, run, sane, solids, wood


def packed(
    s: float, count: int, columns: int, n: int = 64
) -> tuple[SolidWorld, list[int], Liquid, SolidSurface]:
    """Discs 1.3 cells wide, 2 % apart, each second row shifted, in a tank half full."""
    world, r = solids(), 0.65 / n
    pitch = 2.04 * r
    ids = []
    for k in range(count):
        row, column = divmod(k, columns)
        place = (0.3 + column * pitch + 0.5 * r * (row % 2), 0.1 + row * pitch)
        ids.append(world.add_body(Disc(r, material=wood(s)), place))
    liquid, surface = pool(world, n, 0.5)
    return world, ids, liquid, surface


def total_energy(world: SolidWorld, ids: list[int], liquid: Liquid) -> float:
    rows = world.bodies
    mass, inertia = 1.0 / rows.inverse_masses[ids], 1.0 / rows.inverse_inertias[ids]
    own = 0.5 * mass * (rows.velocities[ids] ** 2).sum(axis=1) + 0.5 * inertia * rows.spins[ids] ** 2
    return sum(liquid.energy()) + float((own + mass * G * rows.positions[ids, 1]).sum())


@pytest.mark.parametrize("s", [0.5, 2.0])
def test_a_hundred_discs_hardly_larger_than_a_cell(s):
    """None is faster than what falls from the top of the tank. Light ones rise, dense ones sink.

    Room stays within 2 %. Energy gains no more than 1 % of room that crowding had taken and gives back: so
    much higher stands the water then.
    """
    world, ids, liquid, surface = packed(s, 100, 20)
    first, energies, fastest = float(world.bodies.positions[ids, 1].mean()), list[float](), list[float]()

    def look() -> None:
        energies.append(total_energy(world, ids, liquid))
        speeds = np.concatenate([liquid.speeds, world.bodies.velocities[ids]])
        fastest.append(float(np.hypot(*speeds.T).max()))

    run(world, liquid, surface, 3.0, look)
    assert sane(world, liquid) and max(fastest) < math.sqrt(2.0 * G * 1.0)
    assert max(energies) < 1.01 * energies[0] and max(np.diff(energies)) < 0.01 * energies[0]
    last = float(world.bodies.positions[ids, 1].mean())
    assert last > first + 0.1 if s < 1.0 else last < first - 0.05
    liquid.sample_solids(surface)
    liquid.refresh()
    assert liquid.wet_area() == pytest.approx(liquid.count * liquid.area, rel=0.02)


def test_a_row_of_discs_that_nearly_touch_rises_like_one():
    """The cells between them are closed or nearly so; taken for air, they would draw the row down."""
    world, ids, liquid, surface = packed(0.5, 10, 10)
    heights = [float(world.bodies.positions[ids, 1].mean())]
    run(world, liquid, surface, 0.6, lambda: heights.append(float(world.bodies.positions[ids, 1].mean())))
    assert heights[-1] > heights[0] + 0.1 and min(np.diff(heights)) > -1e-4


def test_balls_of_steel_at_rest_on_the_floor_leave_the_water_calm():
    """Six of them: 99 % of the water about them is slower than 1 cm/s, as it is where they are fixed."""
    world = solids()
    ids = [world.add_body(Disc(0.04, material=wood(7.8)), (0.1 + 0.16 * k, 0.04)) for k in range(6)]
    liquid, surface = pool(world, 64, 0.4)
    below: list[float] = []

    def look() -> None:
        deep = np.hypot(*liquid.speeds[liquid.places[:, 1] < 0.1].T)
        below.append(float(np.quantile(deep, 0.99)))

    run(world, liquid, surface, 1.0)
    run(world, liquid, surface, 2.0, look)
    assert max(below) < 0.01 and np.abs(world.bodies.velocities[ids]).max() < 0.02


def test_what_floats_stays_at_its_height_in_each_step():
    """Pushes that bear it come evenly: it neither hops nor falls back within a step."""
    world = solids()
    body = world.add_body(box(0.3, 0.1, material=wood(0.5)), (0.5, 0.4))
    liquid, surface = pool(world, 40, 0.4 - 0.5 * 0.3 * 0.05)
    speeds: list[float] = []
    run(world, liquid, surface, 0.5, lambda: speeds.append(float(world.bodies.velocities[body, 1])))
    assert np.abs(speeds).max() < 0.3 * G * DT


def test_what_contacts_hold_up_is_what_it_weighs():
    """A disc balances on another: of the lower one what bears it less what it bears is its own weight too."""
    world = solids()
    world.add_body(Disc(0.5), (0.0, -0.5), kind="fixed")
    low, high = (world.add_body(Disc(0.1, material=wood(2.0)), (0.0, 0.1 + 0.2 * k)) for k in range(2))
    for _ in range(60):
        world.step(DT)
    mass = 1.0 / world.bodies.inverse_masses[[low, high]]
    found = SolidSurface(world).held_up(np.array([low, high]), DT)
    assert found[:, 1] == pytest.approx(mass * G * DT, rel=0.02)
    assert found[:, [0, 2]] == pytest.approx(0.0, abs=1e-3 * mass[0] * G * DT)
