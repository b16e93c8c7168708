"""The landing cloud: ends of the exact table for a hand's noise, of a grade or measured."""

import numpy as np
import pytest

from game.billiards.game.arrangement import Stroke, arrange
from game.billiards.game.frame import Frame
from game.billiards.game.games import Practice
from game.billiards.map.hand import FEWEST
from game.billiards.players.opponents import GRADES
from game.billiards.search.strokes import STEADY, Board, Noise
from game.billiards.table.table import Table
from game.scenes.billiards.practice.hands import hand_of
from game.scenes.billiards.practice.landing import SAMPLES, LandingMeter, landings
from game.scenes.billiards.view.beside.on_cloth import cloud_words
from game.scenes.billiards.view.instruments import lengths_words
from game.scenes.shared.tables.unsteady import HANDS
from game.stage import Action, SetParameter
from tests.scenes.billiards.billiards_stages import open_level, seconds, straight_pot, until_aiming

FRAME = Frame(Practice(on_table=(1,)), arrange({0: (0.6, 0.5), 1: (0.3, 2.2)}), Table.pool())
BOARD = Board(FRAME.layout, FRAME.table, FRAME.physics)
SOFT = Stroke(1.0, 1.3)


def test_a_steady_hand_always_ends_where_the_stroke_does():
    *_, landing = landings(BOARD, SOFT, STEADY)
    end = FRAME.play(SOFT).frame.cue_ball
    assert landing.tried == SAMPLES == len(landing.ends) and landing.scratches == 0
    assert np.abs(landing.ends - end).max() < 1e-9 and landing.half_within < 1e-9


def test_its_spread_is_that_of_the_hand():
    """Without a ball or a cushion the cue ball's way goes with the square of the speed: sigma of it is 2
    sigma/v.
    """
    softer = Stroke(0.45, 1.3)
    *_, landing = landings(BOARD, softer, Noise(0.0, 0.0, 0.0, 0.01))
    start = np.array((0.6, 0.5))
    ways = np.linalg.norm(landing.ends - start, axis=1)
    assert ways.std() / ways.mean() == pytest.approx(2.0 * 0.01 / 0.45, rel=0.15)
    across = (landing.ends - start) @ (-np.sin(1.3), np.cos(1.3))
    assert np.abs(across).max() < 1e-6


def test_scratches_are_counted_and_no_ends():
    frame = FRAME.replace(layout=arrange({0: (0.25, 0.25), 1: (0.3, 2.2)}))
    board = Board(frame.layout, frame.table, frame.physics)
    *_, landing = landings(board, Stroke(1.5, -2.36), STEADY)
    assert landing.scratches == SAMPLES and len(landing.ends) == 0 and np.isnan(landing.half_within)
    assert cloud_words(landing) == "down 100 %"


def test_half_of_the_ends_lie_within():
    *_, landing = landings(BOARD, SOFT, Noise().scaled(3.0))
    far = np.linalg.norm(landing.ends - landing.middle, axis=1)
    assert (far <= landing.half_within).mean() == pytest.approx(0.5, abs=0.01)
    assert cloud_words(landing).startswith(f"half within {100.0 * landing.half_within:.0f} cm")


def test_it_is_counted_a_little_in_each_picture_and_begins_anew_for_another_stroke():
    ticks = iter(range(10_000))
    meter = LandingMeter(now=lambda: 0.0015 * next(ticks))
    tried = [meter.of(FRAME, SOFT, Noise()).tried for _ in range(3)]
    assert tried[0] < tried[1] < tried[2] < SAMPLES
    assert meter.of(FRAME, Stroke(1.1, 1.3), Noise()).tried == tried[0]
    fewer = FRAME.replace(layout=FRAME.layout.without(1))
    assert meter.of(fewer, Stroke(1.1, 1.3), Noise()).tried == tried[0]


def test_ones_own_hand_is_measured_from_ones_strokes():
    stage = straight_pot()
    stage.post(SetParameter("odds", "own"))
    assert hand_of(stage.scene.play).noise == GRADES["club"].noise
    assert hand_of(stage.scene.play).words == f"Club player; yours after {FEWEST} more"
    stage.scene.play.strike_by_hand()  # by a hand that does not stray: nothing to measure
    until_aiming(seconds(stage, 0.3))
    assert stage.scene.play.own == ()
    stage.post(SetParameter("hand", "average"))
    for _ in range(40):
        stage.scene.play.strike_by_hand()
        seconds(stage, 0.3)
        stage.post(Action("undo"))
    hand = hand_of(stage.scene.play)
    assert hand.words == "your hand, 40 strokes"
    assert hand.noise.azimuth == pytest.approx(HANDS["average"] * Noise().azimuth, rel=0.3)
    assert hand.noise.tip == pytest.approx(HANDS["average"] * Noise().tip, rel=0.3)


def test_speed_in_table_lengths():
    stage = straight_pot()
    words = lengths_words(2.0, stage.scene.model.frame)
    assert words.endswith(" lengths") and 1.0 < float(words.split()[0]) < 4.0


def test_the_key_of_the_cloud_turns_it_on_and_off():
    stage = open_level("practice")
    seen = []
    for _ in range(2):
        stage.post(Action("cloud"))
        stage.run(1)
        seen.append(stage.scene.values["cloud"])
    assert seen == [True, False]
