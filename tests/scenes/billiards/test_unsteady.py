"""A person's hand that shakes: as far as is declared, the same in a replay, and told by the guide."""

import math

import numpy as np
import pytest

from game.billiards.game.arrangement import Stroke
from game.billiards.game.frame import Struck
from game.billiards.search.strokes import Noise
from game.billiards.shot.cue import strike
from game.billiards.table.rack import BALL_RADIUS
from game.scenes.billiards.scene import Billiards
from game.scenes.shared.tables.prediction import FIRST_BALL, foresee
from game.scenes.shared.tables.sight import fan_of
from game.scenes.shared.tables.unsteady import HANDS, shaken, spread_of
from game.stage import Action, Decision, SetParameter, replay_scene
from tests.scenes.billiards.billiards_stages import (
    AT_THE_CORNER,
    aim,
    drag,
    seconds,
    straight_pot,
    until_aiming,
)

MEANT = Stroke(2.0, 0.7, 0.3, 0.1, -0.2)
MANY = 4000


@pytest.mark.parametrize("hand", ["steady", "average"])
def test_each_part_of_a_stroke_strays_by_its_declared_deviation(hand: str):
    noise = Noise().scaled(HANDS[hand])
    strokes = np.array([shaken(MEANT, hand, 3, count, BALL_RADIUS) for count in range(MANY)])
    declared = np.array(
        [noise.speed, noise.azimuth, noise.elevation, noise.tip / BALL_RADIUS, noise.tip / BALL_RADIUS]
    )
    # of a deviation from n draws itself one part in sqrt(2 n): four of these either way
    assert strokes.std(axis=0) == pytest.approx(declared, rel=4.0 / math.sqrt(2.0 * MANY))
    assert strokes.mean(axis=0) == pytest.approx(np.array(MEANT), abs=4.0 * declared.max() / math.sqrt(MANY))


def test_without_noise_a_stroke_is_what_was_meant():
    assert shaken(MEANT, "none", 3, 4, BALL_RADIUS) is MEANT and spread_of(MEANT, "none", BALL_RADIUS) == 0.0


def test_other_seeds_and_other_strokes_stray_otherwise():
    strokes = {shaken(MEANT, "steady", seed, count, BALL_RADIUS) for seed in range(3) for count in range(3)}
    assert len(strokes) == 9


@pytest.mark.parametrize("hand", ["steady", "average"])
@pytest.mark.parametrize("tip_left", [0.0, 0.4])
def test_the_fan_is_the_spread_of_the_cue_balls_direction(hand: str, tip_left: float):
    meant = Stroke(3.0, 0.0, 0.0, tip_left, 0.0)
    turns = []
    for count in range(MANY):
        done = shaken(meant, hand, 11, count, BALL_RADIUS)
        x, y, _ = strike(*done).velocity
        turns.append(math.atan2(y, x))
    assert spread_of(meant, hand, BALL_RADIUS) == pytest.approx(np.std(turns), rel=0.05)


def test_the_fan_opens_by_the_spread_as_far_as_the_first_cushion_or_ball():
    frame = straight_pot().scene.model.frame
    ball = np.array(frame.cue_ball)
    pot = foresee(Struck(frame, Stroke(2.0, AT_THE_CORNER)), FIRST_BALL)
    start, right, left = fan_of(pot, 0.03)
    assert start == pytest.approx(ball) and np.hypot(*(left - ball)) == pytest.approx(
        math.dist(ball, pot.ghost)
    )
    turns = [math.atan2(*(side - ball)[::-1]) for side in (right, left)]
    assert turns == pytest.approx([AT_THE_CORNER - 0.03, AT_THE_CORNER + 0.03])
    bank = foresee(Struck(frame, Stroke(2.0, 0.1)), FIRST_BALL)
    assert np.hypot(*(fan_of(bank, 0.03)[1] - ball)) == pytest.approx(math.dist(ball, bank.bounces[0]))


def pull_and_let_go(stage) -> None:
    """Strike by hand at the corner."""
    x, y = stage.scene.model.frame.cue_ball
    drag(stage, (x - 0.25, y - 0.25), (x - 0.17, y - 0.17))


@pytest.mark.parametrize("way", ["pull", "button"])
def test_the_stroke_that_is_played_is_not_quite_the_one_that_was_aimed_and_undo_aims_as_it_was_meant(
    way: str,
):
    stage = straight_pot()
    stage.post(SetParameter("hand", "average"))
    aim(stage, AT_THE_CORNER)
    scene = stage.scene
    if way == "pull":
        pull_and_let_go(stage)
    else:
        stage.post(Action("strike"))
    meant, done = scene.play.meant, scene.play.done
    assert done == scene.play.pending and done != meant
    assert abs(done.azimuth - meant.azimuth) < 6.0 * Noise().scaled(2.8).azimuth
    until_aiming(stage)
    stage.post(Action("undo"))
    assert scene.aiming.stroke == pytest.approx(meant)


def test_a_recording_with_a_shaking_hand_replays_to_the_same_digest():
    stage = straight_pot()
    stage.post(SetParameter("hand", "average"))
    for _ in range(3):
        aim(stage, AT_THE_CORNER + 0.1)
        stage.post(Action("strike"))
        until_aiming(stage)
    strokes = stage.scene.play.by_hand
    assert strokes == 3
    again = replay_scene(stage.recording, Billiards)
    assert again.digest() == stage.digest() and again.scene.play.done == stage.scene.play.done


def test_a_step_back_over_a_stroke_brings_the_same_noise_again():
    stage = straight_pot()
    stage.post(SetParameter("hand", "average"))
    aim(stage, AT_THE_CORNER)
    seconds(stage, 0.1)
    steps = stage.step_number
    stage.post(Action("strike"))
    first = stage.scene.play.done
    seconds(stage, 0.1)
    while stage.step_number > steps - 1:
        stage.step_back()
    assert stage.scene.play.by_hand == 0
    stage.post(Action("strike"))
    assert stage.scene.play.done == first


def test_the_hands_of_computer_players_are_left_alone():
    stage = straight_pot()
    stage.post(SetParameter("hand", "average"))
    stage.post(Decision("stroke", (2.0, AT_THE_CORNER, 0.0, 0.0, 0.0, -1.0, -1.0, 0.0, 0.0)))
    assert stage.scene.play.pending == Stroke(2.0, AT_THE_CORNER) and stage.scene.play.by_hand == 0
