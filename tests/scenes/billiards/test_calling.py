"""What is called, what would be a foul, and what is said of it."""

import msgspec
import pytest

from game.billiards.game.rules import Call
from game.scenes.billiards.stroke.calling import call_for
from game.scenes.billiards.view.words import foul_of, line_of
from game.stage import Action
from tests.scenes.billiards.billiards_stages import (
    AT_THE_CORNER,
    aim,
    click,
    drag,
    level_of,
    open_level,
    point,
    seconds,
    until_aiming,
)


def foul_in(scene, first, short=False):
    """Why it would be a foul to meet that ball first."""
    return foul_of(scene.model.frame.game, scene.aiming.call, first, short)


def test_a_ball_that_must_not_be_hit_first_is_named():
    stage = open_level("nine-ball")
    scene = stage.scene
    game = scene.model.frame.game
    assert game.legal_first() == (1,)
    assert foul_in(scene, 1) == foul_in(scene, None) == "" and foul_in(scene, 4) == "foul: the 1 first"
    assert foul_in(scene, 1, short=True) == "foul: behind the line"
    scene.aiming.call = Call(push_out=True)
    assert foul_in(scene, 4) == foul_in(scene, 1, short=True) == ""
    stage = open_level("called-pockets")
    groups = msgspec.structs.replace(
        stage.scene.model.frame.game, opening=False, groups=("solids", "stripes")
    )
    stage.scene.model.frame = stage.scene.model.frame.replace(game=groups)
    assert foul_in(stage.scene, 3) == "" and foul_in(stage.scene, 12) == "foul: not the 12"


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
