"""What the energy of a scene may rise by in a step, what it may not, and what holding it leaves as it is."""

from __future__ import annotations

import math
from typing import NamedTuple

import numba
import numpy as np
import pytest

from game.physics.solids import Disc, Material, SolidSettings, SolidWorld, box
from game.physics.solids.arrays.state import ASLEEP, DX, VX, VY, WORKS_WIDTH, W
from game.physics.solids.effects import SLEEP, USUAL
from game.physics.solids.solvers.governor import (
    FORCE,
    GAIN,
    HEIGHT,
    HELD,
    LIFT,
    MOTION,
    STORED,
    along,
    give_back,
    group_by_contact,
    sum_groups,
    what_to_take_back,
)
from game.physics.solids.solvers.passive import EXCUSED
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


def test_a_spring_against_the_ground_holds_half_of_what_sinking_has_paid():
    world, _ = floor_world(effects=AWAKE)
    (body,) = column(world, 1)
    run(world, 5.0)
    sink = 0.5 - float(world.bodies.positions[body, 1])
    assert sink == pytest.approx(G * 1.25 / (4.0 * (2.0 * math.pi * 0.135 * 240.0) ** 2), rel=1e-3)
    assert world.energy().elastic == pytest.approx(0.5 * G * sink, rel=1e-3)


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
    """What is woken in a step by a ball from below is lifted in it, though gravity did not move it."""
    springy = Material(restitution=1.0, friction=0.0)
    world, _ = floor_world(springy)
    for place in (-1.5, 1.5):
        world.add_body(box(0.5, 2.0, material=springy), (place, 1.0), kind="fixed")
    sleeper = world.add_body(box(3.5, 0.2, material=springy), (0.0, 2.1))
    run(world, 2.0)
    assert world.bodies.flags[sleeper] & ASLEEP
    world.add_body(Disc(0.2, material=springy), (0.0, 0.5), velocity=(0.0, 9.0))
    first = before = world.energy().total
    for _ in range(30):
        world.step(FRAME)
        now = world.energy().total
        assert now <= before + 1e-9 * first
        before = now
    assert world.bodies.positions[sleeper, 1] > 2.15


def test_springs_are_empty_under_another_solver():
    world, _ = floor_world(effects=AWAKE)
    column(world, 4)
    run(world, 1.0)
    assert world.energy().elastic > 0.0
    world.set(solver="sequential-impulses")
    assert world.energy().elastic == 0.0


@pytest.mark.parametrize("torque", [-3.0, 3.0])
def test_a_torque_is_a_source(torque):
    """A wheel that is driven rolls off as it must; what the torque does is no gain of the contact's."""
    world, _ = floor_world(Material(friction=1.0), effects=AWAKE, substeps=12)
    wheel = world.add_body(Disc(0.5, material=Material(friction=1.0)), (0.0, 0.5))
    run(world, 0.5)
    for _ in range(60):
        world.add_force(wheel, (0.0, 0.0), torque)
        world.step(FRAME)
    mass, inertia = 1.0 / world.bodies.inverse_masses[wheel], 1.0 / world.bodies.inverse_inertias[wheel]
    assert world.bodies.velocities[wheel, 0] == pytest.approx(
        -torque / (mass * 0.5 + inertia / 0.5), rel=1e-3
    )
    assert world.bodies.spins[wheel] == pytest.approx(-world.bodies.velocities[wheel, 0] / 0.5, rel=1e-3)


def taken_back(gain, lift=0.0, height=0.0, force=0.0, motion=0.0, most=0.0):
    """`what_to_take_back` of a group, and what is left of its gain when all of that is done, J."""
    works = np.zeros((1, WORKS_WIDTH))
    works[0, [GAIN, LIFT, HEIGHT, FORCE, MOTION]] = gain, lift, height, force, motion
    back, down, keep, stay = _taken_back(works, most)
    left = gain - back * lift - down * force - motion * (1.0 - keep * keep)
    return (back, down, keep, stay), left - (1.0 - stay) * (height - back * lift - down * force)


@numba.njit
def _taken_back(works, most):
    return what_to_take_back(works, 0, most)


@pytest.mark.parametrize(
    ("group", "expected"),
    [
        ({"gain": 1.0, "lift": 4.0, "height": 4.0, "motion": 9.0}, (0.25, 0.0, 1.0, 1.0)),
        ({"gain": 3.0, "lift": 1.0, "height": 1.0, "motion": 4.0}, (1.0, 0.0, math.sqrt(0.5), 1.0)),
        ({"gain": 1.0, "height": 5.0, "force": 10.0, "most": 1.0, "motion": 4.0}, (0.0, 0.1, 1.0, 1.0)),
        ({"gain": 1.0, "height": 0.2, "force": 10.0, "most": 1.0, "motion": 0.8}, (0.0, 0.02, 0.0, 1.0)),
        ({"gain": 1.0, "height": 5.0, "force": 10.0, "most": 0.05, "motion": 2.0}, (0, 0.05, 0.75**0.5, 1)),
        ({"gain": 5.0, "lift": 1.0, "height": 5.0, "motion": 2.0}, (1.0, 0.0, 0.0, 0.5)),
        ({"gain": 1.0, "lift": -1.0, "motion": 2.0}, (0.0, 0.0, math.sqrt(0.5), 1.0)),
    ],
)  # fmt: skip
def test_as_much_is_taken_back_as_was_gained_and_no_more(group, expected):
    """Lifting first, then a little height, then motion, then ways."""
    found, left = taken_back(**group)
    assert found == pytest.approx(expected, abs=1e-15)
    assert left == pytest.approx(0.0, abs=1e-15)


class Stores(NamedTuple):
    """What `give_back` reads and writes of bodies."""

    stored: np.ndarray


class Groups(NamedTuple):
    """And of scratch memory."""

    works: np.ndarray
    parents: np.ndarray
    excused: np.ndarray


@numba.njit
def _give_back(bodies, scratch):
    give_back(bodies, scratch)


def test_springs_pay_for_lifting_only_and_of_their_own_group():
    """Groups of bodies 0 and 1, of 2, of 3 (which has a source)."""
    bodies = Stores(np.array([3.0, 1.0, 5.0, 7.0]))
    works = np.zeros((4, WORKS_WIDTH))
    works[0, [GAIN, LIFT, HEIGHT, STORED]] = 2.0, 1.5, 1.0, 4.0
    works[2, [GAIN, LIFT, HEIGHT, STORED]] = 0.5, 0.0, 3.0, 5.0
    works[3, [GAIN, LIFT, HEIGHT, STORED]] = 2.0, 2.0, 2.0, 7.0
    scratch = Groups(works, np.array([0, 0, 2, 3]), np.array([0, 0, 0, EXCUSED << 2]))
    _give_back(bodies, scratch)
    assert bodies.stored.tolist() == [2.25, 0.75, 4.5, 7.0]
    assert works[0, [GAIN, LIFT, HEIGHT]].tolist() == [1.0, 0.5, 0.0]
    assert works[2, [GAIN, HEIGHT]].tolist() == [0.0, 2.5]
    assert works[3, [GAIN, LIFT, HEIGHT]].tolist() == [2.0, 2.0, 2.0]


@numba.njit
def _grouped(bodies, contacts, scratch, h):
    group_by_contact(bodies, contacts, scratch)
    sum_groups(bodies, scratch, h)


@numba.njit
def _along(bodies, drifts, group, body):
    return along(bodies, drifts, group, body)


def test_groups_are_told_from_each_other_and_move_as_one_body_if_nothing_holds_them():
    """Two that lie on each other on the ground, two that touch in the air, one alone; all of them turn."""
    world, _ = floor_world(effects=AWAKE)
    ground = column(world, 2)
    air = [world.add_body(box(1.0, 1.0), (6.0 + 0.99 * k, 9.9 + 0.1 * k)) for k in (0, 1)]
    lone = world.add_body(box(1.0, 1.0), (12.0, 9.0))
    world.step(FRAME)
    rows, scratch = world.bodies, world._scratch
    spin, drift = 0.7, np.array([3.0, -2.0])
    for body in (*ground, *air, lone):
        x, y = rows.positions[body]
        scratch.motion[body, [VX, VY, W]] = drift[0] - spin * y, drift[1] + spin * x, spin
    _grouped(rows, world._contacts, scratch, FRAME / 4)
    parents, drifts, works = scratch.parents, scratch.drifts, scratch.works
    assert parents[ground].tolist() == [ground[0]] * 2
    assert parents[air].tolist() == [air[0]] * 2
    assert parents[lone] == lone
    assert drifts[[ground[0], air[0], lone], HELD].tolist() == [1.0, 0.0, 0.0]
    for body in (*air, lone):
        assert _along(rows, drifts, parents[body], body) == pytest.approx(scratch.motion[body, [VX, VY, W]])
    assert works[[air[0], lone], MOTION] == pytest.approx(0.0, abs=1e-12)
    assert _along(rows, drifts, ground[0], ground[1]) == (0.0, 0.0, 0.0)
    speeds = scratch.motion[ground][:, [VX, VY]]
    assert works[ground[0], MOTION] == pytest.approx(0.5 * (speeds**2).sum() + spin**2 / 6.0)
    weight = 2.0 * G
    assert works[[ground[0], air[0], lone], FORCE] == pytest.approx([weight, weight, 0.5 * weight])


def test_what_is_stopped_on_its_way_was_not_pushed():
    world = SolidWorld(SolidSettings(gravity=(0.0, 0.0)))
    world.add_body(box(0.05, 10.0), (0.0, 0.0), kind="fixed")
    ball = world.add_body(Disc(0.05), (-3.0, 0.0), velocity=(50.0, 0.0))
    for _ in range(4):
        world.step(FRAME)
        if world.bodies.late[ball] > 0.0:
            break
    assert 0.0 < world.bodies.late[ball] < FRAME
    going, motion = world._scratch.going[ball], world._scratch.motion[ball]
    assert motion[DX] == pytest.approx(FRAME / 4 * going[0], rel=1e-12)
    assert motion[DX] < 50.0 * FRAME
