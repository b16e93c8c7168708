"""The coach: after the stroke, never before it unless asked, and then the score says so."""

import math

import pytest

from game.billiards.map.causes import AIM, PACE, SPIN, THROW, Cause
from game.billiards.shot.cue import speed_ratio
from game.billiards.table.rack import BALL_MASS, BALL_RADIUS
from game.scenes.billiards.beside import COACH, NONE
from game.scenes.billiards.practice.columns import COLUMN, ROWS
from game.scenes.billiards.scene import Billiards
from game.scenes.shared.tables.beside.coach_card import (
    ahead_rows,
    ask_row,
    fault_words,
    left_row,
    told_rows,
)
from game.stage import Action, SetParameter, Stage, replay_scene
from tests.scenes.billiards.billiards_stages import (
    AT_THE_CORNER,
    aim,
    click,
    point,
    seconds,
    standing,
    straight_pot,
    until_aiming,
)


def played(turn: float, **parameters) -> Stage:
    """A straight pot tried with the aim off by so much (rad), the coach beside the table."""
    stage = straight_pot()
    stage.post(SetParameter("power", 3.0))
    for name, value in parameters.items():
        stage.post(SetParameter(name, value))
    stage.post(Action("coach"))
    aim(stage, AT_THE_CORNER + turn)
    stage.post(Action("strike"))
    seconds(stage, 0.1)
    return until_aiming(stage)


def words_of(stage: Stage) -> list[str]:
    """What the card says of the stroke, line by line."""
    coach = stage.scene.coach
    told = coach.now()
    assert told is not None
    return [text for row in told_rows(coach, told) for text in (row.words, row.under) if text]


def test_a_miss_is_told_with_its_cause_and_a_pot_without():
    words = words_of(played(0.03))
    assert "the 3, upper left" in words and any(line.startswith("missed") for line in words)
    assert "Why it missed" in words and any(line.startswith("aim ") and "left" in line for line in words)
    words = words_of(played(0.0))
    assert not any(line.startswith("Why") for line in words)
    assert any(line.startswith("it went down") for line in words)


def test_nothing_is_told_before_a_stroke_and_nothing_of_the_next_one_but_its_chance():
    stage = straight_pot()
    stage.post(Action("coach"))
    coach = stage.scene.coach
    assert coach.now() is None and coach.told() is None and ahead_rows(coach) == [ask_row(coach)]
    stage = played(0.0)
    pot = stage.scene.coach.now().left
    assert pot is not None
    row = left_row(stage.scene.coach, pot)
    assert row.lead == f"{100.0 * pot.chance:.0f} %" and pot.words not in row.words + row.under
    assert (
        ahead_rows(stage.scene.coach) == [ask_row(stage.scene.coach)] and standing(stage).under != "coached"
    )


@pytest.mark.parametrize("way", ["key", "click"])
def test_who_asks_before_a_stroke_is_told_and_the_score_says_so_until_the_next_rack(way: str):
    stage = played(0.03)
    if way == "key":
        stage.post(Action("ask"))
        stage.post(Action("ask"))
    else:
        middle = COLUMN.row_box(ROWS - 1).middle
        point(stage, "move", *middle)
        click(stage, *middle)
    scene = stage.scene
    assert scene.play.coached == 1 and scene.coach.asked and standing(stage).under == "coached"
    scene.coach.advice()
    scene.coach.ahead.wait()
    known, pot = scene.coach.advice()
    assert known and pot is not None
    assert any(pot.words in row.words for row in ahead_rows(scene.coach))
    again = replay_scene(stage.recording, Billiards)
    assert again.scene.play.coached == 1 and again.digest() == stage.digest()
    stage.post(Action("rack"))
    assert scene.play.coached == 0 and standing(stage).under != "coached"


def test_the_key_puts_the_card_away_and_no_ball_is_moved_by_it():
    stage, other = played(0.03), played(0.03)
    stage.scene.coach.now()
    stage.post(Action("coach"))
    assert stage.scene.side.beside == NONE and not stage.scene.coach.active
    other.post(Action("coach"))
    assert stage.digest() == other.digest()
    stage.post(Action("coach"))
    assert stage.scene.side.beside == COACH and stage.scene.way_out == "coach"


def test_what_was_meant_and_what_the_hand_did_stand_on_the_card():
    stage = played(0.0, hand="average")
    meant, made = stage.scene.play.own[-1]
    off = math.degrees(made.azimuth - meant.azimuth)
    assert any(
        f"{abs(off):.2f}° to the {'left' if off > 0.0 else 'right'}" in line for line in words_of(stage)
    )


@pytest.mark.parametrize(
    ("cause", "words"),
    [
        (Cause(AIM, math.radians(0.5), 1.0), "aim 0.50° too far right"),
        (Cause(AIM, math.radians(-0.5), 1.0), "aim 0.50° too far left"),
        (Cause(PACE, 0.5, 1.0), "0.8 m/s too soft"),
        (Cause(PACE, -0.5, 1.0), "0.8 m/s too hard"),
        (Cause(SPIN, 0.1, 1.0, up=True), "tip 2.9 mm too low"),
        (Cause(SPIN, -0.1, 1.0), "tip 2.9 mm too far left"),
        (Cause(THROW, 0.0, math.inf), "throw: the balls' friction took it off"),
    ],
)
def test_a_cause_says_what_was_wrong_not_what_is_to_be_added(cause: Cause, words: str):
    assert fault_words(cause, BALL_RADIUS, speed_ratio(BALL_MASS)) == words
