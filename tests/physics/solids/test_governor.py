"""What the energy of a scene may rise by in a step, what it may not, and what holding it leaves as it is."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.solids import Material, SolidSettings, SolidWorld, box
from game.physics.solids.effects import SLEEP, USUAL
from tests.physics.solids.setups import G, floor_world, run

FRAME = 1.0 / 60.0
AWAKE = USUAL.without(SLEEP)


def column(world, count, place=0.0):
    """Unit boxes on each other."""
    return [world.add_body(box(1.0, 1.0), (place, 0.5 + k)) for k in range(count)]


def springs(sinks, substeps):
    """J in the springs of a column of unit boxes that have sunk so far (m) each, at the usual frequency."""
    pull = (2.0 * math.pi * 0.135 * 60.0 * substeps) ** 2
    stiffness = [pull * 4.0 / 1.25, *[pull / 2.5] * (len(sinks) - 1)]
    return 0.5 * float(np.sum(np.multiply(stiffness, np.square(sinks))))


def test_springs_hold_no_more_than_their_law_and_no_less_than_the_load():
    world, _ = floor_world(effects=AWAKE)
    bodies = column(world, 10)
    start = world.energy().total
    run(world, 10.0)
    energy, heights = world.energy(), world.bodies.positions[bodies, 1]
    sinks = -np.diff(np.concatenate([[-0.5], heights]) - np.arange(-0.5, 10.0))
    assert energy.elastic <= springs(sinks, 4) * (1.0 + 1e-9)
    assert energy.elastic >= 0.9 * springs(sinks, 4)
    assert energy.total < start
    # half of the height that is lost by sinking under its own weight is in the springs
    assert energy.elastic == pytest.approx(0.5 * G * float((np.arange(10) + 0.5 - heights).sum()), rel=0.1)


def test_springs_lift_what_lay_under_a_load_that_is_taken_away():
    world, _ = floor_world(effects=AWAKE)
    bodies = column(world, 5)
    load = world.add_body(box(1.0, 1.0, material=Material(density=20.0)), (0.0, 5.5))
    run(world, 5.0)
    low = float(world.bodies.positions[bodies[-1], 1])
    world.remove_body(load)
    before = world.energy().total
    for _ in range(300):
        world.step(FRAME)
        now = world.energy().total
        assert now <= before + 1e-9 * abs(before)
        before = now
    alone, _ = floor_world(effects=AWAKE)
    others = column(alone, 5)
    run(alone, 5.0)
    assert world.bodies.positions[bodies[-1], 1] > low + 0.01
    assert world.bodies.positions[bodies[-1], 1] == pytest.approx(
        alone.bodies.positions[others[-1], 1], abs=1e-3
    )


def test_what_is_born_in_overlap_parts_though_that_lifts_it():
    world, _ = floor_world()
    low = world.add_body(box(1.0, 1.0), (0.0, 0.5))
    high = world.add_body(box(1.0, 1.0), (0.0, 1.1))
    run(world, 3.0)
    assert world.bodies.positions[high, 1] - world.bodies.positions[low, 1] == pytest.approx(1.0, abs=0.01)


def test_what_is_put_in_overlap_parts_though_that_lifts_it():
    world, _ = floor_world()
    low, high = column(world, 2)
    run(world, 2.0)
    world.set_pose(high, (0.0, 1.1), 0.0)
    run(world, 3.0)
    assert world.bodies.positions[high, 1] - world.bodies.positions[low, 1] == pytest.approx(1.0, abs=0.01)


def test_what_a_press_has_driven_into_each_other_parts_when_it_leaves():
    world, _ = floor_world(effects=AWAKE)
    low, high = column(world, 2)
    press = world.add_body(box(2.0, 1.0), (0.0, 2.5), kind="key-framed", velocity=(0.0, -0.5))
    run(world, 0.8)
    assert world.bodies.positions[high, 1] - world.bodies.positions[low, 1] < 0.9
    world.set_velocity(press, (0.0, 4.0))
    run(world, 3.0)
    assert world.bodies.positions[high, 1] - world.bodies.positions[low, 1] == pytest.approx(1.0, abs=0.01)


@pytest.mark.parametrize("restitution", [0.0, 1.0])
def test_a_swarm_without_gravity_keeps_momentum_and_gains_no_energy(restitution):
    rng = np.random.default_rng(7)
    material = Material(friction=0.7, restitution=restitution)
    world = SolidWorld(SolidSettings(gravity=(0.0, 0.0), effects=AWAKE))
    for k in range(30):
        place = np.array([1.3 * (k % 6), 1.3 * (k // 6)])
        speed = rng.uniform(-2.0, 2.0, 2) - 1.5 * (place - (3.2, 2.6))
        world.add_body(box(1.0, 0.7, material=material), place, rng.uniform(0, 6), speed, rng.uniform(-3, 3))

    def momenta():
        rows = world.bodies
        x, y = rows.positions.T
        vx, vy = rows.velocities.T
        mass, inertia = 1.0 / rows.inverse_masses, 1.0 / rows.inverse_inertias
        return [mass @ vx, mass @ vy, mass @ (x * vy - y * vx) + inertia @ rows.spins]

    start, first, before = momenta(), world.energy().total, world.energy().total
    for _ in range(240):
        world.step(FRAME)
        assert world.energy().total <= before + 1e-9 * first
        before = world.energy().total
    assert momenta()[:2] == pytest.approx(start[:2], abs=1e-10)
    # levers are those of the beginning of a step: angular momentum is kept to first order
    assert momenta()[2] == pytest.approx(start[2], rel=0.15)


def test_a_box_that_slides_over_bodies_keeps_its_speed():
    """What is held is lowered first: slowing it down would brake what slides without friction."""
    smooth = Material(friction=0.0)
    world, _ = floor_world(smooth, effects=AWAKE)
    for k in range(12):
        world.add_body(box(1.0, 0.5, material=smooth), (1.0 * k, 0.25), kind="fixed")
    body = world.add_body(box(1.0, 1.0, material=smooth), (0.0, 1.0), velocity=(5.0, 0.0))
    run(world, 1.9)
    assert world.bodies.velocities[body, 0] == pytest.approx(5.0, rel=1e-5)


def test_the_energy_of_a_hit_sleeper_is_counted():
    """What is woken in a step is moved in it, though gravity did not move it."""
    world, _ = floor_world()
    column(world, 3)
    run(world, 3.0)
    world.add_body(box(0.4, 0.4, material=Material(density=5.0)), (-3.0, 1.2), 0.3, velocity=(14.0, 0.0))
    first = before = world.energy().total
    for _ in range(150):
        world.step(FRAME)
        now = world.energy().total
        assert now <= before + 1e-9 * first
        before = now
