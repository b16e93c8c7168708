"""The course of the billiard game: strokes, the cue ball in hand, undo, replay, set-up, choices."""

import math

import pytest

from game.billiards.table.rack import BALL_RADIUS, HEAD_SPOT
from game.levels import LevelError
from game.scenes.billiards import layout
from game.scenes.billiards.play import REPLAY_S
from game.scenes.billiards.stroke.aiming import AT_THE_RACK
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


def test_it_opens_racked_with_the_cue_ball_in_hand():
    scene = open_level().scene
    assert scene.play.phase == "aiming" and scene.model.frame.game.opening
    assert len(scene.model.frame.layout.places) == 16
    assert scene.model.frame.game.in_hand == "behind the line"
    check_balls(open_level())


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


def test_undo_twice_aims_as_the_stroke_before_the_last_did():
    stage = straight_pot()
    scene, strokes = stage.scene, []
    for turn, power in ((0.4, 0.5), (2.0, 0.8)):
        aim(stage, turn)
        stage.post(SetParameter("power", power))
        strokes.append(scene.aiming.stroke)
        stage.post(Action("strike"))
        until_aiming(stage)
    for stroke in reversed(strokes):
        stage.post(Action("undo"))
        assert scene.aiming.stroke == pytest.approx(stroke)


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


def test_a_shot_is_heard_while_it_rolls_and_in_its_replay_unless_that_is_slow():
    stage = straight_pot()
    scene = stage.scene
    assert scene.hearing() is None
    aim(stage, AT_THE_CORNER)
    stage.post(Action("strike"))
    while scene.play.phase != "rolling":
        seconds(stage, 0.05)
    first = scene.hearing()
    seconds(stage, 0.2)
    later = scene.hearing()
    assert later.key == first.key and later.time - first.time == pytest.approx(0.2)
    assert len(later.sounds) >= 3  # tip, ball, pocket
    until_aiming(stage)
    assert scene.hearing() is None
    stage.post(Action("replay"))
    seconds(stage, 0.3)
    again = scene.hearing()
    assert again.sounds == first.sounds and again.key != first.key
    assert again.time == pytest.approx(float(scene.play.clock[REPLAY_S]))
    press(stage, layout.PLAY)
    assert scene.hearing() is None
    press(stage, layout.PLAY)
    for _ in range(2):
        press(stage, layout.SPEED)
    assert scene.replay.speed < 0.5 and scene.hearing() is None


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
