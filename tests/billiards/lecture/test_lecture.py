"""The lecture's table: what it takes, refuses, reports and computes."""

import math
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numba.core.runtime import _nrt_python, rtsys

from game.billiards.lecture.settings import (
    DEFAULTS,
    FRICTION_LAWS,
    ORDERS,
    PAIRWISE,
    PROPAGATIONS,
    REPOSITIONINGS,
    RULES,
    LectureSettings,
    lecture_settings,
    read_settings,
)
from game.billiards.lecture.state import (
    BALL_COLLISIONS,
    EVENT_CAPACITY,
    EVENTS,
    EVENTS_LOST,
    LECTURE_EFFECTS,
    POCKETS,
    ROLLING,
    WALLS,
    Journal,
    geometry_of,
)
from game.billiards.lecture.table import LectureTable, warm_ups
from game.billiards.lecture.walls import report
from game.billiards.table.rack import BALL_MASS, eight_ball_rack
from game.billiards.table.rack import BALL_RADIUS as R
from game.billiards.table.table import Table
from game.physics.fields import GRAVITY

EPS = 2.0**-52
FRAME = 1.0 / 60.0
LOSSLESS = lecture_settings(bounce=1.0, restitution=1.0, friction=1.0, minimum_speed=0.0)


def free_balls(positions, velocities, radii=R, masses=1.0, **declared):
    """Balls on cloth without an edge."""
    balls = LectureTable(Table.open(), positions, radii, masses, velocities, BALL_COLLISIONS, LOSSLESS)
    balls.settings = lecture_settings(balls.settings, **declared)
    return balls


# -- collisions


@given(
    st.floats(0.1, 10.0),
    st.floats(0.1, 10.0),
    st.floats(0.0, 1.0),
    st.floats(-1.3, 1.3),
    st.sampled_from(["joint", "pairwise"]),
)
def test_two_balls_of_any_mass_and_radius(m1, m2, e, angle, order):
    r1, r2, v = 0.02 + 0.002 * m1, 0.03, 2.0
    normal = np.array([math.cos(angle), math.sin(angle)])
    balls = free_balls(
        [[0.0, 0.0], (r1 + r2) * normal * (1.0 - 1e-6)],
        [[v, 0.0], [0.0, 0.0]],
        [r1, r2],
        [m1, m2],
        order=order,
        restitution=e,
    )
    balls.step(1e-12)
    impulse = (1.0 + e) * v * normal[0] / (1.0 / m1 + 1.0 / m2)
    assert np.abs(balls.velocities[0] - ([v, 0.0] - impulse / m1 * normal)).max() < 1e-9
    assert np.abs(balls.velocities[1] - impulse / m2 * normal).max() < 1e-9
    assert abs(balls.momentum[0] - m1 * v) < 16 * EPS * (m1 + m2) * v
    event = balls.events[0]
    assert (event.kind, {event.ball, event.other}) == ("ball-ball", {0, 1})
    assert event.impulse == pytest.approx(impulse, rel=1e-9)
    assert event.speed == pytest.approx(v * normal[0], rel=1e-9)
    assert np.abs(event.position - r1 * normal).max() < 1e-6


def test_balls_are_moved_apart_by_mass():
    balls = free_balls([[0.0, 0.0], [R, 0.0]], None, masses=[1.0, 3.0])
    balls.step(FRAME)
    assert np.abs(balls.positions[:, 0] - [-0.75 * R, R + 0.25 * R]).max() < 8 * EPS
    heavy = free_balls([[0.0, 0.0], [R, 0.0]], None, masses=[1.0, math.inf])
    heavy.step(FRAME)
    assert np.abs(heavy.positions[:, 0] - [-R, R]).max() < 8 * EPS
    assert heavy.masses.tolist() == [1.0, math.inf]


@pytest.mark.parametrize("e", [0.5, 0.9, 1.0])
def test_rule_scaled_shortens_the_momentum_by_its_loss(e):
    balls = free_balls(
        [[0.0, 0.0], [0.04, 0.03]], [[2.0, -0.3], [-1.0, 0.4]], order="pairwise", rule="scaled", restitution=e
    )
    balls.step(1e-9)
    assert np.abs(np.array(balls.momentum) - e * np.array([1.0, 0.1])).max() < 1e-12


def test_rule_as_printed_makes_a_head_on_hit_fly_off_at_45_degrees():
    balls = free_balls(
        [[0.0, 0.0], [0.05, 0.0]],
        [[1.0, 0.0], [0.0, 0.0]],
        order="pairwise",
        rule="as-printed",
        restitution=1.0,
    )
    balls.step(1e-9)
    assert np.abs(balls.velocities[0]).max() < 8 * EPS
    assert np.abs(balls.velocities[1] - [1.0, 1.0]).max() < 8 * EPS
    assert balls.energy == pytest.approx(1.0)  # twice what there was


# -- walls and pockets


def test_ball_leaving_a_wall_is_not_turned_round_again():
    balls = LectureTable(
        Table.bare(1.0, 2.0), [[0.5 * R, 1.0]], velocities=[[0.2, 0.1]], effects=WALLS, settings=LOSSLESS
    )
    balls.step(FRAME)
    assert balls.velocities[0].tolist() == [0.2, 0.1]
    assert abs(balls.positions[0, 0] - R) < 4 * EPS
    assert not balls.events


@pytest.mark.parametrize(("axis", "sign"), [(0, -1.0), (0, 1.0), (1, -1.0), (1, 1.0)])
def test_a_ball_that_lies_at_a_wall_throws_another_back(axis, sign):
    """All at once the wall bears the whole of it: the ball between stays, the other comes back as it went."""
    at_wall, other = np.array([0.5, 1.0]), np.array([0.5, 1.0])
    at_wall[axis] = R if sign < 0.0 else (1.0, 2.0)[axis] - R
    other[axis] = at_wall[axis] - sign * 2.001 * R
    velocity = np.zeros(2)
    velocity[axis] = 3.0 * sign
    settings = lecture_settings(LOSSLESS, bounce=0.5, order="joint", propagation="at-once")
    balls = LectureTable(
        Table.bare(1.0, 2.0), [at_wall, other], velocities=[[0.0, 0.0], velocity],
        effects=WALLS | BALL_COLLISIONS, settings=settings,
    )  # fmt: skip
    balls.step(FRAME)
    assert balls.velocities == pytest.approx(np.array([[0.0, 0.0], -velocity]), abs=1e-9)


def test_cushion_event_tells_row_speed_impulse_and_place():
    balls = LectureTable(
        Table.bare(1.0, 2.0), [[0.95, 1.0]], velocities=[[3.0, 0.0]], effects=WALLS, masses=2.0
    )
    balls.settings = lecture_settings(balls.settings, bounce=0.5)
    balls.step(FRAME)
    (event,) = balls.events
    assert (event.kind, event.ball, event.other) == ("cushion", 0, 1)
    assert (event.speed, event.impulse) == (3.0, 9.0)
    assert event.position[1] == 1.0


@pytest.mark.parametrize("row", range(6))
@pytest.mark.parametrize("substeps", [0, 1])
def test_every_pocket_takes_a_ball_rolling_straight_in(row, substeps):
    table = Table.pool()
    aim = table.pockets[row, :2]
    start = np.array([0.635, 1.27]) + 0.5 * (aim - [0.635, 1.27])
    balls = LectureTable(table, [start], settings=lecture_settings(substeps=substeps))
    balls.strike(0, (aim - start) / math.dist(aim, start) * 3.0)
    kinds, speed = [], 3.0
    for _ in range(120):
        before, rolled = speed, balls.positions[0].copy()
        balls.step(FRAME)
        kinds += [event.kind for event in balls.events]
        if balls.events:
            assert 0.95 * before < balls.events[0].speed <= before * (1.0 + 1e-12)
        elif balls.state.in_play[0]:
            speed = math.dist(balls.positions[0], rolled) / FRAME
    assert kinds == ["pocket"]
    assert not balls.state.in_play[0]
    assert balls.state.pocketed_by[0] == row
    assert np.abs(balls.positions[0] - aim).max() < 1e-11
    assert not balls.moving


def test_closed_pockets_leave_an_unbroken_cushion():
    balls = LectureTable(
        Table.pool(), [[0.2, 0.2]], effects=LECTURE_EFFECTS.without(POCKETS), settings=LOSSLESS
    )
    balls.strike(0, (-3.0, -3.0))
    for _ in range(60):
        balls.step(FRAME)
        assert (balls.positions >= R - 1e-12).all()
    assert balls.energy == pytest.approx(0.5 * BALL_MASS * 18.0, rel=1e-12)


def test_jaw_turns_a_ball_round():
    table = Table.pool()
    jaw = table.jaws[2]  # of a side pocket
    balls = LectureTable(table, [(jaw[0] + 0.3, jaw[1])], settings=LOSSLESS)
    balls.strike(0, (-2.0, 0.0))
    kinds = []
    for _ in range(20):
        balls.step(FRAME)
        kinds += [event.kind for event in balls.events]
    assert kinds[0] in ("jaw", "cushion")
    assert balls.velocities[0, 0] > 0.0


def test_table_about_its_middle_is_its_own_mirror_image():
    geometry = geometry_of(Table.pool(), True)

    def rows(array, mirror):
        return sorted((array * mirror).tolist())

    for axis in range(2):
        discs = np.where(np.arange(3) == axis, -1.0, 1.0)
        lines = np.where(np.isin(np.arange(6), (axis, axis + 2, axis + 4)), -1.0, 1.0)
        assert rows(geometry.jaws, discs) == rows(geometry.jaws, 1.0)
        assert rows(geometry.pockets, discs) == rows(geometry.pockets, 1.0)
        images = (geometry.cushions * lines).tolist()
        own = geometry.cushions.tolist()
        assert all(image in own or image[2:4] + image[:2] + image[4:] in own for image in images)


# -- rolling


def turned(quaternion, vector):
    """A body vector in the table's frame."""
    w, q = quaternion[0], quaternion[1:]
    return vector + 2.0 * np.cross(q, np.cross(q, vector) + w * vector)


def test_ball_rolls_with_its_way():
    balls = LectureTable(
        Table.open(), [[0.0, 0.0]], velocities=[[3.0, 4.0]], effects=ROLLING, settings=LOSSLESS
    )
    quarter = 0.5 * math.pi * R / 5.0
    for _ in range(10):
        balls.step(quarter / 10.0)
    # a quarter turn brings the top of the ball to its front
    assert (
        np.abs(turned(balls.state.orientations[0], np.array([0.0, 0.0, 1.0])) - [0.6, 0.8, 0.0]).max() < 1e-12
    )
    for _ in range(30):
        balls.step(quarter / 10.0)
    assert np.abs(np.abs(balls.state.orientations[0]) - [1.0, 0.0, 0.0, 0.0]).max() < 1e-12


# -- effects, determinism, cost


def test_effects_switch_what_is_computed():
    balls = LectureTable(Table.bare(1.0, 2.0), [[0.1, 1.0]], velocities=[[-9.0, 0.0]])
    balls.effects = BALL_COLLISIONS
    for _ in range(10):
        balls.step(FRAME)
    assert balls.positions[0, 0] < -1.0
    assert balls.velocities[0, 0] == -9.0
    with pytest.raises(ValueError, match=GRAVITY.name):
        balls.effects = WALLS | GRAVITY


def broken_rack(**declared):
    balls = LectureTable(Table.pool(), eight_ball_rack(Table.pool()), settings=lecture_settings(**declared))
    balls.strike(0, (0.4, 8.0))
    return balls


def test_equal_input_gives_equal_bits_also_after_a_restore():
    one, other = broken_rack(), broken_rack()
    for _ in range(40):
        one.step(FRAME)
    kept = [array.copy() for array in one.state]
    for _ in range(40):
        one.step(FRAME)
    for mine, then in zip(other.state, kept, strict=True):
        mine[...] = then
    for _ in range(40):
        other.step(FRAME)
    assert all((a == b).all() for a, b in zip(one.state, other.state, strict=True))


def test_several_steps_in_one_call_are_the_same_steps():
    one, other = broken_rack(), broken_rack()
    events = []
    for _ in range(30):
        one.step(FRAME)
        events += [event[:3] for event in one.events]
    other.step(FRAME, 30)
    assert all((a == b).all() for a, b in zip(one.state, other.state, strict=True))
    assert [event[:3] for event in other.events] == events
    with pytest.raises(ValueError, match="steps"):
        one.step(FRAME, 0)


@pytest.mark.parametrize("order", ["joint", "pairwise"])
def test_same_bits_as_plain_python(order):
    """The kernels uncompiled, in a process of their own."""
    program = (
        "import sys; sys.path.insert(0, sys.argv[1])\n"
        "from game.billiards.lecture.table import *\n"
        "from game.billiards.table.rack import eight_ball_rack\n"
        "p = Table.pool()\n"
        "t = LectureTable(p, eight_ball_rack(p), settings=lecture_settings(order=sys.argv[2]))\n"
        "t.strike(0, (0.4, 8.0)); t.state.offsets[0, 1] = 0.5\n"
        "[t.step(1 / 60) for _ in range(8)]\n"
        "print(b''.join(array.tobytes() for array in t.state).hex())"
    )
    results = []
    for disabled in ("0", "1"):
        environment = {**os.environ, "NUMBA_DISABLE_JIT": disabled}
        results.append(
            subprocess.run(
                [sys.executable, "-W", "ignore", "-c", program, str(Path.cwd()), order],
                env=environment,
                capture_output=True,
                text=True,
                check=True,
            ).stdout
        )
    assert results[0] == results[1]
    assert len(results[0]) > 1000


def test_a_step_allocates_nothing():
    """Handing over an array costs one small header; a break costs no more than balls at rest."""
    _nrt_python.memsys_enable_stats()
    resting = LectureTable(Table.pool(), eight_ball_rack(Table.pool(), gap=0.002))
    breaking = broken_rack()
    counts = []
    for balls in (resting, breaking):
        balls.step(FRAME)
        before = rtsys.get_allocation_stats().alloc
        for _ in range(60):
            balls.step(FRAME)
        counts.append(rtsys.get_allocation_stats().alloc - before)
    assert counts[0] == counts[1]


def test_what_the_list_has_no_room_for_is_counted():
    journal = Journal(np.zeros((2, 8)), np.zeros(8, np.int64))
    for number in range(5):
        report(journal, np.int64(1), number, -1, 0.5 * number, 1.0, 2.0, 3.0, 4.0)
    assert journal.counters[EVENTS] == 2
    assert journal.counters[EVENTS_LOST] == 3
    assert journal.events[:, 1].tolist() == [0.0, 1.0]


def test_counters_and_bounded_events():
    balls = broken_rack(passes=1)
    tests = 0
    for _ in range(30):
        balls.step(FRAME)
        counters = balls.counters
        tests += counters["pair_tests"]
        assert counters["pair_tests"] >= 120 * counters["substeps"]
        assert counters["events"] == len(balls.events) <= EVENT_CAPACITY
    assert tests > 0
    crowd = 0.021 * np.stack(np.meshgrid(np.arange(40), np.arange(40)), axis=-1).reshape(-1, 2)
    many = free_balls(
        crowd,
        np.full((1600, 2), 0.1) * np.sign(np.sin(np.arange(3200))).reshape(-1, 2),
        order="pairwise",
        passes=1,
    )
    many.step(FRAME)
    assert many.counters["events"] == EVENT_CAPACITY
    assert many.counters["events_lost"] > 0


def test_crowd_is_separated_within_the_capacity_for_contacts():
    crowd = 0.05 * np.stack(np.meshgrid(np.arange(12), np.arange(12)), axis=-1).reshape(-1, 2)
    balls = free_balls(crowd, None, passes=20)
    for _ in range(10):
        balls.step(FRAME)
    assert np.isfinite(balls.positions).all()
    assert balls.deepest_overlap < 1e-9


# -- what comes in


def test_kernels_read_the_settings_that_were_made():
    settings = LectureSettings(0.1, 0.2, 0.3, 0.4, 5, 6, 1, 1, 1, 2, 1, False)
    assert read_settings(np.array(settings, dtype=np.float64)) == settings


def test_choices_have_words_outside_and_places_inside():
    for name, choices in (
        ("rule", RULES),
        ("order", ORDERS),
        ("propagation", PROPAGATIONS),
        ("repositioning", REPOSITIONINGS),
        ("friction_law", FRICTION_LAWS),
    ):
        for place, word in enumerate(choices):
            made = lecture_settings(DEFAULTS._replace(order=PAIRWISE), **{name: word})
            assert getattr(made, name) == place


def test_any_array_like_gives_the_same():
    wanted = LectureTable(
        Table.bare(1.0, 2.0), [[0.5, 0.25], [0.5, 1.0]], velocities=[[1.0, 0.0], [-0.0, 2.0]]
    )
    wide = np.zeros((2, 4))
    wide[:, ::2] = [[0.5, 0.25], [0.5, 1.0]]
    frozen = np.array([[1, 0], [0, 2]])
    frozen.setflags(write=False)
    other = LectureTable(
        Table.bare(1.0, 2.0), wide[:, ::2], velocities=frozen, radii=np.float32([R, R]).astype(float) * 0 + R
    )
    for balls in (wanted, other):
        for _ in range(30):
            balls.step(FRAME)
    assert (wanted.positions == other.positions).all()


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"positions": [[0.5, math.nan]]}, r"positions\[0\]"),
        ({"positions": [[0.5, 1e300]]}, r"positions\[0\]"),
        ({"positions": [[0.5]]}, "positions"),
        ({"positions": [["a", "b"]]}, "positions"),
        ({"positions": np.empty((0, 2))}, "positions"),
        ({"velocities": [[math.inf, 0.0]]}, r"velocities\[0\]"),
        ({"velocities": [[0.0, 0.0], [0.0, 0.0]]}, "velocities"),
        ({"radii": 0.0}, r"radii\[0\]"),
        ({"radii": math.nan}, r"radii\[0\]"),
        ({"radii": [0.1, 0.1]}, "radii"),
        ({"masses": -1.0}, r"masses\[0\]"),
        ({"masses": math.nan}, r"masses\[0\]"),
    ],
)
def test_bad_balls_are_refused(change, message):
    with pytest.raises(ValueError, match=message):
        LectureTable(Table.bare(1.0, 2.0), **{"positions": [[0.5, 0.5]], **change})


@pytest.mark.parametrize("dt", [0.0, -0.1, math.nan, math.inf, 11.0])
def test_bad_steps_are_refused(dt):
    balls = LectureTable(Table.bare(1.0, 2.0), [[0.5, 0.5]])
    with pytest.raises(ValueError, match="dt"):
        balls.step(dt)


@pytest.mark.parametrize(
    ("parameter", "value"),
    [
        ("minimum_speed", -1.0),
        ("substeps", -1),
        ("substeps", 1.5),
        ("passes", 0),
        ("passes", True),
        ("friction", 1.5),
        ("walls_again", 1),
        ("rule", "magic"),
        ("rule", 0),
        ("order", "random"),
        ("bounce", "much"),
        ("rule", "scaled"),  # needs the order pairwise
    ],
)
def test_bad_parameters_are_refused_and_change_nothing(parameter, value):
    balls = LectureTable(Table.bare(1.0, 2.0), [[0.5, 0.5]])
    before = balls.settings
    with pytest.raises(ValueError, match=parameter if value != "scaled" else "order"):
        balls.settings = lecture_settings(balls.settings, **{parameter: value})
    with pytest.raises(ValueError, match="colour"):
        balls.settings = lecture_settings(balls.settings, colour=3)
    assert balls.settings == before


def test_placing_striking_removing():
    balls = LectureTable(Table.pool(), [[0.5, 0.5], [0.5, 1.0]])
    assert not balls.is_clear(0, [0.5, 1.0 - R])
    assert balls.is_clear(0, [0.5, 0.6])
    assert not balls.is_clear(0, [0.5 * R, 0.6])
    balls.place(0, [0.6, 0.7])
    assert np.abs(balls.positions[0] - [0.6, 0.7]).max() < 2 * EPS
    balls.remove(1)
    with pytest.raises(ValueError, match="ball 1"):
        balls.strike(1, (1.0, 0.0))
    balls.place(1, [0.5, 1.0])
    balls.strike(1, (1.0, 0.0))
    assert balls.moving
    for bad in (-1, 2, True, 0.5):
        with pytest.raises(ValueError, match="ball"):
            balls.place(bad, [0.5, 0.5])
    with pytest.raises(ValueError, match="position"):
        balls.place(0, [0.0, 0.5])
    with pytest.raises(ValueError, match="velocity"):
        balls.strike(0, (math.nan, 0.0))


def test_a_number_that_is_not_finite_is_noticed_and_stays_with_its_ball():
    balls = LectureTable(Table.pool(), [[0.5, 0.5], [0.5, 1.0], [0.7, 0.7]], settings=LOSSLESS)
    balls.strike(2, (1.0, 0.0))
    balls.velocities[1, 0] = math.nan
    balls.step(FRAME)
    assert balls.not_finite == 1
    assert np.isfinite(balls.positions[[0, 2]]).all()


def test_warm_ups_name_what_they_compile():
    for name, call in warm_ups():
        assert "lecture" in name
        call()


@pytest.mark.parametrize("radius", [R, 0.5 * R])
def test_as_many_substeps_as_keep_the_fastest_ball_below_half_the_least_radius(radius):
    for halves in (0.3, 0.99, 1.01, 3.5, 7.99):
        speed = halves * 0.5 * radius / FRAME
        balls = free_balls([[0.0, 0.0], [9.0, 0.0]], [[speed, 0.0], [0.1 * speed, 0.0]], [2.0 * R, radius],
                           substeps=0)  # fmt: skip
        balls.step(FRAME)
        assert balls.counters["substeps"] == math.ceil(halves)
