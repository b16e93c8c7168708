"""What is fast and thin does not pass through what is thin; nothing gains energy by being stopped."""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.solids import Capsule, Chain, Disc, SolidSettings, SolidWorld, box
from tests.physics.solids.setups import energy, run

PLATES = {
    "flat": (np.pi / 2.0, 0.0),
    "edge on": (0.0, 0.0),
    "spinning": (0.3, 200.0),
}


def wall_world(**settings):
    settings.setdefault("gravity", (0.0, 0.0))
    world = SolidWorld(SolidSettings(**settings))
    world.add_body(box(0.05, 40.0), (0.0, 0.0), kind="fixed")
    return world


@pytest.mark.parametrize("name", PLATES)
def test_a_thin_plate_at_100_m_per_s_stays_on_its_side(name):
    angle, spin = PLATES[name]
    world = wall_world()
    body = world.add_body(box(1.0, 0.01), (-5.03, 0.1), angle, velocity=(100.0, 0.0), spin=spin)
    before = start = energy(world, 0.0)
    for _ in range(60):
        world.step(1.0 / 60.0)
        assert world.bodies.positions[body, 0] < 0.0
        now = energy(world, 0.0)
        assert now <= before * (1.0 + 1e-9) + 1e-32 * start  # below that speeds are rounding of the first
        before = now


def test_random_shots_at_a_wall_and_at_a_chain():
    rng = np.random.default_rng(11)
    for number in range(100):
        world = wall_world() if number % 2 else SolidWorld(SolidSettings(gravity=(0.0, 0.0)))
        if number % 2 == 0:
            world.add_body(Chain([(0.0, 20.0 - k) for k in range(41)][::-1]), kind="fixed")
        shape = [box(1.0, 0.01), Disc(0.05), Capsule((-0.3, 0.0), (0.3, 0.0), 0.01), box(0.2, 0.3)][
            number % 4
        ]
        bodies = [
            world.add_body(
                shape, (-rng.uniform(1.0, 6.0), 3.0 * k), rng.uniform(0, 6.28),
                velocity=(rng.uniform(20.0, 200.0), rng.uniform(-20.0, 20.0)),
                spin=rng.uniform(-200.0, 200.0),
            )
            for k in range(-4, 5)
        ]  # fmt: skip
        for _ in range(30):
            world.step(1.0 / 60.0)
            inside = np.abs(world.bodies.positions[bodies, 1]) < 19.0
            assert (world.bodies.positions[bodies, 0][inside] < 0.0).all(), number
        world.check()


def test_plate_against_plate():
    world = SolidWorld(SolidSettings(gravity=(0.0, 0.0)))
    left = world.add_body(box(0.01, 1.0), (-3.0, 0.0), velocity=(100.0, 0.0))
    right = world.add_body(box(0.01, 1.0), (3.0, 0.0), velocity=(-100.0, 0.0))
    for _ in range(30):
        world.step(1.0 / 60.0)
        assert world.bodies.positions[left, 0] < world.bodies.positions[right, 0]
    assert np.abs(world.bodies.velocities.sum(axis=0)).max() < 1e-9


def test_the_time_of_an_impact_is_known_within_the_step():
    world = wall_world()
    world.add_body(Disc(0.1), (-2.0, 0.0), velocity=(20.0, 0.0))
    number, shapes = -1, []
    while not len(shapes) and number < 20:
        number += 1
        world.step(1.0 / 60.0)
        shapes, places = world.contacts_begun()
    assert number / 60.0 + places[0, 4] == pytest.approx((2.0 - 0.1 - 0.025) / 20.0, abs=1.0 / 600.0)
    assert places[0, 3] == pytest.approx(20.0)


def test_a_box_falling_on_the_ground_never_gains_energy():
    world = SolidWorld(SolidSettings())
    world.add_body(box(40.0, 0.02), (0.0, 0.0), kind="fixed")
    world.add_body(box(0.3, 0.02), (0.0, 3.0), 0.4, velocity=(0.0, -60.0))
    before = start = world.energy().total
    for _ in range(120):
        world.step(1.0 / 60.0)
        now = world.energy().total
        assert now <= before + 1e-9 * start
        before = now
    run(world, 1.0)
