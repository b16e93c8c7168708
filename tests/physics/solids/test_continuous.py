"""What is fast and thin does not pass through what is thin; nothing gains energy by being stopped."""

from __future__ import annotations

from typing import NamedTuple

import numba
import numpy as np
import pytest

from game.physics.solids import Capsule, Chain, Disc, SolidSettings, SolidWorld, box
from game.physics.solids.arrays.state import DA, DX, DY, MOTION_WIDTH, VX, VY, W
from game.physics.solids.sweep import THIN, all_slow, cut_motion
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


class Sizes(NamedTuple):
    """What `all_slow` reads of bodies."""

    reaches: np.ndarray
    cores: np.ndarray


@numba.njit
def _all_slow(bodies, motion):
    return all_slow(bodies, motion)


def test_where_all_are_slow_no_two_approach_as_far_as_they_are_thick():
    random, seen = np.random.default_rng(5), set()
    for turn in range(3000):
        bodies = Sizes(random.uniform(0.5, 2.0, 4), random.uniform(0.1, 1.0, 4))
        motion = np.zeros((4, MOTION_WIDTH))
        columns = ([DX], [DY], [DA], [DX, DY, DA])[turn % 4]
        motion[:, columns] = random.normal(size=(4, len(columns)))
        gone = np.abs(motion[:, DX]) + np.abs(motion[:, DY]) + np.abs(motion[:, DA]) * bodies.reaches
        motion *= (random.uniform(0.7, 1.3, 4) * THIN * bodies.cores / gone)[:, None]
        motion[random.integers(4)] = 0.0
        turned = np.abs(motion[:, DA]) * bodies.reaches
        ways = motion[:, None, [DX, DY]] - motion[None, :, [DX, DY]]
        approach = np.abs(ways).sum(axis=2) + turned[:, None] + turned[None, :]
        fast = approach > THIN * (bodies.cores[:, None] + bodies.cores[None, :])
        slow = _all_slow(bodies, motion)
        assert not (slow and fast[~np.eye(4, dtype=bool)].any())
        part = (np.abs(motion[:, [DX, DY]]).sum(axis=1) + turned) / (THIN * bodies.cores)
        assert slow or part.max() > 0.99
        seen.add(slow)
    assert seen == {False, True}


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


@pytest.mark.parametrize("room", [0, 1, 3, 4, 5])
def test_contacts_that_begin_are_counted_and_written_down_while_there_is_room(room):
    """Four discs meet the wall in one step; what lies behind the room is nobody's to write to."""
    world = wall_world()
    for k in range(4):
        world.add_body(Disc(0.1), (-0.6, 2.0 * k), velocity=(20.0, 0.0))
    for _ in range(2):
        world.step(1.0 / 60.0)
        assert len(world.contacts_begun()[0]) == 0
    shapes, places = np.full((8, 2), -7, np.int32), np.full((8, 5), -7.0)
    world._scratch = world._scratch._replace(begun=shapes[:room], begun_places=places[:room])
    world.step(1.0 / 60.0)
    assert len(world.contacts_begun()[0]) == min(room, 4)
    written = min(room, 4)
    assert (shapes[:written] >= 0).all() and (places[:written, 3] > 19.0).all()
    assert (shapes[written:] == -7).all() and (places[written:] == -7.0).all()


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


class Stopped(NamedTuple):
    """What `cut_motion` reads and writes of bodies."""

    inverse_masses: np.ndarray
    inverse_inertias: np.ndarray
    late: np.ndarray


class Ways(NamedTuple):
    """And of scratch memory."""

    motion: np.ndarray
    accelerations: np.ndarray
    going: np.ndarray


@numba.njit
def _cut(bodies, scratch, fractions, dt):
    return cut_motion(bodies, scratch, fractions, dt)


def energy_of_ways(bodies, scratch):
    """J of each body, of motion and, from where the step began, in the field of its accelerations."""
    mass, inertia = 1.0 / bodies.inverse_masses, 1.0 / bodies.inverse_inertias
    vx, vy, w = scratch.motion[:, [VX, VY, W]].T
    work = mass * (scratch.accelerations[:, :2] * scratch.motion[:, [DX, DY]]).sum(axis=1)
    work += inertia * scratch.accelerations[:, 2] * scratch.motion[:, DA]
    return 0.5 * (mass * (vx**2 + vy**2) + inertia * w**2) - work


@pytest.mark.parametrize("rising", [False, True])
def test_a_body_that_is_stopped_has_no_more_energy_than_at_the_end_of_the_step(rising):
    """One that falls slows down by the rest of the step; one that has bounced in it would gain by that."""
    dt, t = 1.0 / 60.0, 0.4
    bodies = Stopped(np.array([0.5]), np.array([0.2]), np.zeros(1))
    scratch = Ways(np.zeros((1, MOTION_WIDTH)), np.array([[1.0, -9.81, 0.5]]), np.full((1, 3), 7.0))
    way = -0.195
    scratch.motion[0, [VX, VY, W, DX, DY, DA]] = 0.7, 6.0 if rising else -12.0, 0.3, 0.01, way, 0.02
    before = scratch.motion.copy()
    end = float(energy_of_ways(bodies, scratch)[0])
    assert _cut(bodies, scratch, np.array([t]), dt) == 1
    assert bodies.late[0] == pytest.approx((1.0 - t) * dt)
    assert scratch.motion[0, [DX, DY, DA]] == pytest.approx(t * before[0, [DX, DY, DA]])
    assert scratch.going[0] == pytest.approx(7.0 * t)
    after = float(energy_of_ways(bodies, scratch)[0])
    velocity = scratch.motion[0, [VX, VY, W]]
    if rising:
        assert after == pytest.approx(end)
        straight = before[0, [VX, VY, W]] - (1.0 - t) * dt * scratch.accelerations[0]
        assert velocity / straight == pytest.approx(np.full(3, velocity[1] / straight[1]))
    else:
        assert velocity == pytest.approx(before[0, [VX, VY, W]] - (1.0 - t) * dt * scratch.accelerations[0])
        assert after <= end + 1e-12
