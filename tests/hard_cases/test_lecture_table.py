"""The lecture's table in its hard cases: tunnelling, grazing, corners, racks, cradles, wedges."""

import math

import numpy as np
import pytest

from game.billiards.lecture.settings import lecture_settings
from game.billiards.lecture.state import BALL_COLLISIONS, LECTURE_EFFECTS, WALLS
from game.billiards.lecture.table import LectureTable
from game.billiards.table.rack import BALL_RADIUS as R
from game.billiards.table.rack import eight_ball_rack
from game.billiards.table.table import Table

EPS = 2.0**-52
FRAME = 1.0 / 60.0
NO_LOSS = {"bounce": 1.0, "restitution": 1.0, "friction": 1.0, "minimum_speed": 0.0}
AS_LECTURED = {
    "order": "pairwise",
    "substeps": 1,
    "passes": 1,
    "repositioning": "clamp",
    "walls_again": False,
}
COLLISIONS = WALLS | BALL_COLLISIONS


def table_with(positions, velocities=None, table=None, radii=R, masses=1.0, effects=COLLISIONS, **declared):
    """A bare table 1.27 x 2.54 m unless another is given, no friction, nothing lost."""
    settings = lecture_settings(**{**NO_LOSS, **declared})
    table = Table.bare(1.27, 2.54) if table is None else table
    return LectureTable(table, positions, radii, masses, velocities, effects, settings)


def head_on(speed, start, dt, **declared):
    """True if a ball that starts `start` m before contact passes on its momentum."""
    balls = table_with(
        [[0.5, 0.6], [0.5, 0.6 + 2 * R + start]],
        [[0, speed], [0, 0]],
        Table.open(),
        effects=BALL_COLLISIONS,
        **declared,
    )
    for _ in range(math.ceil(0.4 / (speed * dt)) + 1):
        balls.step(dt)
    return balls.velocities[1, 1] > 0.5 * speed


@pytest.mark.parametrize("dt", [1 / 60, 1 / 240])
def test_tunnelling_begins_at_two_radii_a_step(dt):
    limit = 2.0 * R / dt
    starts = np.linspace(0.0, limit * dt, 40, endpoint=False) + 1e-6
    below = [head_on(0.99 * limit, start, dt, **AS_LECTURED) for start in starts]
    above = [head_on(1.8 * limit, start, dt, **AS_LECTURED) for start in starts]
    assert all(below)
    assert not all(above)


@pytest.mark.parametrize("order", ["joint", "pairwise"])
def test_automatic_substeps_do_not_tunnel(order):
    starts = np.linspace(0.0, 0.17, 20) + 1e-6
    assert all(head_on(speed, start, FRAME, order=order) for speed in (8.0, 40.0) for start in starts)


def share_of_hits_missed(speed, dt, shots, seed):
    """Shots with the impact parameter spread evenly over [0, 2 R] and random phase."""
    rng = np.random.default_rng(seed)
    across = 2.0 * R * (np.arange(shots) + rng.random(shots)) / shots
    missed = 0
    for b, phase in zip(across, rng.random(shots), strict=True):
        balls = table_with(
            [[0.0, 0.0], [b, 0.2]],
            [[0.0, speed], [0.0, 0.0]],
            Table.open(),
            effects=BALL_COLLISIONS,
            **AS_LECTURED,
        )
        balls.state.offsets[0, 1] += speed * dt * phase
        for _ in range(math.ceil(0.4 / (speed * dt))):
            balls.step(dt)
        missed += not balls.velocities[1].any()
    return missed / shots


@pytest.mark.parametrize(("speed", "dt"), [(3.0, 1 / 60), (3.0, 1 / 240), (8.0, 1 / 60)])
def test_grazing_hits_are_missed_as_the_formula_says(speed, dt):
    d, c = 2.0 * R, speed * dt
    if c < d:
        b0 = math.sqrt(d * d - c * c)
        expected = 1.0 - b0 / (2.0 * d) - d / (2.0 * c) * math.acos(b0 / d)
    else:
        expected = 1.0 - math.pi * d / (4.0 * c)
    shots = 1200
    # stratified in the impact parameter, so the spread is at most that of independent shots
    bound = 4.0 * math.sqrt(expected * (1.0 - expected) / shots)
    assert abs(share_of_hits_missed(speed, dt, shots, seed=3) - expected) < bound


@pytest.mark.parametrize(("repositioning", "place"), [("exact", 0.906), ("mirror", 0.89), ("clamp", 0.97)])
@pytest.mark.parametrize("order", ["joint", "pairwise"])
def test_overshoot_at_a_wall(repositioning, place, order):
    declared = {**NO_LOSS, "bounce": 0.8}
    balls = table_with(
        [[0.95, 1.0]],
        [[6.0, 0.0]],
        Table.bare(1.0, 2.0),
        radii=0.03,
        **{**declared, "substeps": 1, "repositioning": repositioning, "order": order},
    )
    balls.step(FRAME)
    assert abs(balls.positions[0, 0] - place) < 16 * EPS
    assert abs(balls.velocities[0, 0] + 4.8) < 16 * EPS


@pytest.mark.parametrize("e", [0.0, 0.5, 1.0])
@pytest.mark.parametrize("repositioning", ["exact", "mirror", "clamp"])
def test_several_walls_in_one_step(e, repositioning):
    """So fast that the reflection leaves by the other side, many times over."""
    for speed in (1e3, 7e4, 1e6):
        balls = table_with(
            [[0.4, 0.7]],
            [[0.6 * speed, 0.8 * speed]],
            substeps=1,
            bounce=e,
            repositioning=repositioning,
        )
        balls.step(FRAME)
        x, y = balls.positions[0]
        assert R - 1e-9 <= x <= 1.27 - R + 1e-9 and R - 1e-9 <= y <= 2.54 - R + 1e-9
        assert np.isfinite(balls.velocities).all()
        assert balls.energy <= 0.5 * speed * speed * (1.0 + 64 * EPS)


@pytest.mark.parametrize("corner", [(0, 0), (0, 1), (1, 0), (1, 1)])
def test_corner_turns_both_parts_round(corner):
    sign = np.array([1.0 if side else -1.0 for side in corner])
    near = np.array([1.27, 2.54]) * corner - sign * (R + 0.01)
    balls = table_with([near], [sign * [3.0, 2.0]], substeps=1)
    balls.step(FRAME)
    assert (balls.velocities[0] == -sign * [3.0, 2.0]).all()
    expected = np.array([1.27, 2.54]) * corner - sign * (R - 0.01 + np.array([3.0, 2.0]) * FRAME)
    assert np.abs(balls.positions[0] - expected).max() < 16 * EPS


def pressed_depth(**declared):
    """How far beyond the rail the centre of a ball gets that another presses on it at 5 m/s, in radii."""
    deepest = 0.0
    for phase in np.linspace(0.0, 1.0, 30):
        start = R + 2 * R + 1e-4 + phase * 5.0 * FRAME
        balls = table_with([[R, 1.0], [start, 1.0]], [[0.0, 0.0], [-5.0, 0.0]], **declared)
        for _ in range(3):
            balls.step(FRAME)
            deepest = max(deepest, R - balls.positions[:, 0].min())
    return deepest / R


def test_only_as_lectured_a_ball_is_pressed_into_the_cushion():
    assert pressed_depth(**AS_LECTURED) > 1.0 - 1e-9  # its centre on the nose of the cushion
    assert pressed_depth(order="pairwise", substeps=1, passes=1) < 1e-12
    assert pressed_depth(order="joint", substeps=1) < 1e-12
    assert pressed_depth() < 1e-12


def rack_overlap_after(passes, order):
    """A rack pressed together by a tenth, left alone for one step: deepest overlap / 2 R."""
    positions = eight_ball_rack(Table.pool())[1:]
    middle = positions.mean(axis=0)
    balls = table_with(middle + 0.9 * (positions - middle), order=order, passes=passes, substeps=1)
    balls.step(FRAME)
    assert not balls.velocities.any()
    return balls.deepest_overlap / (2.0 * R)


def test_a_compressed_rack_opens():
    """Pair after pair the overlap goes slowly; jointly three or four passes leave only rounding."""
    measured = [rack_overlap_after(passes, "pairwise") for passes in (1, 5, 10, 20, 50)]
    assert measured == sorted(measured, reverse=True)
    assert 0.05 < measured[0] < 0.15
    assert measured[3] < 1e-3
    assert measured[4] < 1e-8
    assert rack_overlap_after(4, "joint") < 1e-12


@pytest.mark.parametrize("order", ["joint", "pairwise"])
@pytest.mark.parametrize(("dt", "passes"), [(1 / 60, 1), (1 / 60, 20), (1 / 1000, 1), (1 / 4000, 4)])
def test_break_conserves_momentum_and_energy(order, dt, passes):
    balls = table_with(eight_ball_rack(Table.pool()), order=order, passes=passes)
    balls.strike(0, (0.0, 8.0))
    hit = False
    for _ in range(math.ceil(1.0 / dt)):
        balls.step(dt)
        if any(event.kind == "cushion" for event in balls.events):
            break
        hit = hit or len(balls.events) > 0
        scale = np.abs(balls.velocities).sum()
        assert np.abs(np.array(balls.momentum) - [0.0, 8.0]).max() <= 4 * 16 * EPS * scale
        assert balls.energy == pytest.approx(32.0, rel=1e-14)
    assert hit
    assert (balls.velocities != 0.0).any(axis=1).sum() >= 10


def test_one_ball_onto_two():
    a = math.pi / 6.0
    onto = 0.6 + np.array(
        [[0.0, 0.0], [2 * R * math.sin(a), 2 * R * math.cos(a)], [-2 * R * math.sin(a), 2 * R * math.cos(a)]]
    )
    onto[0, 1] -= 1e-12
    for order, expected in (
        ("joint", [[0.0, -0.2], [0.6 * math.tan(a), 0.6], [-0.6 * math.tan(a), 0.6]]),
        ("pairwise", [[-0.21650635094611, -0.125], [0.433012701892219, 0.75], [-0.21650635094611, 0.375]]),
    ):
        balls = table_with(
            onto, [[0, 1], [0, 0], [0, 0]], Table.open(), effects=BALL_COLLISIONS, order=order, substeps=1
        )
        balls.step(1e-9)
        assert np.abs(balls.velocities - expected).max() < 1e-6


@pytest.mark.parametrize("table", [Table.pool(), Table.bare(1.27, 2.54)])
@pytest.mark.parametrize("substeps", [0, 1])
def test_symmetric_break_stays_symmetric_to_the_last_bit(table, substeps):
    positions = eight_ball_rack(table)
    balls = LectureTable(table, positions, settings=lecture_settings(substeps=substeps))
    x, y = balls.state.offsets.T
    image = [int(np.flatnonzero((x == -x[i]) & (y == y[i]))[0]) for i in range(16)]
    balls.strike(0, (0.0, 8.0))
    collisions = 0
    while balls.moving:
        balls.step(FRAME)
        collisions += len(balls.events)
        offsets, velocities = balls.state.offsets, balls.state.velocities
        assert (offsets[image] == offsets * [-1.0, 1.0]).all()
        assert (velocities[image] == velocities * [-1.0, 1.0]).all()
        # pockets are mirrored by row: left and right alternate
        assert (balls.state.in_play[image] == balls.state.in_play).all()
    assert collisions > 40


def test_pair_after_pair_is_not_symmetric():
    balls = table_with(eight_ball_rack(Table.pool()), order="pairwise")
    x, y = balls.state.offsets.T
    image = [int(np.flatnonzero((x == -x[i]) & (y == y[i]))[0]) for i in range(16)]
    balls.strike(0, (0.0, 8.0))
    for _ in range(60):
        balls.step(FRAME)
    assert np.abs(balls.state.offsets[image] - balls.state.offsets * [-1.0, 1.0]).max() > 0.1


def cradle(order, forwards, frames, n=5):
    y = 0.5 + 2.0 * R * np.arange(n)
    velocities = np.zeros((n, 2))
    if forwards:
        velocities[0, 1] = 1.0
    else:
        velocities[-1, 1] = -1.0
    balls = table_with(
        np.column_stack([np.full(n, 0.6), y]),
        velocities,
        Table.open(),
        effects=BALL_COLLISIONS,
        order=order,
        substeps=1,
        passes=1,
    )
    for _ in range(frames):
        balls.step(1e-4)
    return balls.velocities[:, 1]


def test_each_contact_of_a_cradle_is_told_with_its_speed():
    balls = table_with(
        [[0.6, 0.5 + 2.0 * R * k] for k in range(4)],
        [[0.0, 2.0], [0.0, 0.0], [0.0, 0.0], [0.0, 0.0]],
        Table.open(),
        effects=BALL_COLLISIONS,
        substeps=1,
    )
    balls.step(1e-6)
    assert [event[:3] for event in balls.events] == [("ball-ball", k, k + 1) for k in range(3)]
    assert np.abs(np.array([event.speed for event in balls.events]) - 2.0).max() < 1e-12


@pytest.mark.parametrize("forwards", [True, False])
def test_cradle_sends_off_the_last_ball(forwards):
    expected = np.zeros(5)
    expected[-1 if forwards else 0] = 1.0 if forwards else -1.0
    assert np.abs(cradle("joint", forwards, 1) - expected).max() < 1e-12
    # pair after pair one frame is enough along the loop, against it one for each ball
    assert np.abs(cradle("pairwise", forwards, 1 if forwards else 4) - expected).max() < 1e-12
    assert (np.abs(cradle("pairwise", forwards, 1) - expected).max() < 1e-12) == forwards


@pytest.mark.parametrize("order", ["joint", "pairwise"])
@pytest.mark.parametrize("distance", [0.0, 2 * R, math.nextafter(2 * R, 1.0), R])
def test_no_impulse_without_approach(order, distance):
    balls = table_with([[0.5, 1.0], [0.5 + distance, 1.0]], [[-0.1, 0.0], [0.1, 0.0]], order=order)
    if distance == 0.0:
        balls.velocities[:] = 0.0
    before = balls.velocities.copy()
    balls.step(FRAME)
    assert (balls.velocities == before).all() or distance == 0.0
    assert not balls.events
    assert np.isfinite(balls.positions).all()
    assert balls.deepest_overlap < 1e-12


@pytest.mark.parametrize(
    ("rate", "law", "distance"),
    [
        (60, "per-frame", 3.3168),
        (30, "per-frame", 6.63),
        (240, "per-frame", 0.83),
        (30, "consistent", 3.3335),
        (60, "consistent", 3.3168),
        (120, "consistent", 3.3084),
        (240, "consistent", 3.3042),
    ],
)
def test_friction_factor_and_frame_rate(rate, law, distance):
    balls = LectureTable(
        Table.open(),
        [[0.0, 0.0]],
        velocities=[[2.0, 0.0]],
        settings=lecture_settings(friction=0.99, minimum_speed=0.01, friction_law=law),
    )
    frames = 0
    while balls.moving:
        balls.step(1.0 / rate)
        frames += 1
    assert balls.positions[0, 0] == pytest.approx(distance, rel=2e-3)
    if rate == 60:
        f = 0.99
        assert frames == 528
        assert balls.positions[0, 0] == pytest.approx(
            2.0 / 60.0 * (1.0 - f**528) / (1.0 - f), rel=8 * 528 * EPS
        )


def test_what_is_slower_than_the_minimum_speed_stops():
    slow = math.nextafter(0.01, 0.0)
    balls = LectureTable(
        Table.open(),
        [[0.0, 0.0], [1.0, 0.0]],
        velocities=[[0.01, 0.0], [slow, 0.0]],
        settings=lecture_settings(friction=1.0, minimum_speed=0.01),
    )
    for _ in range(5):
        balls.step(FRAME)
    assert balls.velocities[0, 0] == 0.01  # exactly at the threshold it goes on
    assert balls.velocities[1, 0] == 0.0
    balls.strike(0, (1.0, 0.0))
    for _ in range(70):
        balls.step(FRAME)
    assert balls.velocities[1, 0] > 0.9  # what stopped is woken by a contact


@pytest.mark.parametrize("e", [0.0, 1.0])
def test_bounce_factor_at_its_ends(e):
    balls = table_with([[0.1, 1.0]], [[-3.0, 1.0]], bounce=e)
    for _ in range(10):
        balls.step(FRAME)
    assert balls.velocities[0, 0] == 3.0 * e
    assert balls.velocities[0, 1] == 1.0


@pytest.mark.parametrize("e", [1.0000001, 2.0, -0.1, math.nan, math.inf])
@pytest.mark.parametrize("parameter", ["bounce", "restitution", "friction"])
def test_factors_that_would_feed_energy_are_refused(parameter, e):
    with pytest.raises(ValueError, match=parameter):
        lecture_settings(**{parameter: e})


@pytest.mark.parametrize("order", ["joint", "pairwise"])
@pytest.mark.parametrize("width", [2 * R, 1.9 * R])
def test_wedged_ball_does_not_jitter(order, width):
    """A ball between two walls as wide as itself or narrower, and one pressed by an unyielding ball."""
    balls = table_with([[0.5 * width, 1.0]], None, Table.bare(width, 2.54), order=order)
    balls.step(FRAME)
    first = balls.positions
    for _ in range(60):
        balls.step(FRAME)
    assert np.abs(balls.positions - first).max() < 1e-12


@pytest.mark.parametrize("order", ["joint", "pairwise"])
def test_resting_contacts_stay_where_they_are(order):
    lattice = eight_ball_rack(Table.pool())[1:]
    pressed = [[R, 0.5], [3 * R, 0.5], [1.27 - R, 2.54 - R]]
    balls = table_with(np.concatenate([lattice, pressed]), order=order)
    balls.step(FRAME)
    first = balls.positions
    for _ in range(60):
        balls.step(FRAME)
    assert np.abs(balls.positions - first).max() < 1e-12
    assert not balls.moving


@pytest.mark.parametrize("order", ["joint", "pairwise"])
def test_ball_between_a_wall_and_a_ball_that_does_not_yield(order):
    balls = table_with([[R, 1.0], [2.7 * R, 1.0]], masses=[1.0, math.inf], order=order, passes=10)
    balls.step(FRAME)
    first = balls.positions
    for _ in range(60):
        balls.step(FRAME)
    assert np.abs(balls.positions - first).max() < 1e-12
    assert (first[1] == [2.7 * R, 1.0]).all() or np.abs(first[1] - [2.7 * R, 1.0]).max() < 4 * EPS


# more that has gone wrong elsewhere
def test_numbering_of_the_balls_has_no_influence_on_the_joint_order():
    positions = eight_ball_rack(Table.pool())
    order = np.random.default_rng(7).permutation(16)
    one = LectureTable(Table.pool(), positions)
    other = LectureTable(Table.pool(), positions[order])
    one.strike(0, (0.3, 8.0))
    other.strike(int(np.flatnonzero(order == 0)[0]), (0.3, 8.0))
    for _ in range(120):
        one.step(FRAME)
        other.step(FRAME)
    assert (other.state.offsets == one.state.offsets[order]).all()


@pytest.mark.parametrize("substeps", [0, 1])
@pytest.mark.parametrize("order", ["joint", "pairwise"])
def test_no_ball_ever_leaves_the_table(substeps, order):
    table = Table.pool()
    rng = np.random.default_rng(11)
    for _ in range(25):
        balls = LectureTable(
            table,
            eight_ball_rack(table, gap=0.002, seed=int(rng.integers(1 << 30))),
            settings=lecture_settings(substeps=substeps, order=order, friction=0.995),
            effects=LECTURE_EFFECTS,
        )
        angle = rng.uniform(0.0, 2.0 * math.pi)
        balls.strike(0, (12.0 * math.cos(angle), 12.0 * math.sin(angle)))
        for _ in range(300):
            balls.step(FRAME)
            out = np.abs(balls.state.offsets) - [0.635, 1.27]
            assert out[balls.state.in_play].max(initial=-1.0) < 0.1
        assert balls.not_finite == -1


@pytest.mark.parametrize("order", ["joint", "pairwise"])
def test_balls_of_any_mass_and_radius_never_gain_energy(order):
    rng = np.random.default_rng(4)
    for _ in range(5):
        positions = eight_ball_rack(Table.pool(), radius=0.03)
        radii = rng.uniform(0.02, 0.03, 16)
        masses = np.exp(rng.uniform(math.log(0.05), math.log(5.0), 16))
        balls = LectureTable(
            Table.pool(),
            positions,
            radii,
            masses,
            settings=lecture_settings(order=order, friction=1.0, minimum_speed=0.0),
        )
        balls.strike(0, (rng.uniform(-0.2, 0.2), 10.0))
        energy = balls.energy
        for _ in range(120):
            balls.step(FRAME)
            assert balls.energy <= energy * (1.0 + 1e-12)
            energy = balls.energy
        assert balls.not_finite == -1
