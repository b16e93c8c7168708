"""What stands and what falls: each threshold from both sides, by statics."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.solids import Capsule, Disc, Material, Polygon, SolidWorld, box
from game.physics.solids.effects import SLEEP, USUAL
from tests.physics.solids.setups import column, floor_world, run

AWAKE = USUAL.without(SLEEP)
ARCH = 0.106068  # thickness over mean radius at which 15 straight voussoirs just stand: statics as an LP


@pytest.mark.parametrize("substeps", [4, 12, 24])
def test_a_column_of_forty_stands_for_a_minute_awake(substeps):
    world, _ = floor_world(substeps=substeps, effects=AWAKE)
    bodies = column(world, 40)
    run(world, 60.0)
    assert np.abs(world.bodies.positions[bodies, 0]).max() < 0.25
    sink = 24.525 / (2.0 * math.pi * 0.135 * 60.0 * substeps) ** 2 * (40 * 39 / 2 + 40 / 8)
    assert 39.5 - world.bodies.positions[bodies[-1], 1] == pytest.approx(sink, rel=0.01)


def test_a_thousand_times_heavier_box_on_ten_sinks_by_a_tenth_at_most():
    world, _ = floor_world(substeps=32)
    column(world, 10)
    heavy = world.add_body(box(1.0, 1.0, material=Material(density=1000.0)), (0.0, 10.5))
    run(world, 5.0)
    assert 10.5 - world.bodies.positions[heavy, 1] < 0.1
    assert abs(world.bodies.positions[heavy, 0]) < 0.01


@pytest.mark.parametrize(("part", "stands"), [(1.0 - 0.0034, True), (1.0 + 0.0034, False)])
def test_bricks_overhang_by_the_harmonic_series(part, stands):
    world, _ = floor_world(substeps=64, effects=AWAKE)
    world.add_body(box(1.0, 0.2), (0.0, 0.1), kind="fixed")
    x, bricks = 0.0, []
    for level, k in enumerate(range(4, 0, -1)):
        x += part / (2 * k)
        bricks.append(world.add_body(box(1.0, 0.2), (x, 0.3 + 0.2 * level)))
    top = float(world.bodies.positions[bricks[-1], 1])
    run(world, 4.0)
    assert (world.bodies.positions[bricks[-1], 1] > top - 0.02) == stands


@pytest.mark.parametrize(("part", "stands"), [(0.98, False), (1.02, True)])
def test_an_arch_stands_if_it_is_thick_enough(part, stands):
    world, _ = floor_world(Material(friction=0.8), substeps=32, effects=AWAKE)
    radius, half, turn = 10.0, 0.5 * part * ARCH * 10.0, math.pi / 15
    for k in range(15):
        rays = [np.array([math.cos(a), math.sin(a)]) for a in (k * turn, (k + 1) * turn)]
        corners = [(radius + s * half) * rays[i] for i, s in ((0, -1), (0, 1), (1, 1), (1, -1))]
        stone = world.add_body(Polygon(corners, material=Material(friction=0.8)))
        if k == 7:
            key, before = stone, float(world.bodies.positions[stone, 1])
    run(world, 10.0)
    assert (world.bodies.positions[key, 1] > before - 0.05) == stands


@pytest.mark.parametrize(("part", "stands"), [(0.98, True), (1.02, False)])
def test_a_card_leans_up_to_the_limit_of_friction(part, stands):
    """Half a house of cards against a smooth wall: tan of the angle from upright is 2 mu."""
    angle, t = part * math.atan(0.8), 0.004
    world, _ = floor_world(Material(friction=0.4), substeps=12, effects=AWAKE)
    world.add_body(box(1.0, 20.0, material=Material(friction=0.0)), (-0.5, 10.0), kind="fixed")
    s, c = math.sin(angle), math.cos(angle)
    place = 0.5 * (s + t * c), 0.5 * (c + t * s)
    card = world.add_body(box(t, 1.0, material=Material(friction=0.4)), place, angle)
    run(world, 4.0)
    assert (abs(world.bodies.angles[card] - angle) < 1e-3) == stands


@pytest.mark.parametrize(
    ("between", "floor", "stands"), [(1.02, 1.02, True), (0.98, 1.3, False), (1.3, 0.98, False)]
)
def test_a_disc_on_two_discs_is_held_by_friction_alone(between, floor, stands):
    """2 - sqrt 3 between the discs, a third of it on the floor."""
    mu, mu_floor, r = between * (2.0 - math.sqrt(3.0)), floor * (2.0 - math.sqrt(3.0)) / 3.0, 0.5
    world, _ = floor_world(Material(friction=mu_floor**2 / mu), substeps=16, effects=AWAKE)
    for place in ((-r, r), (r, r), (0.0, r + r * math.sqrt(3.0))):
        top = world.add_body(Disc(r, material=Material(friction=mu)), place)
    run(world, 4.0)
    assert (world.bodies.positions[top, 1] > 1.3) == stands


def test_a_capsule_on_its_end_falls_only_after_a_push():
    world, _ = floor_world(effects=AWAKE)
    shape = Capsule((0.0, -0.5), (0.0, 0.5), 0.2)
    still = world.add_body(shape, (0.0, 0.7))
    pushed = world.add_body(shape, (5.0, 0.7))
    world.push(pushed, (5.0, 1.2), (0.01, 0.0))
    run(world, 3.0)
    assert abs(world.bodies.angles[still]) < 1e-6
    assert abs(world.bodies.angles[pushed]) > 1.4


def test_a_compound_l_rests_on_its_foot_without_jitter():
    world, _ = floor_world(effects=AWAKE)
    corners = [(0, 0), (1.0, 0), (1.0, 0.2), (0.2, 0.2), (0.2, 0.9), (0, 0.9)]
    body = world.add_body(Polygon(corners), (0.0, 0.001))
    run(world, 3.0)
    before = world.bodies.positions[body].copy(), float(world.bodies.angles[body])
    run(world, 2.0)
    assert world.bodies.positions[body] == pytest.approx(before[0], abs=1e-6)
    assert world.bodies.angles[body] == pytest.approx(before[1], abs=1e-6)


@pytest.mark.parametrize("mu", [1.2, 1.5])
def test_a_sliding_rod_at_painleves_angle_stays_finite_and_loses_energy(mu):
    world, _ = floor_world(Material(friction=mu), effects=AWAKE)
    angle = math.radians(63.4)
    rod = box(2.0, 0.01, material=Material(friction=mu))
    world.add_body(rod, (0.0, math.sin(angle) + 0.003), angle, velocity=(-4.0, 0.0))
    before = world.energy().total
    for _ in range(120):
        world.step(1.0 / 60.0)
        now = world.energy().total
        assert now <= before + 2e-4
        before = now
    world.check()


def test_sag_catches_no_edge_of_equal_tiles():
    """A stack of ten, whose foot sags most and sways, slides over tiles at 5 m/s without friction below."""
    smooth = Material(friction=0.0)
    world = SolidWorld()
    for k in range(20):
        world.add_body(box(1.0, 1.0, material=smooth), (k - 45.0, -0.5), kind="fixed")
    boxes = [world.add_body(box(1.0, 1.0), (-40.0, 0.5 + k), velocity=(5.0, 0.0)) for k in range(10)]
    run(world, 1.5)
    assert world.bodies.velocities[boxes, 0] == pytest.approx([5.0] * 10, rel=1e-2)
    assert np.abs(world.bodies.angles[boxes]).max() < 0.01
