"""Balls on tracks, against formulas: loops, bowls, races, ends, grooves, drawn and dragged lines."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.solids.tracks import (
    DISC,
    SPHERE,
    Curve,
    TrackSettings,
    TrackWorld,
    moved_aside,
)
from game.physics.solids.tracks.motion import ANGLE, FREE, PIECE, SPEED, SPIN, VX, VY, WEDGE, X, Y

G = 9.81
DT = 1.0 / 240.0


def world_of(*curves, substeps=4, **settings):
    return TrackWorld([c if isinstance(c, Curve) else Curve(c) for c in curves],
                      TrackSettings(substeps=substeps, **settings))  # fmt: skip


def seated(world, place, radius, **options):
    ball = world.add_ball(place, radius, **options)
    assert world.put_down(ball, 0.1)
    return ball


def run(world, seconds, dt=DT):
    for _ in range(round(seconds / dt)):
        world.step(dt)


def total(world):
    return float(world.energies().sum())


def circle(chords, radius=1.0):
    turns = np.linspace(-0.5 * math.pi, 1.5 * math.pi, chords + 1)
    return radius * np.stack([np.cos(turns), 1.0 + np.sin(turns)], axis=1)


def bowl(chords):
    return Curve(circle(chords)[:-1], closed=True)


def cycloid(a, count=400):
    """From its cusp at (0, 0) to its lowest point at (pi a, -2a)."""
    turn = np.linspace(0.0, math.pi, count)
    return a * np.stack([turn - np.sin(turn), np.cos(turn) - 1.0], axis=1)


def passes_loop(chords, drop, friction, share=DISC):
    """Whether a ball that rolls into a loop of 1 m, after a drop of so many m, comes round."""
    world, r = world_of(circle(chords)), 0.1
    speed = math.sqrt(2.0 * G * drop / (1.0 + share))
    ball = seated(
        world, (0.001, r), r, velocity=(speed, 0.0), spin=-speed / r, friction=friction, share=share
    )
    for _ in range(480):
        world.step(DT)
        if world.balls.pieces[ball, PIECE] == FREE:
            return False
        if world.balls.rows[ball, X] < -0.3 and world.balls.rows[ball, Y] < 0.8:
            return True
    raise AssertionError("it went nowhere")


@pytest.mark.parametrize("chords", [50, 100, 800])
@pytest.mark.parametrize(
    ("friction", "share", "limit"),
    [(1e6, DISC, 2.475), (1e6, SPHERE, 2.43), (0.3, DISC, 2.522244187567568), (0.1, DISC, 2.722246425791511)],
)
def test_a_loop_is_passed_from_the_right_height_whatever_its_chords(chords, friction, share, limit):
    assert not passes_loop(chords, 0.99 * limit, friction, share)
    assert passes_loop(chords, 1.01 * limit, friction, share)


@pytest.mark.parametrize(("friction", "share", "degrees", "within"), [
    (1e6, DISC, 55.15009542, 0.15), (1e6, SPHERE, math.degrees(math.acos(10.0 / 17.0)), 0.15),
    (0.0, DISC, 48.18968510, 0.15), (0.3, DISC, 52.605479860428034, 0.15),
])  # fmt: skip
def test_a_ball_leaves_a_cylinder_where_it_should(friction, share, degrees, within):
    world = world_of(bowl(200))
    r = 0.1
    start = math.radians(0.05)
    place = (1.1 * math.sin(start), 1.0 + 1.1 * math.cos(start))
    ball = seated(world, place, r, friction=friction, share=share)
    for _ in range(5000):
        world.step(DT / 4.0)
        if world.balls.pieces[ball, PIECE] == FREE:
            break
    x, y = world.balls.rows[ball, [X, Y]] - (0.0, 1.0)
    assert math.degrees(math.atan2(x, y)) == pytest.approx(degrees, abs=within)


@pytest.mark.parametrize(("degrees", "period"), [(5.0, 2.3319487350635946), (60.0, 2.5014143193900225)])
def test_the_period_of_a_bowl(degrees, period):
    world, r = world_of(bowl(200)), 0.1
    turn = math.radians(degrees)
    ball = seated(world, (0.9 * math.sin(turn), 1.0 - 0.9 * math.cos(turn)), r, friction=1e6)
    crossings, before = [], world.balls.rows[ball, X]
    for step in range(1, 2000):
        world.step(DT)
        now = world.balls.rows[ball, X]
        if before > 0.0 >= now:
            crossings.append((step - now / (now - before)) * DT if now != before else step * DT)
        before = now
    assert np.diff(crossings).mean() == pytest.approx(period, rel=2e-4)


def test_energy_neither_rises_nor_falls_in_a_minute_in_a_bowl():
    world, r = world_of(bowl(100)), 0.1
    seated(world, (0.9, 1.0), r, friction=0.0)
    first = total(world)
    most = least = before = first
    for _ in range(60 * 240):
        world.step(DT)
        now = total(world)
        assert now <= before + 1e-9 * G
        most, least, before = max(most, now), min(least, now), now
    assert most - first < 1e-6 * G and first - least < 1e-4 * G


def arrival(points, x_end, r, friction, share=DISC):
    """When a ball let go at the beginning of a way of its centre gets so far."""
    world = world_of(moved_aside(points, -r))
    ball = world.add_ball((points[0][0], points[0][1]), r, friction=friction, share=share)
    assert world.put_down(ball, 0.05)
    before, now = 0.0, 0.0
    for step in range(1, 3000):
        world.step(DT)
        now = world.balls.rows[ball, X]
        if now >= x_end:
            return (step - 1 + (x_end - before) / (now - before)) * DT
        before = now
    raise AssertionError("it does not arrive")


def test_the_cycloid_wins_the_race():
    """The times of Bernoulli's race to (pi/2, -1), of a bead and of a disc."""
    a = 0.5
    x = np.linspace(0.0, math.pi / 2.0, 300)
    line = np.stack([x, -x / (math.pi / 2.0)], axis=1)
    slope = math.hypot(math.pi / 2.0, 1.0)
    exact_line = math.sqrt(2.0 * slope**2 / G)
    exact_cycloid = math.pi * math.sqrt(a / G)
    end = math.pi / 2.0 - 1e-6
    for friction, slower in ((0.0, 1.0), (1e6, math.sqrt(1.5))):
        times = [arrival(way, end, 0.02, friction) for way in (line, cycloid(a))]
        assert times[0] == pytest.approx(exact_line * slower, rel=5e-4)
        assert times[1] == pytest.approx(exact_cycloid * slower, rel=3e-3)


@pytest.mark.parametrize("part", [0.0, 0.3, 0.8])
def test_a_cycloid_is_a_tautochrone(part):
    """From wherever it starts, a ball is at the bottom after pi sqrt(a/g), times sqrt(3/2) if it rolls."""
    a, r = 0.5, 0.02
    way = cycloid(a, 600)
    other = way[::-1] * (-1.0, 1.0) + (2.0 * math.pi * a, 0.0)
    world = world_of(moved_aside(np.concatenate([way, other[1:]]), -r))
    turn = math.pi * part
    ball = world.add_ball((a * (turn - math.sin(turn)), a * (math.cos(turn) - 1.0)), r, friction=1e6)
    assert world.put_down(ball, 0.05)
    before, bottom = world.balls.rows[ball, X], math.pi * a
    for step in range(1, 1000):
        world.step(DT)
        now = world.balls.rows[ball, X]
        if now >= bottom:
            when = (step - (now - bottom) / (now - before)) * DT
            break
        before = now
    assert when == pytest.approx(math.pi * math.sqrt(a / G) * math.sqrt(1.5), rel=3e-3)


def test_a_bezier_descent():
    t = np.linspace(0.0, 1.0, 400)[:, None]
    p = np.array([(0.0, 1.0), (0.2, 0.1), (1.0, 0.0), (2.0, 0.3)])
    curve = (1 - t) ** 3 * p[0] + 3 * t * (1 - t) ** 2 * p[1] + 3 * t * t * (1 - t) * p[2] + t**3 * p[3]
    r = 0.05
    world = world_of(curve)
    way = moved_aside(curve, r)
    ball = world.add_ball(way[0], r, friction=1e6)
    assert world.put_down(ball, 0.01)
    end = way[-1][0]
    before = now = world.balls.rows[ball, X]
    step = 0
    while now < end and step < 1000:
        before = now
        world.step(DT)
        step, now = step + 1, world.balls.rows[ball, X]
    assert (step - (now - end) / (now - before)) * DT == pytest.approx(1.0059237873314992, rel=5e-3)


@pytest.mark.parametrize("friction", [0.0, 1e6])
def test_a_straight_line_of_a_thousand_uneven_pieces_keeps_the_speed(friction):
    chance = np.random.default_rng(3)
    x = np.concatenate([[0.0], np.cumsum(10.0 ** chance.uniform(-6.0, 1.0, 1000))])
    world, r = world_of(np.stack([x, np.zeros_like(x)], axis=1)), 0.3
    ball = seated(world, (0.5, r), r, velocity=(5.0, 0.0), spin=-5.0 / r, friction=friction)
    run(world, 10.0)
    assert world.balls.rows[ball, VX] == pytest.approx(5.0, rel=1e-9)
    assert world.balls.rows[ball, X] == pytest.approx(50.5, rel=1e-8)
    assert world.balls.rows[ball, Y] == pytest.approx(r, abs=1e-8)


def test_sliding_becomes_rolling():
    """v = (2 v0 - r w0)/3 after (v0 + r w0)/(3 mu g), Routh; backspin brings it back."""
    world, r, mu = world_of([(-20.0, 0.0), (20.0, 0.0)]), 0.2, 0.3
    ball = seated(world, (0.0, r), r, velocity=(2.0, 0.0), spin=40.0, friction=mu)
    run(world, 1.1)
    assert abs(world.balls.rows[ball, VX] + r * world.balls.rows[ball, SPIN]) > 0.05
    run(world, 0.1)
    assert world.balls.rows[ball, VX] == pytest.approx((2.0 * 2.0 - r * 40.0) / 3.0, rel=1e-6)
    assert world.balls.rows[ball, SPIN] == pytest.approx(-world.balls.rows[ball, VX] / r, rel=1e-9)


@pytest.mark.parametrize(("degrees", "mu"), [(30.0, 0.2), (32.0, 0.2)])
def test_a_disc_slips_on_slopes_steeper_than_three_mu(degrees, mu):
    turn = math.radians(degrees)
    world = world_of([(-1.0, math.tan(turn)), (30.0, -30.0 * math.tan(turn))])
    r = 0.2
    ball = seated(world, (r * math.sin(turn), r * math.cos(turn)), r, friction=mu)
    run(world, 1.0)
    slip = world.balls.rows[ball, SPEED] + r * world.balls.rows[ball, SPIN]
    speed = world.balls.rows[ball, SPEED]
    if math.tan(turn) < 3.0 * mu:
        assert slip == pytest.approx(0.0, abs=1e-9)
        assert speed == pytest.approx(2.0 / 3.0 * G * math.sin(turn), rel=1e-9)
    else:
        assert speed == pytest.approx(G * (math.sin(turn) - mu * math.cos(turn)), rel=1e-9)
        assert world.balls.rows[ball, SPIN] == pytest.approx(-2.0 * mu * G * math.cos(turn) / r, rel=1e-9)


def test_a_disc_rolls_over_the_end_of_a_table():
    """It leaves where cos = 4/7 (1 + 3 v²/(4 g r))."""
    world, r, v = world_of([(-3.0, 0.0), (0.0, 0.0)]), 0.1, 0.5
    ball = seated(world, (-0.05, r), r, velocity=(v, 0.0), spin=-v / r, friction=1e6)
    for _ in range(2000):
        world.step(DT / 4.0)
        if world.balls.pieces[ball, PIECE] == FREE:
            break
    x, y = world.balls.rows[ball, [X, Y]]
    exact = math.degrees(math.acos(4.0 / 7.0 * (1.0 + 3.0 * v * v / (4.0 * G * r))))
    assert math.degrees(math.atan2(x, y)) == pytest.approx(exact, abs=0.5)


@pytest.mark.parametrize(("share", "climbs"), [(0.98, False), (1.02, True)])
def test_a_step_is_climbed_from_the_right_speed(share, climbs):
    r, height = 0.5, 0.1
    limit = math.sqrt(4.0 * G * height / 3.0) / (1.0 - 2.0 * height / (3.0 * r))
    world = world_of(Curve([(-5.0, 0.0), (0.0, 0.0), (0.0, height), (5.0, height)], corner=20.0))
    ball = seated(world, (-1.0, r), r, velocity=(share * limit, 0.0), spin=-share * limit / r, friction=1e6)
    run(world, 6.0)
    assert (world.balls.rows[ball, X] > 0.5) == climbs


def test_a_ball_jumps_as_a_parabola_and_lands():
    turn, v = math.radians(20.0), 6.0
    world = world_of([(-3.0 * math.cos(turn), 2.0 - 3.0 * math.sin(turn)), (0.0, 2.0)],
                     [(-1.0, 0.0), (20.0, 0.0)])  # fmt: skip
    r = 0.001
    ball = world.add_ball((0.002, 2.002), r, (v * math.cos(turn), v * math.sin(turn)), friction=0.0)
    step = 0
    while world.balls.pieces[ball, PIECE] == FREE and step < 1000:
        world.step(DT)
        step += 1
    assert step * DT == pytest.approx(0.8811, abs=2 * DT)
    landed = world.balls.rows[ball, X] - world.balls.rows[ball, VX] * (step * DT - 0.8811287751579031)
    assert landed == pytest.approx(4.967941247868045 + 0.002, abs=5e-3)


def test_a_groove_tighter_than_the_disc_holds_it_at_two_places():
    x = np.linspace(-1.0, 1.0, 81)
    world, r = world_of(np.stack([x, 4.0 * x * x], axis=1)), 0.4
    ball = world.add_ball((0.1, 2.5), r, friction=0.5)
    run(world, 6.0)
    assert world.balls.pieces[ball, WEDGE] != FREE
    place = world.balls.rows[ball, [X, Y]].copy()
    run(world, 5.0)
    assert np.array_equal(world.balls.rows[ball, [X, Y]], place)
    assert place[0] == pytest.approx(0.0, abs=1e-3)  # a circle that touches y = 4 x² twice
    assert place[1] == pytest.approx(4.0 * r * r + 1.0 / 16.0, rel=1e-3)


def test_only_the_branch_it_rides_touches_it():
    """A loop whose way in and out cross: the ball comes out at the other side as fast as it came."""
    turns = np.linspace(0.0, 2.0 * math.pi, 120)[1:-1]
    loop = np.stack([np.sin(turns), 1.0 - np.cos(turns)], axis=1)
    run_in = np.stack([np.linspace(-4.0, 0.0, 80), np.zeros(80)], axis=1)
    world, r = world_of(np.concatenate([run_in, loop, run_in + np.array([4.0, 0.0])])), 0.1
    v = 7.0
    ball = seated(world, (-2.0, r), r, velocity=(v, 0.0), spin=-v / r, friction=1e6)
    run(world, 1.6)
    assert world.balls.rows[ball, X] > 1.0
    assert world.balls.rows[ball, VX] == pytest.approx(v, rel=1e-3)


def test_waves_at_fifty_metres_a_second():
    """It flies, lands, and never gets through; no impact gives it energy."""
    x = np.linspace(0.0, 100.0, 4001)
    world, r = world_of(np.stack([x, 0.1 * np.sin(2.0 * math.pi * x)], axis=1)), 0.2
    ball = world.add_ball((0.0, 0.35), r, (50.0, 0.0), friction=0.3)
    first = before = total(world)
    for _ in range(400):
        world.step(DT)
        now = total(world)
        assert now <= before + 1e-9 * before
        before = now
        place = world.balls.rows[ball, [X, Y]]
        if place[0] > 99.0:
            break
        assert place[1] > 0.1 * math.sin(2.0 * math.pi * place[0])
    assert place[0] > 20.0 and before < 0.9 * first


def test_a_track_dragged_under_a_disc_does_not_launch_it():
    world, r = world_of([(-3.0, 0.0), (0.0, 0.0), (3.0, 0.0)]), 0.2
    ball = seated(world, (-1.0, r), r, velocity=(1.0, 0.0), spin=-1.0 / r)
    fastest = 0.0
    for k in range(60):
        world.set_curves([Curve([(-3.0, 0.0), (0.0, 10.0 * DT * k * 0.1), (3.0, 0.0)])])
        world.step(DT)
        fastest = max(fastest, abs(world.balls.rows[ball, VY]))
    assert world.track_of(ball) == 0
    assert fastest < 2.0


@pytest.mark.parametrize("friction", [0.0, 1e6])
def test_spin_is_kept_without_friction_and_bound_with_much(friction):
    world, r = world_of(bowl(100)), 0.1
    ball = seated(world, (0.9, 1.0), r, friction=friction)
    world.balls.rows[ball, SPIN] = 7.0 if friction == 0.0 else 0.0
    run(world, 2.0)
    row = world.balls.rows[ball]
    if friction == 0.0:
        assert row[SPIN] == 7.0
    else:
        assert row[SPEED] + r * row[SPIN] == pytest.approx(0.0, abs=1e-9)
        assert row[ANGLE] != 0.0


@pytest.mark.parametrize("start", [0.02, -0.02])
def test_a_disc_larger_than_the_track_falls_off_its_tip(start):
    world = world_of([(0.0, 0.0), (0.0, 0.05)])
    ball = world.add_ball((start, 2.0), 1.0, friction=0.5)
    run(world, 3.0)
    x, y = world.balls.rows[ball, [X, Y]]
    assert y < -1.0 and x * start > 0.0
    assert np.isfinite(world.balls.rows).all()


def test_state_and_restore_give_equal_bits():
    world = world_of(bowl(60))
    world.add_ball((0.3, 1.4), 0.1, (1.0, 0.5), 3.0, friction=0.2, restitution=0.4)
    run(world, 0.5)
    kept = type(world.state())(*(array.copy() for array in world.state()))
    run(world, 1.0)
    first = world.balls.rows.copy()
    world.restore(kept)
    run(world, 1.0)
    assert first.tobytes() == world.balls.rows.tobytes()


@pytest.mark.parametrize(("points", "words"), [
    ([(0.0, 0.0)], "points"), ([(0.0, 0.0), (0.0, 0.0)], "two different"),
    ([(0.0, math.nan), (1.0, 0.0)], "finite"), ([(0.0, 0.0), (1e300, 0.0)], "finite"),
])  # fmt: skip
def test_nonsense_is_refused_in_one_line(points, words):
    with pytest.raises(ValueError, match=words) as found:
        TrackWorld([Curve(points)])
    assert "\n" not in str(found.value)


@pytest.mark.parametrize("options", [
    {"radius": 0.0}, {"radius": math.nan}, {"share": 0.0}, {"friction": -1.0}, {"restitution": 1.5},
    {"mass": 0.0},
])  # fmt: skip
def test_a_ball_of_nonsense_is_refused(options):
    given = {"radius": 0.1, **options}
    with pytest.raises(ValueError, match=next(iter(options))):
        TrackWorld().add_ball((0.0, 0.0), **given)


def test_a_ball_rolls_under_an_overhang_and_stays_there():
    """A slope of 30 degrees and a wall that leans over it by 26: both press, one from above."""
    slope, wall, r = math.radians(150.0), math.radians(116.0), 0.2  # directions from the corner, up
    ways = [np.array([math.cos(turn), math.sin(turn)]) for turn in (slope, wall)]
    world = world_of([3.0 * ways[0], -0.3 * ways[0]], [-0.1 * ways[1], 2.0 * ways[1]])
    middle = 0.5 * (slope + wall)
    rest = r / math.sin(0.5 * (slope - wall)) * np.array([math.cos(middle), math.sin(middle)])
    ball = world.add_ball(rest + 0.2 * ways[0] + (0.0, 0.01), r, friction=0.5)
    run(world, 0.7)
    assert world.balls.pieces[ball, WEDGE] != FREE
    place = world.balls.rows[ball, [X, Y]].copy()
    assert place == pytest.approx(rest, abs=1e-6)
    run(world, 0.1)
    assert np.array_equal(world.balls.rows[ball, [X, Y]], place)
    assert not world.balls.rows[ball, [VX, VY, SPIN]].any()


@pytest.mark.parametrize("degrees", [30.0, 34.0, 50.0])
def test_a_ball_rolls_into_a_corner_of_one_curve_and_not_through_it(degrees):
    """However sharp: its two places are then further apart along the curve than those of a loop."""
    angle, r = math.radians(degrees), 0.1
    world = world_of([(-1.0, 0.0), (2.0, 0.0), (2.0 - 3.0 * math.cos(angle), 3.0 * math.sin(angle))])
    deepest = 2.0 - r / math.tan(0.5 * angle)  # x of a ball that touches both sides
    ball = seated(world, (0.3, r), r, velocity=(1.0, 0.0), spin=-1.0 / r, friction=0.5)
    reached = -1.0
    for _ in range(400):
        world.step(DT)
        reached = max(reached, world.balls.rows[ball, X])
    assert reached == pytest.approx(deepest, abs=1e-6)
