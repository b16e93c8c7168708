"""Small worlds for a step or two, against what mechanics says: seconds also without the compiler."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest

from game.physics.solids import SOLVERS, Chain, Disc, Material, SolidSettings, SolidWorld, box
from game.physics.solids.arrays.plan import plan_joints
from game.physics.solids.arrays.state import ASLEEP, DYNAMIC, FIRST_POINT, NORMAL_IMPULSE, POINT_WIDTH
from game.physics.solids.effects import CONTACTS
from game.physics.solids.settings import soft
from tests.physics.solids.setups import G

DT = 1.0 / 60.0
SMOOTH = Material(friction=0.0)


def world_of(**settings):
    """A world without gravity, in one substep of one sweep unless ``settings`` say otherwise."""
    return SolidWorld(SolidSettings(**{"gravity": (0.0, 0.0), "substeps": 1, "iterations": 1, **settings}))


def momenta(world):
    """Momentum (x, y) and angular momentum about the origin, of all dynamic bodies."""
    rows = world.bodies
    moving = rows.inverse_masses > 0.0
    p = rows.velocities[moving] / rows.inverse_masses[moving, None]
    (x, y), spin = rows.positions[moving].T, rows.spins[moving] / rows.inverse_inertias[moving]
    return np.array([*p.sum(axis=0), (x * p[:, 1] - y * p[:, 0] + spin).sum()])


@pytest.mark.parametrize("name", SOLVERS)
def test_what_touches_nothing_falls_and_spins(name):
    world = world_of(solver=name, gravity=(0.5, -G), substeps=2)
    body = world.add_body(box(1.0, 0.5), (1.0, 2.0), velocity=(3.0, 4.0), spin=0.25)
    for _ in range(3):
        world.step(DT)
    n, h = 6, 0.5 * DT
    assert world.bodies.velocities[body] == pytest.approx((3.0 + 0.5 * n * h, 4.0 - G * n * h), rel=1e-9)
    fallen = 0.5 * n * (n + 1) * h * h  # semi-implicit Euler
    assert world.bodies.positions[body] == pytest.approx(
        (1.0 + 3.0 * n * h + 0.5 * fallen, 2.0 + 4.0 * n * h - G * fallen), rel=1e-9
    )
    assert world.bodies.spins[body] == pytest.approx(0.25, rel=1e-6)
    assert world.bodies.angles[body] == pytest.approx(0.25 * n * h, rel=1e-6)


@pytest.mark.parametrize("name", ["soft-step", "shock-propagation", "complementarity"])
def test_a_rubbing_impact_of_two_boxes_keeps_all_momenta(name):
    """Faces that just touch meet askew, with friction at both ends of the face: impulses act in pairs."""
    world = world_of(solver=name, iterations=3)
    world.add_body(box(2.0, 1.0), (0.0, 0.0), velocity=(1.5, 0.5), spin=0.3)
    world.add_body(
        box(1.0, 1.0, material=Material(density=3.0)), (0.3, 1.0), velocity=(-1.0, -1.0), spin=-0.4
    )
    before, spins = momenta(world), world.bodies.spins.copy()
    places = world.bodies.positions.copy()
    world.step(DT)
    assert np.abs(world.bodies.spins[:2] - spins[:2]).min() > 0.05
    world.bodies.positions[:] = places  # where the impulses acted
    assert momenta(world) == pytest.approx(before, abs=1e-9)


@pytest.mark.parametrize("sweeps", [1, 4])
def test_a_smooth_box_that_lands_askew_comes_to_rest_at_both_corners(sweeps):
    """Both corners are solved at once, so further sweeps change nothing."""
    world = world_of(solver="sequential-impulses", iterations=sweeps, slop=0.0)
    world.add_body(box(20.0, 1.0, material=SMOOTH), (0.0, -0.5), kind="fixed")
    body = world.add_body(box(1.0, 1.0, material=SMOOTH), (0.0, 0.5), velocity=(0.2, -1.0), spin=0.5)
    world.step(DT)
    assert world.bodies.velocities[body] == pytest.approx((0.2, 0.0), abs=1e-9)
    assert world.bodies.spins[body] == pytest.approx(0.0, abs=1e-9)


def test_both_corners_of_a_smooth_box_that_lands_askew_bounce():
    """Newton's law at each end of the face, if both still press."""
    e, spin = 0.5, 0.5
    bouncy = Material(friction=0.0, restitution=e)
    world = world_of(solver="sequential-impulses", slop=0.0, bounce=0.1, iterations=3)
    world.add_body(box(20.0, 1.0, material=bouncy), (0.0, -0.5), kind="fixed")
    body = world.add_body(box(1.0, 1.0, material=bouncy), (0.0, 0.5), velocity=(0.2, -1.0), spin=spin)
    world.step(DT)
    assert world.bodies.velocities[body] == pytest.approx((0.2, e), abs=1e-9)
    assert world.bodies.spins[body] == pytest.approx(-e * spin, abs=1e-9)


@pytest.mark.parametrize("spin", [0.5, -0.5])
def test_only_the_corner_that_comes_fast_enough_bounces(spin):
    """One comes at 1.25 m/s, the other at 0.75, 1 m/s must it be: that one only stops."""
    e, fast = 0.5, 1.25
    bouncy = Material(friction=0.0, restitution=e)
    world = world_of(solver="sequential-impulses", slop=0.0, bounce=1.0, iterations=3)
    world.add_body(box(20.0, 1.0, material=bouncy), (0.0, -0.5), kind="fixed")
    body = world.add_body(box(1.0, 1.0, material=bouncy), (0.0, 0.5), velocity=(0.2, -1.0), spin=spin)
    disc = world.add_body(Disc(0.25, material=bouncy), (3.0, 0.25), velocity=(0.0, -1.5))
    world.step(DT)
    assert world.bodies.velocities[body] == pytest.approx((0.2, 0.5 * e * fast), abs=1e-9)
    assert world.bodies.spins[body] == pytest.approx(-math.copysign(e * fast, spin), abs=1e-9)
    assert world.bodies.velocities[disc] == pytest.approx((0.0, e * 1.5), abs=1e-9)


@pytest.mark.parametrize(("kind", "order"), [("fixed", 1), ("fixed", -1), ("dynamic", 1)])
def test_overlap_parts_by_the_spring_of_its_kind(kind, order):
    """A damped spring solved implicitly; against what nothing moves it is twice as stiff in frequency."""
    world = world_of(contact_hertz=5.0, contact_damping=2.0, push=10.0)
    deep = 0.02
    bodies = [(kind, (0.0, 0.0)), ("dynamic", (0.0, 1.0 - deep))][::order]
    for each, place in bodies:
        world.add_body(Disc(0.5, material=SMOOTH), place, kind=each)
    world.step(DT)
    rate, mass, _ = soft(10.0 if kind == "fixed" else 5.0, 2.0, DT)
    gap = float(np.hypot(*(world.bodies.positions[1] - world.bodies.positions[0]))) - 1.0
    assert gap == pytest.approx(-deep + DT * rate * mass * deep, rel=1e-9)


@pytest.mark.parametrize("slope", [0.0, 0.6, 1.0])
def test_a_disc_meets_a_slanted_chain_along_its_normal(slope):
    n = np.array([-slope, 1.0]) / math.hypot(slope, 1.0)
    world = world_of()
    world.add_body(
        Chain(((-3.0, -3.0 * slope), (3.0, 3.0 * slope)), material=SMOOTH), (0.0, 0.0), kind="fixed"
    )
    start = 0.5 * n - 1.5 * np.array([1.0, slope])
    body = world.add_body(Disc(0.5, material=SMOOTH), start, velocity=(1.0, -2.0))
    world.step(DT)
    v = np.array([1.0, -2.0])
    assert world.bodies.velocities[body] == pytest.approx(v - (v @ n) * n, abs=1e-9)


def test_the_weight_of_a_box_is_the_impulse_under_it():
    world = world_of(solver="complementarity", gravity=(0.0, -G), substeps=2)
    world.add_body(box(20.0, 1.0), (0.0, -0.5), kind="fixed")
    body = world.add_body(box(1.0, 1.0), (0.0, 0.5))
    world.step(DT)
    manifold = world.contacts.manifolds[0]
    impulse = sum(manifold[FIRST_POINT + k * POINT_WIDTH + NORMAL_IMPULSE] for k in range(2))
    assert impulse * world.bodies.inverse_masses[body] == pytest.approx(0.5 * DT * G, rel=1e-6)


def test_the_broad_phase_finds_no_pair_of_boxes_that_lie_apart():
    """Discs on a grid finer than their cells: only neighbours can be near, along either axis."""
    world = world_of(effects=CONTACTS, near=1e-3)
    places = [(0.25 * i, 0.25 * k) for i in range(6) for k in range(6)]
    for place in places:
        world.add_body(Disc(0.1), place)
    large = world.add_body(Disc(0.3), (0.6, 0.6))
    world.step(1e-6)
    radii = np.append(np.full(len(places), 0.1), 0.3)
    at = np.array([*places, (0.6, 0.6)])
    for a, b in world.contacts.bodies[: world.contacts.count[0]].tolist():
        assert large in (a, b)
        assert np.abs(at[a] - at[b]).max() < radii[a] + radii[b] + 0.1


def test_a_disc_that_lies_alone_falls_asleep_while_another_moves():
    world = world_of(patience=0.04)
    bodies = [world.add_body(Disc(0.5), (3.0 * k, 0.0), velocity=(0.0, float(k == 1))) for k in range(3)]
    for _ in range(5):
        world.step(DT)
    assert (world.bodies.flags[bodies] & ASLEEP != 0).tolist() == [True, False, True]


def test_two_that_parted_are_no_island_any_more():
    world = world_of(patience=0.04, bounce=0.0)
    here = world.add_body(Disc(0.5, material=SMOOTH), (0.0, 0.0))
    there = world.add_body(Disc(0.5, material=SMOOTH), (0.999, 0.0))
    world.step(DT)
    world.set_velocity(here, (0.0, 0.0))
    world.set_pose(there, (2.0, 0.0), 0.0)
    world.set_velocity(there, (1.0, 0.0))
    for _ in range(6):
        world.step(DT)
    assert (world.bodies.flags[[here, there]] & ASLEEP != 0).tolist() == [True, False]


def test_what_a_broken_joint_held_can_touch():
    """Two discs that overlap shun each other while a pin holds them; when it has broken they part."""
    world = world_of()
    discs = [world.add_body(Disc(0.5), (0.8 * k, 0.0)) for k in range(2)]
    world.add_joint("pin", *discs, (0.4, 0.0), break_force=1.0)
    world.step(DT)
    assert world.contacts.count[0] == 0
    world.add_force(discs[1], (0.0, 1e4))
    world.step(DT)
    assert len(world.joints_broken()) == 1
    world.step(DT)
    assert world.contacts.count[0] == 1


def test_the_plan_holds_every_joint_that_holds_and_no_other():
    world = world_of()
    bodies = [world.add_body(Disc(0.1), (float(k), 0.0)) for k in range(7)]
    pairs = list(pairwise(bodies))
    joints = [world.add_joint("pin", a, b, (a + 0.5, 0.0)) for a, b in pairs]
    mouse = world.add_joint("mouse", bodies[0], bodies[3], (3.0, 0.0), hertz=2.0, most=10.0)
    world.remove_joint(joints[2])
    plan = plan_joints(world.joints, world.bodies.flags & DYNAMIC != 0)
    assert sorted(plan.order.tolist()) == sorted(set(joints) - {joints[2], mouse})
    # a chain is a tree: each joint but the last of each part has one block below its own
    assert sorted(np.diff(plan.starts).tolist()) == [0, 0, 1, 1, 1]
