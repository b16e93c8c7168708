"""First contact of two parabolic ways: against scans and closed forms, grazing, touching, nearly touching."""

import math

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from numba import config

from game.billiards import Physics, Table, make_shot, simulate
from game.billiards.exact import detection
from game.billiards.laws.lean import lean_kernel
from game.billiards.laws.state import AT_REST, CLOSING_SPEED, NEVER
from game.billiards.table.rack import BALL_RADIUS

REACH = 2.0 * BALL_RADIUS
near = st.floats(-1.0, 1.0)


@lean_kernel
def first_contact_time(x, y, vx, vy, ax, ay, reach, horizon):
    """The inner kernel, with an entrance."""
    return detection.first_contact_time(x, y, vx, vy, ax, ay, reach, horizon)


@lean_kernel
def first_crossing(gap, speed, half_acceleration, horizon):
    """The inner kernel, with an entrance."""
    return detection.first_crossing(gap, speed, half_acceleration, horizon)


OPEN = Table.open()


def _gap(t, x, y, vx, vy, ax, ay):
    return np.hypot(x + vx * t + ax * t * t, y + vy * t + ay * t * t) - REACH


def test_the_reference_quartic():
    # a sliding ball and a rolling one, both decelerating along their ways
    speed = math.hypot(3.0, 0.2)
    slow = math.hypot(0.5, 0.1)
    ax = 0.5 * 0.01 * 9.81 * 0.5 / slow + 0.5 * 0.2 * 9.81 * 3.0 / speed
    ay = 0.5 * 0.01 * 9.81 * 0.1 / slow + 0.5 * 0.2 * 9.81 * 0.2 / speed
    found = first_contact_time(1.0, 0.1, -3.5, -0.3, ax, ay, REACH, 10.0)
    assert found == pytest.approx(0.295883971496256, rel=1e-14)


def test_straight_ways_meet_when_the_quadratic_says():
    assert first_contact_time(1.0, 0.02, -10.0, -0.1, 0.0, 0.0, 0.06, 1.0) == pytest.approx(
        0.0940942065485371, rel=1e-14
    )


@settings(max_examples=300)
@given(near, near, st.floats(-4, 4), st.floats(-4, 4), near, near, st.floats(0.01, 2.0))
def test_against_a_fine_scan(x, y, vx, vy, ax, ay, horizon):
    """No contact is missed that a scan of the gap sees, and none is found before the scan sees one."""
    assume(math.hypot(x, y) > REACH * (1.0 + 1e-9))
    found = first_contact_time(x, y, vx, vy, ax, ay, REACH, horizon)
    times = np.linspace(0.0, horizon, 4001)
    gaps = _gap(times, x, y, vx, vy, ax, ay)
    inside = np.flatnonzero(gaps < -1e-12)
    if found < AT_REST:
        assert found <= horizon
        assert abs(_gap(found, x, y, vx, vy, ax, ay)) < 1e-14
        assert len(inside) == 0 or found <= times[inside[0]]
        assert gaps[times < found * (1.0 - 1e-12)].min(initial=1.0) > -1e-13
    else:
        assert len(inside) == 0


@settings(max_examples=300)
@given(st.floats(-15, -9), st.floats(0.1, 5.0), st.floats(0.0, 2 * math.pi), st.booleans())
def test_a_gap_of_any_smallness_keeps_its_relative_precision(exponent, speed, direction, curved):
    gap = 10.0**exponent
    half = 0.9 if curved else 0.0
    ux, uy = math.cos(direction), math.sin(direction)
    x, y = (REACH + gap) * ux, (REACH + gap) * uy
    exact = math.sqrt(x * x + y * y) - REACH
    assume(exact > 0.0)
    time = first_contact_time(x, y, -speed * ux, -speed * uy, half * ux, half * uy, REACH, 1.0)
    # of the gap as it stands in the numbers, which carry rounding of a last place of REACH
    wanted = 2.0 * exact / (speed + math.sqrt(speed * speed - 4.0 * half * exact))
    assert time == pytest.approx(wanted, rel=4e-15 + 4.0 * REACH * 2.0**-52 / exact, abs=0.0)


@pytest.mark.parametrize("degrees", [1e-2, 1e-4, 1e-6, 1e-8, 1e-9])
def test_grazing_hits_and_misses_down_to_a_billionth_of_a_degree(degrees):
    """Aimed past the tangent by this angle a ball misses, and aimed inside it hits."""
    distance = 0.5
    tangent = math.asin(REACH / distance)
    for sign in (-1.0, 1.0):
        angle = tangent + sign * math.radians(degrees)
        found = first_contact_time(distance, 0.0, -math.cos(angle), -math.sin(angle), 0.0, 0.0, REACH, 5.0)
        assert (found < AT_REST) == (sign < 0.0)


def test_touching_counts_only_if_closing():
    touching = (REACH, 0.0)
    assert first_contact_time(*touching, -1.0, 0.0, 0.0, 0.0, REACH, 1.0) == 0.0
    assert first_contact_time(*touching, 1.0, 0.0, 0.0, 0.0, REACH, 1.0) == NEVER
    assert first_contact_time(*touching, 0.0, 1.0, 0.0, 0.0, REACH, 1.0) == AT_REST  # sideways
    assert first_contact_time(*touching, 0.0, 0.0, 0.0, 0.0, REACH, 1.0) == AT_REST


def test_parting_balls_that_come_back_meet_again():
    # thrown apart at 1 m/s, pulled together at 2 m/s^2: back after 1 s
    assert first_contact_time(REACH, 0.0, 1.0, 0.0, -1.0, 0.0, REACH, 5.0) == pytest.approx(1.0, rel=1e-12)
    assert first_contact_time(REACH, 0.0, 1.0, 0.0, -1.0, 0.0, REACH, 0.9) == NEVER


def test_balls_at_rest_on_each_other_that_are_pressed_together_collide_within_rounding():
    time = first_contact_time(REACH, 0.0, 0.0, 0.0, -1.0, 0.0, REACH, 5.0)
    assert 0.0 < time < 1e-6
    assert 0.5 * 2.0 * time**2 < 1e-15 and 2.0 * time >= 0.9 * CLOSING_SPEED


def test_two_balls_rolling_the_same_way():
    """The faster one behind: a quartic whose leading coefficient is nearly nothing."""
    shot = make_shot(
        OPEN,
        [[0.0, 0.0], [0.5, 0.0]],
        [(1.0, 0.0), (0.9, 0.0)],
        [(0.0, 1.0 / BALL_RADIUS, 0.0), (0.0, 0.9 / BALL_RADIUS, 0.0)],
        motions=["rolling", "rolling"],
        physics=Physics("elastic", "mirror"),
    )
    first = simulate(shot).events[0]
    # both slow down alike, so the distance shrinks evenly
    assert first.type == "ball-ball"
    assert first.time == pytest.approx((0.5 - REACH) / 0.1, rel=1e-13)
    # of two that roll equally fast none catches the other
    shot = shot.struck(0, (0.9, 0.0), (0.0, 0.9 / BALL_RADIUS, 0.0))
    assert "ball-ball" not in {e.type for e in simulate(shot).events}


@settings(max_examples=200)
@given(st.floats(0.0, 1.0), st.floats(-3.0, 3.0), st.floats(-2.0, 2.0), st.floats(0.01, 3.0))
def test_crossing_a_line_against_the_roots(gap, speed, half, horizon):
    found = first_crossing(gap, speed, half, horizon)
    times = np.linspace(0.0, horizon, 2001)
    values = gap + times * (speed + times * half)
    if found < NEVER:
        assert found <= horizon
        assert abs(gap + found * (speed + found * half)) < 1e-14
        assert values[times < found].min(initial=1.0) > -1e-14
    else:
        # only a way that never goes beyond, or a touch without speed, is passed over
        assert values.min() > -1e-12


def test_from_behind_a_line_a_ball_comes_forward_and_falls_back():
    """A ball that leaves a pocket's mouth on a curved way, back to the rail beside it."""
    # -0.01 + 0.4 t - 0.8 t^2 is 0 at (0.4 -+ sqrt(0.16 - 0.032))/1.6
    wanted = (0.4 + math.sqrt(0.128)) / 1.6
    assert first_crossing(-0.01, 0.4, -0.8, 1.0) == pytest.approx(wanted, rel=1e-14)
    assert first_crossing(-0.01, 0.4, -0.8, 0.4) == NEVER
    assert first_crossing(-0.06, 0.4, -0.8, 1.0) == NEVER


def test_a_line_far_behind_is_not_met():
    assert first_crossing(-1e-3, -1.0, 0.0, 1.0) == NEVER
    assert first_crossing(-1e-3, 1.0, 0.0, 1.0) == NEVER
    assert first_crossing(-1e-12, -1.0, 0.0, 1.0) == 0.0
    assert first_crossing(0.0, 1.0, -1.0, 5.0) == pytest.approx(1.0, rel=1e-14)


@pytest.mark.skipif(config.DISABLE_JIT, reason="without compilation every kernel is a plain function")
def test_an_inner_kernel_refuses_a_call_from_python():
    for _ in range(2):
        with pytest.raises(TypeError, match="first_contact_time: an inner kernel"):
            detection.first_contact_time(1.0, 0.0, 0.0, 0.0, 0.0, 0.0, REACH, 1.0)
        first_contact_time(1.0, 0.0, 0.0, 0.0, 0.0, 0.0, REACH, 1.0)
