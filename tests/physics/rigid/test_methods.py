"""The ten ways to integrate: orders, what they keep, what explicit Euler does."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.fields import DRAG, GRAVITY
from game.physics.rigid import METHODS, ORDERS, PUSHES, ROTATION, FreeTop, RigidBody, turn_between
from tests.physics.rigid.rigid_motion import (
    ENERGY_BOUNDS,
    MOMENTS,
    STARTS,
    energy,
    free_body,
    length,
)

EPS = 2.0**-52
KEEP_L = [name for name in METHODS if name not in ("implicit-gyroscopic", "body-euler", "world-euler")]
INEXACT = [name for name in METHODS if name != "exact"]


def error_after(method, steps, seconds=1.0, spin=STARTS["generic"]):
    """Angle (rad) between a body and the exact one."""
    body = free_body(method, spin)
    start = body.state[3:7].copy()
    body.step(seconds / steps, steps)
    return turn_between(body.state[3:7], FreeTop(MOMENTS, spin).orientation(start, seconds))


@pytest.mark.parametrize("method", INEXACT)
def test_orders_of_a_free_body(method):
    """Least squares over five step sizes, sixteenfold."""
    counts = [64, 128, 256, 512, 1024] if ORDERS[method] < 4 else [16, 32, 64, 128, 256]
    errors = [error_after(method, n) for n in counts]
    slope = -np.polyfit(np.log(counts), np.log(errors), 1)[0]
    assert ORDERS[method] - 0.15 < slope < ORDERS[method] + 0.25
    assert min(errors) > 1e3 * EPS


def test_the_exact_method_has_no_error_for_any_step():
    for steps in (1, 7, 100):
        assert error_after("exact", steps, seconds=10.0) < 1e-12


@pytest.mark.parametrize("method", METHODS)
def test_orders_under_a_torque(method):
    """A held torque: against 4096 steps of Runge-Kutta."""

    def turned(name, steps):
        body = free_body(name, (0.3, 1.0, 0.2), effects=ROTATION | PUSHES)
        body.apply_torque((0.5, -1.0, 2.0))
        body.apply_force((1.0, 2.0, -1.0))
        body.step(1.0 / steps, steps)
        return body

    exact = turned("rk4", 4096)
    counts = [32, 64, 128, 256, 512] if ORDERS[method] < 4 else [8, 16, 32, 64, 128]
    errors = [turn_between(turned(method, n).state[3:7], exact.state[3:7]) for n in counts]
    slope = -np.polyfit(np.log(counts), np.log(errors), 1)[0]
    assert ORDERS[method] - 0.15 < slope < ORDERS[method] + 0.25
    off = abs(turned(method, 64).position - exact.position).max()
    assert off < 1e-13 if ORDERS[method] > 1 else 1e-3 < off < 0.1


@pytest.mark.parametrize("method", KEEP_L)
def test_angular_momentum_is_the_state_and_stays(method):
    body = free_body(method, STARTS["axis 3 side"])
    before = body.angular_momentum
    body.step(1 / 60, 6000)
    assert np.array_equal(body.angular_momentum, before)


@pytest.mark.parametrize("name", ENERGY_BOUNDS)
@pytest.mark.parametrize("method", ["explicit-euler", "exponential-map", "semi-implicit"])
def test_explicit_euler_raises_the_energy_to_its_bound(method, name):
    """E never falls, never passes |L|²/(2 I1), and comes to it; the exponential map does not help."""
    body = free_body(method, STARTS[name])
    first = before = energy(body)
    bound = body.largest_rotation_energy
    assert bound / first == pytest.approx(ENERGY_BOUNDS[name], rel=1e-14)
    for _ in range(600):
        body.step(1 / 60, 10)
        now = energy(body)
        assert now >= before * (1.0 - 1e-14)
        assert now <= bound * (1.0 + 1e-12)
        before = now
    assert now / bound > 0.9999


@pytest.mark.parametrize(
    ("name", "dt", "ratio"),
    [
        ("axis 3 side", 60, 1.31468),
        ("generic", 60, 1.17253),
        ("axis 3 side", 120, 1.121),
        ("generic", 120, 1.064),
    ],
)
def test_energy_of_explicit_euler_after_ten_seconds(name, dt, ratio):
    body = free_body("explicit-euler", STARTS[name])
    first = energy(body)
    body.step(1 / dt, 10 * dt)
    assert energy(body) / first == pytest.approx(ratio, abs=5e-4 if dt > 60 else 5e-6)


def test_the_sign_depends_on_the_state():
    """Euler's equations in the body's frame gain, the spin in the world's frame loses."""
    ratios, momenta = {}, {}
    for method, seconds in (("body-euler", 10), ("world-euler", 100), ("implicit-gyroscopic", 100)):
        body = free_body(method, STARTS["generic"])
        first, angular = energy(body), length(body.angular_momentum)
        body.step(1 / 60, 60 * seconds)
        ratios[method] = energy(body) / first
        momenta[method] = length(body.angular_momentum) / angular
    assert ratios["body-euler"] == pytest.approx(1.129, abs=1e-3)
    assert momenta["body-euler"] == pytest.approx(1.038, abs=1e-3)
    assert ratios["world-euler"] == pytest.approx(0.63, abs=5e-3)
    assert momenta["world-euler"] == pytest.approx(0.475, abs=5e-3)
    assert 0.3 < ratios["implicit-gyroscopic"] < 0.9
    assert 0.59 < momenta["implicit-gyroscopic"] < 0.96


def test_the_splitting_does_not_drift():
    """Its energy swings by a few millionths and is as good after 100 s as after 10."""
    body = free_body("splitting", STARTS["generic"])
    first = energy(body)
    worst = []
    for _ in range(2):
        off = 0.0
        for _ in range(300):
            body.step(1 / 60, 10)
            off = max(off, abs(energy(body) / first - 1.0))
        worst.append(off)
    assert max(worst) < 2e-5
    assert worst[1] < 1.1 * worst[0]


def test_at_twenty_radians_a_second_and_ten_steps():
    """A coarse step: the spin in the world's frame explodes, the splitting keeps its energy nearly."""
    spin = np.array((0.5, 20.0, 0.5))
    body, wild = free_body("splitting", spin), free_body("world-euler", spin)
    first = energy(body)
    off = 0.0
    for _ in range(100):
        body.step(0.1)
        off = max(off, abs(energy(body) / first - 1.0))
    assert off < 0.05
    with np.errstate(all="ignore"):
        wild.step(0.1, 100)
    assert not energy(wild) < 1e6 * first


@pytest.mark.parametrize("method", METHODS)
def test_length_of_the_quaternion(method):
    """1 to rounding after each step; not normalized, explicit Euler alone makes it longer."""
    body = free_body(method, (0.0, 0.0, 10.0))
    body.step(1 / 60, 600)
    assert length(body.state[3:7]) == pytest.approx(1.0, abs=4 * EPS)
    free = free_body(method, (0.0, 0.0, 10.0), normalizing=False)
    free.step(1 / 60, 60)
    grown = length(free.state[3:7])
    if method in ("explicit-euler", "semi-implicit", "implicit-gyroscopic", "body-euler", "world-euler"):
        assert grown == pytest.approx((1.0 + (10.0 / 120.0) ** 2) ** 30, rel=1e-13)
        assert grown == pytest.approx(1.2307371334142, rel=1e-12)
    else:
        assert grown == pytest.approx(1.0, abs=2e-6)
    # the direction is the same either way, as a step is linear in q
    twin = free_body(method, (0.0, 0.0, 10.0))
    twin.step(1 / 60, 60)
    assert turn_between(twin.state[3:7], free.state[3:7]) < 1e-12


def test_explicit_euler_turns_by_less_than_the_angle():
    """2 atan(w dt / 2) each step: 9.97694782661295 rad instead of 10 in 60 steps."""
    body = free_body("explicit-euler", (0.0, 0.0, 10.0))
    total, before = 0.0, body.orientation
    for _ in range(60):
        body.step(1 / 60)
        total += turn_between(before, body.orientation)
        before = body.orientation
    assert total == pytest.approx(9.97694782661295, abs=1e-12)
    exact = free_body("exponential-map", (0.0, 0.0, 10.0))
    exact.step(1 / 60, 60)
    assert turn_between(exact.orientation, (math.cos(5.0), 0, 0, math.sin(5.0))) < 1e-13


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("spin", [(0.0, 0.0, 0.0), (1e-9, 2e-9, -1e-9), (0.0, 0.0, 400.0)])
def test_no_spin_hardly_any_and_more_than_half_a_turn_a_step(method, spin):
    """No spin at all, hardly any, and much."""
    body = free_body(method, spin)
    body.step(1 / 60, 10)
    body.check()
    if spin[2] == 0.0:
        assert np.array_equal(body.orientation, (1, 0, 0, 0))
    else:
        assert np.allclose(body.spin, spin, rtol=1e-9, atol=1e-24)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("axis", [0, 2])
def test_a_spin_about_a_stable_axis_stays(method, axis):
    """To 1e-12 for ten seconds, in a frame that is not the world's."""
    spin = np.zeros(3)
    spin[axis] = 3.0
    body = free_body(method, (0, 0, 0))
    body.orientation = (0.5, 0.1, -0.7, 0.3)
    body.angular_velocity = body.rotation @ spin
    body.step(1 / 60, 600)
    assert np.allclose(body.spin, spin, rtol=0, atol=1e-12)


def test_rounding_makes_the_middle_axis_flip():
    """E^(1.73 t) makes 1e-16 to 1 in some twenty seconds, so a flip then is right."""
    body = free_body("splitting", (0, 0, 0))
    body.orientation = (0.5, 0.1, -0.7, 0.3)
    body.angular_velocity = body.rotation @ (0.0, 3.0, 0.0)
    body.step(1 / 60, 600)
    assert body.spin[1] == pytest.approx(3.0, abs=1e-6)
    lowest = 3.0
    for _ in range(60):
        body.step(1 / 60, 60)
        lowest = min(lowest, body.spin[1])
    assert lowest < -2.9


@pytest.mark.parametrize("method", ["splitting", "rk4", "midpoint", "exact"])
@pytest.mark.parametrize("name", ["axis 3 side", "axis 1 side"])
def test_flips_in_a_hundred_seconds(method, name):
    """30 and 25 times."""
    body = free_body(method, STARTS[name])
    sign, flips = 1.0, 0
    for _ in range(1000):
        body.step(1 / 100, 10)
        if body.spin[1] * sign < 0.0:
            sign, flips = -sign, flips + 1
    assert flips == {"axis 3 side": 30, "axis 1 side": 25}[name]


@pytest.mark.parametrize("method", METHODS)
def test_precession_of_a_symmetric_body(method):
    """The spin goes round axis 3 at 4 rad/s; only the phase tells the methods apart."""
    body = free_body(method, (0.5, 0.0, 2.0), moments=(1.0, 1.0, 3.0))
    body.step(1 / 4000, 4000)
    assert np.allclose(body.spin, (0.5 * math.cos(4), 0.5 * math.sin(4), 2.0), rtol=0, atol=5e-3)


def test_gravity_and_drag():
    body = RigidBody(
        2.0, MOMENTS, velocity=(1, 2, 0), effects=GRAVITY | DRAG | ROTATION, gravity=10.0, method="rk4"
    )
    body.step(0.1)
    assert np.allclose(body.velocity, (1.0, 1.0, 0.0), rtol=1e-15)
    assert np.allclose(body.position, (0.1, 0.15, 0.0), rtol=1e-15)
    assert np.allclose(body.acceleration, (0, -10, 0))
    body.change(damping=0.5, gravity=0.0)
    body.angular_velocity = (0, 0, 1)
    body.step(0.1, 20)
    assert np.allclose(body.velocity, np.exp(-1.0) * np.array((1, 1, 0)), rtol=1e-14)
    assert np.allclose(body.angular_velocity, (0, 0, np.exp(-1.0)), rtol=1e-13)
    still = RigidBody(2.0, MOMENTS, angular_velocity=(1, 2, 3), effects=GRAVITY, gravity=10.0)
    still.step(0.1, 5)
    assert np.array_equal(still.orientation, (1, 0, 0, 0))


def test_equal_input_gives_equal_bits_in_one_call_or_many():
    for method in METHODS:
        one, many = free_body(method, STARTS["generic"]), free_body(method, STARTS["generic"])
        one.step(1 / 60, 50)
        for _ in range(50):
            many.step(1 / 60)
        assert one.state.tobytes() == many.state.tobytes()
