"""Motion between events against closed forms and against integrating the equations of motion."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from game.billiards import Physics, Table, make_shot, simulate
from game.billiards.table.rack import BALL_RADIUS

G = 9.81
OPEN = Table.open()
R = BALL_RADIUS


def _lone(velocity, spin=(0.0, 0.0, 0.0), **physics):
    shot = make_shot(OPEN, [[0.0, 0.0]], [velocity], [spin], physics=Physics(**physics))
    return simulate(shot)


def test_slide_then_roll_then_rest():
    # v0 = 3, mu = 0.2: slides 2 v0/(7 mu g), 12 v0^2/(49 mu g) far, and rolls at 5/7 v0
    trajectory = _lone((3.0, 0.0))
    (slid, stopped) = trajectory.events
    assert (slid.type, stopped.type) == ("sliding-rolling", "rolling-stationary")
    assert slid.time == pytest.approx(2.0 * 3.0 / (7.0 * 0.2 * G), rel=1e-14)
    rolling = trajectory.state_at(slid.time)
    assert rolling.positions[0, 0] == pytest.approx(12.0 * 9.0 / (49.0 * 0.2 * G), rel=1e-14)
    assert rolling.velocities[0, 0] == pytest.approx(15.0 / 7.0, rel=1e-14)
    assert stopped.time - slid.time == pytest.approx(15.0 / 7.0 / (0.01 * G), rel=1e-14)
    way = trajectory.final["0"][0] - rolling.positions[0, 0]
    assert way == pytest.approx((15.0 / 7.0) ** 2 / (2.0 * 0.01 * G), rel=1e-14)


def test_draw_shot_rolls_at_the_speed_that_keeps_the_angular_momentum_about_the_cloth():
    # back spin of 60 rad/s, topspin positive about y
    trajectory = _lone((3.0, 0.0), (0.0, -60.0, 0.0))
    time = trajectory.events[0].time
    assert time == pytest.approx(0.686544342507645, rel=1e-13)
    assert trajectory.state_at(time).velocities[0, 0] == pytest.approx(
        (15.0 - 2.0 * R * 60.0) / 7.0, rel=1e-13
    )


def test_masse_shot_runs_on_a_parabola():
    trajectory = _lone((2.0, 0.0), (-40.0, 60.0, 0.0))
    slid = trajectory.events[0].time
    assert slid == pytest.approx(0.17156208294438, rel=1e-12)
    state = trajectory.state_at(slid)
    assert state.positions[0] == pytest.approx([0.336126883791528, 0.028013637257918], rel=1e-12)
    # 5/7 v + 2/7 R (w x z)
    assert state.velocities[0] == pytest.approx(
        [10.0 / 7.0 + 2.0 / 7.0 * R * 60.0, 2.0 / 7.0 * R * 40.0], rel=1e-12
    )


def test_spin_about_z_decays_at_its_own_rate_whatever_the_ball_does():
    trajectory = _lone((0.0, 0.0), (0.0, 0.0, 50.0))
    assert [e.type for e in trajectory.events] == ["spinning-stationary"]
    assert trajectory.end_time == pytest.approx(2.0 * R * 50.0 / (5.0 * 0.0127 * G), rel=1e-14)
    moving = _lone((1.0, 0.0), (0.0, 0.0, 50.0))
    for time in (0.01, 0.1, 1.0, 3.0):
        assert moving.state_at(time).spins[0, 2] == pytest.approx(
            trajectory.state_at(time).spins[0, 2], rel=1e-12
        )


def test_a_ball_that_still_spins_when_it_stops_rolling_spins_on():
    trajectory = _lone((0.05, 0.0), (0.0, 0.0, 50.0))
    assert [e.type for e in trajectory.events] == [
        "sliding-rolling",
        "rolling-spinning",
        "spinning-stationary",
    ]


@pytest.mark.parametrize("velocity", [(0.05, 0.0), (0.3, -0.4), (0.0, 0.0)])
def test_side_spin_of_either_hand_is_alike(velocity):
    """The mirrored twin: the same events at the same times, spin about z of the other sign."""
    one, other = _lone(velocity, (0.0, 0.0, 50.0)), _lone(velocity, (0.0, 0.0, -50.0))
    assert [e.type for e in one.events] == [e.type for e in other.events]
    assert one.events[-1].type == "spinning-stationary"
    assert one.times.tolist() == other.times.tolist()
    for time in np.linspace(0.0, one.end_time, 9):
        assert one.state_at(time).spins[0, 2] == -other.state_at(time).spins[0, 2]


def test_what_has_run_out_is_exactly_zero():
    end = _lone((1.0, 2.0), (3.0, -4.0, 5.0))
    last = end.state_at(end.end_time)
    assert not last.velocities.any() and not last.spins.any()


def test_without_friction_a_ball_goes_on_for_ever_and_spin_is_kept():
    shot = make_shot(
        OPEN, [[0.0, 0.0]], [(1.0, 0.5)], [(1.0, 2.0, 3.0)], physics=Physics(sliding=0.0, spinning=0.0)
    )
    trajectory = simulate(shot, until=100.0)
    assert trajectory.events == []
    shot = make_shot(
        Table.bare(1.0, 1.0),
        [[0.5, 0.5]],
        [(0.9, 0.4)],
        [(1.0, 2.0, 3.0)],
        physics=Physics("elastic", "mirror", sliding=0.0, spinning=0.0),
    )
    later = simulate(shot, until=100.0)
    assert later.end_time == 100.0
    state = later.state_at(100.0)
    assert np.hypot(*state.velocities[0]) == pytest.approx(math.hypot(0.9, 0.4), rel=1e-14)
    assert state.spins[0].tolist() == [1.0, 2.0, 3.0]


def test_no_motion_no_events():
    trajectory = simulate(make_shot(Table.pool(), [[0.4, 0.4], [0.5, 0.5]]))
    assert trajectory.events == [] and trajectory.end_time == 0.0


def test_a_ball_put_into_sliding_without_slip_rolls_at_once():
    shot = make_shot(OPEN, [[0.0, 0.0]], [(1.0, 0.0)], [(0.0, 1.0 / R, 0.0)], motions=["sliding"])
    first = simulate(shot).events[0]
    assert first.type == "sliding-rolling" and first.time == pytest.approx(0.0, abs=1e-15)


@settings(max_examples=15)
@given(st.tuples(*[st.floats(-3.0, 3.0)] * 2), st.tuples(*[st.floats(-80.0, 80.0)] * 3))
def test_closed_form_against_integrated_equations(velocity, spin):
    """Newton's law with Coulomb friction at the cloth, up to where the ball begins to roll."""
    if math.hypot(velocity[0] - R * spin[1], velocity[1] + R * spin[0]) < 0.1:
        return
    trajectory = _lone(velocity, spin)
    end = 0.98 * trajectory.events[0].time

    def rate(_, y):
        ux, uy = y[2] - R * y[5], y[3] + R * y[4]
        slip = math.hypot(ux, uy)
        ax, ay = -0.2 * G * ux / slip, -0.2 * G * uy / slip
        # torque of the friction force about the centre: (0, 0, -R) x a, over 2/5 R^2
        return [y[2], y[3], ax, ay, 2.5 / R * ay, -2.5 / R * ax]

    start = [0.0, 0.0, *velocity, *spin[:2]]
    done = solve_ivp(rate, (0.0, end), start, method="DOP853", rtol=1e-11, atol=1e-12)
    state = trajectory.state_at(end)
    found = [*state.positions[0], *state.velocities[0], *state.spins[0, :2]]
    assert found == pytest.approx(done.y[:, -1], rel=0.0, abs=1e-8)
