"""C01 key-framing: every point of the task and beyond, by the events that a hand makes."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.levels import Level, LevelError, format_level, level_files, parse_level
from game.physics.animation import INTERPOLATIONS, Easing
from game.scenes.key_frames.box import turning_handle
from game.scenes.key_frames.level import Motion
from game.scenes.key_frames.scene import KeyFraming
from game.scenes.key_frames.timeline import places_of, x_of
from game.stage import Action, ParameterError, Pointer, SetEffect, SetParameter, replay_scene
from tests.scenes.particle_stages import click, drag, move, open_level, press, readouts, release, stage_of

LEVELS = level_files("c01")
FREE = (-2.0, 2.6)  # nothing is there in any level used here


def test_the_stage_plays_and_pauses_the_motion():
    stage = open_level(KeyFraming, "nearest-and-linear", playing=False)
    assert stage.scene.resting and stage.still
    stage.play_or_pause()
    assert stage.scene.parameters.playing and not stage.still
    stage.play_or_pause()
    assert not stage.scene.parameters.playing and stage.still


def box_at(stage, time):
    stage.post(SetParameter("time", time))
    return stage.scene.model.pose.copy()


def keys(stage):
    return [(key.time, *key.position, key.angle) for key in stage.scene.model.motion.keys]


def on_axis(stage, time):
    places = places_of(stage.scene.model.motion.view)
    return x_of(places, time), places.axis


def track(**declared):
    """The bend of one Bezier curve, at rest at time 0."""
    return open_level(KeyFraming, "one-bezier-curve", playing=False, **declared)


# -- the points of the task ---------------------------------------------------------------------------------


def test_1_a_box_at_the_origin():
    stage = open_level(KeyFraming, "one-box")
    assert keys(stage) == [(0.0, 0.0, 0.0, 0.0)]
    stage.run(200)
    assert stage.scene.model.pose.tolist() == [0.0, 0.0, 0.0]
    assert KeyFraming().model.motion == Motion()  # without any level as well


def test_2_nearest_key():
    stage = open_level(KeyFraming, "nearest-and-linear", playing=False)
    for time, index in ((0.0, 0), (0.12, 0), (0.125, 1), (0.37, 1), (0.38, 2), (1.0, 4)):
        x, y, angle = box_at(stage, time)
        key = stage.scene.model.motion.keys[index]
        assert (x, y, angle) == (*key.position, math.radians(key.angle))


def test_3_straight_lines():
    stage = open_level(KeyFraming, "nearest-and-linear", playing=False, interpolation="linear")
    assert box_at(stage, 0.125) == pytest.approx([-3.2, 0.25, math.radians(22.5)])
    assert box_at(stage, 0.5).tolist() == [0.4, -0.6, math.radians(90.0)]


def test_4_one_bezier_curve_whose_control_points_are_dragged():
    stage = track()
    ends = np.array([(-4.2, -0.9), (-2.2, -0.9 + 11 / 3), (1.2, -0.7 + 10 / 3), (4.2, -0.7)])
    weights = np.array([0.343, 0.441, 0.189, 0.027])
    assert box_at(stage, 0.3)[:2] == pytest.approx(weights @ ends, abs=1e-12)
    drag(stage, ends[1], (-3.0, 0.5), steps=3, run=0)
    ends[1] = (-3.0, 0.5)
    assert box_at(stage, 0.3)[:2] == pytest.approx(weights @ ends, abs=1e-12)
    drag(stage, ends[2], (3.3, 1.1), steps=3, run=0)
    ends[2] = (3.3, 1.1)
    assert box_at(stage, 0.3)[:2] == pytest.approx(weights @ ends, abs=1e-12)
    assert len(stage.scene.model.document.past) == 2


@pytest.mark.parametrize("name", INTERPOLATIONS)
def test_5_every_interpolation_meets_every_key(name):
    stage = open_level(KeyFraming, "hard-04-unsorted", playing=False)
    stage.post(SetParameter("interpolation", name))
    for time, x, y, angle in keys(stage):
        assert box_at(stage, time) == pytest.approx([x, y, math.radians(angle)], abs=1e-15)


def test_5_keys_are_made_by_clicks():
    """On an empty path one after the other; at another time, there and now."""
    stage = open_level(KeyFraming, "one-box")
    for point in ((2.0, 1.0), (3.0, -0.5), (-3.0, 1.0)):
        click(stage, point)
    assert [key[:3] for key in keys(stage)] == [
        (0.0, 0.0, 0.0), (pytest.approx(1 / 3), 2.0, 1.0), (pytest.approx(2 / 3), 3.0, -0.5), (1.0, -3.0, 1.0)
    ]  # fmt: skip
    stage.post(SetParameter("time", 0.5))
    click(stage, FREE)
    assert keys(stage)[2][:3] == (0.5, *FREE)
    assert stage.scene.model.pose[:2].tolist() == list(FREE)
    assert len(stage.scene.model.document.past) == 4


def test_5_keys_are_moved_turned_retimed_and_deleted():
    stage = track(interpolation="linear")
    scene = stage.scene
    drag(stage, (-4.2, -0.9), (-3.0, 0.4), run=0)
    assert keys(stage)[0][:3] == (0.0, pytest.approx(-3.0), pytest.approx(0.4))
    key = scene.model.motion.keys[1]
    handle = turning_handle(scene.model.motion.box, *key.position, math.radians(90.0))
    x, y = key.position
    drag(stage, handle, (x - 2.0, y + 2.0), run=0)
    assert keys(stage)[1][3] == pytest.approx(135.0)
    drag(stage, on_axis(stage, 1.0), on_axis(stage, 0.6), run=0)
    assert keys(stage)[1][0] == pytest.approx(0.6)
    stage.post(SetParameter("time", 0.3))
    click(stage, FREE)
    drag(stage, on_axis(stage, 0.3), on_axis(stage, 0.9), run=0)  # past another one
    assert [key[0] for key in keys(stage)] == pytest.approx([0.0, 0.6, 0.9])
    assert keys(stage)[2][1:3] == FREE
    assert scene.model.document.chosen == 2
    stage.post(Action("delete"))
    assert len(keys(stage)) == 2
    click(stage, on_axis(stage, 0.6), button=3)
    assert len(keys(stage)) == 1
    click(stage, keys(stage)[0][1:3], button=3)
    assert len(keys(stage)) == 1
    assert scene.messages() == ("One key-frame has to stay.",)


def test_5_the_chosen_key_in_numbers():
    stage = open_level(KeyFraming, "hard-04-unsorted", playing=False)
    click(stage, (-0.6, 0.6))
    assert [stage.scene.values[name] for name in ("key_time", "key_x", "key_y", "key_angle")] == [
        0.4,
        -0.6,
        0.6,
        10,
    ]
    for name, value in (("key_x", 1.0), ("key_y", -0.25), ("key_angle", 720.0), ("key_time", 0.7)):
        stage.post(SetParameter(name, value))
    assert keys(stage)[3] == (0.7, 1.0, -0.25, 720.0)
    with pytest.raises(ParameterError):
        stage.post(SetParameter("key_time", 1.5))


def test_6_a_slider_from_zero_to_one():
    stage = open_level(KeyFraming, "default")
    parameter = KeyFraming.parameter("time")
    assert (parameter.minimum, parameter.maximum, parameter.unit) == (0.0, 1.0, "s")
    stage.run(30)
    moving = stage.scene.values["time"]
    assert moving == pytest.approx(30 / 120 / 3.5)
    stage.post(SetParameter("time", 0.4))  # takes over from playback
    stage.run(30)
    assert stage.scene.values["time"] == 0.4
    assert not stage.scene.parameters.playing
    drag(stage, on_axis(stage, 0.05), on_axis(stage, 0.8), run=0)
    assert stage.scene.values["time"] == pytest.approx(0.8)
    stage.post(SetParameter("playing", True))
    stage.run(30)
    assert stage.scene.values["time"] == pytest.approx(0.8 + 30 / 120 / 3.5)


def test_6_the_wheel_goes_frame_by_frame():
    stage = open_level(KeyFraming, "early-film")
    stage.run(50)
    for notches, frame in ((1.0, 4), (3.0, 7), (-7.0, 0), (-1.0, 7), (2.0, 1)):
        stage.post(Pointer("wheel", 0.0, 0.0, wheel=notches))
        assert stage.scene.model.player.present() == frame / 8
    assert not stage.scene.parameters.playing


def test_7_playback_looks_at_the_curve_so_often():
    stage = open_level(KeyFraming, "early-film")
    scene, seen = stage.scene, []
    for _ in range(240):
        stage.run(1)
        seen.append(tuple(scene.model.pose.tolist()))
    assert len(set(seen)) == 8
    for i in range(8):
        expected = scene.model.animation().pose(i / 8)
        assert np.abs(np.array(sorted(set(seen))) - expected).sum(axis=1).min() < 1e-12
    stage.post(SetParameter("fps", 24))
    more = set()
    for _ in range(120):
        stage.run(1)
        more.add(tuple(scene.model.pose.tolist()))
    assert len(more) == 24


def test_8_the_box_is_where_the_time_says():
    stage = open_level(KeyFraming, "default", fps=240)
    stage.run(77)
    scene = stage.scene
    assert np.array_equal(scene.model.pose, scene.model.animation().pose(scene.model.player.shown_part()))
    assert scene.model.player.shown_part() == pytest.approx(scene.model.player.present(), abs=1 / (240 * 3.5))


# -- beyond -------------------------------------------------------------------------------------------------


def test_the_box_is_grabbed_in_flight():
    """It gets a key at that time; playback waits for the hand."""
    stage = open_level(KeyFraming, "default")
    stage.run(60)
    scene, count = stage.scene, len(keys(stage))
    time = scene.model.player.shown_part()
    x, y, angle = scene.model.pose.tolist()
    press(stage, (x + 0.2, y))
    for i in range(1, 6):
        move(stage, (x + 0.2, y + 0.1 * i))
        stage.run(4)
    assert scene.model.player.present() == pytest.approx(60 / 120 / 3.5)
    assert scene.model.pose == pytest.approx([x, y + 0.5, angle])
    release(stage, (x + 0.2, y + 0.5))
    assert len(keys(stage)) == count + 1
    made = next(key for key in keys(stage) if abs(key[0] - time) < 1e-12)
    assert made == pytest.approx((time, x, y + 0.5, math.degrees(angle)))
    assert len(scene.model.document.past) == 1
    stage.run(10)
    assert scene.model.player.present() > time
    stage.post(Action("undo"))
    assert len(keys(stage)) == count


def test_the_box_is_turned_in_flight():
    stage = track()
    stage.post(SetParameter("time", 0.5))
    x, y, angle = stage.scene.model.pose.tolist()
    handle = turning_handle(stage.scene.model.motion.box, x, y, angle)
    press(stage, handle)
    stage.post(Pointer("move", x + 1.0, y + 1.1, button=1, control=True))
    release(stage, (x + 1.0, y + 1.1))
    assert keys(stage)[1][3] == 45.0  # with Ctrl in steps of 15 degrees


def test_a_key_on_a_bezier_curve_leaves_it_as_it_is():
    stage = track()
    times = np.linspace(0, 1, 41)
    before = stage.scene.model.animation().poses(times)
    stage.post(SetParameter("time", 0.37))
    stage.post(Action("insert"))
    assert len(keys(stage)) == 3
    assert np.abs(stage.scene.model.animation().poses(times)[:, :2] - before[:, :2]).max() < 1e-12


def test_joints_are_smooth_until_they_are_made_corners():
    stage = open_level(KeyFraming, "bezier-track", playing=False)
    scene = stage.scene
    assert readouts(stage)["velocity jump"] < 1e-12
    after = scene.model.animation().handles()[1, 1]
    drag(stage, after, after + np.array((0.4, 0.6)), run=0)
    assert readouts(stage)["velocity jump"] < 1e-12
    after = scene.model.animation().handles()[1, 1]
    press(stage, after)
    stage.post(Pointer("move", after[0] + 0.5, after[1] + 0.5, button=1, shift=True))
    release(stage, after + 0.5)
    assert readouts(stage)["velocity jump"] > 5.0
    assert scene.model.motion.keys[1].velocity_before is not None
    stage.post(Action("corner"))
    assert readouts(stage)["velocity jump"] < 1e-12
    stage.post(Action("corner"))
    assert scene.model.motion.keys[1].velocity_before is not None
    click(stage, scene.model.animation().handles()[1, 1], button=3)  # back to what the neighbours say
    assert scene.model.motion.keys[1].velocity is None


def test_hops_are_parabolas_between_corners():
    stage = open_level(KeyFraming, "hop", playing=False)
    for start, end, speed in ((0.0, 0.5, 15.0), (0.5, 0.8, 9.0), (0.8, 1.0, 6.0)):
        for time in np.linspace(start, end, 7)[:-1]:
            y = -1.2 + speed * (time - start) - 30.0 * (time - start) ** 2
            assert stage.scene.model.animation().pose(time)[1] == pytest.approx(y, abs=1e-12)


def test_constant_speed():
    stage = open_level(KeyFraming, "hurry-and-dawdle", fps=240, duration=1.0)
    scene = stage.scene
    length = scene.model.animation().length
    for _ in range(20):
        stage.run(5)
        assert readouts(stage)["speed"] == pytest.approx(length, rel=1e-12)
    places = scene.model.animation().poses(np.linspace(0, 1, 4001))[:, :2]
    steps = np.linalg.norm(np.diff(places, axis=0), axis=1)
    assert np.ptp(steps) < 1e-3 * steps.mean()
    stage.post(SetEffect("constant-speed", False))
    assert np.ptp(scene.model.animation().speeds) > 10.0


def test_the_motion_is_eased_as_its_picture_says():
    """Where the box is at half the time: what the curve says that is drawn, and what CSS says of "ease"."""
    stage = open_level(KeyFraming, "default")
    for easing, half in (("linear", 0.5), ("ease", 0.80240339)):
        stage.post(SetParameter("easing", easing))
        animation = stage.scene.model.animation()
        assert float(animation.easing(0.5)) == pytest.approx(half, abs=1e-7)


def test_easing_and_a_timing_curve_of_ones_own():
    stage = open_level(KeyFraming, "hard-07-steep-timing", playing=False)
    scene = stage.scene
    assert box_at(stage, 0.25)[0] == pytest.approx(-4.0 + 7.6 * Easing((1, 0, 0, 1))(0.25), abs=1e-12)
    stage.post(SetParameter("easing", "ease"))
    assert box_at(stage, 0.5)[0] == pytest.approx(-4.0 + 7.6 * 0.802403387584857, abs=1e-10)
    box = places_of(scene.model.motion.view).timing
    drag(stage, box.at(0.25, 0.1), box.at(0.5, 0.9), run=0)
    assert scene.parameters.easing == "own"
    assert scene.model.document.timing() == pytest.approx((0.5, 0.9, 0.25, 1.0))
    drag(stage, box.at(0.5, 0.9), box.at(5.0, 0.2), run=0)
    assert scene.model.document.timing()[:2] == pytest.approx((1.0, 0.2))  # held at the edge
    stage.post(Action("undo"))
    stage.post(Action("undo"))
    assert scene.parameters.easing == "ease"
    stage.post(SetEffect("easing", False))
    assert box_at(stage, 0.5)[0] == pytest.approx(-0.2)


def test_the_box_turns_along_its_path():
    stage = open_level(KeyFraming, "hard-06-cusp", playing=False)
    assert math.degrees(box_at(stage, 0.0)[2]) == pytest.approx(math.degrees(math.atan2(3, 4)))
    assert abs(math.degrees(box_at(stage, 0.499999)[2]) - 90.0) < 1.0
    assert abs(math.degrees(box_at(stage, 0.500001)[2]) + 90.0) < 1.0
    stage = open_level(KeyFraming, "bezier-track", playing=False)
    for time in np.linspace(0.02, 0.98, 17):
        heading = box_at(stage, time)[2]
        velocity = stage.scene.model.animation().velocity(time)
        assert math.cos(heading - math.atan2(velocity[1], velocity[0])) == pytest.approx(1.0, abs=1e-9)


@pytest.mark.parametrize("name", INTERPOLATIONS)
def test_closed_curves_come_back(name):
    stage = open_level(KeyFraming, "default", playing=False)
    stage.post(SetParameter("interpolation", name))
    first, last = box_at(stage, 0.0), box_at(stage, 1.0)
    assert np.array_equal(first, last)
    near = box_at(stage, 1.0 - 1e-9)
    assert np.abs(near[:2] - first[:2]).max() < 1e-6


def test_what_happens_at_the_end():
    stage = open_level(KeyFraming, "hop", duration=1.0, fps=240)
    stage.run(150)
    assert stage.scene.model.player.present() == pytest.approx(0.25)
    stage.post(SetParameter("repeat", "once"))
    stage.run(200)
    assert stage.scene.model.player.present() == 1.0
    assert not stage.scene.parameters.playing
    stage.post(Action("play"))
    stage.run(12)
    assert stage.scene.model.player.present() == pytest.approx(0.1)
    stage.post(SetParameter("repeat", "there-and-back"))
    stage.run(120)
    assert stage.scene.model.player.present() == pytest.approx(0.9)


def test_from_key_to_key():
    stage = open_level(KeyFraming, "hard-02-outside-the-keys")
    for name, time in (("later", 0.2), ("later", 0.4), ("earlier", 0.2), ("earlier", 0.8), ("later", 0.2)):
        stage.post(Action(name))
        assert stage.scene.model.player.present() == time
        assert stage.scene.model.motion.keys[stage.scene.model.document.chosen].time == time


def test_parameters_that_do_nothing_say_why_once():
    stage = open_level(KeyFraming, "default", playing=False)
    for x in (1.0, 2.0, 3.0):
        stage.post(SetParameter("key_x", x))
    stage.post(SetParameter("easing", "swing"))
    no_key, no_easing = stage.scene.messages()
    assert "click" in no_key and "easing" in no_easing
    stage.post(Pointer("down", *stage.scene.model.motion.keys[2].position, button=1))
    stage.post(Pointer("up", *stage.scene.model.motion.keys[2].position, button=1))
    stage.post(SetParameter("key_x", 1.5))
    assert stage.scene.messages() == () and stage.scene.model.motion.keys[2].position[0] == 1.5


def test_undo_and_redo_of_every_edit():
    """A hundred things done at random are taken back one by one, and done again."""
    rng = np.random.default_rng(7)
    stage = open_level(KeyFraming, "default", playing=False)
    scene = stage.scene
    story = [
        (scene.model.motion, scene.parameters.interpolation, scene.parameters.closed, scene.parameters.easing)
    ]

    def look():
        now = (
            scene.model.motion,
            scene.parameters.interpolation,
            scene.parameters.closed,
            scene.parameters.easing,
        )
        if now != story[-1]:
            story.append(now)

    for _ in range(100):
        what = rng.integers(7)
        point = rng.uniform((-6, -3.4), (6, 3))
        if what == 0:
            click(stage, point)
        elif what == 1:
            drag(
                stage,
                scene.model.motion.keys[rng.integers(len(scene.model.motion.keys))].position,
                point,
                steps=2,
                run=0,
            )
        elif what == 2:
            click(stage, point, button=3)
        elif what == 3:
            stage.post(SetParameter("interpolation", INTERPOLATIONS[rng.integers(len(INTERPOLATIONS))]))
        elif what == 4:
            stage.post(Action(["delete", "insert", "corner", "method", "later"][rng.integers(5)]))
        elif what == 5:
            stage.post(SetParameter("key_x", float(rng.uniform(-5, 5))))
        else:
            stage.post(SetParameter("closed", bool(rng.integers(2))))
        look()
    assert stage.fault is None
    assert len(scene.model.document.past) == len(story) - 1 > 40
    for then in reversed(story[:-1]):
        stage.post(Action("undo"))
        assert (
            scene.model.motion,
            scene.parameters.interpolation,
            scene.parameters.closed,
            scene.parameters.easing,
        ) == then
    scene.messages()
    stage.post(Action("undo"))
    assert scene.messages() == ("There is nothing to undo.",)
    for then in story[1:]:
        stage.post(Action("redo"))
        assert (
            scene.model.motion,
            scene.parameters.interpolation,
            scene.parameters.closed,
            scene.parameters.easing,
        ) == then
    stage.post(Action("redo"))
    assert scene.messages() == ("There is nothing to redo.",)


def test_a_drag_that_is_taken_back_leaves_nothing():
    stage = track()
    before = stage.scene.model.motion
    press(stage, (-4.2, -0.9))
    move(stage, (0.0, 0.0))
    stage.post(Pointer("cancel", 0.0, 0.0, button=1))
    assert stage.scene.model.motion == before
    assert stage.scene.model.document.past == []
    click(stage, (-4.2, -0.9))  # only chosen
    assert stage.scene.model.document.past == []
    assert stage.scene.model.document.chosen == 0


def test_whatever_happens_in_the_middle_of_a_drag():
    """Another button, a key or the panel ends it; what it did so far is one edit, the rest another."""
    for event, edits in (
        (Action("delete"), 2),
        (Action("undo"), 0),
        (SetParameter("interpolation", "linear"), 2),
        (SetParameter("key_x", 1.0), 2),
        (Pointer("down", -3.0, 0.0, button=3), 2),
    ):
        stage = track()
        press(stage, (-4.2, -0.9))
        move(stage, (-3.0, 0.0))
        stage.post(event)
        move(stage, (5.0, 2.0))
        release(stage, (5.0, 2.0))
        assert stage.fault is None
        assert len(stage.scene.model.document.past) == edits
        for _ in range(edits):
            stage.post(Action("undo"))
        assert stage.scene.model.document.edit() == track().scene.model.document.edit()
    stage = track()
    press(stage, (-4.2, -0.9))
    stage.post(SetParameter("interpolation", "linear"))
    assert len(stage.scene.model.document.past) == 1


def test_there_is_an_end_to_keys():
    stage = open_level(KeyFraming, "one-box")
    for i in range(199):
        stage.post(SetParameter("time", (i + 1) / 200))
        stage.post(Action("insert"))
    assert len(keys(stage)) == 200
    stage.post(SetParameter("time", 0.9975))
    click(stage, FREE)
    assert len(keys(stage)) == 200
    assert any("At most 200" in words for words in stage.scene.messages())


# -- files, time back, replay -------------------------------------------------------------------------------


def test_saved_and_read_back():
    stage = open_level(KeyFraming, "bezier-track", playing=False)
    drag(stage, stage.scene.model.animation().handles()[2, 0], (-0.5, 1.9), run=0)
    stage.post(SetParameter("time", 0.3))
    click(stage, FREE)
    text = format_level(Level(scene="c01", content=stage.scene.save_content()))
    back = parse_level(text, "c01", Motion)
    assert back.content == stage.scene.model.motion
    values = stage.scene.values
    again = KeyFraming(back, values, effects=stage.scene.active)
    assert np.array_equal(again.model.pose, stage.scene.model.pose)


@pytest.mark.parametrize(
    ("text", "field"),
    [
        ("keys = []", "keys"),
        ("keys = [{ time = nan }]", "time"),
        ("keys = [{ time = 1.5 }]", "time"),
        ("keys = [{ time = 0.0, position = [inf, 0.0] }]", "position"),
        ("keys = [{ time = 0.0, speed = 1.0 }]", "speed"),
        ("keys = [{ time = 0.0 }]\ntiming = [-0.1, 0.0, 1.0, 1.0]", "timing"),
        ("keys = [{ time = 0.0 }]\ntiming = [0.0, 0.0, 1.2, 1.0]", "timing"),
        ("keys = [{ time = 0.0 }]\nbox = [0.0, 1.0]", "box"),
    ],
)
def test_what_is_broken_in_a_file_is_named(text, field):
    """H1, H8 and G-N1 in the file."""
    with pytest.raises(LevelError, match=field):
        KeyFraming(parse_level(f'scene = "c01"\n[content]\n{text}\n', "c01", Motion))


@pytest.mark.parametrize("path", LEVELS, ids=lambda path: path.stem)
def test_every_level_runs_and_comes_back(path):
    """The same digests on two runs, and after steps back in the middle of edits."""
    digests = []
    for back in range(2):
        stage = stage_of(KeyFraming, path)
        stage.run(40)
        drag(stage, stage.scene.model.pose[:2], (1.0, 2.2), steps=4)
        stage.post(SetParameter("interpolation", "bezier"))
        stage.post(SetEffect("constant-speed", False))
        stage.run(30)
        if back:
            for _ in range(33):
                assert stage.step_back()
            stage.resume()
            stage.run(33)
        assert stage.fault is None
        assert np.isfinite(stage.scene.model.pose).all()
        assert all(math.isfinite(value) for value in readouts(stage).values())
        digests.append(stage.digest())
    assert digests[0] == digests[1]


def test_a_recording_replays():
    stage = open_level(KeyFraming, "default")
    stage.run(25)
    drag(stage, stage.scene.model.pose[:2], (0.0, 2.4), steps=5, run=3)
    stage.post(SetEffect("easing", True))
    stage.run(40)
    stage.post(Action("undo"))
    stage.run(10)
    again = replay_scene(stage.recording, KeyFraming)
    assert again.digest() == stage.digest()
    assert np.array_equal(again.scene.model.pose, stage.scene.model.pose)


# -- hard cases, as levels ----------------------------------------------------------------------------------


def test_hard_levels_are_there_for_every_case():
    cases = {
        parse_level(path.read_text(encoding="utf-8"), "c01", Motion).hard_case
        for path in LEVELS
        if path.stem.startswith("hard")
    }
    assert cases == {f"C01 H{i}" for i in range(1, 12)}


def test_hard_levels_show_what_they_say():
    one = open_level(KeyFraming, "hard-01-one-key", playing=False)
    assert box_at(one, 0.9).tolist() == [1.5, 0.5, math.radians(30.0)]
    outside = open_level(KeyFraming, "hard-02-outside-the-keys", playing=False)
    assert box_at(outside, 0.1)[:2].tolist() == [-3.0, 0.0]
    assert box_at(outside, 0.95)[:2].tolist() == [3.0, 1.0]
    jump = open_level(KeyFraming, "hard-03-jump", playing=False)
    assert box_at(jump, math.nextafter(0.5, 0.0))[:2] == pytest.approx([-1.0, -0.5])
    assert box_at(jump, 0.5)[:2].tolist() == [1.4, 1.2]
    order = [key[0] for key in keys(open_level(KeyFraming, "hard-04-unsorted"))]
    assert order == sorted(order)
    tiny = open_level(KeyFraming, "hard-05-no-time-between", playing=False)
    assert box_at(tiny, 0.0)[:2].tolist() == [-3.0, -0.8]
    places = tiny.scene.model.animation().poses(np.linspace(0.001, 1.0, 200))[:, :2]
    assert np.abs(places).max() < 4.0
    far = open_level(KeyFraming, "hard-05-far-from-zero", playing=False)
    near = np.array([box_at(far, time)[:2] for time in (0.0, 0.25, 0.5, 0.75)])
    assert near.tolist() == [[-3.6, 0.4], [0.0, 1.9], [3.6, 0.4], [0.0, -1.1]]
    still = open_level(KeyFraming, "hard-06-all-in-one-place", playing=False)
    assert box_at(still, 0.4)[:2].tolist() == [0.0, 0.4]
    assert readouts(still)["path length"] == 0.0


def test_hard_turns():
    short = open_level(KeyFraming, "hard-09-the-short-way", playing=False)
    assert math.cos(box_at(short, 0.5)[2]) == pytest.approx(1.0, abs=1e-15)
    short.post(SetParameter("shortest", False))
    assert math.degrees(box_at(short, 0.5)[2]) == pytest.approx(180.0)
    half = open_level(KeyFraming, "hard-10-half-turn", playing=False)
    assert math.degrees(box_at(half, 0.5)[2]) == pytest.approx(90.0)


def test_hard_backwards_is_bit_by_bit_forwards():
    stage = open_level(KeyFraming, "hard-11-there-and-back")
    seen = {}
    for step in range(1, 240):
        stage.run(1)
        place = stage.scene.model.pose.tobytes()
        mirrored = min(step, 240 - step)
        assert seen.setdefault(mirrored, place) == place
