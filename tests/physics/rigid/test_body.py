"""One body: what follows from its state, forces at points, density, and what it refuses."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.physics.constraints import LINKS
from game.physics.rigid import (
    METHODS,
    PUSHES,
    ROTATION,
    RigidBody,
    mass_properties,
    quaternion_from_axis_angle,
    quaternion_to_matrix,
)

DUMBBELL = ([(-1.0, 0.0, 0.0), (1.0, 0.0, 0.0)], [0.5, 0.25])
vectors = st.tuples(*[st.floats(-5.0, 5.0)] * 3)


def dumbbell(**more):
    return RigidBody.from_spheres(*DUMBBELL, 100.0, **more)


def test_spheres_make_a_body():
    """C12.1, .4: mass, centre, tensor; the spheres stand where they were given."""
    body = dumbbell()
    mass, center, inertia = mass_properties(*DUMBBELL, 100.0)
    assert body.mass == pytest.approx(mass, rel=1e-15)
    assert np.array_equal(body.position, center)
    assert np.allclose(body.inertia, inertia, rtol=0, atol=1e-13 * inertia.max())
    assert np.allclose(body.inertia @ body.inverse_inertia, np.eye(3), rtol=0, atol=1e-14)
    assert np.allclose(body.spheres(), DUMBBELL[0], rtol=0, atol=1e-15)
    body.check()


@given(w=vectors, axis=vectors.filter(lambda v: sum(x * x for x in v) > 0.1), angle=st.floats(-3, 3))
def test_velocity_spin_and_accelerations_follow(w, axis, angle):
    """C12.2: v = P/m, w = J⁻¹ L, J = R I Rᵀ, a = f/m, α = J⁻¹ (t - w x L), against numpy."""
    turn = quaternion_from_axis_angle(axis, angle)
    body = RigidBody(2.0, np.diag((2.0, 3.0, 1.5)), orientation=turn, velocity=(1, 2, 3), angular_velocity=w)
    r = quaternion_to_matrix(turn)
    j = r @ np.diag((2.0, 3.0, 1.5)) @ r.T
    assert np.allclose(body.orientation, turn, rtol=0, atol=1e-15) or np.allclose(
        body.orientation, -turn, atol=1e-15
    )
    assert np.allclose(body.momentum, (2, 4, 6))
    assert np.allclose(body.inertia, j, rtol=0, atol=1e-14)
    assert np.allclose(body.angular_momentum, j @ w, rtol=0, atol=1e-13)
    assert np.allclose(body.angular_velocity, w, rtol=0, atol=1e-13)
    body.apply_force((0, 1, 0), body.position + np.array((1.0, 0.0, 0.0)))
    body.apply_torque((0.5, 0, 0))
    assert np.allclose(body.acceleration, (0, 0.5, 0))
    assert np.allclose(body.torque, (0.5, 0, 1.0))
    alpha = np.linalg.solve(j, np.array((0.5, 0, 1.0)) - np.cross(w, j @ w))
    assert np.allclose(body.angular_acceleration, alpha, rtol=0, atol=1e-12)
    shift, rotation = body.kinetic_energy
    assert shift == pytest.approx(14.0)
    assert rotation == pytest.approx(0.5 * float(np.array(w) @ j @ w), rel=1e-12, abs=1e-25)


def test_angular_acceleration_is_the_rate_of_the_spin():
    body = RigidBody(1.0, (1, 2, 3), angular_velocity=(1, 2, -1), method="exact")
    alpha, before = body.angular_acceleration, body.angular_velocity
    body.step(1e-6)
    assert np.allclose((body.angular_velocity - before) / 1e-6, alpha, rtol=0, atol=1e-4)


@pytest.mark.parametrize("method", METHODS)
def test_a_force_at_a_point_shifts_and_turns(method):
    """C12.5: f at r gives P = f t and L = r x f t."""
    body = dumbbell(method=method)
    point = body.position + np.array((0.0, 0.3, 0.2))
    body.apply_force((10.0, 0.0, 0.0), point)
    body.step(0.01)
    assert np.allclose(body.momentum, (0.1, 0, 0), rtol=1e-14)
    assert np.allclose(body.angular_momentum, np.cross((0, 0.3, 0.2), (0.1, 0, 0)), rtol=1e-10, atol=1e-16)
    before = body.momentum
    body.step(0.01)
    assert np.array_equal(body.momentum, before), "forces act for one step"
    body.apply_force((10.0, 0.0, 0.0))
    body.clear_forces()
    body.step(0.01)
    assert np.array_equal(body.momentum, before)
    body.change(effects=ROTATION)
    body.apply_force((10.0, 0.0, 0.0))
    body.step(0.01)
    assert np.array_equal(body.momentum, before), "switched off"


def test_a_force_through_the_centre_does_not_turn():
    body = dumbbell()
    body.apply_force((0.0, 5.0, 0.0), body.position + np.array((0.0, 3.0, 0.0)))
    body.step(0.1)
    assert np.array_equal(body.angular_momentum, (0, 0, 0))


def test_impulse_and_force_agree():
    force, impulse = dumbbell(), dumbbell()
    point = (1.0, 0.5, 0.25)
    force.apply_force((3.0, -2.0, 1.0), point)
    force.step(0.01)
    impulse.apply_impulse((0.03, -0.02, 0.01), point)
    assert np.allclose(force.momentum, impulse.momentum, rtol=1e-14)
    assert np.allclose(force.angular_momentum, impulse.angular_momentum, rtol=1e-14)


@pytest.mark.parametrize("keep", ["momentum", "velocity"])
def test_density_changes_while_it_runs(keep):
    """C12.8: mass and tensor follow; either the momenta or the velocities stay."""
    body = dumbbell(velocity=(1, 0, 0), angular_velocity=(0, 1, 2))
    mass, inertia, momentum, spin = body.mass, body.inertia, body.momentum, body.angular_velocity
    body.change_density(4.0, keep)
    assert body.mass == 4.0 * mass
    assert np.allclose(body.inertia, 4.0 * inertia, rtol=1e-14)
    if keep == "momentum":
        assert np.array_equal(body.momentum, momentum)
        assert np.allclose(body.angular_velocity, spin / 4.0, rtol=1e-13, atol=1e-14)
    else:
        assert np.allclose(body.velocity, (1, 0, 0), rtol=1e-14)
        assert np.allclose(body.angular_velocity, spin, rtol=1e-13, atol=1e-14)
    body.change_density(0.25, keep)
    assert body.mass == mass


def test_a_row_of_points_never_turns_about_itself():
    """A torque along the row gives no spin and no infinity, by any method."""
    for method in METHODS:
        body = RigidBody.from_spheres([(-1, 0), (0, 0), (1, 0)], [1e-7] * 3, 1e20, method=method)
        body.angular_velocity = (0, 0, 2.0)
        body.step(0.01, 10)
        assert np.isfinite(body.state).all()
        assert body.spin[0] == 0.0
        assert np.allclose(body.angular_velocity, (0, 0, 2.0), rtol=1e-9, atol=1e-9)


def test_a_millionfold_in_mass_within_a_body():
    """It moves as one; L and the energy of the exact method stay."""
    body = RigidBody.from_spheres(
        [(1e6, 0, 0), (1e6 + 1.5, 0.5, 0), (1e6, 1.0, 0.7)], [1.0, 0.01, 0.01], 1000.0, method="exact"
    )
    body.angular_velocity = (3.0, 1.0, 2.0)
    first, angular = body.kinetic_energy[1], body.angular_momentum
    places = body.spheres()
    body.step(0.01, 100)
    assert body.kinetic_energy[1] == pytest.approx(first, rel=1e-12)
    assert np.array_equal(body.angular_momentum, angular)
    moved = body.spheres()
    for a, b in ((0, 1), (0, 2), (1, 2)):
        assert math.dist(moved[a], moved[b]) == pytest.approx(math.dist(places[a], places[b]), abs=1e-9)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: RigidBody(0.0), "mass"),
        (lambda: RigidBody(math.nan), "mass"),
        (lambda: RigidBody(1.0, (1, 1)), "inertia"),
        (lambda: RigidBody(1.0, (1, 1, -1)), "negative"),
        (lambda: RigidBody(position=(0, 0)), "position"),
        (lambda: RigidBody(velocity=(0, 0, math.inf)), "velocity"),
        (lambda: RigidBody(orientation=(0, 0, 0, 0)), "no length"),
        (lambda: RigidBody(angular_velocity=(0, 0, 1e300)), "angular_velocity|vector|velocity"),
        (lambda: RigidBody(method="verlet"), "method"),
        (lambda: RigidBody(effects=LINKS), "links"),
        (lambda: RigidBody(gravity=math.nan), "gravity"),
        (lambda: RigidBody(restitution=1.1), "restitution"),
        (lambda: RigidBody(lower=(0, 0, 0), upper=(1, 0, 1)), "empty"),
        (lambda: RigidBody(colour="red"), "colour"),
        (lambda: RigidBody().step(0.0), "dt"),
        (lambda: RigidBody().step(math.nan), "dt"),
        (lambda: RigidBody().apply_force((1, 0)), "force"),
        (lambda: RigidBody().apply_force((1, 0, 0), (0, 0, math.nan)), "point"),
        (lambda: RigidBody().change_density(0.0), "factor"),
        (lambda: RigidBody().change_density(2.0, "speed"), "keep"),
        (lambda: RigidBody.from_spheres([], [], 1.0), "positions"),
    ],
)
def test_nonsense_is_refused(call, words):
    with pytest.raises(ValueError, match=words):
        call()


def test_a_refused_setting_changes_nothing():
    body = RigidBody(effects=ROTATION | PUSHES)
    with pytest.raises(ValueError, match="method"):
        body.change(gravity=3.0, method="none")
    assert body.gravity == 0.0
