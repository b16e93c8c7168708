"""The stepped table: closed forms that a step keeps, invariants at any step, what is missed, how it ends."""

import json
import math
import os
import subprocess
import sys

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from game.billiards import (
    Physics,
    ShotError,
    Table,
    eight_ball_rack,
    load_shot,
    make_shot,
    run_shot_file,
    simulate,
)
from game.billiards.laws.state import (
    FLOAT_ROWS,
    INTEGER_ROWS,
    MASS,
    PAIR_PLANES,
    POCKETED,
    RADIUS,
    ROLLING,
    SLIDING,
    VX,
    WZ,
    X,
    Y,
)
from game.billiards.shot.physics import FRICTIONLESS
from game.billiards.shot.sampled import MAX_SAMPLES, SampledTrajectory
from game.billiards.stepped.contacts import meet_ball
from game.billiards.stepped.play import MAX_EVENTS
from game.billiards.table.rack import BALL_MASS, BALL_RADIUS
from tests.paths import TESTS

EPS = 2.0**-52
SHOTS = TESTS / "reference" / "shots"
BARE = Table.bare(1.27, 2.54)
FULL = Physics()


def energies(trajectory):
    """Kinetic energy of all balls at the samples (m,), J; equal balls."""
    samples = trajectory.samples
    v2 = (samples[..., 2:4] ** 2).sum(axis=(1, 2))
    w2 = (samples[..., 4:7] ** 2).sum(axis=(1, 2))
    return 0.5 * BALL_MASS * (v2 + 0.4 * BALL_RADIUS**2 * w2)


def break_shot(physics=FULL):
    return make_shot(BARE, eight_ball_rack(BARE), physics=physics).struck(0, (0.05, 8.0), (-30.0, 0.0, 20.0))


# -- one ball


@pytest.mark.parametrize("rate", [30.0, 240.0, 4000.0])
def test_slide_ends_at_five_sevenths_of_the_speed_at_any_step(rate):
    physics = Physics(rolling=0.0)
    shot = make_shot(Table.open(), [[0.0, 0.0]], [[3.0, 0.0]], physics=physics)
    dt = 1.0 / rate
    played = simulate(shot, "stepped", dt=dt, until=1.0)
    # v + 2/5 R w is kept by friction at the cloth, step by step
    assert played.end[0, 2] == pytest.approx(15.0 / 7.0, rel=8.0 * EPS * rate)
    (event,) = played.events
    rolls_at = 2.0 * 3.0 / (7.0 * physics.sliding * physics.gravity)
    assert event.type == "sliding-rolling"
    assert 0.0 <= event.time - rolls_at <= dt * (1.0 + 1e-9)
    # a constant force in semi-implicit steps: off by a h t/2, and less than the like for the broken step
    way = 12.0 * 9.0 / (49.0 * physics.sliding * physics.gravity) + (1.0 - rolls_at) * 15.0 / 7.0
    assert abs(played.end[0, 0] - way) <= 0.5 * physics.sliding * physics.gravity * dt * (rolls_at + 2.0 * dt)


def test_error_of_a_slide_halves_with_the_step():
    shot = make_shot(Table.open(), [[0.0, 0.0]], [[3.0, 0.0]], [[20.0, 0.0, 5.0]])
    exact = simulate(shot, until=0.25).end[0, :2]
    errors = [
        math.dist(simulate(shot, "stepped", dt=0.25 / steps, until=0.25).end[0, :2], exact)
        for steps in (50, 100, 200, 400, 800, 1600)
    ]
    assert np.polyfit(np.log(2.0) * np.arange(6), np.log(errors), 1)[0] == pytest.approx(-1.0, abs=0.05)


@pytest.mark.parametrize(
    "name", ["a01", "a02", "a03", "a04", "a06", "a08", "c01", "c02", "c04", "f01", "f02", "f04"]
)
def test_one_ball_has_the_events_of_the_exact_table(name):
    (path,) = SHOTS.glob(f"{name}-*.json")
    shot = load_shot(path)
    exact = simulate(shot)
    played = simulate(shot, "stepped", dt=1.0 / 4000.0)
    assert [(e.type, e.ids) for e in played.events] == [(e.type, e.ids) for e in exact.events]
    assert played.times == pytest.approx(exact.times, abs=20.0 / 4000.0)
    assert played.end_time == pytest.approx(exact.end_time, abs=20.0 / 4000.0)
    assert played.end[:, :2] == pytest.approx(exact.end[:, :2], abs=2e-3)


@pytest.mark.parametrize("name", ["p01", "p03", "p09"])
def test_pockets_take_and_jaws_turn(name):
    (path,) = SHOTS.glob(f"{name}-*.json")
    expect = json.loads(path.read_text())["expect"]
    assert run_shot_file(path, "stepped")["final"] == expect["final"]
    played = simulate(load_shot(path), "stepped", dt=1e-4)
    wanted = [(e["type"], tuple(e["ids"])) for e in expect["events"]]
    assert [(e.type, e.ids) for e in played.events] == wanted


def test_a_pocket_takes_a_ball_that_a_step_carries_over_it():
    table = Table.pool()
    shot = make_shot(table, [[0.3, 0.3]], [[-30.0, -30.0]])
    played = simulate(shot, "stepped", dt=0.05)
    assert played.final == {"0": "pocketed"}
    assert played.events[-1].ids == ("0", "0")


# -- balls together


def test_head_on_hit_without_loss_hands_the_velocity_over():
    shot = make_shot(Table.open(), [[0.0, 0.0], [0.5, 0.0]], [[2.0, 0.0], [0.0, 0.0]], physics=FRICTIONLESS)
    played = simulate(shot, "stepped", until=1.0)
    assert played.end[:, 2].tolist() == [0.0, 2.0]
    exact = simulate(shot, until=1.0)
    assert sorted((e.type, e.ids) for e in played.events) == sorted((e.type, e.ids) for e in exact.events)


def test_unequal_balls_keep_momentum_and_touch_where_spheres_do():
    radii, masses = [0.03, 0.02], [0.2, 0.05]
    shot = make_shot(
        Table.open(), [[0.0, 0.0], [0.5, 0.01]], [[2.0, 0.0], [0.0, 0.0]], radii=radii, masses=masses,
        physics=FRICTIONLESS,
    )  # fmt: skip
    played = simulate(shot, "stepped", dt=1e-4, until=0.4)
    assert np.array(masses) @ played.end[:, 2:4] == pytest.approx([0.4, 0.0], abs=8.0 * EPS)
    exact = simulate(shot, until=0.4)
    assert played.times == pytest.approx(exact.times, abs=1e-4)


@pytest.mark.parametrize("rate", [20.0, 60.0, 240.0, 2000.0])
@pytest.mark.parametrize("physics", [Physics(), Physics(cushion="mathavan-2010"), FRICTIONLESS])
def test_energy_never_rises_and_balls_stay_on_the_table(rate, physics):
    played = simulate(break_shot(physics), "stepped", dt=1.0 / rate, until=2.0)
    energy = energies(played)
    assert (np.diff(energy) <= 64.0 * EPS * energy[0]).all()
    positions = played.samples[..., :2]
    assert np.isfinite(positions).all()
    assert (positions >= 0.0).all()
    assert (positions <= [1.27, 2.54]).all()


@given(
    speed=st.floats(0.1, 200.0),
    angle=st.floats(0.0, 2.0 * math.pi),
    spin=st.tuples(*[st.floats(-200.0, 200.0)] * 3),
    dt=st.floats(1e-3, 0.05),
)
@settings(max_examples=60)
def test_no_ball_leaves_a_bare_table_however_fast(speed, angle, spin, dt):
    shot = make_shot(BARE, [[0.5, 0.7]]).struck(0, (speed * math.cos(angle), speed * math.sin(angle)), spin)
    played = simulate(shot, "stepped", dt=dt, until=1.0)
    places = played.samples[:, 0, :2]
    least = BALL_RADIUS - 1e-9
    assert (places >= least).all()
    assert (places <= np.array([1.27, 2.54]) - least).all()


def test_more_passes_leave_less_overlap_in_a_break():
    def deepest(passes):
        samples = simulate(break_shot(), "stepped", dt=1.0 / 240.0, passes=passes, until=0.4).samples
        apart = samples[:, :, None, :2] - samples[:, None, :, :2]
        distance = np.sqrt((apart**2).sum(axis=3)) + 10.0 * np.eye(16)
        return 2.0 * BALL_RADIUS - distance.min()

    few, some, many = deepest(1), deepest(4), deepest(20)
    assert few > 2.0 * some > 4.0 * many


def test_a_ball_too_fast_for_its_step_passes_through_another():
    shot = make_shot(Table.open(), [[0.0, 0.0], [1.25, 0.0]], [[30.0, 0.0], [0.0, 0.0]], physics=FRICTIONLESS)
    assert simulate(shot, "stepped", dt=1.0 / 60.0, until=0.2).events == []
    assert [e.type for e in simulate(shot, "stepped", dt=1e-3, until=0.2).events] == ["ball-ball"]


# -- how it ends, and what is kept


def test_nothing_moves_nothing_happens():
    played = simulate(make_shot(BARE, [[0.5, 0.5], [0.6, 0.6]]), "stepped")
    assert played.events == []
    assert played.end_time == 0.0
    assert played.state_at(1.0).positions.tolist() == [[0.5, 0.5], [0.6, 0.6]]


def test_without_friction_it_ends_at_the_time_asked_for_with_a_shorter_last_step():
    shot = make_shot(Table.open(), [[0.0, 0.0]], [[1.0, 0.5]], physics=FRICTIONLESS)
    played = simulate(shot, "stepped", dt=0.3, until=1.0)
    assert played.end_time == 1.0
    assert played.counts["steps"] == 4
    assert played.end[0, :2] == pytest.approx([1.0, 0.5], abs=8.0 * EPS)


def test_a_ball_that_spins_for_ever_does_not_keep_the_table_busy():
    physics = Physics(spinning=0.0)
    played = simulate(make_shot(BARE, [[0.5, 0.5]], spins=[[0.0, 0.0, 9.0]], physics=physics), "stepped")
    assert played.end_time == 0.0
    assert played.end[0, 6] == 9.0


def test_what_is_pocketed_from_the_start_takes_no_part():
    shot = make_shot(
        BARE, [[0.5, 0.5], [0.5, 0.8]], [[0.0, 2.0], [0.0, 0.0]], motions=["sliding", "pocketed"]
    )
    played = simulate(shot, "stepped")
    assert played.final["1"] == "pocketed"
    assert not any(e.type == "ball-ball" for e in played.events)


def test_samples_are_thinned_evenly_and_begin_and_end_the_shot():
    shot = make_shot(BARE, [[0.5, 0.5]], [[0.3, 1.0]])
    dt = 1.0 / 8000.0
    played = simulate(shot, "stepped", dt=dt, until=4.0)
    times = played.sample_times
    assert isinstance(played, SampledTrajectory)
    assert played.counts["steps"] == 32_000
    assert MAX_SAMPLES // 2 < len(times) <= MAX_SAMPLES
    assert times[0] == 0.0
    assert times[-1] == played.end_time == 4.0
    gaps = np.diff(times)
    assert gaps[:-1] == pytest.approx(gaps[0], rel=1e-9)
    assert gaps[0] == pytest.approx(round(gaps[0] / dt) * dt)
    coarse = simulate(shot, "stepped", dt=dt, until=times[100])
    assert coarse.end[0, :2] == pytest.approx(played.samples[100, 0, :2], abs=1e-12)


def test_state_between_samples_lies_between_them():
    played = simulate(break_shot(), "stepped", until=0.5)
    early, late = played.sample_times[40:42]
    middle = played.state_at(0.5 * (early + late))
    assert middle.positions == pytest.approx(
        0.5 * (played.samples[40] + played.samples[41])[:, :2], abs=1e-15
    )
    assert played.state_at(early).velocities.tolist() == played.samples[40, :, 2:4].tolist()
    assert played.state_at(-1.0).positions == pytest.approx(played.shot.positions, abs=0.0)
    assert played.state_at(math.inf).time == played.end_time
    with pytest.raises(ValueError, match="time"):
        played.state_at(math.nan)


def test_a_rolling_ball_turns_by_its_way():
    shot = make_shot(
        Table.open(), [[0.0, 0.0]], [[1.0, 0.0]], [[0.0, 1.0 / BALL_RADIUS, 0.0]], motions=["rolling"],
        physics=FRICTIONLESS,
    )  # fmt: skip
    played = simulate(shot, "stepped", until=0.5)
    angle = 0.4321 / BALL_RADIUS
    c, s = math.cos(angle), math.sin(angle)
    turned = played.orientations_at(0.4321)[0]
    assert turned == pytest.approx(np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]]), abs=1e-12)
    start = np.array([[[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]])
    assert played.orientations_at(0.4321, start)[0] == pytest.approx(turned @ start[0], abs=1e-15)
    assert played.state_at(0.1).motions.tolist() == [ROLLING]


def test_events_beyond_the_room_for_them_are_counted():
    narrow = Table.bare(0.2, 1.0)
    shot = make_shot(narrow, [[0.1, 0.5]], [[90.0, 0.0]], physics=FRICTIONLESS)
    played = simulate(shot, "stepped", dt=1e-3, until=60.0)
    assert len(played.events) == MAX_EVENTS
    assert played.counts["lost_events"] > 0
    assert np.isfinite(played.end).all()


@pytest.mark.parametrize("dt", [1e-3, 0.05, 10.0])
def test_absurd_speeds_stay_finite_and_end(dt):
    shot = make_shot(Table.pool(), eight_ball_rack(Table.pool())).struck(0, (5e3, 9e3), (1e6, -1e6, 1e6))
    played = simulate(shot, "stepped", dt=dt, until=60.0)
    assert np.isfinite(played.samples).all()
    assert played.end_time <= 60.0


def test_balls_on_one_spot_are_parted():
    shot = make_shot(BARE, [[0.5, 0.5], [0.75, 0.5]], [[4.0, 0.0], [0.0, 0.0]], physics=FRICTIONLESS)
    played = simulate(shot, "stepped", dt=0.0625, until=0.0625)  # one step, onto the other ball's place
    assert played.end[1, 0] - played.end[0, 0] == pytest.approx(2.0 * BALL_RADIUS, abs=1e-12)
    assert played.end[:, 2].tolist() == [0.0, 4.0]


def test_equal_shots_give_equal_bits():
    assert simulate(break_shot(), "stepped").digest == simulate(break_shot(), "stepped").digest


def test_kernels_give_the_same_bits_as_plain_python():
    code = (
        "from game.billiards import Physics, Table, make_shot, simulate\n"
        "physics = Physics(ball_ball='wallace-1988')\n"
        "shot = make_shot(Table.bare(1.27, 2.54), [[0.35, 0.5], [0.75, 1.25]], physics=physics)\n"
        "shot = shot.struck(0, (1.154, 2.104), (-27.0, 14.8, -35.0))\n"
        "print(simulate(shot, 'stepped', until=2.0).digest)\n"
    )
    said = [
        subprocess.run(
            [sys.executable, "-c", code],
            env={**os.environ, "NUMBA_DISABLE_JIT": flag},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for flag in ("0", "1")
    ]
    assert said[0] == said[1] != ""


@pytest.mark.parametrize(
    ("options", "word"),
    [
        ({"dt": 0.0}, "dt"),
        ({"dt": -1.0}, "dt"),
        ({"dt": math.nan}, "dt"),
        ({"dt": math.inf}, "dt"),
        ({"dt": "1"}, "dt"),
        ({"dt": 1e-9}, "dt"),
        ({"passes": 0}, "passes"),
        ({"passes": 2.5}, "passes"),
        ({"passes": True}, "passes"),
        ({"until": math.nan}, "until"),
        ({"until": math.inf}, "until"),
        ({"until": -1.0}, "until"),
    ],
)
def test_bad_options_are_named(options, word):
    shot = make_shot(BARE, [[0.5, 0.5]], [[1.0, 0.0]])
    with pytest.raises(ShotError, match=f"^{word}: ") as told:
        simulate(shot, "stepped", **options)
    assert "\n" not in str(told.value)


def test_motions_of_the_samples_are_those_of_the_exact_table():
    played = simulate(make_shot(Table.pool(), [[0.3, 0.3]], [[-1.0, -1.0]]), "stepped")
    assert played.state_at(0.0).motions.tolist() == [SLIDING]
    assert played.state_at(played.end_time).motions.tolist() == [POCKETED]


def test_balls_that_overlap_are_moved_apart_about_their_centre_of_mass():
    masses = np.array([0.05, 0.2])
    state, modes = np.zeros((FLOAT_ROWS, 2)), np.zeros((INTEGER_ROWS, 2), np.int64)
    state[X], state[RADIUS], state[MASS] = (0.0, 1.8 * BALL_RADIUS), BALL_RADIUS, masses
    overlap = 0.2 * BALL_RADIUS
    pairs, constants = np.zeros((PAIR_PLANES, 2, 2)), make_shot(BARE, [[0.5, 0.5]]).constants
    middle = masses @ state[X]
    meet_ball(state, modes, pairs, 0, 1, overlap, constants, np.zeros((4, 4)), np.zeros(8, np.int64))
    assert state[X, 1] - state[X, 0] == pytest.approx(2.0 * BALL_RADIUS, rel=1e-12)
    assert masses @ state[X] == pytest.approx(middle, rel=1e-12)
    assert not state[Y].any() and not state[VX : WZ + 1].any()
