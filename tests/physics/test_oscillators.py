"""Small motions against integration in very short steps, and against what is known of them."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.physics.integrators import integrate
from game.physics.oscillators import (
    bead_positions,
    bounce_height,
    fall,
    pendulum_angle,
    rod_pull,
    spring_pull,
)


@pytest.mark.parametrize("start", [0.01, -1.0, 2.0, 3.1])
@pytest.mark.parametrize("time", [0.3, 2.0, 5.0])
def test_a_pendulum_is_where_short_steps_lead_it(start, time):
    angle, _ = integrate("rk4", rod_pull(9.81), [start], [0.0], time / 8_000, 8_000)
    assert pendulum_angle(start, 9.81, time) == pytest.approx(float(angle[0]), abs=1e-9)


def test_the_period_of_a_pendulum_at_sixty_degrees():
    """4 K(1/2) √(l/g) = 1.07318 of that of small swings (Abramowitz and Stegun, table 17.1: K = 1.68575)."""
    period = 4.0 * 1.685750354812596 / math.sqrt(9.81)
    assert period * math.sqrt(9.81) / math.tau == pytest.approx(1.0731820071, abs=1e-9)
    assert pendulum_angle(math.pi / 3, 9.81, period) == pytest.approx(math.pi / 3, abs=1e-12)
    assert pendulum_angle(math.pi / 3, 9.81, period / 2) == pytest.approx(-math.pi / 3, abs=1e-12)
    assert pendulum_angle(math.pi / 3, 9.81, period / 4) == pytest.approx(0.0, abs=1e-12)


def test_a_pendulum_without_weight_stays():
    assert pendulum_angle(1.0, 0.0, 7.0) == pytest.approx(1.0, abs=1e-15)


def test_a_ball_comes_back_to_heights_that_shrink_by_e_squared():
    fallen = math.sqrt(2.0 / 9.81)
    top = fallen + 0.8 * fallen
    assert bounce_height(1.0, 0.8, 9.81, top) == pytest.approx(0.64, abs=1e-12)
    assert bounce_height(1.0, 0.8, 9.81, top + 0.8 * fallen + 0.64 * fallen) == pytest.approx(
        0.4096, abs=1e-12
    )
    assert bounce_height(1.0, 1.0, 9.81, 40.0 * fallen) == pytest.approx(1.0, abs=1e-9)


def test_all_bounces_are_over_in_a_finite_time():
    fallen = math.sqrt(2.0 / 9.81)
    end = fallen * (1.0 + 2.0 * 0.5 / (1.0 - 0.5))
    assert bounce_height(1.0, 0.5, 9.81, end - 1e-3) > 0.0
    assert bounce_height(1.0, 0.5, 9.81, end + 1e-9) == 0.0
    assert bounce_height(1.0, 0.0, 9.81, 2.0) == 0.0


@given(st.floats(0.1, 1.0), st.floats(1e-3, 0.02))
def test_falling_to_the_root_follows_the_exact_bounces(restitution, dt):
    """As long as no step holds two impacts."""
    y, v, time = 1.0, 0.0, 0.0
    limit = math.sqrt(2.0 / 9.81)
    speed = restitution * math.sqrt(2.0 * 9.81)
    while 2.0 * speed / 9.81 > 2.0 * dt and limit < 3.0:
        limit += 2.0 * speed / 9.81
        speed *= restitution
    while time + dt < min(limit, 3.0):
        y, v = fall(y, v, 9.81, restitution, True, dt)
        time += dt
        assert y == pytest.approx(bounce_height(1.0, restitution, 9.81, time), abs=1e-9)


def test_an_impact_seen_at_the_end_of_a_step_puts_the_ball_on_the_ground():
    assert fall(0.1, -3.0, 9.81, 0.5, False, 0.1) == (0.0, 0.5 * (3.0 + 0.981))
    assert fall(0.1, -3.0, 9.81, None, False, 0.1)[0] < 0.0
    assert fall(0.1, -3.0, 0.0, 1.0, True, 0.1) == pytest.approx((0.2, 3.0))


@pytest.mark.parametrize("n", [1, 2, 15])
def test_beads_are_where_short_steps_lead_them(n):
    start = np.random.default_rng(n).normal(size=n)
    beads, _ = integrate("rk4", spring_pull(50.0), start, np.zeros(n), 2.0 / 4_000, 4_000)
    assert np.abs(bead_positions(start, math.sqrt(50.0), 2.0) - beads).max() < 1e-9
    assert np.abs(bead_positions(start, math.sqrt(50.0), 0.0) - start).max() < 1e-13


def test_a_mode_keeps_its_shape():
    shape = np.sin(3.0 * math.pi * np.arange(1, 10) / 10)
    swing = math.cos(2.0 * 7.0 * math.sin(3.0 * math.pi / 20) * 1.3)
    assert np.abs(bead_positions(shape, 7.0, 1.3) - swing * shape).max() < 1e-13
