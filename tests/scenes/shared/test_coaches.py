"""The coaches of snooker and carom: after the stroke what was there and why it missed, before it if asked."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from game.billiards.game.arrangement import Stroke
from game.billiards.game.rules import Call
from game.billiards.map.causes import AIM, PACE, SPIN, Hand, causes_of
from game.billiards.search.strokes import Noise
from game.billiards.table.carom import BALL_RADIUS
from game.scenes.carom import layout as carom_layout
from game.scenes.shared.tables.beside.coach import Told, Way
from game.scenes.shared.tables.beside.coach_card import ahead_rows, ask_row, left_row, told_rows
from game.scenes.snooker.coach import legality_for
from game.scenes.snooker.columns import COLUMN, WIDE_FRAME
from game.stage import Action, Decision, Stage, replay_scene
from tests.scenes.carom import carom_stages
from tests.scenes.snooker import snooker_stages

MEANT = Stroke(2.0, 1.0)
RED_AND_BLACK = """
balls = [
  {number = 0, position = [0.5, 0.5]}, {number = 1, position = [0.22, 0.22]},
  {number = 21, position = [1.5, 3.3]},
]
practice = true
"""


def played_at_snooker(turn: float) -> Stage:
    """A straight red tried with the aim off by so much, rad, the coach beside the table."""
    stage = snooker_stages.level_of(RED_AND_BLACK, coach=True, power=2.5)
    stage.scene.course.cue.point_to(math.atan2(-0.28, -0.28) + turn)
    stage.post(Action("strike"))
    snooker_stages.seconds(stage, 0.1)
    return snooker_stages.until_aiming(stage)


def played_at_carom(turn: float) -> Stage:
    """The surest way of straight rail, off by so much, rad."""
    stage = carom_stages.open_level("straight-rail", coach=True)
    stroke = stage.scene.advisor.now().map.groups[0].stroke
    course = stage.scene.course
    course.choose(stroke._replace(azimuth=stroke.azimuth + turn))
    stage.post(Action("strike"))
    carom_stages.seconds(stage, 0.1)
    return carom_stages.until_aiming(stage)


def words_of(stage: Stage) -> list[str]:
    coach = stage.scene.coach
    told = coach.now()
    assert told is not None
    return [text for row in told_rows(coach, told) for text in (row.words, row.under) if text]


def test_a_missed_red_is_told_with_its_cause_and_a_pot_without():
    words = words_of(played_at_snooker(0.04))
    assert "the red, upper left" in words and any(line.startswith("missed") for line in words)
    assert any(line.startswith("aim ") and line.endswith("too far left") for line in words)
    words = words_of(played_at_snooker(0.0))
    assert any(line.startswith("it went down") for line in words)
    assert not any(line.startswith("Why") for line in words)


def test_a_missed_point_is_told_with_its_cause_and_a_point_without():
    words = words_of(played_at_carom(0.0))
    assert any(line.startswith("it scored") for line in words)
    assert any(line.startswith("the chance of the surest way") for line in words)
    missed = played_at_carom(0.08)
    if missed.scene.model.played.verdict.scored:
        missed = played_at_carom(-0.08)
    told = missed.scene.coach.now()
    assert told is not None and not told.made and told.causes
    assert told.best is not None and told.best.chance > told.tried.chance
    aim = next(one for one in told.causes if one.name == AIM)
    assert abs(aim.change) < math.radians(8.1)


def test_a_safety_is_no_point_that_was_tried():
    stage = carom_stages.open_level("straight-rail", coach=True)
    stage.post(Action("safety"))
    carom_stages.seconds(stage, 0.1)
    carom_stages.until_aiming(stage)
    told = stage.scene.coach.now()
    assert told is not None and told.tried is None
    assert "no point was tried" in words_of(stage)


@pytest.mark.parametrize("table", ["snooker", "carom"])
def test_nothing_is_told_before_a_stroke_unless_asked_and_then_the_score_says_so(table: str):
    if table == "snooker":
        stage: Any = snooker_stages.level_of(RED_AND_BLACK, coach=True)
        column = COLUMN
    else:
        stage, column = carom_stages.open_level("straight-rail", coach=True), carom_layout.COLUMN
    scene = stage.scene
    coach, course = scene.coach, scene.course
    assert coach.now() is None and ahead_rows(coach) == [ask_row(coach)] and course.coached == 0
    carom_stages.click(stage, *column.row_box(column.rows - 1).middle)
    assert course.coached == 1 and coach.asked
    stage.post(Action("ask"))
    assert course.coached == 1, "asked once for a stroke"
    coach.advice()
    coach.ahead.wait()
    known, way = coach.advice()
    assert known and way is not None and 0.0 < way.chance <= 1.0
    assert [row.words for row in ahead_rows(coach)] == ["The stroke to come", way.words]
    assert way.words not in left_row(coach, way).words
    again = replay_scene(stage.recording, stage.scene_type)
    assert again.scene.course.coached == 1 and again.digest() == stage.digest()
    course.begin_again()
    assert course.coached == 0 and not coach.asked


def test_the_card_makes_the_picture_of_snooker_wider_and_a_key_puts_it_away():
    stage = snooker_stages.open_level()
    narrow = stage.scene.frame()
    stage.post(Action("coach"))
    assert stage.scene.frame() == WIDE_FRAME != narrow
    assert all(WIDE_FRAME.bottom <= COLUMN.row_box(k).left for k in range(COLUMN.rows))
    assert COLUMN.row_box(COLUMN.rows - 1).bottom <= COLUMN.box.bottom
    stage.post(Action("coach"))
    assert stage.scene.frame() == narrow


def test_rows_of_the_map_are_not_clicked_through_the_coach():
    stage = carom_stages.open_level("straight-rail")
    stage.listen(at_once=True)
    stage.post(Action("coach"))
    carom_stages.click_row(stage, 0)
    assert stage.scene.course.chosen is None
    stage.post(Action("coach"))
    carom_stages.click_row(stage, 0)
    assert stage.scene.course.chosen is not None


def test_a_nominated_colour_alone_may_be_hit():
    game = snooker_stages.open_level("masters").scene.model.game
    red = legality_for(game, Call())
    assert 1 in red.first and 21 not in red.first and 21 in red.barred and 1 not in red.barred
    colour = snooker_stages.level_of(RED_AND_BLACK + "after_red = true\n").scene.model.game
    asked = legality_for(colour, Call(21))
    assert asked.first == (21,) and asked.barred == (1,)


def within(column: int, value: float, reach: float):
    """What works: strokes with one of their numbers so near to a value."""
    return lambda strokes: np.abs(strokes[:, column] - value) <= reach


def test_the_smallest_change_that_works_is_found_and_signed():
    hand = Hand(Noise(), BALL_RADIUS)
    strayed, (aim,) = causes_of(within(1, 1.02, 0.005), MEANT, MEANT, hand)
    assert not strayed and aim.name == AIM and 0.015 <= aim.change <= 0.025
    _, (pace,) = causes_of(within(0, 1.8, 0.05), MEANT, MEANT, hand)
    assert pace.name == PACE and -0.25 <= pace.change <= -0.15
    _, (spin,) = causes_of(within(4, -0.3, 0.03), MEANT, MEANT, hand)
    assert spin.name == SPIN and spin.up and -0.33 <= spin.change <= -0.27
    assert spin.size == pytest.approx(abs(spin.change) * BALL_RADIUS / Noise().tip)


def test_what_the_hand_did_wrong_is_put_back_to_what_was_meant():
    done = MEANT._replace(azimuth=1.03, tip_left=0.1)
    strayed, found = causes_of(within(1, 1.0, 0.01), MEANT, done, Hand(Noise(), BALL_RADIUS))
    assert strayed and [one.name for one in found] == [AIM]
    assert found[0].change == pytest.approx(-0.03)


def test_causes_give_way_where_there_is_little_space():
    coach = carom_stages.open_level("straight-rail").scene.coach
    _, causes = causes_of(lambda strokes: np.ones(len(strokes), np.bool_), MEANT, MEANT,
                          Hand(Noise(), BALL_RADIUS))  # fmt: skip
    assert len(causes) == 3
    told = Told("Ada", "Ben", False, Way(0.2, "red, yellow"), causes=causes, best=Way(0.9, "long, red"))
    assert len(told_rows(coach, told)) == 10
    assert len(told_rows(coach, told, 9)) == 9 and told_rows(coach, told, 9)[-1].words.startswith("no way")
    assert not told.surest and told._replace(best=Way(0.21, "long, red")).surest


def test_a_decision_of_the_map_is_reviewed_as_it_was_played():
    stage = carom_stages.open_level("straight-rail", coach=True)
    stroke = stage.scene.advisor.now().map.groups[0].stroke
    stage.post(Decision("play", tuple(stroke)))
    carom_stages.seconds(stage, 0.1)
    carom_stages.until_aiming(stage)
    told = stage.scene.coach.now()
    assert told is not None and told.made and told.tried.chance > 0.3


def test_what_is_left_is_told_of_the_next_player_and_its_own_ball():
    missed = played_at_carom(0.08)
    if missed.scene.model.played.verdict.scored:
        missed = played_at_carom(-0.08)
    told = missed.scene.coach.now()
    assert told is not None and (told.shooter, told.next_shooter) == ("Ada", "Ben")
    assert told.left is not None and "yellow" not in told.left.words and "white" in told.left.words
    assert told.best is not None and "white" not in told.best.words
