"""Closed forms of rods, blocks and dominoes that turn about an edge and hit."""

from __future__ import annotations

import math

import pytest

from game.physics.solids import Disc, Material, SolidSettings, SolidWorld, box
from game.physics.solids.arrays.state import FIRST_POINT, NORMAL_IMPULSE, POINT_WIDTH, TOUCHING
from game.physics.solids.effects import SLEEP, USUAL
from tests.physics.solids.setups import G, floor_world, run

AWAKE = USUAL.without(SLEEP)
ROUGH = Material(friction=10.0)
THIN = 0.002  # m, of a rod


@pytest.mark.parametrize(("e", "degrees"), [(0.0, 30.0), (1.0, 45.0), (0.5, 60.0)])
def test_a_smooth_rod_hits_the_floor_with_one_end(e, degrees):
    """J = m v (1 + e)/(1 + m c²/I), spin J c/I: of a rod as thick as it is, so that they hold to rounding."""
    material, angle = Material(friction=0.0, restitution=e), math.radians(degrees)
    world, _ = floor_world(material, gravity=(0.0, 0.0))
    rod = world.add_body(
        box(1.0, THIN, material=material), (0.0, 0.5 * math.sin(angle) + 0.02), angle, (0.0, -3.0)
    )
    run(world, 0.1)
    lever, inertia = 0.5 * math.cos(angle) - 0.5 * THIN * math.sin(angle), (1.0 + THIN**2) / 12.0
    impulse = 3.0 * (1.0 + e) / (1.0 + lever**2 / inertia)
    assert world.bodies.velocities[rod, 1] == pytest.approx(impulse - 3.0, rel=1e-9)
    assert world.bodies.spins[rod] == pytest.approx(-impulse * lever / inertia, rel=1e-9)


def test_a_rough_rod_hits_the_floor_and_its_end_stays():
    """m v c/(I + m r²), near 3/2 v cos/L: angular momentum about the end that hits."""
    angle = math.radians(30.0)
    world, _ = floor_world(ROUGH, gravity=(0.0, 0.0))
    rod = world.add_body(box(1.0, THIN, material=ROUGH), (0.0, 0.27), angle, (0.0, -3.0))
    run(world, 0.1)
    lever, about = 0.5 * math.cos(angle) - 0.5 * THIN * math.sin(angle), (1.0 + THIN**2) / 3.0
    assert world.bodies.spins[rod] == pytest.approx(-3.0 * lever / about, rel=1e-9)


def test_a_rod_tips_over_in_the_time_of_a_pendulum():
    """theta'' = 3 g/(2 L) sin theta from 5 degrees, about an edge of its foot."""
    t, tilt = 0.01, math.radians(5.0)
    half, dt = 0.5 * math.hypot(1.0, t), 1.0 / 240.0
    world, _ = floor_world(ROUGH, substeps=4, effects=AWAKE)
    rod = world.add_body(
        box(t, 1.0, material=ROUGH), (half * math.sin(tilt), half * math.cos(tilt)), -tilt - math.atan(t)
    )
    while world.bodies.angles[rod] > 0.02 - math.pi / 2 and world.time < 2.0:
        world.step(dt)
    assert world.time == pytest.approx(0.9483167, abs=2.0 * dt)


def test_a_ladder_leaves_the_wall_at_two_thirds_of_its_height():
    """From 10 degrees, 2 m, all smooth: 0.8444 s, cos theta = 2/3 cos theta0."""
    angle, t, dt = math.radians(10.0), 0.002, 1.0 / 240.0
    smooth = Material(friction=0.0)
    world, _ = floor_world(smooth, substeps=12, effects=AWAKE)
    wall = world.add_body(box(1.0, 20.0, material=smooth), (-0.5, 10.0), kind="fixed")
    s, c = math.sin(angle), math.cos(angle)
    ladder = world.add_body(box(t, 2.0, material=smooth), (s + 0.5 * t * c, c + 0.5 * t * s), angle)

    def is_pushed():
        contacts = world.contacts
        both = (contacts.bodies == wall).any(axis=1) & (contacts.bodies == ladder).any(axis=1)
        touching = contacts.manifolds[both & (contacts.marks[:, TOUCHING] == 1)]
        return bool(
            (touching[:, [FIRST_POINT + k * POINT_WIDTH + NORMAL_IMPULSE for k in (0, 1)]] > 0.0).any()
        )

    left, angle_then = 0.0, 0.0
    while world.time < 1.05:  # it lies at 1.1 s
        world.step(dt)
        if is_pushed():
            left, angle_then = world.time, math.degrees(world.bodies.angles[ladder])
    assert left == pytest.approx(0.8444266, rel=0.005)
    assert angle_then == pytest.approx(48.96359, rel=0.01)


def test_a_block_rocks_as_housner_said():
    """0.25 x 1 m from 5 degrees: 0.2676 s to the impact, then up to 3.983 degrees."""
    b, h, tilt, dt = 0.25, 1.0, math.radians(5.0), 1.0 / 240.0
    s, c = math.sin(tilt), math.cos(tilt)
    world, _ = floor_world(ROUGH, substeps=12, effects=AWAKE)
    block = world.add_body(box(b, h, material=ROUGH), (0.5 * (h * s - b * c), 0.5 * (h * c + b * s)), -tilt)
    while world.bodies.angles[block] < 0.0 and world.time < 1.0:
        world.step(dt)
    assert world.time == pytest.approx(0.2676327, abs=1.5 * dt)
    highest = 0.0
    for _ in range(90):
        world.step(dt)
        highest = max(highest, math.degrees(world.bodies.angles[block]))
    assert highest == pytest.approx(3.983075, rel=0.03)


@pytest.mark.parametrize(("mu", "gap", "speed"), [(0.2, 0.4, 1.3466), (0.2, 0.6, 1.2438), (0.4, 0.5, 1.0505)])
def test_dominoes_fall_at_the_speed_of_theory(mu, gap, speed):
    """In sqrt(g h), 0.16 thick (van Leeuwen 2010, feet fixed, plastic impacts)."""
    d = 0.16
    world, _ = floor_world(Material(friction=100.0), effects=AWAKE)
    row = [
        world.add_body(box(d, 1.0, material=Material(friction=mu)), (k * (gap + d), 0.5)) for k in range(36)
    ]
    world.push(row[0], (0.0, 1.0), (0.1, 0.0))
    times = {}
    while len(times) < 2 and world.time < 12.0:
        world.step(1.0 / 240.0)
        for k in (14, 32):
            if k not in times and world.bodies.angles[row[k]] < -0.02:
                times[k] = world.time
    found = 18 * (gap + d) / (times[32] - times[14])
    assert found / math.sqrt(G) == pytest.approx(speed, rel=0.02)


def test_a_light_disc_is_thrown_up_by_a_heavy_one():
    """1,000 : 1, both fall at v: the light one leaves at (3 M - m)/(M + m) v."""
    world = SolidWorld(SolidSettings(gravity=(0.0, 0.0), substeps=12))
    bouncy = Material(restitution=1.0, friction=0.0)
    world.add_body(box(40.0, 1.0, material=bouncy), (0.0, -0.5), kind="fixed")
    heavy = Material(density=1000.0, restitution=1.0, friction=0.0)
    world.add_body(Disc(0.5, material=heavy), (0.0, 0.6), velocity=(0.0, -3.0))
    light = world.add_body(Disc(0.5, material=bouncy), (0.0, 1.9), velocity=(0.0, -3.0))
    run(world, 0.3)
    assert world.bodies.velocities[light, 1] == pytest.approx(3.0 * (3000.0 - 1.0) / 1001.0, rel=1e-3)
