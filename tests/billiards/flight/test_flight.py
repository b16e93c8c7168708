"""Balls in the air: parabola, bounces, what they meet, and the end of it, against closed forms."""

import itertools
import json
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from game.billiards import Physics, ShotError, Table, make_shot, simulate, simulate_many, strike
from game.billiards.laws.state import (
    BALL_OFF,
    BALL_SLATE,
    LANDING_SPEED,
    SLIDING_ROLLING,
)
from game.billiards.shot.impacts import heard_impacts
from game.billiards.shot.paths import Paths
from game.billiards.shot.shot_file import parse_shot
from game.billiards.shot.shot_writing import shot_data
from game.billiards.table.table import checked_table
from game.lab.benchmarks.billiards import break_shot, random_shots
from tests.billiards.flight.flights import (
    OPEN,
    POOL,
    SMOOTH,
    G,
    R,
    events,
    hits,
    kinds,
    play,
    put,
    thrown,
    with_flight_kernel,
)

# to a thousandth: plain Python warns where a machine divides by the smallest numbers there are
speeds = st.integers(-3000, 3000).map(lambda n: 0.001 * n)
falls = st.integers(-4000, -100).map(lambda n: 0.001 * n)
turns = st.integers(-80, 80).map(float)


def test_a_flight_is_a_parabola_with_its_apex_and_range():
    up, along = 1.7, 0.9
    trajectory = play(thrown((along, 0.0, up), 0.1, physics=SMOOTH), until=2.0)
    apex = up / G
    assert trajectory.heights_at(apex)[0] == pytest.approx(0.1 + up * up / (2.0 * G), rel=1e-14)
    landing = (up + math.sqrt(up * up + 2.0 * G * 0.1)) / G
    assert hits(trajectory, BALL_SLATE)[0] == pytest.approx(landing, rel=1e-14)
    assert trajectory.state_at(landing).positions[0, 0] == pytest.approx(0.6 + along * landing, rel=1e-14)


def test_spin_is_kept_in_the_air():
    shot = thrown((0.5, 0.2, 2.0), 0.05, (30.0, -20.0, 50.0))
    trajectory = play(shot)
    assert trajectory.state_at(0.3).spins[0].tolist() == [30.0, -20.0, 50.0]
    turned = trajectory.orientations_at(0.3)[0]
    assert math.acos(0.5 * (np.trace(turned) - 1.0)) == pytest.approx(
        abs((0.3 * math.sqrt(3800.0) + math.pi) % (2.0 * math.pi) - math.pi), abs=1e-9
    )


def test_the_bounces_are_a_geometric_series_that_ends():
    e, drop = 0.5, 0.3
    trajectory = play(thrown((0.0, 0.0, 0.0), drop))
    times = hits(trajectory, BALL_SLATE)
    speed = math.sqrt(2.0 * G * drop)
    expected, t = [], speed / G
    while True:
        expected.append(t)
        speed *= e
        if speed <= LANDING_SPEED:
            break
        t += 2.0 * speed / G
    assert times == pytest.approx(expected, rel=1e-13)
    # all bounces would end at sqrt(2 h/g) (1 + e)/(1 - e); what was cut off is less than the last hop
    whole = math.sqrt(2.0 * drop / G) * (1.0 + e) / (1.0 - e)
    assert 0.0 < whole - times[-1] <= 2.0 * LANDING_SPEED / G / (1.0 - e)
    assert trajectory.end_time == times[-1] or kinds(trajectory)[-1] == "ball-slate"


@pytest.mark.parametrize("restitution", [0.0, 0.99, 1.0])
def test_bounces_end_whatever_the_slate_gives_back(restitution):
    shot = thrown((0.3, 0.0, 0.0), 0.02, physics=Physics(slate_restitution=restitution))
    trajectory = play(shot, until=20.0)
    if restitution < 1.0:
        assert len(hits(trajectory, BALL_SLATE)) < 400 and trajectory.heights_at(20.0)[0] == 0.0
    else:
        t = math.sqrt(2.0 * 0.02 / G)
        assert hits(trajectory, BALL_SLATE) == pytest.approx(t * (1 + 2 * np.arange(157)), rel=1e-9)


@given(
    st.tuples(speeds, speeds, falls),
    st.tuples(turns, turns, turns),
)
@settings(max_examples=40, deadline=None)
def test_a_bounce_obeys_coulomb_and_keeps_the_velocity_at_which_the_ball_will_roll(velocity, spin):
    physics = Physics()
    trajectory = play(thrown(velocity, 1e-6, spin, physics=physics), until=0.01)
    before = np.array([*velocity])
    t = hits(trajectory, BALL_SLATE)[0]
    fall = velocity[2] - G * t
    after = trajectory.segments[1]
    rise = float(after[13])
    assert rise == pytest.approx(-0.5 * fall if -0.5 * fall > LANDING_SPEED else 0.0, rel=1e-12)
    pressed = rise - fall
    dv = after[3:5] - before[:2]
    slip = np.array([before[0] - R * spin[1], before[1] + R * spin[0]])
    new_slip = np.array([after[3] - R * after[6], after[4] + R * after[5]])
    size = float(np.hypot(*slip))
    assert np.hypot(*dv) == pytest.approx(min(0.2 * pressed, 2.0 / 7.0 * size), rel=1e-9, abs=1e-12)
    if size > 1e-6:
        assert dv @ slip <= 0.0 and abs(dv[0] * slip[1] - dv[1] * slip[0]) < 1e-9 * size
        assert new_slip @ slip >= -1e-9
    roll = (5.0 * before[:2] + 2.0 * R * np.array([spin[1], -spin[0]])) / 7.0
    assert (5.0 * after[3:5] + 2.0 * R * np.array([after[6], -after[5]])) / 7.0 == pytest.approx(
        roll, abs=1e-12
    )
    lost = 2.5 * physics.spinning * pressed / R
    assert after[7] == pytest.approx(math.copysign(max(abs(spin[2]) - lost, 0.0), spin[2]), abs=1e-9)


@given(
    st.tuples(speeds, speeds, speeds),
    st.floats(-1.4, 1.4),
    st.floats(-math.pi, math.pi),
    st.floats(0.5, 2.0),
    st.floats(0.5, 2.0),
)
@settings(max_examples=60, deadline=None)
def test_two_balls_in_the_air_keep_momentum_spin_and_the_law_of_restitution(velocity, tilt, turn, mass, size):
    """Ball 1 rests high up for the moment; ball 0 is put at a gap from it and flung at it."""
    n = np.array([math.cos(tilt) * math.cos(turn), math.cos(tilt) * math.sin(turn), math.sin(tilt)])
    v = np.array(velocity) + 2.0 * n
    if v @ n < 0.2:
        return
    radii, masses = (R, size * R), (0.17, mass * 0.17)
    centre = np.array([0.0, 0.0, 3.0])
    gap = 1e-9
    place = centre - (radii[0] + radii[1] + gap) * n
    shot = make_shot(OPEN, [place[:2], centre[:2] + 5.0], radii=radii, masses=masses)
    shot = shot.in_air(0, v, place[2] - radii[0], (40.0, 5.0, -30.0))
    shot = put(shot.in_air(1, (0.0, 0.0, 0.0), centre[2] - radii[1]), 1, centre[:2])
    trajectory = simulate(shot, until=1e-4)
    assert kinds(trajectory)[:1] == ["ball-ball"]
    a, b = trajectory.segments[2], trajectory.segments[3]
    a, b = (a, b) if a[10] == 0 else (b, a)
    t = a[0]
    n = b[[1, 2, 12]] - a[[1, 2, 12]] + np.array([0.0, 0.0, radii[1] - radii[0]])
    n /= np.linalg.norm(n)
    old = (v - (0, 0, G * t), np.array([0.0, 0.0, -G * t]))
    new = (np.array([a[3], a[4], a[13]]), np.array([b[3], b[4], b[13]]))
    assert sum(m * u for m, u in zip(masses, new, strict=True)) == pytest.approx(
        sum(m * u for m, u in zip(masses, old, strict=True)), abs=1e-13
    )
    assert (new[1] - new[0]) @ n == pytest.approx(0.95 * (old[0] - old[1]) @ n, rel=1e-6)
    spins = (np.array(a[5:8]), np.array(b[5:8]))
    # the friction's torque turns both alike: I dw is R times the tangential impulse, crossed with n
    push = masses[0] * (new[0] - old[0])
    across = np.cross(n, push)
    for k, began in ((0, np.array([40.0, 5.0, -30.0])), (1, np.zeros(3))):
        inertia = 0.4 * masses[k] * radii[k] ** 2
        assert inertia * (spins[k] - began) == pytest.approx(radii[k] * across, abs=1e-8)
    energy = sum(
        0.5 * m * (u @ u) + 0.2 * m * r * r * (w @ w)
        for m, r, u, w in zip(masses, radii, new, spins, strict=True)
    )
    start = 0.5 * masses[0] * (old[0] @ old[0]) + 0.5 * masses[1] * (old[1] @ old[1])
    start += 0.2 * masses[0] * radii[0] ** 2 * (1600 + 25 + 900)
    assert energy <= start + 1e-12


def test_a_ball_clears_another_by_a_tenth_of_a_millimetre_and_just_does_not():
    """The apex over the other ball's top: centres 2 R apart when the height is 2 R."""
    for spare, kind in ((1e-4, "ball-slate"), (-1e-4, "ball-ball")):
        height = 2.0 * R + spare
        up = math.sqrt(2.0 * G * (height - 1e-3))
        along = 2.0
        trajectory = play(thrown((along, 0.0, up), 1e-3, others=[(0.6 + along * up / G, 0.6)]), until=3.0)
        assert kinds(trajectory)[0] == kind
        if kind == "ball-slate":
            assert not len(hits(trajectory))


def test_a_ball_comes_down_on_another_and_presses_it_on_the_slate():
    shot = put(thrown((0.05, 0.0, 0.0), 0.2, others=[(0.8, 0.6)]), 1, (0.61, 0.6))
    trajectory = play(shot, until=20.0)
    assert kinds(trajectory)[0] == "ball-ball"
    assert trajectory.heights_at(20.0).tolist() == [0.0, 0.0]
    apart = np.linalg.norm(np.subtract(*trajectory.end[:, :2]))
    assert apart > 2.0 * R - 1e-9


@pytest.mark.parametrize(("aside", "restitution"), [(1e-9, 0.95), (1e-3, 0.95), (1e-4, 0.2)])
def test_a_ball_that_comes_down_near_the_top_of_another_slides_off(aside, restitution):
    """With little restitution its bounces have died out long before it is off, but for the least one."""
    physics = Physics(ball_restitution=restitution)
    thrown_on = thrown((0.0, 0.0, 0.0), 0.1, physics=physics, others=[(0.8, 0.6)])
    trajectory = play(put(thrown_on, 1, (0.6 + aside, 0.6)), until=30.0)
    assert "off the table" not in trajectory.final.values()
    assert trajectory.heights_at(30.0).tolist() == [0.0, 0.0]
    assert trajectory.end[0, 0] <= trajectory.end[1, 0] - 2.0 * R + 1e-9  # to the side where it came down


def test_a_ball_balanced_on_another_never_rests_on_the_bed():
    shot = put(thrown((0.0, 0.0, 0.0), 0.1, others=[(0.8, 0.6)]), 1, (0.6, 0.6))
    assert simulate(shot).final == {"0": "off the table", "1": (0.6, 0.6)}


def test_two_balls_in_the_air_meet():
    shot = make_shot(OPEN, [(0.0, 0.5), (1.0, 0.5)])
    shot = shot.in_air(0, (2.0, 0.0, 2.0), 0.05).in_air(1, (-2.0, 0.0, 2.0), 0.05)
    trajectory = play(shot)
    time, kind, _, _ = events(trajectory)[0]
    meets = (1.0 - 2.0 * R) / 4.0
    assert kind == "ball-ball" and time == pytest.approx(meets, rel=1e-13)
    assert trajectory.heights_at(time) == pytest.approx([0.05 + 2.0 * meets - 0.5 * G * meets**2] * 2)


def test_the_edge_of_a_nose_is_met_where_a_quartic_says():
    """A ball that falls past the edge: gap^2 + (z + R - h)^2 = R^2 at the contact, in the air above h."""
    table = Table.bare(1.27, 2.54)
    trajectory = play(thrown((-1.0, 0.0, 0.0), 0.08, table=table, at=(0.1, 1.0)), until=5.0)
    t, kind, _, cushion = events(trajectory)[0]
    assert (kind, cushion) == ("ball-cushion", 0)
    x = trajectory.state_at(t).positions[0, 0]
    above = 0.08 - 0.5 * G * t * t + R - table.cushion_height
    assert above > 0.0 and math.hypot(x, above) == pytest.approx(R, abs=1e-12)


def test_a_ball_low_enough_meets_the_wall_as_it_would_on_the_slate():
    """The law of the nose passes into Han's as the hop vanishes."""
    table = Table.bare(1.27, 2.54)
    velocity, spin = (-1.3, 0.4), (3.0, -20.0, 15.0)
    place = (R + 1e-9, 1.0)
    rolled = simulate(make_shot(table, [place]).struck(0, velocity, spin))
    flown = simulate(make_shot(table, [place]).in_air(0, (*velocity, 0.0), 1e-9, spin), until=0.1)
    for trajectory in (rolled, flown):
        assert kinds(trajectory)[0] == "ball-cushion"
    after_roll, after_flight = rolled.segments[1], flown.segments[1]
    assert after_flight[3:5] == pytest.approx(after_roll[3:5], abs=1e-7)
    assert after_flight[5:8] == pytest.approx(after_roll[5:8], abs=1e-4)


@pytest.mark.parametrize(("height", "ends"), [(0.12, "off"), (0.03, "on")])
def test_a_ball_leaves_the_table_if_it_is_high_enough_over_the_cushion(height, ends):
    trajectory = play(thrown((-3.0, 0.0, 0.0), height, table=POOL, at=(0.1, 0.8)))
    off = len(hits(trajectory, BALL_OFF)) == 1
    assert off == (ends == "off")
    if off:
        assert trajectory.final["0"] == "off the table"
        edge = (0.1 + 0.119) / 3.0
        assert hits(trajectory, BALL_OFF)[0] == pytest.approx(edge, rel=1e-12) or "ball-rail-top" in kinds(
            trajectory
        )


def test_a_ball_that_stays_on_top_of_a_rail_is_off_the_table():
    trajectory = play(thrown((0.0, 0.0, 0.0), 0.12, table=POOL, at=(-0.05, 0.8)))
    assert set(kinds(trajectory)) == {"ball-rail-top", "ball-off-table"}
    assert trajectory.final["0"] == "off the table"
    fall = math.sqrt(2.0 * (0.12 - POOL.cushion_height) / G)
    assert events(trajectory)[0][0] == pytest.approx(fall, rel=1e-12)


def test_a_ball_comes_back_from_the_top_of_a_rail():
    trajectory = play(thrown((0.5, 0.0, 0.0), 0.12, table=POOL, at=(-0.1, 0.8)), until=20.0)
    assert kinds(trajectory)[0] == "ball-rail-top" and kinds(trajectory)[-1] != "ball-off-table"
    x, _ = trajectory.final["0"]
    assert R <= x <= POOL.width - R and "ball-slate" in kinds(trajectory)


@pytest.mark.parametrize(
    ("height", "speed", "ends"),
    [(0.05, 0.3, "pocketed"), (0.01, 4.0, "pocketed"), (0.4, 1.5, "off the table")],
)
def test_a_pocket_takes_what_is_low_enough_over_it(height, speed, ends):
    """From the middle of the bed towards the corner: falling in, stopped by its back, too high."""
    x, y, _ = POOL.pockets[0].tolist()
    s = speed / math.sqrt(2.0)
    shot = thrown((-s, -s, 0.0), height, table=POOL, at=(x + 0.09, y + 0.09))
    assert play(shot).final["0"] == ends


@pytest.mark.parametrize(("up", "ends"), [(1.0, "ball-slate"), (0.2, "ball-pocket")])
def test_a_ball_over_a_hole_falls_in_only_where_it_comes_down(up, ends):
    nothing = np.empty((0, 3))
    table = checked_table(2.0, 2.0, 0.0, np.empty((0, 6)), nothing, np.array([[0.8, 0.6, 0.05]]))
    trajectory = play(thrown((1.0, 0.0, up), 0.1, table=table, at=(0.6, 0.6)), until=0.5)
    time, kind, _, _ = events(trajectory)[0]
    assert kind == ends and time == pytest.approx((up + math.sqrt(up * up + 0.2 * G)) / G, rel=1e-13)


@pytest.mark.parametrize("jaw", range(12))
def test_the_rim_of_a_jaw_is_met_at_its_distance(jaw):
    x, y, r = POOL.jaws[jaw].tolist()
    middle = (0.5 * POOL.width, 0.5 * POOL.length)
    away = np.array([middle[0] - x, 0.4 * (middle[1] - y)])
    away /= np.hypot(*away)
    start = np.array([x, y]) + (r + 0.06) * away
    trajectory = play(thrown((*(-1.0 * away), 0.0), 0.03, table=POOL, at=start), until=3.0)
    t, kind, _, which = events(trajectory)[0]
    if kind == "ball-jaw" and which == jaw:
        px, py = trajectory.state_at(t).positions[0]
        above = trajectory.heights_at(t)[0] + R - POOL.cushion_height
        across = math.hypot(px - x, py - y) - r
        assert above > 0.0 and math.hypot(across, above) == pytest.approx(R, abs=1e-10)
    else:
        assert kind == "ball-cushion"  # the nose beside it comes first


def test_a_hard_contact_with_a_cushion_makes_a_ball_hop_if_the_table_says_so():
    table = Table.bare(1.27, 2.54)
    for hop in (0.0, 0.3, 1.0):
        shot = make_shot(table, [(0.5, 0.6)], physics=Physics(cushion_hop=hop)).struck(0, (-4.0, 0.0))
        trajectory = play(shot)
        tops = [trajectory.heights_at(t)[0] for t in np.linspace(0.0, 1.0, 400)]
        assert (max(tops) > 0.0) == (hop > 0.0)
    # Han's vertical impulse of a ball that slides without spin into the nose, e = 0.85, mu = 0.2
    first = next(row for row in trajectory.segments if row[11] == 6.0)
    sine = table.cushion_height / R - 1.0
    arrives = trajectory.segments[np.flatnonzero(trajectory.segments[:, 11] == 6.0)[0] - 1]
    t = first[0] - arrives[0]
    speed = -(arrives[3] + 2.0 * t * arrives[8])
    wy = arrives[6] - 5.0 * t * arrives[8] / R
    cosine = math.sqrt(1.0 - sine * sine)
    normal = 1.85 * speed * cosine
    slip = speed * sine - R * wy  # of Han's sx, with y the other way round
    rubbed = math.copysign(min(abs(slip) * 2.0 / 7.0, 0.2 * normal), slip)
    down = abs(rubbed * cosine - normal * sine) if rubbed * cosine < normal * sine else None
    assert down is not None and first[13] == pytest.approx(0.5 * down, rel=1e-9)


def test_what_does_not_hop_comes_out_the_same_to_the_last_bit():
    """The kernel for flights on shots without one."""
    for shot in (break_shot(1e-4), break_shot(0.0), *random_shots(5)[:40]):
        plain = simulate(shot)
        flown = simulate(with_flight_kernel(shot))
        assert flown.digest == plain.digest
        assert np.array_equal(flown.segments[:, :12], plain.segments)
        assert not flown.segments[:, 12:].any() and not flown.end[:, 11:].any()


def test_flying_shots_among_others_in_a_batch_are_the_same():
    rolls = make_shot(POOL, [(0.6, 0.6), (0.6, 1.0)]).struck(0, (0.1, 2.0))
    jumps = rolls.struck(0, (0.1, 2.0, -2.0))
    assert not rolls.flies and jumps.flies
    many = simulate_many([jumps, rolls, jumps], threads=1)
    for shot, rows in zip((jumps, rolls, jumps), many.rows, strict=True):
        assert np.array_equal(simulate(shot).rows, rows)


def test_vertical_speed_is_left_out_where_balls_do_not_fly_or_hardly_would():
    off = make_shot(POOL, [(0.6, 0.6)], physics=Physics(airborne=False))
    assert simulate(off.struck(0, (0.0, 2.0, -3.0))).digest == simulate(off.struck(0, (0.0, 2.0))).digest
    on = make_shot(POOL, [(0.6, 0.6)])
    assert not on.struck(0, (0.0, 2.0, -1.99 * LANDING_SPEED)).flies
    assert on.struck(0, (0.0, 2.0, -2.01 * LANDING_SPEED)).flies
    assert simulate(on.struck(0, (0.0, 2.0))).digest == simulate(off.struck(0, (0.0, 2.0))).digest
    with pytest.raises(ShotError, match="all balls stay down"):
        off.in_air(0, (0.0, 0.0, 0.0), 0.1)
    with pytest.raises(ShotError, match="height"):
        on.in_air(0, (0.0, 0.0, 0.0), -0.1)


@pytest.mark.parametrize(
    ("left", "up", "elevation"), [(0.3, 0.1, 60.0), (-0.4, -0.2, 75.0), (0.2, -0.4, 45.0)]
)
def test_a_masse_ends_along_the_line_of_coriolis(left, up, elevation):
    """From where the ball rests to where the line of the cue meets the cloth (Alciatore, TP A.19)."""
    raised = math.radians(elevation)
    struck = strike(2.5, 0.5 * math.pi, raised, left, up, cue_end_mass=None)
    shot = make_shot(OPEN, [(0.0, 0.0)]).struck(0, struck.pressed(raised), struck.spin)
    assert shot.flies
    trajectory = play(shot)
    roll = trajectory.rows[:, 1] == SLIDING_ROLLING
    velocity = trajectory.state_at(float(trajectory.rows[roll, 0][-1])).velocities[0]
    # the cue points along y and down; its line goes through the tip's place on the ball
    c = math.sqrt(1.0 - left * left - up * up)
    tip = R * np.array(
        [-left, -c * math.cos(raised) + up * math.sin(raised), c * math.sin(raised) + up * math.cos(raised)]
    )
    along = np.array([0.0, math.cos(raised), -math.sin(raised)])
    aim = tip + along * (tip[2] + R) / math.sin(raised)
    assert velocity[0] * aim[1] - velocity[1] * aim[0] == pytest.approx(0.0, abs=1e-12)
    assert velocity @ aim[:2] > 0.0


@given(st.integers(0, 2**31))
@settings(max_examples=30, deadline=None)
def test_wild_flights_end_with_all_balls_somewhere(seed):
    """Six balls flung about a pool table, hops off cushions included: no overlap, no energy gained."""
    generator = np.random.default_rng(seed)
    places = [(0.2 + 0.2 * k, 0.4 + 0.3 * k) for k in range(5)]
    shot = make_shot(POOL, [*places, (0.3, 2.0)], physics=Physics(cushion_hop=1.0))
    for ball in range(6):
        velocity = generator.uniform(-4.0, 4.0, 3)
        shot = shot.in_air(
            ball, velocity, float(generator.uniform(0.01, 0.3)), generator.uniform(-100, 100, 3)
        )
    trajectory = play(shot, until=60.0)
    assert np.isfinite(trajectory.end).all() and not trajectory.heights_at(trajectory.end_time).any()
    for x, y in (place for place in trajectory.final.values() if not isinstance(place, str)):
        assert -0.12 < x < POOL.width + 0.12 and -0.12 < y < POOL.length + 0.12


def test_a_shot_file_keeps_heights_and_restitutions_to_the_last_bit():
    physics = Physics(slate_restitution=0.6, cushion_hop=0.25)
    shot = make_shot(POOL, [(0.6, 0.6), (0.3, 1.0), (0.9, 1.5)], physics=physics)
    shot = shot.struck(0, (0.1, 2.0, -2.0)).in_air(1, (1.0, 0.5, 0.3), 0.2, (1.0, 2.0, 3.0))
    again = parse_shot(json.loads(json.dumps(shot_data(shot))))
    assert again.physics == physics and again.flies
    # places are kept from the table's corner, and come back to it within a last place
    assert again.balls == pytest.approx(shot.balls, rel=0.0, abs=1e-15)
    assert simulate(again).events[0] == simulate(shot).events[0]
    data = shot_data(shot)
    data["balls"][1]["height"] = -0.1
    with pytest.raises(ShotError, match=r"balls\[1\].height"):
        parse_shot(data)
    data["balls"][1] = {**data["balls"][1], "height": 0.1, "motion": "airborne"}
    with pytest.raises(ShotError, match=r"balls\[1\].motion"):
        parse_shot(data)


def test_landings_are_heard_as_hard_as_the_ball_falls():
    shot = make_shot(POOL, [(0.6, 0.6)]).struck(0, (0.0, 0.8, -2.0))
    heard = list(heard_impacts(simulate(shot)))
    expected = [2.0 * 0.5**k for k in range(6)]
    assert [one.code for one in heard] == [BALL_SLATE] * 6
    assert [one.speed for one in heard] == pytest.approx(expected, rel=1e-9)


def test_the_path_is_cut_into_flights_and_what_lies_between():
    shot = make_shot(POOL, [(0.6, 0.6)]).struck(0, (0.3, 0.8, -2.0))
    trajectory = simulate(shot)
    paths = Paths(trajectory)
    end = trajectory.end_time
    flights, rolls = paths.in_air(0, 0.0, end, G), paths.on_cloth(0, 0.0, end)
    assert len(flights) == len(hits(trajectory, BALL_SLATE)) - 1 and len(rolls) == 1
    assert flights[0][:, 2].max() == pytest.approx(1.0 / (2.0 * G), rel=1e-9)
    for one, other in itertools.pairwise(flights):
        assert one[-1] == pytest.approx(other[0], abs=1e-12)
    assert rolls[0][0] == pytest.approx(flights[-1][-1, :2], abs=1e-12)
    assert rolls[0][-1] == pytest.approx(trajectory.end[0, :2], abs=1e-12)
    assert paths.in_air(0, 0.05, 0.1, G)[0][0, 2] == pytest.approx(0.05 - 0.5 * G * 0.05**2, rel=1e-9)
