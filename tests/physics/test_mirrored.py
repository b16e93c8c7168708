"""Rule of everything that has a sign: the mirrored twin of a run does the mirror image.

To the bit, or to rounding where the twin has other numbers: principal axes, outlines that go the other way
round, angles.

Mirrored at the plane x = 0: vectors change the sign of x; angular momenta and turns, which are axial, that of
y and z.
"""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.animation.ik.inverse_kinematics import solve_ik
from game.physics.animation.ik.solver import METHODS as WAYS
from game.physics.animation.skeleton import Skeleton
from game.physics.constraints import LINKED, MODELS, SCHEMES, PositionBasedDynamics, shapes
from game.physics.fields import ATTRACTOR, DRAG, GRAVITY, GROUND, QUADRATIC_DRAG, WHIRL, WIND
from game.physics.particles import METHODS as FLIGHTS
from game.physics.particles import OBSTACLES, Discs, Forces, ParticleSystem
from game.physics.rigid import METHODS, RigidBody
from game.physics.rigid.effects import BODIES
from game.physics.spheres.collisions import CollidingSpheres
from game.physics.spheres.effects import IMPACT_TIMES, SPHERES
from game.physics.spheres.settings import LAWS, material_tables, surroundings_of
from game.physics.spheres.settings import SCHEMES as MOTIONS
from game.physics.spheres.spheres import SphereBodies

POLAR, AXIAL = np.array((-1.0, 1.0, 1.0)), np.array((1.0, -1.0, -1.0))
TURN = np.array((1.0, 1.0, -1.0, -1.0))  # of a quaternion, scalar first
both = (1.0, -1.0)


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("scheme", MOTIONS)
@pytest.mark.parametrize("path", ["general", "planar"])
def test_colliding_spheres(law, scheme, path):
    """With everything on: a wall, a slanting ledge, friction, spin, a string, a push.

    One wall, as those at the left come before those at the right: another order, in which touches are solved.
    """
    states = []
    for side in both:
        random = np.random.default_rng(8)
        places = np.array([(-1.45 + i % 4, 0.5 + i // 4) for i in range(12)])
        places += random.uniform(-0.05, 0.05, (12, 2))
        speeds, spins = random.normal(0.0, 2.0, (12, 2)), random.normal(0.0, 3.0, 12)
        mirror = np.array((side, 1.0))
        bodies = SphereBodies(
            places * mirror, np.full(12, 0.45), speeds * mirror, [(0.0, 0.0, side * w) for w in spins],
            inertias="solid",
        )  # fmt: skip
        room = surroundings_of(
            (-2, 0, 50, 9) if side > 0 else (-50, 0, 2, 9), [(-1.0 * side, 3.2, 1.3 * side, 3.6)],
            *(() if path == "planar" else ([11], [(places[11, 0] * side, 4.0, 0.0, 1.5)])),
        )  # fmt: skip
        world = CollidingSpheres(
            bodies, room, material_tables(0.6, 0.4), effects=SPHERES.known.without(IMPACT_TIMES),
            path=path, law=law, scheme=scheme, drag=0.2,
        )  # fmt: skip
        for _ in range(40):
            world.apply_force(2, (3.0 * side, 1.0, 0.0), (*(bodies.state.positions[2, :2] + (0, 0.1)), 0.0))
            world.step(1.0 / 60.0)
        assert world.planar() == (path == "planar" and law == "in-turn")
        assert world.collisions > 5
        states.append(bodies.state)
    plain, mirrored = states
    assert np.array_equal(plain.positions * POLAR, mirrored.positions)
    assert np.array_equal(plain.momenta * POLAR, mirrored.momenta)
    assert np.array_equal(plain.spins * AXIAL, mirrored.spins)
    assert np.array_equal(plain.orientations * TURN, mirrored.orientations)


@pytest.mark.parametrize("method", METHODS)
def test_a_rigid_body(method):
    """In space, under a force off its centre and between walls."""
    bodies = []
    for side in both:
        polar = np.array((side, 1.0, 1.0))
        body = RigidBody.from_spheres(
            np.array([(-1.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 0.4, 0.1)]) * polar, [0.5, 0.25, 0.3], 1.0,
            velocity=polar * (1.0, 2.0, -0.5), angular_velocity=(0.3, side, 2.0 * side), method=method,
            effects=BODIES.known, gravity=9.81, damping=0.4, restitution=0.8, lower=(-2, -2, -2),
            upper=(2, 2, 2),
        )  # fmt: skip
        for _ in range(80):
            body.apply_force(polar * (0.1, 0.2, 0.3), body.position + polar * (0.2, 0.0, 0.1))
            body.step(0.01)
        assert body.bounces > 0
        bodies.append(body)
    plain, mirrored = bodies
    assert np.allclose(plain.position * POLAR, mirrored.position, rtol=0, atol=1e-11)
    assert np.allclose(plain.velocity * POLAR, mirrored.velocity, rtol=0, atol=1e-10)
    assert np.allclose(plain.angular_velocity * AXIAL, mirrored.angular_velocity, rtol=0, atol=1e-10)
    assert np.allclose(plain.spheres() * POLAR, mirrored.spheres(), rtol=0, atol=1e-11)


@pytest.mark.parametrize("method", FLIGHTS)
@pytest.mark.parametrize("contact", ["chord", "root"])
def test_particles(method, contact):
    """Wind and the whirl's turn have signs of their own."""
    runs = []
    for side in both:
        random = np.random.default_rng(3)
        mirror = np.array((side, 1.0))
        law = Forces(
            9.81, 0.7, 0.05, 2.0 * side, -0.5, 1.0 * side, 1.5, 1.3 * side, 0.4, 0.5 * side, 0.2, 3.0
        )
        system = ParticleSystem(
            60, solids=Discs([(0.3 * side, -1.0), (-1.0 * side, 1.0)], [0.45, 0.6]), method=method,
            floor=-3.0, contact=contact, forces=law, life=1e9, substeps=2,
            effects=GRAVITY | DRAG | QUADRATIC_DRAG | WIND | WHIRL | ATTRACTOR | GROUND | OBSTACLES,
        )  # fmt: skip
        system.add(random.uniform(-3, 3, (60, 2)) * mirror, random.uniform(-5, 5, (60, 2)) * mirror)
        for _ in range(40):
            system.step(0.02)
        runs.append((system.positions * mirror, system.velocities * mirror))
    for plain, mirrored in zip(*runs, strict=True):
        assert np.array_equal(plain, mirrored)


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("scheme", SCHEMES)
def test_linked_particles(model, scheme):
    """A jelly that lands, is torn and pulled at; its outline is mirrored the other way round."""
    runs = []
    for side in both:
        mirror = np.array((side, 1.0))
        ring = shapes.ring((0.3, 0.0), 0.5, 9)
        system = PositionBasedDynamics(
            ring.positions * mirror, 1.0, ring.links, 0.8, areas=[list(range(9))[:: 1 if side > 0 else -1]],
            area_stiffness=0.5, compliances=1e-4, area_compliance=1e-3, contacts=[(0, 4)], distances=0.8,
            velocities=np.tile((1.5 * side, -0.5), (9, 1)), model=model, scheme=scheme, iterations=4,
            floor=-0.7, damping=0.1, stretch_limit=0.3, effects=LINKED.known,
        )  # fmt: skip
        system.grab(2)
        for step in range(40):
            system.drag(((0.3 + 0.02 * step) * side, 0.6))
            system.step(1.0 / 60.0)
        runs.append((system.positions * mirror, system.velocities * mirror))
    for plain, mirrored in zip(*runs, strict=True):
        assert np.allclose(plain, mirrored, rtol=0, atol=1e-11)


@pytest.mark.parametrize("method", WAYS)
@pytest.mark.parametrize("target", [(0.9, 1.3), (-0.5, 0.4), (4.0, 1.0)])
def test_inverse_kinematics(method, target):
    """Limits are not alike on both sides, and mirrored with the rest."""
    angles = []
    for side in both:
        limits = np.sort(np.array([(-0.4, 2.0), (-1.0, 0.9), (-0.3, 1.1)]) * side, axis=1)
        skeleton = Skeleton(
            [-1, 0, 1],
            [1.0, 0.8, 0.6],
            np.array((0.3, 0.4, 0.5)) * side,
            lower=limits[:, 0],
            upper=limits[:, 1],
        )
        solve_ik(skeleton, (0, 2), (target[0], target[1] * side), method, 1e-9, 40, limited=True)
        angles.append(skeleton.angles * side)
    assert np.allclose(*angles, rtol=0, atol=1e-12)
