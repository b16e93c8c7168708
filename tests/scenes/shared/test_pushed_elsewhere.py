"""Strokes are pushed at every cue table: at snooker and at carom as at pool, recorded and replayed."""

import math

import pytest

from game.scenes.carom.scene import CaromScene
from game.scenes.shared.tables.through.choices import START_LINE
from game.scenes.snooker.scene import SnookerScene
from game.stage import Pointer, SetParameter, Stage, replay_scene
from tests.scenes.carom import carom_stages
from tests.scenes.pushing import push
from tests.scenes.snooker import snooker_stages

OPEN = {"snooker": (snooker_stages.open_level, SnookerScene), "carom": (carom_stages.open_level, CaromScene)}


def ready(game: str) -> Stage:
    """A game where strokes are pushed and the aim does not sway."""
    stage = OPEN[game][0]()
    stage.post(SetParameter("stroke_by", "push"))
    stage.post(SetParameter("sway", 0.0))
    return stage


def ball_of(stage: Stage) -> tuple[float, float]:
    course = stage.scene.course
    return course.cue_ball if hasattr(course, "cue_ball") else course.model.frame.cue_ball


@pytest.mark.parametrize("game", OPEN)
def test_a_push_strikes_as_fast_as_the_pointer_and_replays_to_the_bit(game: str):
    stage = ready(game)
    course = stage.scene.course
    push(stage, ball_of(stage), 0.4 * math.pi, 1.8)
    assert course.phase == "striking"
    stage.run(2)
    assert course.phase == "rolling", "the tip is at the ball already"
    assert course.model.frame.last.stroke.cue_speed == pytest.approx(1.8, rel=1e-9)
    assert course.model.frame.last.stroke.azimuth == pytest.approx(0.4 * math.pi, abs=1e-9)
    stage.run(200)
    assert replay_scene(stage.recording, OPEN[game][1]).digest() == stage.digest()


@pytest.mark.parametrize("game", OPEN)
def test_a_cue_that_is_let_go_before_the_ball_strikes_nothing(game: str):
    stage = ready(game)
    x, y = ball_of(stage)
    for kind, away in (("move", 0.3), ("down", 0.3), ("move", 0.1), ("up", 0.1)):
        stage.post(Pointer(kind, x, y + away, button=int(kind != "move")))
        stage.run(3)
    course = stage.scene.course
    assert course.phase == "aiming" and course.model.frame.strokes == 0 and not course.push.held


@pytest.mark.parametrize("game", OPEN)
def test_hints_and_start_card_offer_the_push(game: str):
    stage = OPEN[game][0]()
    assert not any("push" in hint.text for hint in stage.scene.hints_now())
    stage.post(SetParameter("stroke_by", "push"))
    assert any("push" in hint.text for hint in stage.scene.hints_now())
    assert SnookerScene.declared_parameters()[START_LINE.parameter].default == START_LINE.default
