"""Hard cases of the liquid: one drop, fast drops, thin columns, pockets, full tanks, large bodies."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.grid.layout import Grid
from game.physics.liquid import Liquid, LiquidSettings
from game.physics.solids import Disc, Material, SolidSettings, SolidWorld, box
from game.physics.surfaces import SolidSurface

G = 9.81


def tank(nx: int, ny: int, cell: float = 1.0 / 32, **more) -> Liquid:
    return Liquid(Grid(nx, ny, cell), more.pop("settings", None), most=20_000, **more)


def sane(liquid: Liquid) -> bool:
    """All is finite and within the grid."""
    low, high = liquid.grid.lower, liquid.grid.upper
    inside = (liquid.places >= low).all() and (liquid.places <= high).all()
    return bool(inside and np.isfinite(liquid.places).all() and np.isfinite(liquid.speeds).all())


def run(liquid: Liquid, seconds: float, dt: float = 1.0 / 60.0) -> None:
    for _ in range(round(seconds / dt)):
        liquid.advance(dt)


@pytest.mark.parametrize("carrier", [0, 1])
@pytest.mark.parametrize("count", [1, 2])
def test_single_particles_fall_freely(carrier, count):
    liquid = tank(32, 32, settings=LiquidSettings(carrier=carrier))
    liquid.add([(0.3, 0.9), (0.7, 0.85)][:count], (0.1, 0.2))
    run(liquid, 0.25)
    heights = np.array([0.9, 0.85])[:count] + 0.2 * 0.25 - 0.5 * G * 0.25**2
    assert liquid.places[:, 1] == pytest.approx(heights, abs=1e-12)
    assert liquid.speeds == pytest.approx(np.array([[0.1, 0.2 - 0.25 * G]] * count), abs=1e-12)
    run(liquid, 1.0)
    assert liquid.report.wet == 0 and sane(liquid)
    assert np.abs(liquid.speeds[:, 1]).max() < G / 60.0 + 1e-9


def test_an_empty_tank_steps():
    liquid = tank(8, 8)
    assert liquid.advance(1.0) >= 1 and liquid.wet_area() == 0.0


def test_a_drop_of_20_metres_a_second_neither_passes_nor_gains():
    liquid = tank(64, 64, 1.0 / 64)
    liquid.add(liquid.lattice((0.0, 0.0), (1.0, 0.2)))
    drop = liquid.lattice((0.4, 0.7), (0.6, 0.9))
    liquid.add(drop[np.hypot(drop[:, 0] - 0.5, drop[:, 1] - 0.8) < 0.1], (0.0, -20.0))
    count, start = liquid.count, sum(liquid.energy())
    for _ in range(60):
        parts = liquid.advance(1.0 / 60.0)
        assert parts < 40 and sane(liquid) and sum(liquid.energy()) <= start * (1.0 + 1e-9)
    assert liquid.count == count


def test_a_column_two_cells_wide_and_forty_high():
    liquid = tank(64, 48)
    liquid.add(liquid.lattice((1.0, 0.0), (1.0 + 2 / 32, 40 / 32)))
    start = sum(liquid.energy())
    for _ in range(120):
        liquid.advance(1.0 / 60.0)
        assert sane(liquid) and sum(liquid.energy()) <= start
    assert liquid.count == 2 * 40 * 4


@pytest.mark.parametrize("size", [1, 8])
def test_a_pocket_of_air_under_a_lid(size):
    """The tank is full but for a bubble of so many cells at its top, then for one in its middle."""
    for top in (32, 20):
        liquid = tank(32, 32)
        places = liquid.lattice((0.0, 0.0), (1.0, 1.0))
        x, y = (places * 32).T
        liquid.add(places[(np.abs(x - 16) > size / 2) | (y > top) | (y < top - size)])
        run(liquid, 2.0)
        assert sane(liquid) and np.abs(liquid.cells.q).max() < 10.0


def test_a_full_closed_tank_has_no_null_space():
    liquid = tank(16, 16)
    liquid.add(liquid.lattice((0.0, 0.0), (0.5, 0.5)))
    places = liquid.places.copy()
    run(liquid, 1.0)
    assert sane(liquid) and np.abs(liquid.speeds).max() < 1e-2
    assert np.abs(liquid.places - places).max() < 0.01
    p = liquid.pressure(1.0 / 60.0)
    assert np.diff(p, axis=0) == pytest.approx(-1000.0 * G / 32, rel=0.02)


def test_liquid_poured_into_a_full_tank_is_bounded():
    liquid = tank(16, 16)
    liquid.add(liquid.lattice((0.0, 0.0), (0.5, 0.5)))
    for _ in range(60):
        liquid.add(liquid.lattice((0.2, 0.2), (0.3, 0.3)))
        liquid.advance(1.0 / 60.0)
    assert sane(liquid) and np.isfinite(liquid.cells.q).all()


def test_64_particles_in_one_cell_come_apart_slowly():
    liquid = tank(32, 32)
    liquid.add(np.random.default_rng(1).uniform(0.5, 0.53, (64, 2)))
    start = sum(liquid.energy())
    run(liquid, 2.0)
    assert sane(liquid) and sum(liquid.energy()) < start


def test_wet_cells_that_touch_by_a_corner():
    liquid = tank(16, 16)
    liquid.add(liquid.lattice((0.125, 0.125), (0.25, 0.25)))
    liquid.add(liquid.lattice((0.25, 0.25), (0.375, 0.375)))
    run(liquid, 1.0)
    assert sane(liquid)


def test_gravity_that_turns_round():
    liquid = tank(32, 32)
    liquid.add(liquid.lattice((0.0, 0.0), (1.0, 0.4)))
    run(liquid, 0.2)
    liquid.settings = liquid.settings._replace(gravity=-G)
    run(liquid, 3.0)
    assert sane(liquid) and liquid.places[:, 1].mean() > 0.7


def test_a_body_larger_than_the_pool_is_pressed_on_it():
    world = SolidWorld(SolidSettings(gravity=(0.0, -G)))
    lid = world.add_body(box(3.0, 0.5), (0.5, 1.0), kind="key-framed")
    liquid = tank(32, 32)
    liquid.add(liquid.lattice((0.0, 0.0), (1.0, 0.6)))
    world.set_velocity(lid, (0.0, -0.5), 0.0)
    for _ in range(40):
        liquid.set_solids(SolidSurface(world))
        liquid.advance(1.0 / 60.0)
        world.step(1.0 / 60.0)
    assert sane(liquid) and liquid.count == 64 * 38


def test_a_block_put_into_water_moves_it_out():
    world = SolidWorld(SolidSettings())
    world.add_body(box(0.4, 0.4), (0.5, 0.3), kind="fixed")
    liquid = tank(32, 32)
    liquid.add(liquid.lattice((0.0, 0.0), (1.0, 0.5)))
    liquid.set_solids(SolidSurface(world))
    run(liquid, 5.0)
    assert sane(liquid) and (liquid.solid_distance(liquid.places) > -0.01).all()
    level = float(np.sort(liquid.places[:, 1])[-20:].mean())
    assert level == pytest.approx(0.66, abs=1.0 / 32)


def test_water_stays_in_a_glass_that_is_no_wall_of_the_grid():
    world = SolidWorld(SolidSettings())
    for size, place in (((0.1, 0.7), (0.25, 0.45)), ((0.1, 0.7), (0.75, 0.45)), ((0.6, 0.1), (0.5, 0.15))):
        world.add_body(box(*size), place, kind="fixed")
    liquid = tank(32, 32)
    liquid.set_solids(SolidSurface(world))
    count = liquid.add(liquid.lattice((0.32, 0.22), (0.68, 0.5)))
    run(liquid, 3.0)
    inside = (np.abs(liquid.places[:, 0] - 0.5) < 0.21) & (liquid.places[:, 1] > 0.19)
    assert sane(liquid) and inside.all() and liquid.count == count


def released(r: float, density: float, n: int) -> float:
    """First acceleration of a disc in the middle of a full closed box 1 m wide, in g."""
    world = SolidWorld(SolidSettings(gravity=(0.0, -G)))
    body = world.add_body(Disc(r, material=Material(density=1000.0 * density)), (0.5, 0.5))
    liquid = Liquid(Grid(n, n, 1.0 / n), LiquidSettings(residual=1e-9, turns=1000), most=4 * n * n)
    liquid.set_solids(SolidSurface(world))
    liquid.add(liquid.lattice((0.0, 0.0), (1.0, 1.0)))
    liquid.step(1e-4)
    assert abs(world.bodies.velocities[body, 0]) < 1e-9 and abs(world.bodies.spins[body]) < 1e-9
    return float(world.bodies.velocities[body, 1]) / (1e-4 * G) - 1.0


@pytest.mark.parametrize(("r", "density", "exact"), [(0.1, 0.01, 0.9156496947), (0.25, 0.1, 0.5462795931)])
def test_a_light_disc_in_a_full_box_starts_as_its_added_mass_says(r, density, exact):
    """Even a hundredth of the liquid's density: (1 - s) / (s + m_a), one coupled solve."""
    assert released(r, density, 64) == pytest.approx(exact, rel=0.025)
    assert released(r, density, 128) == pytest.approx(exact, rel=0.006)


def test_a_body_as_dense_as_water_stays_and_a_denser_one_sinks():
    assert abs(released(0.25, 1.0, 32)) < 0.02
    assert released(0.25, 2.0, 64) == pytest.approx(-1.0 / (2.0 + 1.547508), rel=0.02)


def test_a_floating_log_displaces_its_mass():
    """Archimedes: the level rises by the log's mass over the tank's width; it comes to swim there."""
    world = SolidWorld(SolidSettings(gravity=(0.0, -G)))
    body = world.add_body(box(0.5, 0.25, material=Material(density=500.0)), (0.5, 0.55))
    liquid = tank(48, 48, 1.0 / 48, settings=LiquidSettings(carrier=0, flip=0.5))
    liquid.add(liquid.lattice((0.0, 0.0), (1.0, 0.5)))
    middles = []
    for frame in range(720):
        liquid.set_solids(SolidSurface(world))
        liquid.advance(1.0 / 60.0)
        world.step(1.0 / 60.0)
        if frame > 480:
            middles.append(world.bodies.positions[body, 1])
    assert sane(liquid) and abs(world.bodies.angles[body]) < 0.2
    level = 0.5 + 0.5 * 0.5 * 0.25
    assert np.mean(middles) == pytest.approx(level, abs=1.0 / 48)


def test_open_sides_let_it_go_and_it_is_counted():
    liquid = tank(32, 32, open_sides=("right",))
    liquid.add(liquid.lattice((0.0, 0.0), (1.0, 0.3)))
    count = liquid.count
    run(liquid, 4.0)
    assert sane(liquid) and liquid.account[1] > 0.8 * count
    assert liquid.count + liquid.account[1] == count == liquid.account[0]


def test_a_film_of_one_cell_runs_down_a_wall_and_off_its_corner():
    """It slides without friction, g sin a t along the wall, and then flies; none of it stays."""
    world, turn = SolidWorld(SolidSettings()), -0.6
    along, out = np.array([math.cos(turn), math.sin(turn)]), np.array([-math.sin(turn), math.cos(turn)])
    middle = np.array([0.45, 1.3])
    world.add_body(box(0.7, 0.1), tuple(middle), turn, kind="fixed")
    liquid = tank(48, 64)
    liquid.set_solids(SolidSurface(world))
    places = liquid.lattice((0.0, 0.0), (1.5, 2.0))
    x, y = (places - middle) @ along, (places - middle) @ out - 0.05
    count = liquid.add(places[(np.abs(x + 0.2) < 0.1) & (y > 0.0) & (y < 1.0 / 32)])
    start = float(((liquid.places - middle) @ along).mean())
    energy = sum(liquid.energy())
    run(liquid, 0.3)
    slid = float(((liquid.places - middle) @ along).mean()) - start
    assert slid == pytest.approx(0.5 * G * math.sin(-turn) * 0.3**2, rel=0.12)
    assert (np.abs(liquid.solid_distance(liquid.places)) < 3.0 / 32).all()
    run(liquid, 2.0)
    assert liquid.count == count and sane(liquid) and sum(liquid.energy()) < energy
    assert liquid.places[:, 1].max() < 0.5


def test_a_wall_that_moved_takes_no_liquid_into_it():
    """All that it covered is outside again after one sampling, and nothing is lost."""
    world = SolidWorld(SolidSettings())
    block = world.add_body(box(0.3, 0.3), (0.5, 0.8), kind="key-framed")
    liquid = tank(32, 32)
    surface = SolidSurface(world)
    liquid.set_solids(surface)
    count = liquid.add(liquid.lattice((0.0, 0.0), (1.0, 0.5)))
    for place in ((0.5, 0.3), (0.3, 0.25), (0.7, 0.25)):
        world.bodies.positions[block] = place
        liquid.set_solids(surface)
        assert (liquid.solid_distance(liquid.places) > -0.2 / 32).all()
        run(liquid, 0.5)
        assert sane(liquid) and liquid.count == count
    run(liquid, 2.0)
    liquid.refresh()
    assert liquid.wet_area() == pytest.approx(count * liquid.area, rel=0.01)


@pytest.mark.parametrize("carrier", [0, 1], ids=["flip", "apic"])
def test_a_free_blob_keeps_its_momentum_and_has_no_more_energy_than_at_first(carrier):
    """It turns and flies without gravity. Its surface lies between cells, where pressures on both sides of a
    face are not each other's opposite: what is open is bounded.
    """
    liquid = tank(64, 64, 1.0 / 64, settings=LiquidSettings(carrier=carrier, gravity=0.0))
    places = liquid.lattice((0.3, 0.3), (0.7, 0.7))
    liquid.add(places[np.hypot(*(places - 0.5).T) < 0.15], (0.3, 0.1))
    liquid.speeds[:] += (liquid.places - 0.5)[:, ::-1] * (-1.0, 1.0)
    momentum, energy = liquid.speeds.mean(axis=0), sum(liquid.energy())
    for _ in range(30):
        liquid.advance(1.0 / 60.0)
        assert sum(liquid.energy()) < energy
    assert np.abs(liquid.speeds.mean(axis=0) - momentum).max() < 3e-4 * math.hypot(0.3, 0.1)


@pytest.mark.parametrize(
    ("words", "more"),
    [
        ("most", {"most": 0}),
        ("spread", {"spread": 9}),
        ("density", {"density": math.nan}),
        ("open_sides", {"open_sides": ("up",)}),
    ],
)
def test_nonsense_is_refused(words, more):
    with pytest.raises(ValueError, match=words):
        Liquid(Grid(8, 8, 0.1), **more)


def test_what_is_no_number_is_refused_and_what_lies_outside_left_out():
    liquid = tank(8, 8)
    with pytest.raises(ValueError, match="places"):
        liquid.add([(math.nan, 0.1)])
    with pytest.raises(ValueError, match="duration"):
        liquid.advance(-1.0)
    assert liquid.add([(-1.0, 0.1), (0.1, 0.1)]) == 1
    liquid.speeds[:] = 1e6
    with pytest.raises(RuntimeError, match="part steps"):
        liquid.advance(1.0)
