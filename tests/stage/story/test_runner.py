"""A story as it goes on: lines in order, moments by the state, one and the same however it is played."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

from game.stage import Pointer, Stage, replay_scene
from game.stage.script.camera import Aim, CameraPath, View, kept_inside
from game.stage.script.course import READING
from game.stage.story.rehearsal import rehearse, stage_of
from game.stage.story.runner import Runner
from tests.stage.story.bouncing import TEXT, StoryBall, story

DT = StoryBall.dt


def played(text: str = TEXT, **options) -> Runner:
    """A story at its end."""
    runner = Runner(story(text), stage_of(story(text), StoryBall), **options)
    while not runner.finished:
        assert runner.stage.run(1) == 1
    return runner


def begun(runner: Runner, kind: str) -> list[float]:
    """When lines of a kind began, s of film."""
    return [
        entry.film_s
        for number, entry in runner.course.begun.items()
        if type(runner.story.lines[number]).__name__ == kind
    ]


def test_lines_stand_in_order_and_each_waits_for_the_one_before():
    runner = played()
    in_turn = [i for i, line in enumerate(runner.story.lines) if not line.at]
    starts = [runner.course.begun[i].film_s for i in in_turn]
    assert starts == sorted(starts)
    assert begun(runner, "Title") == [0.0]
    assert begun(runner, "Follow")[0] == pytest.approx(2.0, abs=0.02)  # after the title
    assert begun(runner, "Say")[0] == pytest.approx(3.0, abs=0.02)  # after the camera has come


def test_a_line_at_a_moment_begins_out_of_its_turn():
    runner = played()
    five = runner.course.reached["five"]
    kick = next(e for i, e in runner.course.begun.items() if runner.story.lines[i].at == "five")
    assert kick.film_s == pytest.approx(five.film_s + 0.5, abs=0.02)


def test_a_moment_is_named_by_the_state():
    low, high = played(), played(TEXT.replace("height = 12.0", "height = 24.0"))
    times = [runner.course.reached["three"].time_s for runner in (low, high)]
    assert times[1] / times[0] == pytest.approx(math.sqrt(2.0), abs=0.02)  # falls go with the root


def test_slow_stretches_the_film_alone():
    runner = played()
    three, five = runner.course.reached["three"], runner.course.reached["five"]
    assert five.film_s - three.film_s == pytest.approx(4.0 * (five.time_s - three.time_s), abs=0.1)


def test_a_parameter_goes_to_its_value_in_its_time():
    runner = played()
    assert runner.stage.scene.restitution == 0.4
    values = [e.event.value for e in runner.stage.recording.events if hasattr(e.event, "value")]
    assert values[0] < 0.8 and values[-1] == 0.4
    assert np.all(np.diff(values) <= 0.0) and len(values) == pytest.approx(60, abs=3)


def test_captions_hold_measured_numbers_and_stay_as_long_as_reading_takes():
    runner = played()
    first, second = runner.course.captions()
    said = next(e for i, e in runner.course.begun.items() if type(runner.story.lines[i]).__name__ == "Say")
    assert first.text == said.text and "{" not in first.text and "bounced 1 times" in first.text
    assert first.ends - first.begins >= len(first.text) / READING
    assert second.ends == pytest.approx(runner.course.reached["five"].film_s)
    assert second.begins >= first.ends


def test_captions_that_come_at_once_follow_one_another():
    extra = '[[line]]\nsay = "And one more out of turn."\nat = "five"\n[[line]]\nsay = "Out of turn."'
    captions = played(TEXT.replace('[[line]]\ndo = { action = "kick" }', extra)).course.captions()
    assert len(captions) == 4
    assert all(a.ends <= b.begins + 1e-9 for a, b in itertools.pairwise(captions))


def test_a_run_that_is_stopped_tells_what_it_has_not_measured():
    found = rehearse(story(), StoryBall, progress=lambda film_s: film_s < 0.5)
    assert not found.ended and found.film_s < 4.0
    assert [(one.value, one.time_s, one.holds) for one in found.expectations] == [(None, None, False)] * 3
    assert sum("is not measured" in line for line in found.failures) == 3


def test_expectations_are_measured_when_their_time_comes():
    found = rehearse(story(), StoryBall)
    assert found.failures == [] and found.ended
    at_five, by_two, at_end = found.expectations
    assert at_five.value == 5 and at_five.time_s == next(m.time_s for m in found.moments if m.name == "five")
    assert by_two.value <= 4.0 and 1.2 < by_two.time_s < 1.5  # after a fall of 8 m
    assert at_end.time_s == pytest.approx(found.time_s, abs=0.3)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("least = 5.0", "least = 6.0", "bounces is 5 at 'five'; expected at least 6"),
        ("most = 4.0", "most = -1.0", "height is"),
        ("deadline = 9.0", "deadline = 0.1", "the moment 'five' was not reached"),
    ],
)
def test_what_is_not_so_is_said(old, new, words):
    assert any(words in line for line in rehearse(story(TEXT.replace(old, new)), StoryBall).failures)


def test_a_missed_deadline_does_not_hold_up_the_story():
    found = rehearse(story(TEXT.replace("deadline = 9.0", "deadline = 0.1")), StoryBall)
    assert found.ended and [one.missed for one in found.moments] == [False, True]


# -- one and the same ------------------------------------------------------------------------------


def test_the_picture_is_at_a_moment_of_its_own_between_two_steps():
    runner = Runner(story(), stage_of(story(), StoryBall))
    assert runner.shown_s == 0.0
    runner.stage.advance(10.25 * DT)
    assert runner.film_s == pytest.approx(10.0 * DT)
    assert runner.shown_s == pytest.approx(9.25 * DT)


def test_it_is_the_same_headless_in_frames_and_as_a_replay():
    runner = played()
    headless = rehearse(story(), StoryBall)
    window = Runner(story(), stage_of(story(), StoryBall))
    while window.stage.step_number < runner.stage.step_number:
        window.stage.advance(min(0.013, (runner.stage.step_number - window.stage.step_number) * DT + 1e-6))
        window.stage.speed = window.course.speed
    while headless.steps > runner.stage.step_number:
        runner.stage.run(1)
        window.stage.run(1)
    assert headless.digest == runner.stage.digest() == window.stage.digest()
    assert window.course.captions() == runner.course.captions()
    assert replay_scene(runner.stage.recording, StoryBall).digest() == headless.digest
    for time in np.linspace(0.0, runner.course.end_s, 50):
        assert window.path.at(time) == runner.path.at(time)


def test_a_step_back_and_forward_changes_nothing():
    straight = played()
    runner = Runner(story(), stage_of(story(), StoryBall))
    rng = np.random.default_rng(3)
    while not runner.finished:
        runner.stage.run(int(rng.integers(1, 40)))
        if rng.uniform() < 0.3:
            for _ in range(int(rng.integers(1, 60))):
                runner.stage.step_back()
            runner.follow()
            assert all(e.step <= runner.stage.step_number for e in runner.course.entries)
            runner.stage.resume()
    while straight.stage.step_number < runner.stage.step_number:
        straight.stage.run(1)
    assert runner.stage.digest() == straight.stage.digest()
    assert runner.course.entries == straight.course.entries
    assert len(runner.stage.recording.events) == len(straight.stage.recording.events)


@pytest.mark.parametrize("share", [0.0, 0.3, 0.9])
def test_the_stage_returns_to_any_step_and_the_script_goes_on_the_same(share):
    straight, runner = played(), played()
    step = int(share * runner.stage.step_number)
    runner.stage.return_to(step)
    runner.follow()
    other = Runner(story(), stage_of(story(), StoryBall))
    other.stage.run(step)
    assert runner.target() == other.target() and runner.view(runner.film_s) == other.view(other.film_s)
    assert runner.path.at(1e9) == other.path.at(1e9)  # no key of what is to come
    while not runner.finished:
        runner.stage.run(1)
    assert runner.stage.digest() == straight.stage.digest()
    assert runner.course.entries == straight.course.entries


def test_after_taking_over_no_line_begins():
    runner = Runner(story(), Stage(StoryBall, level=story().level))
    runner.stage.run(300)
    before = runner.stage.digest()
    runner.take_over()
    runner.stage.post(Pointer("down", 1.0, 5.0, 1))
    assert runner.stage.digest() != before
    runner.stage.post(Pointer("move", -50.0, 5.0, 1))
    runner.stage.post(Pointer("up", -50.0, 5.0, 1))
    lines = dict(runner.course.begun)
    runner.stage.run(900)
    assert runner.course.begun == lines and runner.finished and not runner.playing
    assert runner.stage.step_number == 1200
    with pytest.raises(ValueError, match="left at step 300"):
        runner.return_to(301)
    runner.return_to(300)
    assert runner.stage.digest() == before
    while not runner.finished:
        runner.stage.run(1)
    straight = played()
    assert runner.course.entries == straight.course.entries
    for time in np.linspace(0.0, straight.course.end_s, 50):
        assert runner.path.at(time) == straight.path.at(time)


def test_a_line_that_is_due_where_somebody_takes_over_is_not_lost():
    straight = played()
    for entry in straight.course.entries:
        runner = Runner(story(), stage_of(story(), StoryBall))
        runner.stage.run(entry.step)
        runner.take_over()
        runner.stage.post(Pointer("down", 1.0, 5.0, 1))
        runner.stage.run(50)
        runner.return_to(entry.step)
        while not runner.finished:
            runner.stage.run(1)
        assert runner.course.entries == straight.course.entries
        assert runner.stage.digest() == straight.stage.digest()


def test_meanwhile_lets_the_next_line_begin():
    runner = played(TEXT.replace("seconds = 2.0", "seconds = 2.0\nmeanwhile = true"))
    assert begun(runner, "Follow") == [0.0]


@pytest.mark.parametrize("over", [0.0, 0.5])
def test_a_drag_is_what_a_hand_does(over):
    deed = f'{{ pointer = "drag", place = "ball", to = [3.0, 6.0], over = {over} }}'
    runner = played(TEXT.replace('{ action = "kick" }', deed))
    events = [e for e in runner.stage.recording.events if isinstance(e.event, Pointer)]
    drag = events[: next(i for i, e in enumerate(events) if e.event.kind == "up") + 1]
    kinds = [e.event.kind for e in drag]
    assert kinds[:2] == ["move", "down"] and kinds[-2:] == ["move", "up"]
    assert [(e.event.x, e.event.y) for e in drag[-2:]] == [(3.0, 6.0)] * 2
    assert (drag[-1].step - drag[0].step) * DT == pytest.approx(over, abs=0.03)
    ways = [math.hypot(e.event.x - 3.0, e.event.y - 6.0) for e in drag[1:]]
    assert ways == sorted(ways, reverse=True) and len(drag) == 4 + (29 if over else 0)


@pytest.mark.parametrize("over", [0.0, 0.5])
def test_a_pointer_moves_to_a_place_smoothly_and_presses_nothing(over):
    deed = f'{{ pointer = "move", place = [0.0, 6.0], to = [3.0, 6.0], over = {over} }}'
    runner = played(TEXT.replace('{ action = "kick" }', deed))
    events = [e for e in runner.stage.recording.events if isinstance(e.event, Pointer)]
    clicked = next(i for i, e in enumerate(events) if e.event.kind == "down")
    events = events[: clicked - 1]  # the move before it is the click's
    assert {(e.event.kind, e.event.button) for e in events} == {("move", 0)}
    ways = [e.event.x for e in events]
    assert ways[0] == 0.0 and ways[-1] == 3.0 and ways == sorted(ways)
    assert (events[-1].step - events[0].step) * DT == pytest.approx(over, abs=0.03)
    if over:
        steps = [b - a for a, b in itertools.pairwise(ways)]
        assert max(steps) == pytest.approx(1.5 * 3.0 / len(steps), rel=0.1)
        assert max(steps[:3] + steps[-3:]) < 0.5 * max(steps)


# -- camera ----------------------------------------------------------------------------------------


def test_what_is_followed_is_in_the_middle():
    runner = Runner(story(), stage_of(story(), StoryBall))
    seen = 0
    while not runner.course.reached.get("five"):
        runner.stage.run(1)
        view, target = runner.view(runner.shown_s), runner.target()
        if target is not None and runner.shown_s > 3.1:
            seen += 1
            assert abs(target[0] - view.x) <= 0.3 * view.width + 1e-9
            assert abs(target[1] - view.y) <= 0.3 * view.width * 9.0 / 16.0 + 1e-9
    assert seen > 200


def test_the_camera_moves_smoothly_and_cuts_only_where_told():
    runner = played()
    times = np.linspace(0.0, runner.course.end_s, 4000)
    views = np.array([runner.path.at(time) for time in times])
    jumps = np.linalg.norm(np.diff(views, axis=0), axis=1)
    cut = next(
        e.film_s for i, e in runner.course.begun.items() if i and getattr(runner.story.lines[i], "cut", 0)
    )
    assert runner.path.cuts() == [pytest.approx(cut)]
    far = times[1:][jumps > 0.15]
    assert len(far) == 1 and far[0] == pytest.approx(cut, abs=0.01)


def test_it_looks_ahead_of_what_moves():
    path = CameraPath(View(0.0, 0.0, math.log(10.0)))
    aim = Aim("ball", 0.0, 0.0, math.log(10.0), 0.0, 0.0, path.last())
    for i in range(100):
        path.lay(0.1 * i, i, aim, (0.2 * i, 0.0))  # 2 m/s
    assert path.at(8.0).x == pytest.approx(2.0 * (8.0 + 0.4), abs=0.01)


def test_a_place_that_is_looked_at_is_met_exactly():
    path = CameraPath(View(0.0, 0.0, math.log(10.0)))
    for i, aim in enumerate([("ball", 0.0), ("", 5.0)]):
        told = Aim(aim[0], aim[1], 0.0, math.log(10.0), 5.0 * i, 0.0, path.last())
        for j in range(50 * i, 50 * (i + 1)):
            path.lay(0.1 * j, j, told, (0.2 * j, 0.0) if not i else (5.0, 0.0))
    assert path.at(9.5).x == pytest.approx(5.0)


def test_looking_ahead_never_loses_what_moves_fast():
    for turned, most in ((False, (1.8, 1.8 * 9.0 / 16.0)), (True, (1.8 * 9.0 / 16.0, 1.8))):
        path = CameraPath(View(0.0, 0.0, math.log(10.0)), turned)
        aim = Aim("ball", 0.0, 0.0, math.log(10.0), 0.0, 0.0, path.last())
        for i in range(100):
            path.lay(0.1 * i, i, aim, (5.0 * i, 5.0 * i))  # 50 m/s
        view = path.at(9.1)
        assert (view.x - 5.0 * 89, view.y - 5.0 * 89) == (pytest.approx(most[0]), pytest.approx(most[1]))


def test_kept_inside_moves_the_view_no_further_than_it_must():
    view = View(0.0, 0.0, math.log(16.0))
    assert kept_inside(view, 4.7, -2.6) == view
    moved = kept_inside(view, 6.0, -3.7)
    assert (moved.x, moved.y) == (pytest.approx(6.0 - 4.8), pytest.approx(-3.7 + 2.7))
    moved = kept_inside(view, -6.0, 3.7)
    assert (moved.x, moved.y) == (pytest.approx(4.8 - 6.0), pytest.approx(3.7 - 2.7))
    turned = kept_inside(view, 6.0, 0.0, turned=True)
    assert turned.x == pytest.approx(6.0 - 2.7)
