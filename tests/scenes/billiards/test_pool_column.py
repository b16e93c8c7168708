"""The map beside the pool table: what a click shows and plays, and that it follows the balls."""

import math

import numpy as np
import pytest

from game.billiards.game.arrangement import Stroke
from game.billiards.game.rules import Call
from game.scenes.billiards.beside import MAP, NONE
from game.scenes.billiards.practice import columns
from game.scenes.billiards.practice.columns import WIDE_FRAME, frame_with
from game.scenes.billiards.scene import Billiards
from game.scenes.billiards.view.beside.on_cloth import COLUMNS, ROWS, heat_of, heat_picture
from game.scenes.billiards.view.beside.pot_list import heading, row_of
from game.scenes.billiards.view.instruments import odds_numbers
from game.scenes.billiards.view.words import foul_of
from game.scenes.shared.tables.odds import OddsMeter
from game.scenes.shared.tables.prediction import FIRST_BALL, Foresight
from game.stage import Action, Decision, ParameterError, replay_scene
from tests.scenes.billiards.billiards_stages import click, level_of, point, straight_pot, until_aiming


@pytest.fixture
def stage():
    stage = straight_pot()
    stage.post(Action("map"))
    stage.scene.advisor.now()
    return stage


def click_row(stage, row: int) -> None:
    click(stage, *columns.COLUMN.row_box(row).middle)
    stage.listen()


def test_a_first_click_aims_and_a_second_one_plays(stage):
    scene = stage.scene
    pot = scene.advisor.now().map.pots[0]
    assert (pot.ball, pot.pocket) == (3, 0) and pot.chance > 0.8
    click_row(stage, 0)
    assert scene.aiming.stroke == pytest.approx(pot.stroke) and scene.play.phase == "aiming"
    assert scene.advisor.chosen is pot
    click_row(stage, 0)
    assert scene.play.phase == "striking" and scene.play.pending == pytest.approx(pot.stroke)
    until_aiming(stage)
    assert scene.model.frame.game.on_table == (5,)
    assert replay_scene(stage.recording, Billiards).digest() == stage.digest()


def test_while_the_balls_are_set_up_the_map_follows_them_and_a_click_plays(stage):
    scene = stage.scene
    stage.post(Action("set-up"))
    x, y = next(place for place in [scene.model.frame.layout.place_of(3)])
    point(stage, "move", x, y)
    point(stage, "down", x, y, button=1)
    before = scene.advisor.key
    point(stage, "move", x + 0.3, y + 0.2, button=1)
    assert scene.advisor.key != before and not scene.advisor.fresh
    point(stage, "up", x + 0.3, y + 0.2, button=1)
    places = scene.model.frame.layout.places
    pots = scene.advisor.now().map.pots
    click_row(stage, 0)
    assert scene.play.phase == "striking" and scene.play.pending == pytest.approx(pots[0].stroke)
    until_aiming(stage)
    stage.post(Action("undo"))
    assert scene.model.frame.layout.places == places


def test_a_click_on_a_map_of_another_position_does_nothing(stage):
    stage.scene.model.set_up(stage.scene.model.frame.layout.without(5))
    assert not stage.scene.advisor.fresh
    click_row(stage, 0)
    assert stage.scene.play.phase == "aiming" and stage.scene.advisor.chosen is None


def test_only_what_the_rules_allow_is_in_the_map():
    stage = level_of(
        'game = "nine-ball"\nballs = [{ number = 0, position = [0.5, 0.5] },'
        " { number = 3, position = [0.22, 0.22] }, { number = 5, position = [0.9, 2.2] }]",
        beside=MAP,
    )
    first = {pot.chain[1] for pot in stage.scene.advisor.now().map.pots}
    assert first == {3}
    stage.post(Action("set-up"))
    assert 5 in {pot.chain[1] for pot in stage.scene.advisor.now().map.pots}


def test_called_shots_are_called_by_the_click():
    stage = level_of(
        'game = "eight-ball"\ncalling = "all"\nballs = [{ number = 0, position = [0.5, 0.5] },'
        " { number = 3, position = [0.22, 0.22] }, { number = 8, position = [0.9, 2.2] }]",
        beside=MAP,
    )
    stage.scene.advisor.now()
    click_row(stage, 0)
    aiming = stage.scene.aiming
    assert aiming.call[:2] == (3, 0)
    clicked = aiming.cue.aim
    stage.post(Action("left"))
    assert aiming.cue.aim != clicked and aiming.call == Call()  # another aim is another pot
    click_row(stage, 0)
    click_row(stage, 0)
    assert aiming.call[:2] == (3, 0) and stage.scene.play.phase == "striking"


MATCH = (
    'game = "nine-ball"\nballs = [{ number = 0, position = [0.8, 1.2] },'
    " { number = 3, position = [0.35, 0.4] }, { number = 5, position = [0.9, 2.2] }]"
)


def test_in_a_match_it_is_the_hand_that_plays_a_pot_whose_chance_the_map_tells():
    made, chance, hits = [], 0.0, 24
    for number in range(hits):
        stage = level_of(MATCH, beside=MAP)
        stage.scene.play.by_hand = number  # so many strokes have been played before
        pots = stage.scene.advisor.now().map.pots
        row = next(k for k, pot in enumerate(pots) if 0.2 < pot.chance < 0.8)
        chance = pots[row].chance
        click_row(stage, row)
        click_row(stage, row)
        assert stage.scene.play.pending != pytest.approx(pots[row].stroke, abs=1e-6)
        until_aiming(stage)
        struck = stage.scene.model.played
        made.append(pots[row].ball in struck.summary.balls_down and struck.verdict.legal)
        assert stage.scene.play.own[-1][0] == pytest.approx(pots[row].stroke)
        if number == 0:  # as it was opened
            assert replay_scene(stage.recording, Billiards).digest() == stage.digest()
    spread = (chance * (1.0 - chance) / hits) ** 0.5
    assert abs(sum(made) / hits - chance) < 3.0 * spread + 0.5 / hits


def test_the_figure_of_the_map_is_the_one_beside_the_aim():
    stage = level_of(MATCH, beside=MAP)
    view = stage.scene.view
    compared = 0
    for row, pot in enumerate(stage.scene.advisor.now().map.pots):
        click_row(stage, row)
        assert stage.scene.advisor.aimed is pot
        meter = OddsMeter(lambda: 0.0)
        odds = meter.of(stage.scene.model.frame, stage.scene.aiming.stroke, view._asked(pot.chain[1]))
        assert odds.ball == pot.ball and odds.chance == pytest.approx(pot.chance, abs=1e-12)
        compared += 1
    assert compared > 5


BEHIND = (
    'game = "nine-ball"\nin_hand = "behind the line"\nballs = [{ number = 0, position = [0.45, 0.45] },'
    " { number = 6, position = [0.2, 0.2] }, { number = 9, position = [0.9, 2.2] }]"
)


def test_from_behind_the_line_a_ball_there_is_a_foul_for_map_aim_and_referee():
    stage = level_of(BEHIND, beside=MAP)
    scene = stage.scene
    straight = Stroke(1.5, math.atan2(-1.0, -1.0), tip_up=-0.4)
    assert all(len(pot.chain) > 2 or pot.stroke.azimuth > 0 for pot in scene.advisor.now().map.pots)
    scene.aiming.aim_as(straight)
    frame = scene.model.frame
    sight = Foresight().of(frame, scene.aiming.stroke, FIRST_BALL)
    assert sight.target == 6 and sight.short
    assert foul_of(frame.game, scene.aiming.call, 6, sight.short) == "foul: behind the line"
    odds = OddsMeter(lambda: 0.0).of(frame, scene.aiming.stroke, scene.view._asked(6))
    assert odds.foul and odds_numbers(odds)[1].words == "foul"
    assert [foul.kind for foul in frame.play(straight).verdict.fouls] == ["behind the line"]


@pytest.mark.parametrize("values", [(), (1.0,) * 6, (1.0, 0.0, 0.0, 2.0, 0.0, 3.0, 0.0)])
@pytest.mark.parametrize("name", ["show", "pot"])
def test_a_decision_that_cannot_be_is_refused(stage, name, values):
    with pytest.raises(ParameterError):
        stage.post(Decision(name, values))


def test_one_that_comes_while_balls_roll_is_refused(stage):
    stroke = tuple(stage.scene.advisor.now().map.pots[0].stroke)
    stage.post(Decision("pot", (*stroke, 3.0, 0.0)))
    with pytest.raises(ParameterError, match="none may be played now"):
        stage.post(Decision("show", (*stroke, 3.0, 0.0)))


def test_the_heat_is_of_all_pots_or_of_the_chosen_one(stage):
    drawn = stage.scene.advisor.now()
    every, one = heat_of(drawn, None), heat_of(drawn, drawn.map.pots[0])
    assert every.shape == one.shape == (ROWS, COLUMNS)
    assert every.sum() == pytest.approx(1.0) and one.sum() == pytest.approx(1.0)
    pot = drawn.map.pots[0]
    own = drawn.map.outcomes.places[pot.rows, drawn.board.cue]
    assert np.isclose(one[one > 0.0].min() * len(own) % 1.0, (0.0, 1.0), atol=1e-9).any() and len(own) < len(
        drawn.map.keys
    )
    assert ((one > 0.0) <= (every > 0.0)).all() and (one > 0.0).sum() < (every > 0.0).sum()
    counted = drawn.map.keys > 0
    ends = drawn.map.outcomes.places[counted, drawn.board.cue]
    row, column = np.unravel_index(int(np.argmax(every)), every.shape)
    table = drawn.board.table
    inside = (np.floor(ends[:, 1] / table.length * ROWS) == row) & (
        np.floor(ends[:, 0] / table.width * COLUMNS) == column
    )
    assert every[row, column] == pytest.approx(inside.mean())
    picture = heat_picture(every, (4 * ROWS, 4 * COLUMNS))
    brightest = picture.get_at((4 * row + 2, 4 * column + 2))
    assert brightest.a > 100 and picture.get_size() == (4 * ROWS, 4 * COLUMNS)


def test_the_column_widens_the_frame_and_goes_again(stage):
    assert stage.scene.frame() == WIDE_FRAME
    stage.post(Action("map"))
    assert stage.scene.parameters.beside == NONE and stage.scene.frame() == frame_with(NONE) != WIDE_FRAME
    assert not stage.scene.advisor.active and stage.scene.advisor.now() is None


def test_words(stage):
    drawn = stage.scene.advisor.now()
    title, under = heading(stage.scene.advisor, drawn)
    assert title.startswith("Every pot: ") and under.startswith("Club player.")
    row = row_of(drawn.map.pots[0], lit=False, faint=False)
    assert row.lead.endswith(" %") and row.words == "3, upper left" and "m/s" in row.under
    assert heading(stage.scene.advisor, None)[1] == "It is being drawn …"


def test_esc_closes_what_stands_beside_the_table_before_it_leaves(stage):
    assert stage.scene.way_out == "map"
    stage.post(Action(stage.scene.way_out))
    assert stage.scene.side.beside == NONE and stage.scene.way_out == ""
