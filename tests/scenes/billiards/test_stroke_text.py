"""One stroke as a text: from the position before it, to the same rest and the same verdict."""

import numpy as np
import pytest

from game.scenes.billiards.scene import Billiards
from game.stage import Decision, SetParameter, replay_scene
from game.stage.records.run_text import recording_in, text_of
from game.stage.replaying import recording_of_excerpt
from tests.scenes.billiards.billiards_stages import (
    AT_THE_CORNER,
    open_level,
    seconds,
    straight_pot,
    until_aiming,
)

NO_CALL = (-1.0, -1.0, 0.0, 0.0)


def struck(stage, speed: float, azimuth: float, more=(0.0, 0.0, 0.0)):
    """A stroke, played to its end."""
    stage.post(Decision("stroke", (speed, azimuth, *more, *NO_CALL)))
    return until_aiming(seconds(stage, 0.25))


def text_of_stroke(stage) -> str:
    return text_of(recording_of_excerpt(Billiards, stage.scene.excerpt()))


def test_the_last_stroke_alone_does_the_same_again():
    stage = open_level("nine-ball", sliding=0.3)
    struck(stage, 7.0, np.pi / 2 + 0.01)
    assert stage.scene.model.frame.strokes == 1
    for _ in range(3):  # fouls, which are counted in a row
        struck(stage, 0.2, -0.5)
    struck(stage, 3.0, 1.3, (0.0, 0.2, -0.3))
    assert stage.scene.model.frame.last.frame.game.fouls_in_row == (2, 1)
    text = text_of_stroke(stage)
    assert len(text) < 1400
    again = replay_scene(recording_in(text), Billiards)
    mine, theirs = stage.scene.model.frame, again.scene.model.frame
    assert again.scene.play.phase == "aiming" and theirs.layout.places == mine.layout.places
    assert (theirs.game, theirs.words) == (mine.game, mine.words)
    assert theirs.last.stroke == mine.last.stroke and theirs.conditions == mine.conditions


def test_a_stroke_by_a_shaking_hand_is_the_one_that_was_played():
    stage = straight_pot()
    stage.post(SetParameter("hand", "average"))
    stage.scene.aiming.cue.point_to(AT_THE_CORNER)
    stage.scene.play.strike_by_hand()
    until_aiming(seconds(stage, 0.5))
    again = replay_scene(recording_in(text_of_stroke(stage)), Billiards)
    assert again.scene.model.frame.last.stroke == stage.scene.play.done != stage.scene.play.meant
    assert again.scene.model.frame.layout.places == stage.scene.model.frame.layout.places


def test_while_the_balls_still_roll_the_stroke_is_there_already():
    stage = straight_pot()
    stage.post(Decision("stroke", (2.0, AT_THE_CORNER, 0.0, 0.0, 0.0, *NO_CALL)))
    while stage.scene.play.phase != "rolling":
        stage.run(1)
    again = replay_scene(recording_in(text_of_stroke(stage)), Billiards)
    assert again.scene.model.frame.layout.places == until_aiming(stage).scene.model.frame.layout.places


@pytest.mark.parametrize("level", ["default", "practice"])
def test_without_a_stroke_or_on_another_cloth_there_is_none(level):
    stage = open_level(level)
    assert stage.scene.excerpt() is None
    struck(stage, 5.0, np.pi / 2)
    assert stage.scene.excerpt().name == "stroke"
    stage.post(SetParameter("sliding", 0.4))
    assert stage.scene.excerpt() is None
