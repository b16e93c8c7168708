"""The lecture's ball, point by point."""

import itertools
import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from game.billiards.lecture.ball import Ball
from game.billiards.lecture.slips import SLIPS

EPS = 2.0**-52


def pair(v1=(0.0, 0.0), v2=(0.0, 0.0), offset=(1.5, 0.0), masses=(1.0, 1.0), radius=1.0):
    """Ball 1 in the origin, ball 2 offset from it."""
    first = Ball(0.0, 0.0, radius, mass=masses[0])
    second = Ball(*offset, radius, mass=masses[1])
    first.velocity, second.velocity = v1, v2
    return first, second


def test_speed_and_velocity():
    ball = Ball(0, 0, 5)
    ball.velocity = (-3, 4)
    assert ball.speed == 5.0
    assert ball.angle == math.atan2(4, -3)
    ball.set_speed_and_angle(2.0, math.pi / 6.0)
    assert np.abs(np.array(ball.velocity) - [math.sqrt(3.0), 1.0]).max() < 4 * EPS
    assert (Ball(0, 0, 5).speed, Ball(0, 0, 5).angle) == (0.0, 0.0)


def test_velocity_is_added_to_position_and_acceleration_to_velocity_once_a_frame():
    ball = Ball(20, 20, 5)
    ball.velocity = (10, 15)
    ball.acceleration = (-1, 0.5)  # deceleration in x
    for _ in range(3):
        ball.update()
    assert ball.velocity == (7.0, 16.5)
    assert ball.position == (20 + 9 + 8 + 7, 20 + 15.5 + 16 + 16.5)


def test_frames_and_seconds_agree():
    """60 px a frame is 3600 px/s at 60 frames a second."""
    frames, seconds = Ball(0, 0, 5), Ball(0, 0, 5)
    frames.velocity, seconds.velocity = (60, 30), (3600, 1800)
    for _ in range(7):
        frames.update()
        seconds.update(1.0 / 60.0)
    assert np.abs(np.array(frames.position) - seconds.position).max() < 1e-10


@pytest.mark.parametrize(
    ("velocity", "position", "side"),
    [
        ((-30, 1), (5, 51), "left"),
        ((30, 1), (95, 51), "right"),
        ((1, -30), (51, 5), "low"),
        ((1, 30), (51, 95), "high"),
    ],
)
def test_overshoot_on_each_of_four_sides(velocity, position, side):
    ball = Ball(50, 50, 5, bounce=0.5)
    ball.set_bounds(0, 100, 0, 100)
    ball.velocity = velocity
    ball.update()
    overshoot = ball.update()
    assert getattr(overshoot, side) == 15.0
    axis = 0 if abs(velocity[0]) > 1 else 1
    assert ball.position[axis] == position[axis]
    assert ball.velocity[axis] == -0.5 * velocity[axis]
    assert ball.velocity[1 - axis] == 1.0
    assert sum(value > 0.0 for value in overshoot) == 1


def test_corner_turns_both_parts_round():
    ball = Ball(90, 90, 5, bounce=0.9)
    ball.set_bounds(0, 100, 0, 100)
    ball.velocity = (20, 30)
    ball.update()
    assert ball.position == (95, 95)
    assert ball.velocity == (-18, -27)


def test_ball_that_is_leaving_is_not_turned_round_again():
    ball = Ball(3, 50, 5)
    ball.set_bounds(0, 100, 0, 100)
    ball.velocity = (1, 0)
    ball.update()
    assert ball.position == (5.0, 50.0)
    assert ball.velocity == (1.0, 0.0)


def test_friction_and_minimum_speed():
    ball = Ball(0, 0, 5, friction=0.5, minimum_speed=0.3)
    ball.velocity = (1, 0)
    ball.update()
    assert ball.velocity == (0.5, 0.0)
    ball.update()
    assert (ball.position, ball.velocity) == ((1.5, 0.0), (0.0, 0.0))


def test_distance_rolled_with_a_friction_factor_is_a_geometric_series():
    ball = Ball(0, 0, 0.03, friction=0.99, minimum_speed=0.01)
    ball.velocity = (2.0, 0.0)
    frames = 0
    while ball.speed > 0.0:
        ball.update(1.0 / 60.0)
        frames += 1
    assert frames == 528
    assert ball.position[0] == pytest.approx(2.0 / 60.0 * (1.0 - 0.99**528) / 0.01, rel=8 * 528 * EPS)


def test_overlap_is_shared_by_halves_along_the_line_of_centres():
    first, second = pair(offset=(0.9, 1.2))
    record = first.handle_collision(second)
    assert (record.distance, record.overlap) == (1.5, 0.5)
    assert record.angle == math.atan2(-1.2, -0.9)
    assert np.abs(np.array(record.contact) - [0.45, 0.6]).max() < 4 * EPS
    assert np.abs(np.array(first.position) - [-0.15, -0.2]).max() < 4 * EPS
    assert np.abs(np.array(second.position) - [1.05, 1.4]).max() < 4 * EPS
    assert record.positions_before == ((0.0, 0.0), (0.9, 1.2))
    assert record.positions_after == (first.position, second.position)
    assert not record.exchanged


@pytest.mark.parametrize("offset", [(2.0, 0.0), (3.0, 0.0), (math.nextafter(2.0, 3.0), 0.0)])
def test_balls_that_do_not_overlap_do_not_collide(offset):
    first, second = pair((1.0, 0.0), offset=offset)
    assert first.handle_collision(second) is None
    assert first.velocity == (1.0, 0.0)


def test_balls_in_one_place_part_along_x():
    first, second = pair((0.0, 1.0), offset=(0.0, 0.0))
    record = first.handle_collision(second)
    assert (record.cosa, record.sina) == (1.0, 0.0)
    assert (first.position, second.position) == ((1.0, 0.0), (-1.0, 0.0))


coordinates = st.floats(-5.0, 5.0)
velocities = st.tuples(coordinates, coordinates)


@given(
    velocities, velocities, st.floats(0.1, 1.9), st.floats(0.0, 6.3), st.floats(0.2, 5.0), st.floats(0.0, 1.0)
)
def test_conserving_rule(v1, v2, distance, angle, mass, e):
    first, second = pair(v1, v2, (distance * math.cos(angle), distance * math.sin(angle)), (mass, 1.0))
    record = first.handle_collision(second, "conserving", e)
    size = sum(map(abs, (*v1, *v2))) * (1.0 + mass)
    assert math.dist(record.momentum_before, record.momentum_after) <= 8 * EPS * size
    assert record.energy_after <= record.energy_before * (1.0 + 32 * EPS) + 1e-300
    (a, b), (c, d) = record.parts_before, record.parts_after
    assert abs(a.tangential - c.tangential) + abs(b.tangential - d.tangential) < 1e-12
    if record.exchanged:
        assert abs((c.normal - d.normal) + e * (a.normal - b.normal)) < 1e-12 * (1.0 + size)
    assert record.velocities_after == (first.velocity, second.velocity)
    assert math.dist(first.position, second.position) == pytest.approx(2.0, abs=1e-12)


@given(velocities, velocities, st.floats(0.0, 6.3), st.floats(0.0, 1.0))
def test_scaled_rule_exchanges_normal_parts_and_shortens_everything(v1, v2, angle, loss):
    first, second = pair(v1, v2, (1.5 * math.cos(angle), 1.5 * math.sin(angle)))
    record = first.handle_collision(second, "scaled", loss)
    assume(record.exchanged)
    (a, b), (c, d) = record.parts_before, record.parts_after
    expected = [loss * value for value in (b.normal, a.tangential, a.normal, b.tangential)]
    assert np.abs(np.array([*c, *d]) - expected).max() < 1e-13 * 20
    assert (
        np.abs(np.array(record.momentum_after) - loss * np.array(record.momentum_before)).max() < 1e-13 * 40
    )


def test_conserving_and_scaled_agree_without_loss_for_equal_masses():
    results = []
    for rule in ("conserving", "scaled"):
        first, second = pair((1.0, 0.3), (-0.5, 0.2), (0.9, 1.2))
        first.handle_collision(second, rule, 1.0)
        results.append([*first.velocity, *second.velocity])
    assert np.abs(np.subtract(*results)).max() < 8 * EPS


def printed_listing(v1, v2, cosa, sina, loss, mended=()):
    """The listing line by line; `mended` names the slips to put right."""
    (vx1, vy1), (vx2, vy2) = v1, v2
    px1, px2 = cosa * vx1 + sina * vy1, cosa * vx2 + sina * vy2
    py1, py2 = cosa * vx1 - sina * vy1, cosa * vx2 - sina * vy2
    if "turning in" in mended:
        py1, py2 = cosa * vy1 - sina * vx1, cosa * vy2 - sina * vx2
    pnewx1, pnewy1, pnewx2, pnewy2 = px2, py2, px1, py1
    if "exchange" in mended:
        pnewy1, pnewy2 = py1, py2
    vynew, othervynew = cosa * pnewx1 + sina * pnewy1, cosa * pnewx2 + sina * pnewy2
    if "turning back" in mended:
        vynew, othervynew = cosa * pnewy1 + sina * pnewx1, cosa * pnewy2 + sina * pnewx2
    vxnew, othervxnew = cosa * pnewx1 - sina * pnewy1, cosa * pnewx2 - sina * pnewy2
    return np.array([[vxnew, vynew], [othervxnew, othervynew]]) * loss


@given(velocities, velocities, st.floats(0.0, 6.3), st.floats(0.0, 1.0))
def test_as_printed_is_the_listing_and_scaled_the_listing_mended(v1, v2, angle, loss):
    names = [slip.name for slip in SLIPS]
    for rule, mended in (("as-printed", ()), ("scaled", names)):
        first, second = pair(v1, v2, (1.5 * math.cos(angle), 1.5 * math.sin(angle)))
        record = first.handle_collision(second, rule, loss)
        if record.exchanged:
            listing = printed_listing(v1, v2, record.cosa, record.sina, loss, mended)
            assert np.abs(np.array([first.velocity, second.velocity]) - listing).max() < 1e-13 * 20


def test_what_each_slip_does_is_as_told():
    """Head-on along x, v = (1, 0), and what the texts say of the slips."""
    names = {slip.name for slip in SLIPS}
    v1, v2 = (1.0, 0.7), (0.0, 0.0)
    forgotten = printed_listing(v1, v2, -1.0, 0.0, 1.0, names - {"turning in"})
    assert (
        np.abs(forgotten - [[0.0, 1.0], [1.0, 0.0]]).max() == 0.0
    )  # 0.7 across is gone, a copy of 1 in its place
    swapped = printed_listing(v1, v2, math.cos(1.0), math.sin(1.0), 1.0, names - {"exchange"})
    assert np.abs(swapped - [v2, v1]).max() < 4 * EPS
    diagonal = printed_listing((1.0, 0.0), v2, -1.0, 0.0, 1.0, names - {"turning back"})
    assert np.abs(diagonal - [[0.0, 0.0], [1.0, 1.0]]).max() == 0.0
    first, second = pair((1.0, 0.0))
    record = first.handle_collision(second, "as-printed", 1.0)
    assert second.velocity == (1.0, 1.0)
    assert (record.energy_before, record.energy_after) == (0.5, 1.0)
    assert record.momentum_after != record.momentum_before


def test_the_printed_listing_exchanges_also_when_the_balls_part():
    for rule, expected in (("as-printed", True), ("scaled", False), ("conserving", False)):
        first, second = pair((-1.0, 0.0), (1.0, 0.0))
        assert first.handle_collision(second, rule, 1.0).exchanged is expected


def test_the_ball_hands_itself_to_a_painter():
    drawn = []

    class Notebook:
        def ball(self, position, radius, colour):
            drawn.append((position, radius, colour))

    Ball(3, 4, 5, "red").draw(Notebook())
    assert drawn == [((3.0, 4.0), 5.0, "red")]


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf, "7"])
def test_numbers_that_are_not_finite_are_refused(value):
    ball = Ball(0, 0, 1)
    for name in ("position", "velocity", "acceleration"):
        for place in itertools.permutations((0.0, value)):
            with pytest.raises(ValueError, match=name):
                setattr(ball, name, place)
    for arguments in ((value, 0, 1), (0, value, 1), (0, 0, value)):
        with pytest.raises(ValueError, match=r"position|radius"):
            Ball(*arguments)
    for call in (
        lambda: ball.update(value),
        lambda: ball.set_speed_and_angle(value, 0),
        lambda: ball.set_bounds(0, value, 0, 9),
    ):
        with pytest.raises(ValueError, match=r"dt|speed|bounds"):
            call()


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("mass", 0.0),
        ("mass", -1.0),
        ("bounce", 1.1),
        ("bounce", -0.1),
        ("friction", 2.0),
        ("minimum_speed", -1.0),
    ],
)
def test_absurd_numbers_are_refused(name, value):
    with pytest.raises(ValueError, match=name):
        Ball(0, 0, 1, **{name: value})


def test_absurd_calls_are_refused():
    ball, other = pair()
    with pytest.raises(ValueError, match="radius"):
        Ball(0, 0, 0)
    with pytest.raises(ValueError, match="dt"):
        ball.update(0)
    with pytest.raises(ValueError, match="bounds"):
        ball.set_bounds(0, 1, 0, 10)
    with pytest.raises(ValueError, match="rule"):
        ball.handle_collision(other, "magic")
    with pytest.raises(ValueError, match="restitution"):
        ball.handle_collision(other, restitution=1.5)
