"""A shot on the lecture's table: the same as that table stepped by hand; its friction; what it leaves out."""

import math

import numpy as np
import pytest

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
from game.billiards.laws.state import ROLLING
from game.billiards.lecture.shot import (
    EFFECTS,
    MINIMUM,
    REFERENCE_SPEED,
    bed_of,
    friction_factor,
    lecture_settings_for,
)
from game.billiards.lecture.table import LectureTable
from game.billiards.shot.physics import FRICTIONLESS
from game.billiards.shot.sampled import MAX_SAMPLES
from game.billiards.table.table import checked_table
from tests.paths import TESTS

SHOTS = TESTS / "reference" / "shots"
POOL = Table.pool()


def break_shot(**more):
    return make_shot(POOL, eight_ball_rack(POOL), **more).struck(0, (0.05, 8.0), (-30.0, 0.0, 20.0))


def test_it_is_the_table_stepped_by_hand():
    shot = break_shot()
    velocities = np.zeros((16, 2))
    velocities[0] = 0.05, 8.0
    twin = LectureTable(
        POOL, shot.positions, velocities=velocities, effects=EFFECTS, settings=lecture_settings_for(shot)
    )
    twin.step(1.0 / 60.0, 100)
    played = simulate(shot, "lecture")
    assert played.sample_times[100] == pytest.approx(100.0 / 60.0, abs=1e-12)
    assert played.samples[100, :, :2] == pytest.approx(twin.positions, abs=1e-12)
    names = {"ball-ball": "ball-ball", "cushion": "ball-cushion", "jaw": "ball-jaw", "pocket": "ball-pocket"}
    early = [e for e in played.events if e.time < played.sample_times[100] - 1e-9]
    assert [(e.type, tuple(map(int, e.ids))) for e in early] == [
        (names[e.kind], (e.ball, e.other)) for e in twin.events
    ]
    assert [e.time for e in early] == pytest.approx([e.time for e in twin.events], abs=1e-12)


def test_a_ball_of_the_reference_speed_stops_when_the_cloth_would_stop_it():
    physics = Physics()
    shot = make_shot(Table.open(), [[0.0, 0.0]], [[REFERENCE_SPEED, 0.0]], physics=physics)
    played = simulate(shot, "lecture")
    on_cloth = REFERENCE_SPEED / (physics.rolling * physics.gravity)
    assert played.end_time == pytest.approx(on_cloth, abs=2.0 / 60.0)
    factor = friction_factor(physics.rolling, physics.gravity)
    assert factor ** (60.0 * on_cloth) == pytest.approx(MINIMUM / REFERENCE_SPEED, rel=1e-9)


def test_without_rolling_friction_nothing_stops():
    shot = make_shot(Table.open(), [[0.0, 0.0]], [[1e-3, 0.0]], physics=FRICTIONLESS)
    played = simulate(shot, "lecture", dt=0.3, until=2.0)
    assert played.end_time == pytest.approx(2.0, abs=1e-12)
    assert played.end[0, :4] == pytest.approx([2e-3, 0.0, 1e-3, 0.0], abs=1e-15)


def test_spin_is_ignored():
    shot = make_shot(POOL, eight_ball_rack(POOL))
    plain, spun = (
        simulate(shot.struck(0, (0.05, 8.0), (wx, 0.0, 3.0 * wx)), "lecture") for wx in (0.0, 90.0)
    )
    assert plain.digest == spun.digest


def test_loss_is_the_shots():
    physics = FRICTIONLESS._replace(ball_ball="wallace-1988", cushion="restitution")
    physics = physics._replace(ball_restitution=0.9, cushion_restitution=0.7)
    shot = make_shot(
        Table.bare(2.0, 1.0), [[0.5, 0.5], [1.0, 0.5]], [[1.0, 0.0], [0.0, 0.0]], physics=physics
    )
    played = simulate(shot, "lecture", until=2.0)
    assert [e.type for e in played.events] == ["ball-ball", "ball-cushion"]
    assert played.end[:, 2] == pytest.approx([0.05, -0.7 * 0.95], abs=1e-12)


@pytest.mark.parametrize("name", ["p01", "p03", "p09"])
def test_tables_from_files_have_their_rails_where_the_noses_are(name):
    (path,) = SHOTS.glob(f"{name}-*.json")
    bed = bed_of(load_shot(path))
    assert bed.width < bed.length
    assert run_shot_file(path, "lecture")["final"] == run_shot_file(path)["final"]


def test_open_cloth_is_open():
    shot = make_shot(Table.open(), [[3.0, -2.0]], [[1.0, 0.0]])
    played = simulate(shot, "lecture")
    assert played.state_at(0.0).positions.tolist() == [[3.0, -2.0]]
    assert played.events == []


def test_a_bed_that_is_no_rectangle_is_refused():
    slanted = np.array([[0.0, 0.0, 1.0, 1.0, -math.sqrt(0.5), math.sqrt(0.5)]])
    table = checked_table(1.0, 1.0, 0.03629, slanted, np.empty((0, 3)), np.empty((0, 3)))
    with pytest.raises(ShotError, match=r"^table: "):
        simulate(make_shot(table, [[0.2, 0.8]], [[1.0, 0.0]]), "lecture")


def test_what_is_pocketed_from_the_start_takes_no_part():
    motions = ["sliding", "pocketed"]
    shot = make_shot(POOL, [[0.5, 0.5], [0.5, 0.8]], [[0.0, 2.0], [0.0, 0.0]], motions=motions)
    played = simulate(shot, "lecture")
    assert played.final["1"] == "pocketed"
    assert not any(e.type == "ball-ball" for e in played.events)
    assert played.state_at(0.1).motions[0] == ROLLING


def test_a_moving_ball_rolls_and_turns_by_its_way():
    shot = make_shot(Table.open(), [[0.0, 0.0]], [[1.0, 0.0]], physics=FRICTIONLESS)
    played = simulate(shot, "lecture", until=0.5)
    c, s = math.cos(0.4 / 0.028575), math.sin(0.4 / 0.028575)
    wanted = np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])
    assert played.orientations_at(0.4)[0] == pytest.approx(wanted, abs=1e-10)


def test_many_steps_are_played_in_few_samples():
    played = simulate(break_shot(), "lecture", dt=1.0 / 1000.0, until=20.0)
    assert played.counts["lost_events"] == 0
    assert len(played.sample_times) <= MAX_SAMPLES
    assert (np.diff(played.sample_times) > 0.0).all()


@pytest.mark.parametrize(
    "options", [{"rule": "as-printed"}, {"rule": "scaled"}, {"order": "joint", "substeps": 0}]
)
def test_other_rules_and_orders_stay_finite(options):
    played = simulate(break_shot(), "lecture", until=3.0, **options)
    assert np.isfinite(played.samples).all()
    assert played.events


def test_absurd_speeds_stay_finite_and_end():
    shot = make_shot(POOL, eight_ball_rack(POOL)).struck(0, (5e3, 9e3), (1e6, 0.0, 0.0))
    for dt in (1.0 / 60.0, 10.0):
        assert np.isfinite(simulate(shot, "lecture", dt=dt, until=30.0).samples).all()


@pytest.mark.parametrize(
    ("options", "word"),
    [
        ({"dt": 0.0}, "dt"),
        ({"dt": math.nan}, "dt"),
        ({"until": math.inf}, "until"),
        ({"substeps": -1}, "substeps"),
        ({"rule": "fair"}, "rule"),
        ({"order": "joint", "rule": "as-printed"}, "order"),
    ],
)
def test_bad_options_are_named(options, word):
    with pytest.raises(ValueError, match=f"^{word}: "):
        simulate(break_shot(), "lecture", **options)


def test_unknown_models_are_named():
    with pytest.raises(ValueError, match="exact, stepped, lecture"):
        simulate(break_shot(), "guessed")
