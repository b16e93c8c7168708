"""Two persons at one table: between their turns a card, and until it is answered nobody strikes."""

from __future__ import annotations

import pytest

from game.scenes.shared.tables.seats.hot_seat import counts_of, waits
from game.stage import Action, Pointer
from tests.scenes.billiards import billiards_stages as pool
from tests.scenes.carom import carom_stages as carom
from tests.scenes.shared.test_together import settled, struck
from tests.scenes.snooker import snooker_stages as snooker

TABLES = {
    "billiards": lambda: pool.open_level("nine-ball"),
    "snooker": snooker.open_level,
    "carom": lambda: carom.open_level(map=False, second_player="person"),
}


@pytest.fixture(params=TABLES)
def stage(request):
    made = TABLES[request.param]()
    made.scene.parameters.hand_over = "card"
    made.run(2)
    return made


def test_the_first_player_has_the_cue(stage):
    assert not waits(stage.scene.course) and stage.scene.course.may_aim


@pytest.mark.parametrize("way", ["click", "enter"])
def test_after_a_turn_has_changed_the_other_takes_the_cue_first(stage, way):
    course = stage.scene.course
    struck(stage, 0.6)
    while course.model.frame.game.turn == 0:
        struck(stage, 0.6)
    options = course.model.frame.game.options
    assert waits(course) and not course.may_aim
    strokes = course.model.frame.strokes
    if way == "click":
        stage.post(Pointer("down", 0.6, 0.6, 1))
        stage.run(1)
        stage.post(Pointer("up", 0.6, 0.6, 1))
    else:
        stage.post(Action("strike"))
    stage.run(2)
    assert not waits(course) and course.seated == 1
    assert course.model.frame.strokes == strokes and course.phase == "aiming"
    if not options:
        struck(stage, 0.6)
        assert course.model.frame.strokes == strokes + 1


def test_a_step_back_brings_the_card_back(stage):
    course = stage.scene.course
    struck(stage, 0.6)
    stage.run(3)
    stage.post(Action("strike"))
    stage.run(2)
    assert not waits(course)
    for _ in range(3):
        stage.step_back()
    assert waits(course)


def test_without_the_choice_or_against_the_computer_play_goes_on():
    stage = TABLES["billiards"]()
    struck(stage, 0.6)
    assert not waits(stage.scene.course)
    stage.scene.parameters.hand_over = "card"
    assert waits(stage.scene.course)
    stage.scene.parameters.first_player = "novice"
    assert not waits(stage.scene.course)


def test_the_card_counts_what_the_game_counts():
    rows = counts_of(settled(TABLES["snooker"]()).scene.model.frame.game)
    assert [row[0] for row in rows][:1] == ["Won"] and any(row[0] == "Points" for row in rows)


def test_the_card_names_the_figures_of_the_first_player_first():
    class Game:
        won, points, high = (0, 2), (31, 7), (12,)

    assert counts_of(Game()) == [("Won", "0", "2"), ("Points", "31", "7")]


@pytest.mark.parametrize("seat", ["first_player", "second_player"])
def test_the_card_is_for_two_persons_only(seat):
    stage = TABLES["billiards"]()
    struck(stage, 0.6)
    stage.scene.parameters.hand_over = "card"
    assert waits(stage.scene.course)
    setattr(stage.scene.parameters, seat, "novice")
    assert not waits(stage.scene.course)
