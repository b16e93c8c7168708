"""A position of one's own: played to its end, set up again, by a hand or by the table itself."""

import pytest

from game.billiards.game.games import Ghost, Practice
from game.levels import level_files
from game.scenes.billiards import layout
from game.stage import Action
from tests.scenes.billiards.billiards_stages import (
    AT_THE_CORNER,
    drag,
    level_of,
    open_level,
    seconds,
    until_aiming,
)
from tests.scenes.billiards.test_drill_maker import press_button, strike

ONE_BALL = 'balls = [{number=0,position=[0.5,0.5]},{number=3,position=[0.22,0.22]}]\ngame = "practice"'


def own_position(stage):
    """Set up by hand: the 3 before a corner, the cue ball straight behind it."""
    stage.post(Action("set-up"))
    press_button(stage, "clear")
    drag(stage, stage.scene.model.frame.cue_ball, (0.5, 0.5))
    drag(stage, layout.tray_place(3), (0.22, 0.22))
    press_button(stage, "set-up")
    assert stage.scene.play.phase == "aiming"
    return stage


def test_what_was_potted_is_set_up_again_and_the_match_is_behind_it():
    stage = own_position(open_level("ghost-09"))
    model = stage.scene.model
    places, hand = model.frame.layout.places, model.frame.game.in_hand
    strike(stage, 1.0, AT_THE_CORNER)
    assert model.frame.game.over
    assert ("rack", "Again", True) in stage.scene.buttons.rows()
    press_button(stage, "rack")
    game = model.frame.game
    assert model.frame.layout.places == places and game.on_table == (3,) and game.in_hand == hand
    assert (game.strokes, game.potted, game.over) == (1, 1, False)
    assert model.match_behind
    press_button(stage, "undo")
    assert isinstance(model.frame.game, Ghost)


def test_in_the_midst_it_is_set_up_again_too():
    stage = level_of(ONE_BALL)
    strike(stage, 1.0, 0.3)
    stage.post(Action("rack"))
    assert stage.scene.model.frame.layout.places == ((0, 0.5, 0.5), (3, 0.22, 0.22))


def test_a_cue_ball_in_the_tray_is_in_hand_again():
    stage = own_position(open_level("ghost-09"))
    stage.post(Action("set-up"))
    drag(stage, (0.5, 0.5), (-0.3, 1.0))
    press_button(stage, "set-up")
    strike(stage, 1.0, 0.3)
    stage.post(Action("rack"))
    frame = stage.scene.model.frame
    assert frame.game.in_hand == "anywhere" and frame.cue_ball is not None


@pytest.mark.parametrize("name", ["own", *(path.stem for path in level_files("billiards"))][:12])
def test_the_table_plays_itself_through_the_end_of_any_game(name):
    stage = level_of(ONE_BALL) if name == "own" else open_level(name)
    stage.post(Action("demo"))
    seconds(stage, 90.0)
    assert stage.scene.play.plays_itself


def test_the_table_clears_a_position_of_ones_own_and_sets_it_up_again():
    stage = level_of(ONE_BALL)
    stage.post(Action("demo"))
    racks = stage.scene.model.racks
    for _ in range(20):
        seconds(stage, 5.0)
    assert stage.scene.model.racks > racks
    assert isinstance(stage.scene.model.frame.game, Practice)
    assert until_aiming(stage).scene.model.frame.game.set_up
