"""The two-ball program as a scene: its rules, its levels, the hand, and what it shows."""

import math

import numpy as np
import pytest

from game.levels import level_files, load_level
from game.scenes.two_balls import record
from game.scenes.two_balls.hand import ARROW
from game.scenes.two_balls.lens import NAME_SPACE, label_is_free
from game.scenes.two_balls.readouts import velocity_words
from game.scenes.two_balls.scene import LectureBalls
from game.stage import Action, Pointer, SetEffect, SetParameter, Stage
from game.ui.charts.strips import Strips
from game.ui.look.layout import arrange
from game.ui.look.look import Look
from game.ui.look.theme import DARK


def open_level(name: str = "default", **parameters) -> Stage:
    path = next(path for path in level_files("lecture-balls") if path.stem == name)
    level = load_level(path, "lecture-balls", LectureBalls.content_type)
    return Stage(LectureBalls, level=level, parameters=parameters)


def until_collision(stage: Stage, frames: int = 2000) -> Stage:
    for _ in range(frames):
        stage.run(1)
        assert stage.fault is None
        if stage.scene.model.collisions:
            return stage
    raise AssertionError("they never met")


def readout(stage: Stage, name: str) -> float:
    return next(row.value for row in stage.readouts() if row.name == name)


def test_the_conserving_rule_keeps_momentum_over_many_collisions():
    stage = open_level(hold=0.0)
    stage.run(20_000)
    assert stage.scene.model.collisions > 20
    assert readout(stage, "momentum lost") <= stage.scene.model.collisions * 1e-12


def test_as_printed_loses_momentum_and_the_readout_says_so():
    stage = until_collision(open_level("as-printed", hold=0.0))
    lost = readout(stage, "momentum lost")
    assert lost > 1.0
    row = stage.scene.model.last
    assert lost == pytest.approx(math.dist(row[record.MOMENTA][:2], row[record.MOMENTA][2:]), rel=1e-12)


def test_head_on_they_exchange_their_velocities():
    stage = until_collision(open_level("head-on", hold=0.0))
    first, second = stage.scene.model.balls
    assert first.velocity == pytest.approx((-5.0, 0.0), abs=1e-12)
    assert second.velocity == pytest.approx((9.0, 0.0), abs=1e-12)


def test_restitution_acts_on_the_normal_part_for_any_masses():
    stage = until_collision(open_level("heavy-and-light", hold=0.0, restitution=0.6))
    (n1, t1), (n2, t2) = stage.scene.model.last[record.PARTS].reshape(2, 2)
    (m1, u1), (m2, u2) = stage.scene.model.last[record.NEW_PARTS].reshape(2, 2)
    assert m1 - m2 == pytest.approx(-0.6 * (n1 - n2), rel=1e-12)
    assert (u1, u2) == pytest.approx((t1, t2), abs=1e-12)


def test_a_collision_is_held_and_its_five_steps_are_shown_in_turn():
    from game.scenes.two_balls.lens import phase_of

    stage = until_collision(open_level(hold=2.0))
    places = [ball.position for ball in stage.scene.model.balls]
    seen = []
    while stage.scene.model.hold_s > 0.0:
        seen.append(phase_of(stage.scene.model))
        assert [ball.position for ball in stage.scene.model.balls] == places
        stage.run(1)
    assert sorted(set(seen)) == [0, 1, 2, 3, 4] and seen == sorted(seen)
    assert len(seen) == pytest.approx(2.0 * 30, abs=1)
    stage = until_collision(open_level(hold=2.0))
    stage.post(Action("release"))
    stage.run(1)
    assert [ball.position for ball in stage.scene.model.balls] != places


def test_balls_and_arrows_are_dragged():
    stage = open_level()
    ball = stage.scene.model.balls[0]
    x, y = ball.position
    stage.post(Pointer("down", x, y, button=1))
    stage.post(Pointer("move", 300.0, 200.0, button=1))
    stage.post(Pointer("up", 300.0, 200.0, button=1))
    assert stage.scene.model.balls[0].position == (300.0, 200.0)
    head = (300.0 + 4.0 * ball.velocity[0], 200.0 + 4.0 * ball.velocity[1])
    stage.post(Pointer("down", *head, button=1))
    stage.post(Pointer("move", 340.0, 200.0, button=1))
    assert stage.scene.model.balls[0].velocity == (10.0, 0.0)
    stage.post(Pointer("cancel", 0.0, 0.0))
    stage.post(Pointer("move", 390.0, 200.0))
    assert stage.scene.model.balls[0].velocity == (10.0, 0.0)


def test_dragged_far_outside_it_stays_in_the_window():
    stage = open_level()
    x, y = stage.scene.model.balls[1].position
    stage.post(Pointer("down", x, y, button=1))
    stage.post(Pointer("move", -1e9, 1e9, button=1))
    assert stage.scene.model.balls[1].position == (34.0, 400.0 - 34.0)


def test_metres_are_the_same_motion_in_other_numbers():
    pixels, metres = open_level(), open_level(units="metres")
    pixels.run(30)
    metres.run(30)
    assert np.array_equal(pixels.scene.state().positions, metres.scene.state().positions)
    assert readout(metres, "speed of 1") == pytest.approx(0.004 * 30 * readout(pixels, "speed of 1"))


def test_switched_off_effects_do_nothing():
    stage = open_level("head-on")
    for name in stage.scene.effects.names:
        stage.post(SetEffect(name, False))
    before = [ball.velocity for ball in stage.scene.model.balls]
    stage.run(300)
    assert [ball.velocity for ball in stage.scene.model.balls] == before
    assert stage.scene.model.collisions == 0


def test_two_runs_and_a_way_back_give_one_digest():
    def played() -> Stage:
        stage = open_level()
        stage.run(60)
        stage.post(SetParameter("mass_ratio", 3.0))
        stage.run(40)
        stage.post(Pointer("down", *stage.scene.model.balls[0].position, button=1))
        stage.post(Pointer("move", 200.0, 150.0, button=1))
        stage.post(Pointer("up", 200.0, 150.0, button=1))
        stage.run(200)
        return stage

    first, second = played(), played()
    assert first.digest() == second.digest()
    for _ in range(30):
        first.step_back()
    first.run(30)
    assert first.digest() == second.digest()


# -- hard cases ---------------------------------------------------------------------------------------


def test_a_thin_hit_changes_little_unless_printed():
    stage = until_collision(open_level("hard-01-thin-hit", hold=0.0))
    assert abs(stage.scene.model.balls[0].velocity[0] - 6.0) < 0.4
    printed = until_collision(open_level("hard-01-thin-hit", hold=0.0, rule="as-printed"))
    assert abs(printed.scene.model.balls[0].velocity[0] - 6.0) > 2.0


def test_coincident_centres_part_at_once():
    stage = open_level("hard-02-same-place")
    stage.run(1)
    first, second = stage.scene.model.balls
    assert math.dist(first.position, second.position) == pytest.approx(68.0, abs=1e-9)
    assert np.isfinite(stage.scene.model.last).all()


def test_the_corner_turns_both_components():
    stage = open_level("hard-03-corner", bounce=1.0)
    stage.run(1)
    ball = stage.scene.model.balls[0]
    assert ball.velocity == (-55.0, -48.0)
    assert ball.position == (640.0 - 34.0, 400.0 - 34.0 - 0.0) or ball.position[0] == 606.0
    assert (stage.scene.model.walls[0, :2] > 0.0).all()


def test_the_lectures_program_does_not_see_fast_balls():
    stage = open_level("hard-04-through")
    stage.run(8)
    first, second = stage.scene.model.balls
    assert stage.scene.model.collisions == 0
    assert first.position[0] > second.position[0]


@pytest.mark.parametrize("way", (9.0, -9.0))
def test_the_magnified_collision_keeps_clear_of_the_words_around_it(way, monkeypatch):
    """Straight up and down its arrows and its angle reach farthest. The new velocities are named alone."""
    from game.app.stagehand.headless import picture_of_stage
    from game.ui.canvas.canvas import Canvas

    stage = open_level("head-on", hold=10.0)
    for ball, y, speed in zip(stage.scene.model.balls, (150.0, 250.0), (abs(way), -abs(way)), strict=True):
        ball.position, ball.velocity = (
            (320.0, y if way > 0.0 else 400.0 - y),
            (0.0, math.copysign(speed, speed * way)),
        )
    until_collision(stage)
    stage.run(round(0.3 * 10.0 * 30.0))
    heights: dict[str, tuple[float, float]] = {}
    label = Canvas.label

    def note(canvas, position, text, color="text2", size=12, weight="medium", anchor="center", **rest):
        y = canvas._place(position)[1]
        high = canvas.look.fonts.size(text, size, weight)[1]
        heights[text] = (y, y + high) if anchor == "topleft" else (y - 0.5 * high, y + 0.5 * high)
        label(canvas, position, text, color, size, weight, anchor, **rest)

    monkeypatch.setattr(Canvas, "label", note)
    for size in ((960, 512), (1520, 820)):
        heights.clear()
        picture_of_stage(stage, size, "dark")
        step = next(words for words in heights if words.startswith("2 "))
        inside = [words for words in heights if words.startswith(("α", "v₁", "v₂"))]
        assert len(inside) == 3
        assert all(heights[words][0] >= heights[step][1] for words in inside)
        assert all(heights[words][1] <= heights["before"][0] for words in inside)
        assert max(foot for _, foot in heights.values()) <= size[1]
        assert min(top for top, _ in heights.values()) >= 0.0
    stage.run(round(0.6 * 10.0 * 30.0))
    heights.clear()
    picture_of_stage(stage, size, "dark")
    assert any(words.startswith("5 ") for words in heights)
    assert not any(words.startswith(("α", "v₁", "v₂")) for words in heights)


def test_the_name_of_a_velocity_gives_way_to_that_of_a_new_one():
    centres, new = np.array([(0.0, 0.0), (80.0, 0.0)]), np.array([(-50.0, 0.0), (0.0, 50.0)])
    near, far = np.array([50.0 - 0.5 * NAME_SPACE, 0.0]), np.array([-50.0, 0.0])
    assert not label_is_free(centres, near, new, 0) and label_is_free(centres, far, new, 0)
    assert not label_is_free(centres, np.array((0.0, -50.0)), new, 1)


def test_each_strip_has_a_unit_that_of_what_is_chosen_now():
    stage, strips = open_level(), Strips(Look(DARK), LectureBalls.strips)
    strips.place(arrange(1280, 720, 1.0), strips.look)
    for units, shown in (
        ("pixels", ["kg px/frame", "kg px²/frame²", "kg px/frame"]),
        ("metres", ["kg m/s", "J", "kg m/s"]),
    ):
        stage.post(SetParameter("units", units))
        stage.run(2)
        strips.update(0.3, stage)
        assert [strips.unit_shown(strip) for strip in LectureBalls.strips] == shown


def alone(**parameters) -> Stage:
    """Two balls without walls, collisions and friction."""
    names = tuple(effect.name for effect in LectureBalls.effects)
    return Stage(LectureBalls, parameters=parameters, effects_off=names)


def test_acceleration_is_added_to_the_velocity_in_every_frame():
    stage = alone(acceleration=0.5, direction=90.0)
    before = [ball.velocity for ball in stage.scene.model.balls]
    stage.run(10)
    for ball, (vx, vy) in zip(stage.scene.model.balls, before, strict=True):
        assert ball.velocity == pytest.approx((vx, vy + 5.0), abs=1e-12)


def test_the_direction_of_an_acceleration_is_clockwise_from_the_right_as_y_points_down():
    stage = alone(acceleration=2.0, direction=-30.0)
    (vx, vy), _ = (ball.velocity for ball in stage.scene.model.balls)
    stage.run(1)
    now = stage.scene.model.balls[0].velocity
    assert now == pytest.approx((vx + math.sqrt(3.0), vy - 1.0), abs=1e-12)


def test_deceleration_takes_from_the_speed_and_ends_at_rest():
    stage = alone(deceleration=2.0)
    ball = stage.scene.model.balls[0]
    speed, angle = ball.speed, ball.angle
    stage.run(3)
    ball = stage.scene.model.balls[0]
    assert ball.speed == pytest.approx(speed - 6.0) and ball.angle == pytest.approx(angle)
    stage.run(30)
    assert [ball.speed for ball in stage.scene.model.balls] == [0.0, 0.0]


def test_speed_direction_and_components_are_written_also_while_a_ball_is_dragged():
    stage = open_level("default")
    model = stage.scene.model
    assert velocity_words(model, 0) == "18.0 px/frame at 56°, (10.0, 15.0)"
    assert velocity_words(model, 1) == "22.4 px/frame at −153°, (−20.0, −10.0)"
    stage.post(SetParameter("units", "metres"))
    assert velocity_words(stage.scene.model, 0) == "2.16 m/s at 56°, (1.20, 1.80)"
    stage.post(SetParameter("units", "pixels"))
    x, y = stage.scene.model.balls[0].position
    head = (x + ARROW * 10.0, y + ARROW * 15.0)
    stage.post(Pointer("down", *head, 1))
    stage.post(Pointer("move", x + ARROW * 8.0, y, 1))
    assert velocity_words(stage.scene.model, 0) == "8.0 px/frame at 0°, (8.0, 0.0)"
    assert readout(stage, "direction of 1") == 0.0
