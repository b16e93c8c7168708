"""The exact table as a whole: hard cases, conservation, reversal, symmetry, endless contacts, pockets."""

import itertools
import math

import numpy as np
import pytest

from game.billiards import Physics, SimulationError, Table, eight_ball_rack, make_shot, simulate, strike
from game.billiards.laws.contacts import BALL_MODELS, CUSHION_MODELS
from game.billiards.shot.physics import FRICTIONLESS
from game.billiards.simulation import FIRST_CAPACITY
from game.billiards.table.rack import BALL_MASS, BALL_RADIUS
from game.billiards.table.table import POCKET_NAMES
from tests.billiards.exact.exact_checks import audit, ball_hits, cushion_hits

R = BALL_RADIUS
POOL = Table.pool()
OPEN = Table.open()
MODELS = list(itertools.product(BALL_MODELS, CUSHION_MODELS))


def random_shot(n, seed):
    """n balls anywhere, one of them struck; the models go round with the seed."""
    rng = np.random.default_rng(seed)
    while True:
        places = rng.uniform((R, R), (POOL.width - R, POOL.length - R), (n, 2))
        gaps = np.hypot(*(places[:, None] - places[None]).transpose(2, 0, 1)) + 9.0 * np.eye(n)
        if gaps.min() > 2.0 * R:
            break
    tip = rng.uniform(-0.35, 0.35, 2)
    stroke = strike(rng.uniform(0.3, 4.5), rng.uniform(0.0, 2.0 * math.pi), rng.uniform(0.0, 0.6), *tip)
    shot = make_shot(POOL, places, physics=Physics(*MODELS[seed % len(MODELS)]))
    return shot.struck(0, stroke.velocity, stroke.spin)


def break_shot(seed, gap):
    """A break from the head spot, slightly off, with any spin."""
    rng = np.random.default_rng(seed)
    racked = eight_ball_rack(POOL, R, gap=gap, seed=seed if gap else None)
    tip = rng.uniform(-0.3, 0.3, 2)
    stroke = strike(5.2, 0.5 * math.pi + rng.uniform(-0.05, 0.05), 0.0, *tip)
    shot = make_shot(POOL, racked, physics=Physics(*MODELS[seed % len(MODELS)]))
    return shot.struck(0, stroke.velocity, stroke.spin)


def hold_invariants(shots):
    """Check each shot; return the largest number of events."""
    most = 0
    for shot in shots:
        trajectory = simulate(shot)
        found = audit(trajectory)
        scale = math.sqrt(2.0 * BALL_MASS * found.energy)
        assert found.overlap <= 1e-9 * R
        assert found.energy_rise <= 1e-13 * found.energy
        assert found.momentum_change <= 1e-13 * scale
        assert found.jump <= 1e-14
        assert (np.diff(trajectory.times) >= 0.0).all()
        on_bed = trajectory.end[trajectory.end[:, 9] != 4, :2]
        assert (on_bed > -R).all() and (on_bed < [POOL.width + R, POOL.length + R]).all()
        most = max(most, len(trajectory.times))
    return most


def test_random_shots_hold_the_invariants():
    assert 0 < hold_invariants(random_shot((2, 5, 9, 16)[k % 4], k) for k in range(400)) < 1000


@pytest.mark.compiled
def test_breaks_hold_the_invariants():
    gaps = (0.0, 1e-6, 1e-5, 1e-4, 1e-3)
    assert 0 < hold_invariants(break_shot(k, gaps[k % 5]) for k in range(100)) < 2000


@pytest.mark.compiled
@pytest.mark.slow
def test_ten_thousand_random_shots_hold_the_invariants(record_property):
    most = hold_invariants(random_shot((2, 5, 9, 16)[k % 4], k) for k in range(1_000, 11_000))
    record_property("largest number of events", most)
    assert most < 1000


@pytest.mark.compiled
@pytest.mark.slow
def test_two_thousand_breaks_hold_the_invariants(record_property):
    gaps = (0.0, 1e-6, 1e-5, 1e-4, 1e-3)
    most = hold_invariants(break_shot(k, gaps[k % 5]) for k in range(1_000, 3_000))
    record_property("largest number of events", most)
    assert most < 2000


@pytest.mark.compiled
def test_thin_breaks_end():
    """At a 45 degree cut others' simulators lose one break in 200 to contacts without end."""
    most = 0
    for k in range(200):
        racked = eight_ball_rack(POOL, R, gap=1e-6, seed=k)
        apex = racked[1:][np.argmin(racked[1:, 1])]
        way = 0.5 * math.pi + 1e-4 * k
        aim = math.pi / 4
        ghost = apex - 2.0 * R * np.array([math.cos(way + aim), math.sin(way + aim)])
        racked[0] = ghost - 0.6 * np.array([math.cos(way), math.sin(way)])
        shot = make_shot(POOL, racked).struck(0, (8.0 * math.cos(way), 8.0 * math.sin(way)))
        trajectory = simulate(shot)
        assert audit(trajectory).overlap <= 1e-9 * R
        most = max(most, len(trajectory.times))
    assert most < 2000


def test_three_events_of_a_carom_without_friction():
    """Two balls and two rails: times and places to fourteen digits."""
    places = [[0.6, 0.5], [0.615, 1.2], [1.12, 2.2]]
    shot = make_shot(Table.bare(1.27, 2.54), places, physics=FRICTIONLESS).struck(0, (0.0, 2.0))
    trajectory = simulate(shot, until=1.5)
    kinds = [(e.type, e.ids) for e in trajectory.events]
    assert kinds == [("ball-ball", ("0", "1")), ("ball-cushion", ("1", "3")), ("ball-cushion", ("0", "0"))]
    assert trajectory.times == pytest.approx(
        [0.322426813296247, 1.02665275282392, 1.45054212668299], rel=1e-13
    )
    state = trajectory.state_at(1.5)
    assert state.positions.ravel() == pytest.approx(
        [0.053626929465729, 1.30709736791472, 1.21147692946573, 1.62994736791472, 1.12, 2.2], rel=1e-12
    )
    assert state.velocities[:2].ravel() == pytest.approx(
        [0.506530665100637, 0.137778053333884, 0.506530665100637, -1.86222194666612], rel=1e-12
    )


def _gas(seed, until):
    """Nine balls on a bare table without any loss."""
    rng = np.random.default_rng(seed)
    table = Table.bare(1.27, 2.54)
    grid = np.array([(0.25 + 0.35 * a, 0.5 + 0.6 * b) for a in range(3) for b in range(3)])
    places = grid + rng.uniform(-0.05, 0.05, (9, 2))
    return make_shot(table, places, rng.uniform(-6.0, 6.0, (9, 2)), physics=FRICTIONLESS), until


def test_without_loss_energy_is_kept_and_time_can_be_turned_round():
    for seed in range(5):
        shot, until = _gas(seed, 0.6)
        there = simulate(shot, until=until)
        assert 10 < ball_hits(there) + cushion_hits(there) < 45
        middle = there.state_at(until)
        energy = (shot.balls[:, 2:4] ** 2).sum()
        assert (middle.velocities**2).sum() == pytest.approx(energy, rel=1e-14)
        back = simulate(
            make_shot(shot.table, middle.positions, -middle.velocities, physics=FRICTIONLESS), until=until
        )
        assert back.state_at(until).positions == pytest.approx(shot.positions, rel=0.0, abs=1e-9)
        assert back.state_at(until).velocities == pytest.approx(-shot.balls[:, 2:4], rel=0.0, abs=1e-8)


def test_energy_is_kept_over_two_hundred_contacts_without_loss():
    shot, until = _gas(7, 6.0)
    trajectory = simulate(shot, until=until)
    assert len(trajectory.times) > 200
    energy = (shot.balls[:, 2:4] ** 2).sum()
    assert (trajectory.state_at(until).velocities ** 2).sum() == pytest.approx(energy, rel=1e-14)


def test_a_trillionth_of_a_metre_grows_to_a_metre():
    shot, _ = _gas(3, 0.0)
    moved = shot.positions.copy()
    moved[0, 0] += 1e-12
    other = make_shot(shot.table, moved, shot.balls[:, 2:4], physics=FRICTIONLESS)
    apart = []
    for until in (0.1, 0.6, 8.0):
        ends = [simulate(s, until=until).state_at(until).positions for s in (shot, other)]
        apart.append(np.abs(ends[0] - ends[1]).max())
    assert apart[0] < 1e-9 and apart[0] < apart[1] < 1e-3 and apart[2] > 0.1


@pytest.mark.parametrize("gap", [0.0, 1e-4])
@pytest.mark.parametrize(("ball", "cushion"), MODELS[::3])
def test_a_symmetric_break_stays_symmetric_to_the_last_bit(ball, cushion, gap):
    racked = eight_ball_rack(POOL, R, gap=gap)
    shot = make_shot(POOL, racked, physics=Physics(ball, cushion)).struck(0, (0.0, 8.0), (-40.0, 0.0, 0.0))
    trajectory = simulate(shot)
    assert ball_hits(trajectory) > 10
    middle = 0.5 * POOL.width
    ends = [(x - middle, y, motion) for x, y, motion in trajectory.end[:, [0, 1, 9]].tolist()]
    left = sorted((-x, y, motion) for x, y, motion in ends if x < 0.0)
    right = sorted((x, y, motion) for x, y, motion in ends if x > 0.0)
    # moving the origin back to the corner of the table rounds the last place
    assert np.array(left) == pytest.approx(np.array(right), rel=0.0, abs=5e-16)


def test_one_ball_onto_two_at_once():
    height = math.sqrt(3.0) * R
    shot = make_shot(OPEN, [[-0.3, 0.0], [height, R], [height, -R]], physics=FRICTIONLESS).struck(
        0, (1.0, 0.0)
    )
    trajectory = simulate(shot, until=1.0)
    speeds = trajectory.state_at(1.0).velocities
    assert speeds[0] == pytest.approx([-0.2, 0.0], abs=1e-13)
    assert np.hypot(*speeds[1]) == pytest.approx(2.0 * math.sqrt(3.0) / 5.0, rel=1e-13)
    assert speeds[1].tolist() == [speeds[2, 0], -speeds[2, 1]]
    assert {frozenset(e.ids) for e in trajectory.events} == {frozenset("01"), frozenset("02")}


@pytest.mark.parametrize("balls", [2, 3, 5, 8])
def test_newtons_cradle_hands_the_speed_to_the_last_ball(balls):
    places = [[-0.3, 0.0]] + [[2.0 * R * k, 0.0] for k in range(balls)]
    trajectory = simulate(make_shot(OPEN, places, physics=FRICTIONLESS).struck(0, (1.4, 0.0)), until=1.0)
    speeds = trajectory.state_at(1.0).velocities[:, 0]
    assert speeds == pytest.approx([0.0] * balls + [1.4], abs=1e-12)


def test_a_cradle_on_cloth_ends_without_overlap():
    places = [[0.3, 1.0]] + [[0.6 + 2.0 * R * k, 1.0] for k in range(5)]
    for model in BALL_MODELS:
        shot = make_shot(OPEN, places, physics=Physics(model)).struck(0, (1.4, 0.0))
        trajectory = simulate(shot)
        assert audit(trajectory).overlap <= 1e-9 * R
        assert len(trajectory.times) < 2000
        assert np.argmax(trajectory.end[:, 0]) == 5 and np.ptp(trajectory.end[:, 1]) == 0.0


def test_a_ball_pressed_into_a_rail_by_its_own_spin_ends():
    """Strong topspin into the rail, little restitution: bounces that would go on for ever in finite time."""
    table = Table.bare(1.27, 2.54)
    for e in (0.0, 0.1, 0.3, 0.6):
        physics = Physics("elastic", "restitution", cushion_restitution=e)
        shot = make_shot(table, [[0.1, 1.0]], physics=physics).struck(0, (-0.5, 0.0), (0.0, -300.0, 0.0))
        trajectory = simulate(shot)
        assert len(trajectory.times) < 2000
        assert trajectory.segments[:, 1].min() > R - 1e-9 * R
        found = audit(trajectory)
        assert found.energy_rise <= 1e-15 * found.energy


def test_a_ball_pressed_into_a_corner_by_its_own_spin_ends():
    shot = make_shot(Table.bare(1.27, 2.54), [[0.1, 0.12]], physics=Physics("elastic", "restitution"))
    trajectory = simulate(shot.struck(0, (-0.5, -0.6), (250.0, -280.0, 0.0)))
    assert len(trajectory.times) < 1000
    assert trajectory.segments[:, 1:3].min() > R - 1e-9 * R


def test_a_ball_between_two_others_without_restitution_ends():
    """e = 0.1 and three balls in a line: in theory collisions without number."""
    places = [[0.0, 0.0], [2.0 * R + 0.01, 0.0], [4.0 * R + 0.011, 0.0]]
    shot = make_shot(
        OPEN,
        places,
        [(1.0, 0.0), (0.0, 0.0), (-1.0, 0.0)],
        physics=FRICTIONLESS._replace(ball_ball="frictional", ball_restitution=0.05),
    )
    trajectory = simulate(shot, until=5.0)
    assert len(trajectory.times) < 200
    assert audit(trajectory).overlap <= 1e-9 * R


def test_touching_balls_moving_apart_together_and_resting():
    pair = [[0.0, 0.0], [2.0 * R, 0.0]]
    for speed, hits in ((-1.0, 0), (1.0, 1)):
        trajectory = simulate(make_shot(OPEN, pair, physics=FRICTIONLESS).struck(0, (speed, 0.0)), until=1.0)
        assert ball_hits(trajectory) == hits
        assert hits == 0 or trajectory.times[0] == 0.0
    assert simulate(make_shot(OPEN, pair)).events == []


def test_two_contacts_at_the_same_moment_that_do_not_hang_together_both_happen():
    places = [[-0.5, 0.0], [0.0, 0.0], [-0.5, 1.0], [0.0, 1.0]]
    shot = make_shot(OPEN, places, [(1.0, 0.0), (0.0, 0.0), (1.0, 0.0), (0.0, 0.0)], physics=FRICTIONLESS)
    trajectory = simulate(shot, until=1.0)
    hits = [e for e in trajectory.events if e.type == "ball-ball"]
    assert [e.ids for e in hits] == [("0", "1"), ("2", "3")]
    assert hits[0].time == hits[1].time


def test_too_many_events_are_an_error_not_an_endless_loop():
    shot, until = _gas(1, math.inf)
    with pytest.raises(SimulationError, match="more than 50 events"):
        simulate(shot, until=until, max_events=50)


def test_a_log_that_is_too_small_grows():
    shot, _ = _gas(1, 0.0)
    trajectory = simulate(shot, until=100.0)
    assert len(trajectory.times) > FIRST_CAPACITY
    assert audit(trajectory).overlap <= 1e-9 * R


@pytest.mark.compiled
def test_many_balls():
    """Eighty balls: more than the bits of one number."""
    places = [[0.1 + 0.13 * (k % 9), 0.1 + 0.25 * (k // 9)] for k in range(80)]
    rng = np.random.default_rng(5)
    shot = make_shot(Table.bare(1.27, 2.54), places, rng.uniform(-2.0, 2.0, (80, 2)))
    found = audit(simulate(shot))
    assert found.overlap <= 1e-9 * R and found.energy_rise <= 1e-13 * found.energy


def test_balls_of_different_size_and_mass():
    for seed in range(20):
        rng = np.random.default_rng(seed)
        places = [[0.2 + 0.25 * (k % 4), 0.4 + 0.5 * (k // 4)] for k in range(12)]
        radii, masses = rng.uniform(0.02, 0.05, 12), rng.uniform(0.05, 1.0, 12)
        shot = make_shot(
            Table.bare(1.27, 2.54),
            places,
            rng.uniform(-3.0, 3.0, (12, 2)),
            radii=radii,
            masses=masses,
            physics=Physics("wallace-1988", "restitution"),
        )
        found = audit(simulate(shot))
        assert found.overlap <= 1e-9 * 0.02
        assert found.energy_rise <= 1e-13 * found.energy
        assert found.momentum_change <= 1e-12


def _mouth(pocket):
    """Middle of a pocket's mouth: between the two jaws nearest to it."""
    nearest = np.argsort(np.hypot(*(POOL.jaws[:, :2] - POOL.pockets[pocket, :2]).T))[:2]
    return POOL.jaws[nearest, :2].mean(axis=0)


@pytest.mark.parametrize("pocket", range(6), ids=POCKET_NAMES)
def test_a_ball_rolling_straight_at_a_pocket_goes_in(pocket):
    x, y = _mouth(pocket)
    for start in ([0.635, 1.0], [0.635, 1.27], [0.635, 1.6]):
        way = np.array([x, y]) - start
        way /= np.hypot(*way)
        velocity = 1.2 * way
        shot = make_shot(
            POOL, [start], [velocity], [(-velocity[1] / R, velocity[0] / R, 0.0)], motions=["rolling"]
        )
        trajectory = simulate(shot)
        assert [e.type for e in trajectory.events] == ["ball-pocket"]
        assert trajectory.events[0].ids == ("0", str(pocket)) and trajectory.final["0"] == "pocketed"


@pytest.mark.parametrize("pocket", [0, 1, 4, 5])
def test_a_ball_rolling_along_a_rail_drops_in_the_corner(pocket):
    x, y, _ = POOL.pockets[pocket]
    along_x = R if x < 0.0 else POOL.width - R
    direction = -1.0 if y < 0.0 else 1.0
    shot = make_shot(
        POOL,
        [[along_x, 1.27 + 0.3 * direction]],
        [(0.0, 1.5 * direction)],
        [(-1.5 * direction / R, 0.0, 0.0)],
        motions=["rolling"],
    )
    assert simulate(shot).final["0"] == "pocketed"


def test_a_ball_wide_of_the_mouth_rattles_in_the_jaws():
    hit = 0
    for off in np.linspace(-0.06, 0.06, 61):
        start = np.array([0.635, 0.9])
        way = np.array([-0.016 + off, -0.016 - off]) - start
        velocity = 2.0 * way / np.hypot(*way)
        trajectory = simulate(make_shot(POOL, [start]).struck(0, velocity))
        hit += "ball-jaw" in {e.type for e in trajectory.events}
    assert 5 < hit < 50


def test_a_ball_that_curves_out_of_a_mouth_meets_the_rail_beside_it():
    shot = make_shot(POOL, [[1.25, 1.3]]).struck(0, (-0.34, -2.38), (85.0, 65.0, 0.0))
    trajectory = simulate(shot)
    assert trajectory.segments[:, 1].max() <= 1.25
    rails = [e for e in trajectory.events if e.type == "ball-cushion"]
    assert rails and trajectory.state_at(rails[0].time).positions[0, 0] == pytest.approx(
        POOL.width - R, abs=1e-15
    )


def test_a_pocketed_ball_takes_no_further_part():
    shot = make_shot(POOL, [[0.3, 0.3], [0.6, 0.6]], [(-1.0, -1.0), (-1.0, -1.0)])
    trajectory = simulate(shot)
    assert trajectory.final == {"0": "pocketed", "1": "pocketed"}
    times = {e.ids[0]: e.time for e in trajectory.events if e.type == "ball-pocket"}
    assert all(e.time <= times[e.ids[0]] for e in trajectory.events)
    end = trajectory.state_at(trajectory.end_time)
    assert not end.velocities.any() and not end.spins.any()


def test_equal_input_equal_bits():
    one, other = (simulate(break_shot(3, 1e-4)) for _ in range(2))
    assert one.digest == other.digest
    assert one.digest != simulate(break_shot(4, 1e-4)).digest


@pytest.mark.parametrize("speed", [1e-9, 1e-3, 100.0, 5000.0])
def test_absurd_speeds_stay_finite(speed):
    places = [[0.4, 0.4], [0.5, 1.2], [0.8, 2.0]]
    shot = make_shot(Table.bare(1.27, 2.54), places).struck(
        0, (0.6 * speed, 0.8 * speed), (10.0 * speed, 0.0, speed)
    )
    trajectory = simulate(shot, max_events=100_000)
    assert np.isfinite(trajectory.end).all()
    assert audit(trajectory).overlap <= 1e-9 * R


@pytest.mark.parametrize("friction", [0.05, 2.0, 50.0])
def test_friction_shared_by_many_contacts_at_once_gives_no_energy(friction):
    """A ball that spins falls into a nest of five small heavy ones: each contact gets its share, not all."""
    physics = Physics("wallace-1988", ball_friction=friction, ball_restitution=0.5)
    radii, masses = [R, *[0.3 * R] * 5], [BALL_MASS, *[10.0 * BALL_MASS] * 5]
    reach = 2.0 * math.sqrt(0.3) * R
    nest = [(reach * math.cos(turn), reach * math.sin(turn)) for turn in np.radians(33.0) * np.arange(-2, 3)]
    shot = make_shot(OPEN, [(0.0, 0.0), *nest], radii=radii, masses=masses, physics=physics)
    shot = shot.struck(0, (2.0, 0.0), (30.0, -20.0, 300.0))
    trajectory = simulate(shot, until=0.5)
    assert (trajectory.rows[:5, 0] == 0.0).all() and (trajectory.rows[:5, 1] == 0).all(), "all at once"
    after = trajectory.state_at(0.0)

    def energy(velocities, spins):
        turning = 0.4 * np.square(radii) * (spins**2).sum(axis=1)
        return float((0.5 * np.array(masses) * ((velocities**2).sum(axis=1) + turning)).sum())

    assert energy(after.velocities, after.spins) < energy(shot.balls[:, 2:4], shot.balls[:, 4:7])
