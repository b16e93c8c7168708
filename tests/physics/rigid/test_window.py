"""A body in its window: mirrored, or struck; it never leaves and never gains."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from game.physics.fields import GRAVITY
from game.physics.rigid import ROTATION, WINDOW, RigidBody

BOX = {"lower": (-2.0, -2.0, -2.0), "upper": (2.0, 2.0, 2.0), "effects": ROTATION | WINDOW}
HAMMER = (
    [(0, 0, 0), (0.4, 0, 0), (0.8, 0, 0), (0.8, 0.35, 0), (0.8, -0.35, 0)],
    [0.15, 0.15, 0.15, 0.3, 0.3],
)


def hammer(**more):
    return RigidBody.from_spheres(*HAMMER, 500.0, **{**BOX, **more})


def beyond(body):
    places = body.spheres()
    low = (places - body.radii[:, None]).min(axis=0) - body.lower
    high = body.upper - (places + body.radii[:, None]).max(axis=0)
    return -min(low.min(), high.min())


def test_the_velocity_is_mirrored_and_the_spin_stays():
    """C12.7"""
    body = RigidBody.from_spheres([(1.0, 0.0, 0.0)], [0.5], 100.0, velocity=(3.0, 1.0, 0.0), **BOX)
    body.angular_velocity = (0, 0, 1)
    body.step(0.2)
    assert np.allclose(body.velocity, (-3.0, 1.0, 0.0))
    assert np.allclose(body.angular_velocity, (0, 0, 1))
    assert body.position[0] == pytest.approx(1.5)
    assert body.bounces == 1


def test_who_is_on_the_way_back_is_not_mirrored_again():
    body = RigidBody.from_spheres([(1.9, 0.0, 0.0)], [0.5], 100.0, velocity=(-1.0, 0.0, 0.0), **BOX)
    body.step(1e-3)
    assert body.velocity[0] == pytest.approx(-1.0)
    assert body.bounces == 0
    assert body.position[0] == pytest.approx(1.5)


@settings(max_examples=20)
@given(
    v=st.tuples(*[st.floats(-10, 10)] * 3),
    w=st.tuples(*[st.floats(-20, 20)] * 3),
    wall=st.sampled_from(["mirror", "impulse"]),
    restitution=st.floats(0.0, 1.0),
)
def test_a_body_stays_inside_and_does_not_gain(v, w, wall, restitution):
    body = hammer(velocity=v, angular_velocity=w, wall=wall, restitution=restitution, method="splitting")
    before = sum(body.kinetic_energy)
    for _ in range(100):
        body.step(1 / 120)
        assert beyond(body) < 1e-9
        now = sum(body.kinetic_energy)
        # what is not a bounce is the splitting's own swing
        assert now <= before * 1.02 + 1e-12
        before = max(now, before) if restitution == 1.0 else before
    body.check()


def test_an_elastic_impulse_keeps_the_energy_and_changes_the_spin():
    body = hammer(velocity=(4.0, 1.0, -2.0), angular_velocity=(1, 2, 3), wall="impulse", method="exact")
    first, angular = sum(body.kinetic_energy), body.angular_momentum
    body.step(1 / 120, 1200)
    assert body.bounces > 5
    assert sum(body.kinetic_energy) == pytest.approx(first, rel=1e-11)
    assert not np.allclose(body.angular_momentum, angular, rtol=0.01)


def test_an_impulse_on_one_end():
    """A rod flat against a wall is struck in its middle; off its middle it begins to turn."""
    flat = RigidBody.from_spheres([(-0.5, 0), (0.5, 0)], [0.2, 0.2], 100.0, **{**BOX, "wall": "impulse"})
    flat.velocity = (0, -30.0, 0)
    flat.step(0.1)
    assert flat.bounces == 1
    assert np.allclose(flat.velocity, (0, 30.0, 0))
    assert np.allclose(flat.angular_velocity, 0, atol=1e-12)
    sloping = RigidBody.from_spheres([(-0.5, 0), (0.5, 0.1)], [0.2, 0.2], 100.0, **{**BOX, "wall": "impulse"})
    sloping.velocity = (0, -30.0, 0)
    energy = sum(sloping.kinetic_energy)
    sloping.step(0.1)
    assert sloping.angular_velocity[2] < -1.0
    assert sum(sloping.kinetic_energy) == pytest.approx(energy, rel=1e-13)


def test_a_body_larger_than_the_window_comes_to_its_middle():
    body = RigidBody.from_spheres([(0, 0, 0), (5, 0, 0)], [0.5, 0.5], 1.0, velocity=(1, 0, 0), **BOX)
    body.step(0.01, 100)
    places = body.spheres()
    assert places[:, 0].mean() == pytest.approx(0.0, abs=1e-12)
    assert np.isfinite(body.state).all()


def test_it_comes_to_rest_on_the_floor():
    body = hammer(gravity=9.81, effects=ROTATION | WINDOW | GRAVITY, wall="impulse", restitution=0.3)
    body.angular_velocity = (1, 2, 0.5)
    body.step(1 / 240, 240 * 6)
    assert beyond(body) < 1e-9
    assert body.spheres()[:, 1].min() < -1.6
    assert np.linalg.norm(body.velocity) < 0.5
