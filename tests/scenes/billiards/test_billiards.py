"""The billiard game by hand: aiming, strokes, cue ball in hand, undo, replay, set-up, choices."""

import math

import msgspec
import numpy as np
import pytest

from game.billiards.game.frame import Struck, trajectory_of
from game.billiards.game.rules import Call
from game.billiards.table.rack import BALL_RADIUS, HEAD_SPOT
from game.levels import LevelError
from game.scenes.billiards import layout
from game.scenes.billiards.play import REPLAY_S
from game.scenes.billiards.stroke.aiming import AT_THE_RACK, LARGEST_TIP, NOTCH, TIP_STEP
from game.scenes.billiards.stroke.calling import call_for
from game.scenes.billiards.stroke.motion import cue_speed_of, power_of, pull_of, stroke_motion
from game.scenes.billiards.stroke.prediction import foresee
from game.scenes.billiards.view.words import foul_of, line_of
from game.scenes.shared.tables.cue import FULL_PULL, MAX_SPEED
from game.stage import Action, Decision, ParameterError, SetEffect, SetParameter
from tests.scenes.billiards.billiards_stages import (
    AT_THE_CORNER,
    aim,
    check_balls,
    drag,
    level_of,
    open_level,
    point,
    press,
    seconds,
    standing,
    straight_pot,
    until_aiming,
)


def foul_in(scene, first):
    """Why it would be a foul to meet that ball first."""
    return foul_of(scene.model.frame.game, scene.aiming.call, first)


def test_it_opens_racked_with_the_cue_ball_in_hand():
    scene = open_level().scene
    assert scene.play.phase == "aiming" and scene.model.frame.game.opening
    assert len(scene.model.frame.layout.places) == 16
    assert scene.model.frame.game.in_hand == "behind the line"
    check_balls(open_level())


def test_pulling_the_cue_back_strikes_as_hard_as_it_was_pulled():
    stage = straight_pot()
    scene = stage.scene
    aim(stage, AT_THE_CORNER)
    pull = 0.4 * FULL_PULL
    x, y = 0.45, 0.45
    point(stage, "down", x, y, button=1)
    assert scene.play.grip == "cue"
    point(
        stage,
        "move",
        x - pull * math.cos(scene.aiming.cue.aim),
        y - pull * math.sin(scene.aiming.cue.aim),
        button=1,
    )
    assert scene.parameters.power == pytest.approx(0.4 * MAX_SPEED)
    point(
        stage,
        "up",
        x - pull * math.cos(scene.aiming.cue.aim),
        y - pull * math.sin(scene.aiming.cue.aim),
        button=1,
    )
    assert scene.play.phase == "striking"
    seconds(stage, 0.5)
    assert scene.play.phase == "rolling"
    struck = scene.model.frame.last
    assert power_of(struck.stroke.cue_speed) == pytest.approx(0.4 * MAX_SPEED)
    until_aiming(stage)
    assert 3 not in [number for number, _, _ in scene.model.frame.layout.places]
    assert scene.model.frame.game.potted == 1
    check_balls(stage)


def test_after_a_pull_the_power_is_again_what_was_set():
    stage = straight_pot()
    scene = stage.scene
    stage.post(SetParameter("power", 2.5))
    aim(stage, AT_THE_CORNER)
    x, y = scene.model.frame.cue_ball
    ux, uy = math.cos(AT_THE_CORNER), math.sin(AT_THE_CORNER)
    near, far = 0.1, 0.1 - 0.6 * FULL_PULL
    drag(stage, (x + near * ux, y + near * uy), (x + far * ux, y + far * uy))
    assert scene.play.phase == "striking" and scene.parameters.power > 2.5
    until_aiming(stage)
    assert scene.parameters.power == 2.5
    stage.post(Action("undo"))
    assert scene.parameters.power > 2.5  # the same stroke can be tried again


def test_a_ball_that_must_not_be_hit_first_is_named():
    stage = open_level("nine-ball")
    scene = stage.scene
    game = scene.model.frame.game
    assert game.legal_first() == (1,)
    assert foul_in(scene, 1) == foul_in(scene, None) == "" and foul_in(scene, 4) == "foul: the 1 first"
    scene.aiming.call = Call(push_out=True)
    assert foul_in(scene, 4) == ""
    stage = open_level("called-pockets")
    groups = msgspec.structs.replace(
        stage.scene.model.frame.game, opening=False, groups=("solids", "stripes")
    )
    stage.scene.model.frame = stage.scene.model.frame.replace(game=groups)
    assert foul_in(stage.scene, 3) == "" and foul_in(stage.scene, 12) == "foul: not the 12"


def test_a_short_pull_is_a_change_of_mind_and_esc_takes_the_stroke_back():
    stage = straight_pot()
    scene = stage.scene
    power = scene.parameters.power
    aim(stage, AT_THE_CORNER)
    drag(stage, (0.45, 0.45), (0.4502, 0.4502))
    assert scene.play.phase == "aiming" and scene.parameters.power == power
    point(stage, "down", 0.45, 0.45, button=1)
    point(stage, "move", 0.6, 0.6, button=1)
    assert scene.parameters.power != power
    point(stage, "cancel", 0.6, 0.6)
    assert scene.play.phase == "aiming" and scene.parameters.power == power and not scene.play.grip


def test_the_line_that_is_aimed_by_is_the_stroke_itself():
    stage = straight_pot()
    scene = stage.scene
    aim(stage, AT_THE_CORNER + 0.02)
    scene.parameters.tip_up, scene.parameters.tip_left, scene.parameters.elevation = -0.4, 0.2, 12.0
    struck = Struck(scene.model.frame, scene.aiming.stroke)
    sight = foresee(struck, 60)
    stage.post(Action("strike"))
    seconds(stage, 0.5)
    played = scene.model.played
    assert played.trajectory.digest == trajectory_of(struck).digest
    assert sight.target == 3
    assert sight.last == pytest.approx(played.trajectory.final["0"], abs=1e-9)
    ghost = np.array(sight.ghost)
    first = next(event.time for event in played.trajectory.events if event.type == "ball-ball")
    assert ghost == pytest.approx(played.trajectory.state_at(first).positions[0], abs=1e-9)
    assert np.linalg.norm(ghost - sight.target_place) == pytest.approx(2.0 * BALL_RADIUS, abs=1e-9)
    path = next(path for path in sight.others if path.number == 3)
    assert path.points[-1] == pytest.approx(played.trajectory.end[1, :2], abs=1e-9)


def test_fewer_events_show_a_shorter_path():
    stage = open_level("default")
    scene = stage.scene
    struck = Struck(scene.model.frame, scene.aiming.stroke)
    lengths = []
    for events in (1, 40, 120):
        sight = foresee(struck, events)
        lengths.append(sum(np.abs(np.diff(path.points, axis=0)).sum() for path in sight.others))
    assert lengths == sorted(lengths) and lengths[0] < 1e-3 < lengths[-1]


def test_the_cue_ball_in_hand_stays_behind_the_line_and_out_of_others():
    stage = open_level()
    scene = stage.scene
    start = scene.model.frame.cue_ball
    drag(stage, start, (0.3, 0.3))
    assert scene.model.frame.cue_ball == pytest.approx((0.3, 0.3))
    drag(stage, (0.3, 0.3), (0.635, 2.0))
    assert scene.model.frame.cue_ball[1] <= HEAD_SPOT * 2.54 + 1e-12
    assert scene.play.phase == "aiming"
    check_balls(stage)


def test_after_a_scratch_the_cue_ball_is_in_hand_for_the_other():
    stage = level_of(
        'game = "eight-ball"\nballs = [{ number = 0, position = [0.3, 0.3] },'
        " { number = 3, position = [0.9, 2.2] }, { number = 8, position = [0.3, 2.0] },"
        " { number = 9, position = [0.5, 1.6] }]"
    )
    scene = stage.scene
    aim(stage, AT_THE_CORNER)
    stage.post(Action("strike"))
    until_aiming(stage)
    assert scene.model.frame.foul and "went down" in " ".join(scene.model.frame.words)
    assert scene.model.frame.game.turn == 1 and scene.model.frame.game.in_hand == "anywhere"
    assert scene.model.frame.cue_ball is not None
    drag(stage, scene.model.frame.cue_ball, (0.8, 1.9))
    assert scene.model.frame.cue_ball == pytest.approx((0.8, 1.9))
    check_balls(stage)


def test_fine_aim_by_wheel_keys_and_shift_is_not_spoilt_by_a_trembling_hand():
    stage = straight_pot()
    scene = stage.scene
    aim(stage, 1.0)
    assert scene.aiming.cue.aim == pytest.approx(1.0)
    x, y = scene.model.frame.cue_ball
    here = (x + 0.1 * math.cos(1.0), y + 0.1 * math.sin(1.0))
    point(stage, "wheel", *here, wheel=2.0)
    fine = scene.aiming.cue.aim
    assert fine == pytest.approx(1.0 - 2.0 * NOTCH)
    point(stage, "move", here[0] + 0.001, here[1])
    assert scene.aiming.cue.aim == fine
    point(stage, "wheel", *here, wheel=1.0, shift=True)
    assert scene.aiming.cue.aim == pytest.approx(fine - 0.1 * NOTCH)
    stage.post(Action("left"))
    assert scene.aiming.cue.aim > fine
    point(stage, "move", x - 0.1, y)
    assert abs(scene.aiming.cue.aim) == pytest.approx(math.pi)
    point(stage, "move", x - 0.1, y + 0.02, shift=True)
    assert abs(abs(scene.aiming.cue.aim) - math.pi) == pytest.approx(0.1 * math.atan2(0.02, 0.1), rel=1e-6)


def click(stage, x, y):
    """Press and let go where the pointer already is."""
    point(stage, "down", x, y, button=1)
    point(stage, "up", x, y, button=1)


def test_a_click_locks_the_aim_and_another_frees_it():
    stage = straight_pot()
    scene = stage.scene
    aim(stage, 1.0)
    x, y = scene.model.frame.cue_ball
    click(stage, x + 0.1 * math.cos(1.0), y + 0.1 * math.sin(1.0))
    assert scene.aiming.locked and scene.play.phase == "aiming" and "locked" in scene.messages()[0]
    for place in ((0.9, 1.9), layout.SPIN, (0.2, 2.4)):
        point(stage, "move", *place)
    assert scene.aiming.cue.aim == pytest.approx(1.0)
    stage.post(Action("left"))
    assert scene.aiming.cue.aim > 1.0  # finely, by keys and wheel, it can still be turned
    stage.step_back()
    stage.resume()
    assert scene.aiming.locked
    click(stage, 0.2, 2.4)
    assert not scene.aiming.locked and not scene.messages()
    point(stage, "move", x + 0.1, y)
    assert scene.aiming.cue.aim == pytest.approx(0.0)
    stage.post(Action("lock"))
    assert scene.aiming.locked


def test_a_locked_aim_is_pulled_from_anywhere_and_is_free_after_the_stroke():
    stage = straight_pot()
    scene = stage.scene
    aim(stage, AT_THE_CORNER)
    stage.post(Action("lock"))
    drag(stage, (0.9, 1.8), (1.0, 1.9))
    assert scene.play.phase == "striking"
    assert scene.play.pending.azimuth == pytest.approx(AT_THE_CORNER)
    until_aiming(stage)
    assert scene.model.frame.game.potted == 1 and not scene.aiming.locked
    stage.post(Action("undo"))
    point(stage, "move", 0.9, 1.8)
    assert scene.aiming.cue.aim == pytest.approx(AT_THE_CORNER)  # undo aims as before, and so it stays


def test_the_aim_that_stood_is_kept_on_the_way_to_an_instrument():
    stage = straight_pot()
    scene = stage.scene
    aim(stage, 1.0)
    seconds(stage, 0.5)
    for share in (0.3, 0.6, 0.9):  # over the cloth to the spin at its right
        point(stage, "move", 0.6, 0.5 + 2.0 * share)
        seconds(stage, 0.1)
    assert scene.aiming.cue.aim != pytest.approx(1.0)
    drag(stage, layout.SPIN, (layout.SPIN[0], layout.SPIN[1] + 0.01))
    assert scene.aiming.cue.aim == pytest.approx(1.0) and scene.aiming.locked
    assert scene.parameters.tip_left < 0.0


def test_the_right_button_and_keys_set_spin_while_one_watches_the_line():
    stage = straight_pot()
    scene = stage.scene
    aim(stage, 1.0)
    scene.aiming.set_tip(0.1, 0.0)
    point(stage, "down", 0.6, 0.6, button=3)
    point(stage, "move", 0.6 + 0.3 * layout.SPIN_RADIUS, 0.6 + 0.2 * layout.SPIN_RADIUS, button=3)
    assert (scene.parameters.tip_left, scene.parameters.tip_up) == pytest.approx((-0.1, -0.3))
    assert scene.aiming.cue.aim == pytest.approx(1.0)
    point(stage, "move", 1.2, 0.6, button=3)
    assert scene.parameters.tip_up == pytest.approx(-math.sqrt(LARGEST_TIP**2 - 0.0), abs=0.02)
    point(stage, "up", 1.2, 0.6, button=3)
    assert not scene.play.grip and scene.play.phase == "aiming"
    scene.aiming.centre()
    for name in ("spin-up", "spin-up", "spin-right", "spin-down", "spin-left", "spin-left"):
        stage.post(Action(name))
    assert (scene.parameters.tip_left, scene.parameters.tip_up) == pytest.approx((TIP_STEP, TIP_STEP))
    point(stage, "down", 0.45, 0.45, button=1)  # with the cue in hand it still takes the stroke back
    point(stage, "down", 0.45, 0.45, button=3)
    assert not scene.play.grip and scene.play.phase == "aiming"


def test_instruments_follow_the_pointer():
    stage = straight_pot()
    scene = stage.scene
    zero, full = layout.POWER.bottom - layout.POWER_FOOT, layout.POWER.top + layout.POWER_TOP
    middle = (0.5 * (zero + full), layout.LEFT_MIDDLE)
    drag(stage, (zero, layout.LEFT_MIDDLE), middle)
    assert scene.parameters.power == pytest.approx(0.5 * MAX_SPEED)
    point(stage, "wheel", *middle, wheel=-3.0)
    assert scene.parameters.power == pytest.approx(0.5 * MAX_SPEED - 0.3)
    sx, sy = layout.SPIN
    drag(stage, (sx, sy), (sx + 0.3 * layout.SPIN_RADIUS, sy - 0.2 * layout.SPIN_RADIUS))
    assert (scene.parameters.tip_up, scene.parameters.tip_left) == pytest.approx((-0.3, 0.2))
    drag(stage, (sx, sy), (sx - 5.0 * layout.SPIN_RADIUS, sy))
    assert scene.parameters.tip_up == pytest.approx(LARGEST_TIP)
    dx, dy = layout.ELEVATION
    reach = layout.ELEVATION_RADIUS
    drag(stage, (dx, dy + reach), (dx - reach * math.sin(0.5), dy + reach * math.cos(0.5)))
    assert scene.parameters.elevation == pytest.approx(math.degrees(0.5))
    stage.post(Action("centre"))
    assert (scene.parameters.tip_up, scene.parameters.tip_left, scene.parameters.elevation) == (0.0, 0.0, 0.0)
    stage.post(Action("harder"))
    assert scene.play.phase == "aiming" and scene.aiming.cue.phase == 0.0


def test_undo_goes_back_before_the_stroke_with_the_same_aim():
    stage = straight_pot()
    scene = stage.scene
    before = scene.model.frame
    aim(stage, AT_THE_CORNER)
    scene.parameters.tip_up = -0.2
    stroke = scene.aiming.stroke
    stage.post(Action("strike"))
    until_aiming(stage)
    after = scene.model.frame.layout.places
    assert after != before.layout.places
    scene.parameters.tip_up = 0.5
    scene.aiming.cue.point_to(0.0)
    stage.post(Action("undo"))
    assert scene.model.frame.layout.places == before.layout.places and scene.model.frame.game == before.game
    assert scene.aiming.stroke == pytest.approx(stroke)
    stage.post(Action("strike"))
    until_aiming(stage)
    assert scene.model.frame.layout.places == after
    check_balls(stage)
    stage.post(Action("undo"))
    stage.post(Action("undo"))
    assert (
        scene.model.frame.layout.places == before.layout.places
    )  # there was nothing more to undo, and it was said
    assert any("undo" in text for text in scene.messages())


def test_a_stroke_can_be_skipped_to_its_end():
    stage = straight_pot()
    scene = stage.scene
    aim(stage, AT_THE_CORNER)
    stage.post(Action("strike"))
    seconds(stage, 0.4)
    stage.post(Action("strike"))
    assert scene.play.phase == "aiming" and scene.model.frame.game.potted == 1


def test_replay_runs_at_any_speed_stands_and_is_scrubbed():
    stage = straight_pot()
    scene = stage.scene
    stage.post(Action("replay"))
    assert scene.play.phase == "aiming"  # nothing to show yet
    aim(stage, AT_THE_CORNER)
    stage.post(Action("strike"))
    until_aiming(stage)
    kept = scene.model.frame
    stage.post(Action("replay"))
    assert scene.play.phase == "replay"
    press(stage, layout.SPEED)
    assert scene.replay.speed == 0.5
    seconds(stage, 0.5)
    assert scene.play.clock[REPLAY_S] == pytest.approx(0.25)
    press(stage, layout.PLAY)
    seconds(stage, 0.5)
    assert scene.play.clock[REPLAY_S] == pytest.approx(0.25, abs=0.01)
    bar = layout.SCRUBBER
    half = (bar.middle[0], 0.5 * (bar.left + bar.right))
    drag(stage, (bar.middle[0], bar.left), half)
    assert scene.play.clock[REPLAY_S] == pytest.approx(0.5 * scene.play.shown_s)
    drag(stage, half, (bar.middle[0], bar.right + 1.0))
    assert scene.play.clock[REPLAY_S] == pytest.approx(scene.play.shown_s)
    press(stage, layout.PLAY)  # from the end it begins anew
    assert scene.play.clock[REPLAY_S] == 0.0 and scene.replay.runs
    stage.post(Action("replay"))
    assert scene.play.phase == "aiming" and scene.model.frame is kept


def test_set_up_places_balls_and_what_is_saved_opens_again():
    stage = straight_pot()
    scene = stage.scene
    stage.post(Action("set-up"))
    assert scene.play.phase == "set-up"
    drag(stage, layout.tray_place(11), (0.6, 1.3))
    drag(stage, (0.9, 2.2), (0.9, 3.2))
    drag(stage, (0.22, 0.22), (0.5, 0.505))  # into the cue ball: as near as it may lie
    assert [number for number, _, _ in scene.model.frame.layout.places] == [0, 3, 11]
    stage.post(Action("set-up"))
    assert scene.play.phase == "aiming" and scene.model.frame.game.on_table == (3, 11)
    check_balls(stage)
    content = scene.save_content()
    again = level_of_content(content)
    assert again.scene.model.frame.layout.places == scene.model.frame.layout.places
    assert again.scene.model.frame.game == scene.model.frame.game
    stage.post(Action("undo"))
    assert scene.model.frame.game.on_table == (3, 5)
    stage.post(Action("set-up"))
    press(stage, layout.button_box(1))
    assert [number for number, _, _ in scene.model.frame.layout.places] == [0]
    press(stage, layout.button_box(2))
    assert len(scene.model.frame.layout.places) == 16
    stage.post(Action("set-up"))
    check_balls(stage)


def level_of_content(content):
    from game.levels import Level, format_level, parse_level
    from game.scenes.billiards.scene import Billiards
    from game.stage import Stage

    text = format_level(Level(scene="billiards", content=content))
    return Stage(Billiards, level=parse_level(text, "billiards", Billiards.content_type))


def test_an_illegal_break_gives_a_choice_by_click_and_key():
    for by_key in (False, True):
        stage = open_level()
        scene = stage.scene
        aim(stage, 0.5 * math.pi)
        stage.post(SetParameter("power", 1.0))
        stage.post(Action("strike"))
        until_aiming(stage)
        options = scene.model.frame.game.options
        assert len(options) == 3 and scene.model.frame.game.turn == 1
        places = scene.model.frame.layout.places
        aim_before = scene.aiming.cue.aim
        point(stage, "move", 0.3, 0.3)
        assert scene.aiming.cue.aim == aim_before
        stage.post(Action("strike"))
        assert (
            scene.play.phase == "aiming" and scene.model.frame.layout.places == places
        )  # first it must be chosen
        if by_key:
            stage.post(Action("second"))
        else:
            press(stage, layout.option_box(1, 3))
        assert not scene.model.frame.game.options and scene.model.frame.game.opening
        check_balls(stage)


def test_a_click_on_a_name_makes_it_a_computer_player_of_the_next_grade():
    stage = open_level()
    grades = []
    for _ in range(5):
        press(stage, layout.card_box(1))
        grades.append(stage.scene.parameters.second_player)
    assert grades == ["novice", "club", "expert", "master", "person"]
    assert stage.scene.parameters.first_player == "person" and stage.scene.play.phase == "aiming"


def called_pockets():
    return level_of(
        'game = "eight-ball"\ncalling = "all"\nballs = [{ number = 0, position = [0.5, 0.5] },'
        " { number = 3, position = [0.22, 0.22] }, { number = 5, position = [0.9, 2.2] },"
        " { number = 8, position = [0.3, 1.9] }, { number = 10, position = [0.6, 1.9] }]"
    )


def test_pockets_are_called_by_hand_or_by_the_line_of_aim():
    stage = called_pockets()
    scene = stage.scene
    aim(stage, AT_THE_CORNER)
    assert call_for(scene.model.frame, scene.aiming.call, scene.aiming.stroke) == (3, 0, False, False)
    assert line_of(scene.play, None).more == "Called: the 3 into the upper left pocket."
    x, y, _ = scene.model.frame.table.pockets[5].tolist()
    point(stage, "down", x, y, button=1)
    point(stage, "up", x, y, button=1)
    point(stage, "down", 0.9, 2.2, button=1)
    point(stage, "up", 0.9, 2.2, button=1)
    assert scene.aiming.call[:2] == (5, 5) and scene.play.phase == "aiming"
    stage.post(Action("safety"))
    assert scene.aiming.call.safety and scene.aiming.call.ball is None
    stage.post(Action("safety"))
    stage.post(Action("lock"))  # which frees the aim that was locked when the pocket was called
    aim(stage, AT_THE_CORNER)
    stage.post(Action("strike"))
    until_aiming(stage)
    assert scene.model.frame.game.groups == ("solids", "stripes") and scene.model.frame.game.turn == 0


def test_a_click_on_a_pocket_calls_it_and_leaves_the_aim_alone():
    stage = called_pockets()
    scene = stage.scene
    aim(stage, AT_THE_CORNER)
    seconds(stage, 0.5)
    x, y, _ = scene.model.frame.table.pockets[5].tolist()
    for place in ((0.7, 1.0), (0.9, 2.0), (x, y)):
        point(stage, "move", *place)
        seconds(stage, 0.1)
    before = scene.aiming.cue.aim
    seconds(stage, 2.0)  # however long one looks
    assert scene.aiming.cue.aim == before
    click(stage, x, y)
    assert scene.aiming.call.pocket == 5
    assert scene.aiming.cue.aim == pytest.approx(AT_THE_CORNER) and scene.aiming.locked


def test_a_pull_that_begins_on_a_ball_is_a_pull():
    stage = called_pockets()
    scene = stage.scene
    aim(stage, AT_THE_CORNER)
    stage.post(Action("lock"))
    drag(stage, (0.9, 2.2), (1.0, 2.3))
    assert scene.play.phase == "striking" and scene.play.pending.azimuth == pytest.approx(AT_THE_CORNER)
    assert scene.aiming.call[:2] == (3, 0)


def test_it_is_said_that_a_call_is_needed():
    stage = called_pockets()
    aim(stage, -0.2)  # past all balls
    assert line_of(stage.scene.play, None).more.startswith("A call is needed")
    stage.post(Action("safety"))
    assert line_of(stage.scene.play, None).more == "A safety."


def test_what_follows_is_said_first_and_then_why():
    stage = level_of(
        'game = "eight-ball"\nballs = [{ number = 0, position = [0.3, 0.3] },'
        " { number = 3, position = [0.9, 2.2] }, { number = 8, position = [0.3, 2.0] },"
        " { number = 9, position = [0.5, 1.6] }]"
    )
    aim(stage, AT_THE_CORNER)
    stage.post(Action("strike"))
    until_aiming(stage)
    line = line_of(stage.scene.play, None)
    assert line.lead == "Ben has the cue ball in hand." and line.foul
    assert line.more.startswith("The cue ball went down.")


def test_a_drill_puts_its_balls_back_and_gives_stars():
    stage = level_of(
        'game = "drill"\nballs = [{ number = 0, position = [0.5, 0.5] },'
        " { number = 3, position = [0.22, 0.22] }]\n"
        "[content.goal]\npots = [{ ball = 3, pocket = 0 }]\n"
        "[[content.more]]\nzones = [{ ball = 0, x = 0.35, y = 0.35, radius = 0.4 }]"
    )
    scene = stage.scene
    start = scene.model.frame.layout.places
    aim(stage, AT_THE_CORNER + 0.3)
    stage.post(Action("strike"))
    until_aiming(stage)
    assert scene.model.frame.game.best == 0 and scene.model.frame.layout.places == start
    stage.post(SetParameter("tip_up", -0.3))  # else the cue ball follows into the pocket
    aim(stage, AT_THE_CORNER)
    stage.post(SetParameter("power", 2.5))
    stage.post(Action("strike"))
    until_aiming(stage)
    assert scene.model.frame.game.best == 2 and scene.model.frame.game.attempts == 2
    assert scene.model.frame.layout.places == start
    stage.post(Action("rack"))
    assert scene.model.frame.game.attempts == 0


def test_next_rack_after_the_game_is_won():
    stage = level_of(
        'game = "nine-ball"\nballs = [{ number = 0, position = [0.5, 0.5] },'
        " { number = 9, position = [0.22, 0.22] }]"
    )
    scene = stage.scene
    aim(stage, AT_THE_CORNER)
    stage.post(Action("strike"))
    until_aiming(stage)
    assert scene.model.frame.game.over and scene.model.frame.game.won == (1, 0)
    aim_before = scene.aiming.cue.aim
    point(stage, "move", 0.9, 1.0)
    assert scene.aiming.cue.aim == aim_before
    won, lost = standing(stage).cards
    assert (won.status, won.lit) == ("won the rack", True) and (lost.status, lost.lit) == ("", False)
    stage.post(Action("strike"))
    assert (
        scene.model.frame.game.opening
        and scene.model.frame.game.breaker == 1
        and scene.model.frame.game.won == (1, 0)
    )
    assert scene.aiming.cue.aim == AT_THE_RACK
    assert not standing(stage).cards[0].lit and standing(stage).cards[1].lit
    check_balls(stage)


def test_effects_and_measures_of_the_table_hold_for_the_next_stroke():
    stage = straight_pot()
    stage.post(SetEffect("cloth", False))
    stage.post(SetEffect("pockets", False))
    stage.post(SetParameter("cushion_restitution", 1.0))
    scene = stage.scene
    assert scene.model.frame.physics.sliding == 0.0 and len(scene.model.frame.table.pockets) == 0
    aim(stage, AT_THE_CORNER)
    stage.post(Action("strike"))
    seconds(stage, 30.0)
    assert scene.play.phase == "rolling"
    stage.post(Action("strike"))
    assert scene.play.phase == "aiming" and len(scene.model.frame.layout.places) == 3


def test_what_is_changed_while_balls_roll_holds_after_the_stroke():
    stage = straight_pot()
    scene = stage.scene
    stage.post(Action("strike"))
    seconds(stage, 0.5)
    assert scene.play.phase == "rolling"
    stage.post(SetParameter("sliding", 0.31))
    stage.post(SetEffect("pockets", False))
    until_aiming(stage)
    assert scene.model.frame.physics.sliding == 0.31 and len(scene.model.frame.table.pockets) == 0


def test_balls_of_different_sizes_are_racked_and_played():
    stage = open_level("combination", mass_spread=0.5, radius_spread=0.3)
    radii, masses = stage.scene.model.frame.conditions.radii, stage.scene.model.frame.conditions.masses
    assert radii[0] == BALL_RADIUS and len(set(radii)) > 10 and len(set(masses)) > 10
    assert max(radii) == BALL_RADIUS
    aim(stage, 0.5 * math.pi)
    stage.post(SetParameter("power", 9.0))
    stage.post(Action("strike"))
    until_aiming(stage)
    check_balls(stage)


def test_the_cue_meets_the_ball_when_the_stroke_begins():
    for power in (0.1, 1.0, 4.0, 10.0):
        for practised in (False, True):
            motion = stroke_motion(cue_speed_of(power), practised)
            gap, solid = motion.track.sample(motion.hit_s).tolist()
            assert gap == 0.0 and solid == 1.0
            times = np.linspace(0.0, motion.hit_s, 400)
            gaps = motion.track.sample(times)[:, 0]
            assert gaps.min() >= 0.0 and gaps.max() <= max(pull_of(power), 0.6 * pull_of(power) + 0.02) + 1e-9
            assert motion.track.sample(motion.end_s).tolist()[1] == 0.0
            if not practised:
                assert gaps[0] == pytest.approx(pull_of(power))
                assert np.all(np.diff(gaps) <= 0.0)


def test_decisions_that_cannot_be_are_refused():
    stage = open_level()
    for event in (
        Decision("stroke", (1.0,)),
        Decision("option", (0.0,)),
        Decision("dance", ()),
        Decision("stroke", (2.0, math.nan, 0.0, 0.0, 0.0, -1.0, -1.0, 0.0, 0.0)),
        Decision("stroke", (2.0, 1.0, 0.0, 2.0, 0.0, -1.0, -1.0, 0.0, 0.0)),
    ):
        with pytest.raises(ParameterError):
            stage.post(event)
    straight = straight_pot()
    with pytest.raises(ParameterError):
        straight.post(Decision("white", (0.5, 0.5)))
    stage.post(Decision("white", (0.4, 0.4)))
    assert stage.scene.model.frame.cue_ball == pytest.approx((0.4, 0.4))


@pytest.mark.parametrize(
    ("content", "field"),
    [
        (
            "balls = [{ number = 0, position = [0.5, 0.5] }, { number = 0, position = [0.8, 0.5] }]",
            "number 0",
        ),
        (
            "balls = [{ number = 0, position = [0.5, 0.5] }, { number = 1, position = [0.5, 0.51] }]",
            "number 1",
        ),
        ("balls = [{ number = 0, position = [-0.5, 0.5] }]", "number 0"),
        ('game = "drill"', "goal"),
        ("[content.goal]\ndown = 1", "goal"),
        ("[content.saved]\ngame = 'chess'", "saved"),
        ("[content.saved]\ngame = 'eight-ball'\nturn = 7", "saved.turn"),
        ("[content.saved]\ngame = 'nine-ball'\non_table = [1, 1]", "saved.on_table"),
    ],
)
def test_a_broken_level_is_named(content, field):
    with pytest.raises(LevelError) as refused:
        level_of(content)
    assert field in str(refused.value)
