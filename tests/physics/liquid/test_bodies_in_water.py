"""Bodies that the liquid moves, beside what is exactly known, and in cases that break a lagged coupling."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest

from game.physics.effects import EffectSet
from game.physics.fields import GRAVITY
from game.physics.grid.layout import Grid
from game.physics.hydrostatics import exact
from game.physics.liquid import Liquid, LiquidSettings
from game.physics.solids import Disc, Material, Polygon, SolidSettings, SolidWorld, box
from game.physics.surfaces import KeyFrames, SolidSurface

G = 9.81
FINE = LiquidSettings(residual=1e-9, turns=1000)
CALM = LiquidSettings(carrier=0, flip=0.0)  # PIC: waves die out soon
DT = 1.0 / 60.0


def solids() -> SolidWorld:
    return SolidWorld(SolidSettings(gravity=(0.0, -G)))


def wood(s: float) -> Material:
    return Material(density=1000.0 * s, friction=0.3)


def walls(world: SolidWorld, width: float, height: float) -> list[int]:
    """Three bodies that keep solids in the tank; the liquid does not know them."""
    return [
        world.add_body(box(1.0, 4.0 * height), (-0.5, height), kind="fixed"),
        world.add_body(box(1.0, 4.0 * height), (width + 0.5, height), kind="fixed"),
        world.add_body(box(width + 2.0, 1.0), (0.5 * width, -0.5), kind="fixed"),
    ]


def pool(world: SolidWorld, n: int, depth: float, settings: LiquidSettings | None = None, high: float = 1.0):
    """A tank 1 m wide with water about what stands in it; hidden walls."""
    hidden = walls(world, 1.0, high)
    liquid = Liquid(Grid(n, round(high * n), 1.0 / n), settings, most=8 * n * n)
    surface = SolidSurface(world, without=hidden)
    liquid.set_solids(surface)
    liquid.add(liquid.lattice((0.0, 0.0), (1.0, depth)))
    return liquid, surface


def run(world: SolidWorld, liquid: Liquid, surface: SolidSurface, seconds: float, each=None) -> None:
    for _ in range(round(seconds / DT)):
        liquid.set_solids(surface)
        liquid.advance(DT)
        world.step(DT)
        if each is not None:
            each()


def sane(world: SolidWorld, liquid: Liquid) -> bool:
    places, bodies = liquid.places, world.bodies
    inside = (places >= liquid.grid.lower).all() and (places <= liquid.grid.upper).all()
    return bool(inside and np.isfinite(places).all() and np.isfinite(bodies.velocities).all())


def first_acceleration(shape, s: float, n: int, around: float | None = None) -> float:
    """In g, upwards, of a body let go in the middle of a box 1 m wide; around: radius of a ring of stone."""
    world = solids()
    body = world.add_body(shape, (0.5, 0.5))
    if around is not None:
        turn = 2.0 * math.pi * np.arange(65) / 64
        rim = np.stack([np.cos(turn), np.sin(turn)], axis=1)
        for p, q in pairwise(rim):
            stone = Polygon(0.5 + np.array([around * p, 0.8 * p, 0.8 * q, around * q]))
            world.add_body(stone, (0.0, 0.0), kind="fixed")
    liquid = Liquid(Grid(n, n, 1.0 / n), FINE, most=4 * n * n)
    liquid.set_solids(SolidSurface(world))
    places = liquid.lattice((0.0, 0.0), (1.0, 1.0))
    liquid.add(places)
    liquid.step(1e-4)
    return float(world.bodies.velocities[body, 1]) / (1e-4 * G) - 1.0


def in_box(r: float) -> float:
    """Added mass over the displaced one, of a small disc amid a closed box 1 m wide: 1 + 2 c r², by the
    reference of r = 0.1 (1.071199).
    """
    return 1.0 + 0.071199 * (r / 0.1) ** 2


@pytest.mark.parametrize("s", [0.01, 0.5, 2.0])
def test_a_small_disc_starts_as_in_unbounded_liquid(s):
    """But for the box's own share of the added mass, 2 %, scaled from that of the reference tank."""
    r = 0.05
    found = first_acceleration(Disc(r, material=wood(s)), s, 256)
    assert found == pytest.approx(exact.released(s, in_box(r)), rel=0.02)


def test_a_square_takes_more_water_along_than_it_displaces():
    """At sharp corners the order is 1: two grids, and what they tend to."""
    a, s = 0.125, 0.2
    coarse, fine = ((1.0 - s) / first_acceleration(box(a, a, material=wood(s)), s, n) - s for n in (96, 192))
    alone = exact.square_added_mass() + 1.0
    dipole = 0.5 * alone * a * a / math.pi  # radius squared of a disc with the same dipole
    walled = alone * (1.0 + 0.5 * 0.071199 * dipole / 0.01) - 1.0
    assert fine == pytest.approx(walled, rel=0.1)
    assert 2.0 * fine - coarse == pytest.approx(walled, rel=0.02)


@pytest.mark.parametrize(("r", "ring"), [(0.16, 0.4)])
def test_in_a_ring_the_added_mass_is_stokes(r, ring):
    """The same shape as 0.2 in 0.5 (1.380952)."""
    s = 0.3
    found = first_acceleration(Disc(r, material=wood(s)), s, 128, around=ring)
    assert (1.0 - s) / found - s == pytest.approx(exact.ring_added_mass(0.2, 0.5), rel=0.02)


def test_a_light_disc_rises_without_trembling():
    """A hundredth of the water's density: a lagged coupling would turn its speed round in each step."""
    world = solids()
    body = world.add_body(Disc(0.08, material=wood(0.01)), (0.5, 0.2))
    liquid, surface = pool(world, 40, 0.7)
    speeds: list[float] = []
    run(world, liquid, surface, 0.33, lambda: speeds.append(float(world.bodies.velocities[body, 1])))
    assert min(speeds) > 0.0 and min(np.diff(speeds[:8])) > 0.0 and sane(world, liquid)
    run(world, liquid, surface, 3.0)
    level = liquid.count * liquid.area + 0.01 * math.pi * 0.08 * 0.08
    rest = level + 0.08 - exact.disc_draft(0.08, 0.01)[0]
    assert float(world.bodies.positions[body, 1]) == pytest.approx(rest, abs=0.03)


@pytest.mark.parametrize(("s", "low", "high"), [(1.0, -0.098, 0.098), (1.2, -0.5, -0.12), (0.85, 0.12, 0.5)])
def test_as_dense_as_water_it_hovers(s, low, high):
    """Within what 2 % of gravity would do in a second."""
    world = solids()
    body = world.add_body(box(0.2, 0.2, material=wood(s)), (0.5, 0.3))
    liquid, surface = pool(world, 40, 0.7)
    run(world, liquid, surface, 1.0)
    assert low < float(world.bodies.positions[body, 1]) - 0.3 < high


@pytest.mark.parametrize(("s", "start", "least", "most"), [(0.15, 30.0, 0.0, 8.0), (0.35, 8.0, 37.0, 45.0)])
def test_a_square_log_turns_to_flat_or_to_corner_up(s, start, least, most):
    world = solids()
    body = world.add_body(box(0.3, 0.3, material=wood(s)), (0.5, 0.5 + 0.3 * (0.5 - s)), math.radians(start))
    liquid, surface = pool(world, 40, 0.5, CALM)
    found: list[float] = []
    run(world, liquid, surface, 8.0)
    run(world, liquid, surface, 4.0, lambda: found.append(float(world.bodies.angles[body])))
    turned = math.degrees(float(np.mean(found))) % 90.0
    assert least <= min(turned, 90.0 - turned) <= most


def test_what_is_thrown_out_slams_and_energy_falls():
    world = solids()
    body = world.add_body(box(0.4, 0.1, material=wood(0.4)), (0.5, 0.9))
    liquid, surface = pool(world, 40, 0.4, high=1.25)
    mass = 1.0 / float(world.bodies.inverse_masses[body])
    sums: list[float] = []

    def add() -> None:
        rows = world.bodies
        own = 0.5 * mass * float((rows.velocities[body] ** 2).sum()) + mass * G * float(
            rows.positions[body, 1]
        )
        sums.append(own + sum(liquid.energy()))

    run(world, liquid, surface, 2.0, add)
    rise = max(0.0, *np.diff(sums))
    assert sane(world, liquid) and rise < 0.01 * (sums[0] - sums[-1]) + 0.02 * sums[0] and sums[-1] < sums[0]


def test_it_falls_faster_than_a_cell_a_step_and_lies_on_the_floor():
    world = solids()
    body = world.add_body(box(0.2, 0.1, material=wood(8.0)), (0.5, 0.5))
    liquid, surface = pool(world, 40, 0.4)
    world.set_velocity(body, (0.0, -6.0))
    run(world, liquid, surface, 2.0)
    assert sane(world, liquid)
    assert float(world.bodies.positions[body, 1]) == pytest.approx(0.05, abs=0.01)


def test_a_float_bears_another():
    world = solids()
    low, high = (world.add_body(box(0.6, 0.1, material=wood(0.25)), (0.5, 0.4 + 0.101 * k)) for k in range(2))
    liquid, surface = pool(world, 40, 0.4)
    run(world, liquid, surface, 3.0)
    apart = world.bodies.positions[high] - world.bodies.positions[low]
    assert sane(world, liquid) and float(np.hypot(*apart)) == pytest.approx(0.1, abs=0.02)


def test_a_float_in_a_slot_of_a_cell_on_each_side():
    """Hardly any water: it is pressed up by the little beside it."""
    world = solids()
    n = 40
    body = world.add_body(box(1.0 - 2.0 / n, 0.3, material=wood(0.5)), (0.5, 0.4))
    liquid, surface = pool(world, n, 0.24)
    run(world, liquid, surface, 3.0)
    assert sane(world, liquid)
    assert 0.05 < float(world.bodies.positions[body, 1]) - 0.15 < 0.35


def test_a_led_piston_is_handed_over():
    """It drives water ahead of it, moves exactly as it is led, and floats when it is let go."""
    world = solids()
    body = world.add_body(box(0.1, 0.5, material=wood(0.5)), (0.15, 0.3))
    frames = KeyFrames(world, body, lambda t: (0.15 + 0.2 * t, 0.3, 0.0))
    liquid, surface = pool(world, 40, 0.4)
    for k in range(60):
        frames.lead(k * DT, DT)
        run(world, liquid, surface, DT)
    assert world.bodies.positions[body].tolist() == pytest.approx([0.35, 0.3], abs=1e-9)
    right = liquid.places[:, 0] > 0.41
    assert float(liquid.places[right, 1].max()) > 0.42
    frames.let_go()
    run(world, liquid, surface, 3.0)
    assert sane(world, liquid) and float(world.bodies.positions[body, 1]) > 0.3


def test_what_the_water_gives_a_body_it_loses():
    """One step in a closed full box: water and body have what gravity and the walls gave them.

    Floor and ceiling push by the pressure of the cells there. The correction of the volume is left out: it
    moves particles, and stands in the field beside the speeds.
    """
    n, r, s = 32, 0.2, 0.5
    world = solids()
    body = world.add_body(Disc(r, material=wood(s)), (0.5, 0.5))
    liquid = Liquid(Grid(n, n, 1.0 / n), FINE, most=4 * n * n, effects=EffectSet([GRAVITY]))
    liquid.set_solids(SolidSurface(world))
    liquid.add(liquid.lattice((0.0, 0.0), (1.0, 1.0)))
    dt = 1e-4
    liquid.step(dt)
    scale = 1000.0 / (n * n)
    mass = 1.0 / float(world.bodies.inverse_masses[body])
    open_v = np.clip(liquid.walls.ay[1:-1], 0.0, 1.0)
    flow = scale * float((open_v * liquid.cells.v[1:-1]).sum())
    fall = -scale * G * dt * float(open_v.sum())
    q = liquid.cells.q
    # the pressure difference over each open face, and what the body got of its closed part, sum to the walls'
    walls_push = scale * float(q[0].sum() - q[-1].sum())
    got = mass * float(world.bodies.velocities[body, 1])
    assert flow - fall + got == pytest.approx(walls_push, abs=1e-6 * abs(got))
    assert abs(float(world.bodies.velocities[body, 0])) < 1e-9 * abs(float(world.bodies.velocities[body, 1]))


def test_ten_bodies_raise_the_level_by_what_they_weigh_or_fill():
    """Five that float and five that lie on the floor."""
    world = solids()
    for k in range(5):
        world.add_body(box(0.1, 0.1, material=wood(0.5)), (0.14 + 0.18 * k, 0.47))
        world.add_body(Disc(0.04, material=wood(3.0)), (0.14 + 0.18 * k, 0.1))
    liquid, surface = pool(world, 64, 0.4)
    water, found = liquid.count * liquid.area, list[float]()

    def look() -> None:
        liquid.refresh()
        free = (liquid.obstacles.faces.volume > 0.999).all(axis=0)
        inside = np.clip(0.5 - liquid.cells.phi[:, free], 0.0, 1.0)
        if free.any():
            found.append(float(inside.sum()) / 64 / int(free.sum()))

    run(world, liquid, surface, 3.0)
    run(world, liquid, surface, 2.0, look)
    rise = 5 * (0.01 * 0.5 + math.pi * 0.04 * 0.04)
    assert float(np.mean(found)) == pytest.approx(water + rise, rel=0.01)
