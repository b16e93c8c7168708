"""Races, the way back from set-up, choices beside the cloth, own balls lit, an opponent that gets ready."""

import math
import threading
from itertools import pairwise

import msgspec
import numpy as np
import pygame
import pytest

from game.app.stagehand.headless import prepare
from game.app.stagehand.view import StageView
from game.billiards.table.rack import BALL_RADIUS
from game.scenes.billiards import layout
from game.scenes.billiards.view.marks import OWN_RING, own_balls
from game.scenes.billiards.view.words import line_of
from game.scenes.shared.thinker import Question, Thinker, Thought
from game.stage import Action, SetParameter
from game.ui.look.look import Look
from game.ui.look.theme import THEMES
from tests.scenes.billiards.billiards_stages import (
    AT_THE_CORNER,
    aim,
    drag,
    level_of,
    open_level,
    point,
    press,
    seconds,
    standing,
    until_aiming,
)

ON_THE_EIGHT = (
    'game = "eight-ball"\nballs = [{ number = 0, position = [0.5, 0.5] },'
    " { number = 8, position = [0.22, 0.22] }, { number = 9, position = [0.9, 2.2] }]"
)


def win_a_rack(stage) -> None:
    """The player at turn has won."""
    model = stage.scene.model
    game = model.frame.game
    won = tuple(n + (k == game.turn) for k, n in enumerate(game.won))
    model.frame = model.frame.replace(game=msgspec.structs.replace(game, winner=game.turn, won=won))


def test_a_race_to_two_racks_ends_with_the_second_and_n_begins_another_match():
    stage = open_level("default", race="3")
    play, model = stage.scene.play, stage.scene.model
    winner = model.frame.game.turn
    for rack in range(3):
        model.frame = model.frame.replace(game=msgspec.structs.replace(model.frame.game, turn=winner))
        win_a_rack(stage)
        assert play.match_over == (rack == 2)
        label = next(words for name, words, _ in stage.scene.buttons.rows() if name == "rack")
        assert label == ("New match" if rack == 2 else "Next rack")
        if rack < 2:
            assert "won the rack" in standing(stage).cards[winner].status
            stage.post(Action("rack"))
            assert model.frame.game.won[winner] == rack + 1
    assert "won the match" in standing(stage).cards[winner].status
    assert standing(stage).caption == "racks, race to 3"
    stage.post(Action("rack"))
    assert model.frame.game.won == (0, 0) and not play.match_over and model.frame.game.opening


def test_without_a_race_racks_are_counted_on_and_on():
    stage = open_level("default")
    for rack in range(9):
        win_a_rack(stage)
        assert not stage.scene.play.match_over
        stage.post(Action("rack"))
        assert sum(stage.scene.model.frame.game.won) == rack + 1


def test_a_race_means_nothing_in_practice():
    stage = open_level("practice", race="1")
    assert stage.scene.play.racks_to_win == 0 and not stage.scene.play.match_over


# -- set-up -----------------------------------------------------------------------------------------


def test_leaving_a_changed_set_up_says_that_the_match_is_left_and_the_button_leads_back():
    stage = level_of(ON_THE_EIGHT)
    scene = stage.scene
    before = scene.model.frame
    stage.post(Action("set-up"))
    drag(stage, (0.9, 2.2), (0.6, 1.4))
    stage.post(Action("set-up"))
    assert len(scene.model.frame.game.players) == 1
    line = line_of(scene.play, None)
    assert "practice" in line.lead and "back to the match" in line.more
    row, label = next((i, words) for i, (name, words, _) in enumerate(scene.buttons.rows()) if name == "undo")
    assert label == "To match"
    press(stage, layout.button_box(row))
    assert scene.model.frame.game == before.game and scene.model.frame.layout.places == before.layout.places
    assert [words for name, words, _ in scene.buttons.rows() if name == "undo"] == ["Undo"]


def test_practice_that_is_set_up_has_left_no_match():
    stage = open_level("practice")
    stage.post(Action("set-up"))
    places = {number: (x, y) for number, x, y in stage.scene.model.frame.layout.places}
    drag(stage, places[1], (0.4, 0.9))
    stage.post(Action("set-up"))
    assert "match" not in " ".join(line_of(stage.scene.play, None)[:2])
    assert not stage.scene.model.match_behind


def test_a_stroke_after_the_set_up_is_undone_before_the_match_comes_back():
    stage = level_of(ON_THE_EIGHT)
    scene = stage.scene
    stage.post(Action("set-up"))
    drag(stage, (0.9, 2.2), (0.6, 1.4))
    stage.post(Action("set-up"))
    aim(stage, AT_THE_CORNER)
    stage.post(Action("strike"))
    until_aiming(stage)
    assert not scene.model.match_behind
    stage.post(Action("undo"))
    assert len(scene.model.frame.game.players) == 1 and scene.model.match_behind
    stage.post(Action("undo"))
    assert len(scene.model.frame.game.players) == 2


# -- own balls ----------------------------------------------------------------------------------------


def test_the_own_balls_are_lit_once_there_are_some():
    opening = open_level("default").scene.model.frame.game
    assert own_balls(opening) == () and own_balls(msgspec.structs.replace(opening, opening=False)) == ()
    solids = msgspec.structs.replace(opening, opening=False, groups=("solids", "stripes"))
    assert own_balls(solids) == tuple(range(1, 8))
    assert own_balls(msgspec.structs.replace(solids, turn=1)) == tuple(range(9, 16))
    assert own_balls(msgspec.structs.replace(solids, on_table=(8, 9, 10))) == (8,)
    assert own_balls(open_level("nine-ball").scene.model.frame.game) == (1,)
    assert own_balls(open_level("practice").scene.model.frame.game) == ()


def ring_of(number: int) -> np.ndarray:
    """The picture of the cloth beside the own ball of a person."""
    group = "stripes" if number > 8 else "solids"
    other = "solids" if number > 8 else "stripes"
    far = 3 if number > 8 else 9
    stage = level_of(
        'game = "eight-ball"\nballs = [{ number = 0, position = [0.5, 0.5] },'
        f" {{ number = {number}, position = [0.7, 1.6] }}, {{ number = {far}, position = [0.2, 2.2] }}]"
    )
    model = stage.scene.model
    game = msgspec.structs.replace(model.frame.game, groups=(group, other))
    model.frame = model.frame.replace(game=game)
    stage.post(SetParameter("guide", "none"))
    prepare()
    look = Look(THEMES["dark"], 1.5)
    picture = pygame.Surface((1920, 1080), 0, 32)
    view = StageView(stage, look)
    view.place(picture.get_rect(), look)
    view.draw(picture)
    light = []
    for turn in np.linspace(0.0, 2.0 * math.pi, 200, endpoint=False):
        found = []
        for radius in np.linspace(0.96, 1.04, 9) * OWN_RING * BALL_RADIUS:
            x, y = view.camera.to_screen(0.7 + radius * math.cos(turn), 1.6 + radius * math.sin(turn))
            found.append(sum(picture.get_at((round(x), round(y)))[:3]))
        light.append(max(found))
    return np.array(light)


def test_the_ring_of_a_stripe_is_broken_and_that_of_a_solid_whole():
    whole, broken = ring_of(4), ring_of(12)
    assert np.all(np.abs(whole / np.roll(whole, 1) - 1.0) < 0.2)  # a shadow comes and goes slowly: no gap
    assert 0.3 < float((broken < 0.8 * whole).mean()) < 0.7
    assert broken.min() < 0.5 * whole.max()


# -- choices, the strike, and who thinks --------------------------------------------------------------


@pytest.mark.parametrize("count", [1, 2, 3, 4])
def test_choices_lie_side_by_side_below_the_table_and_cover_no_ball(count: int):
    boxes = [layout.option_box(row, count) for row in range(count)]
    for box in boxes:
        assert box.top >= layout.TABLE.bottom
        assert layout.FOOT.top <= box.top < box.bottom <= layout.FOOT.bottom
        assert (
            layout.FOOT.left + layout.metres(layout.ASKED) <= box.left < box.right <= layout.FOOT.right + 1e-9
        )
    for one, other in pairwise(boxes):
        assert one.right < other.left


def test_the_strike_button_strikes_as_it_is_set_and_is_there_only_when_one_may():
    stage = level_of(ON_THE_EIGHT)
    scene = stage.scene
    aim(stage, AT_THE_CORNER)
    meant = scene.aiming.stroke
    row = [name for name, _, _ in scene.buttons.rows()].index("strike")
    press(stage, layout.button_box(row))
    assert scene.play.phase == "striking" and scene.play.pending == pytest.approx(meant)
    assert "strike" not in [name for name, _, _ in scene.buttons.rows()]


def test_on_its_way_to_the_strike_button_the_hand_does_not_turn_the_cue():
    stage = level_of(ON_THE_EIGHT)
    scene = stage.scene
    aim(stage, AT_THE_CORNER)
    seconds(stage, 0.6)
    meant = scene.aiming.cue.aim
    row = [name for name, _, _ in scene.buttons.rows()].index("strike")
    x, y = layout.button_box(row).middle
    for share in (0.2, 0.4, 0.6, 0.8):
        point(stage, "move", 0.3 + share * (x - 0.3), 0.3 + share * (y - 0.3))
        seconds(stage, 0.05)
    press(stage, layout.button_box(row))
    assert scene.play.pending is not None and scene.play.pending.azimuth == meant


def test_who_gets_ready_says_how_far_it_has_come():
    first, second = threading.Event(), threading.Event()
    begun = threading.Event()

    def wait_again() -> None:
        begun.set()
        second.wait(600.0)

    thinker = Thinker(lambda question: Thought(()), lambda: first.wait(600.0), wait_again)
    stage = open_level("default", first_player="club")
    stage.scene.opponents.thinker = thinker
    thinker.prepare()
    assert standing(stage).cards[0].status.startswith("gets ready: part 1 of 2, 0 s")
    first.set()
    assert begun.wait(600.0)
    assert standing(stage).cards[0].status.startswith("gets ready: part 2 of 2")
    second.set()
    question = Question("key", stage.scene.model.frame, "club", 0)
    while thinker.ask(question) is None:
        pass
    assert thinker.warm and standing(stage).cards[0].status == "thinks"


def test_a_level_with_a_game_as_it_says_takes_no_other_parameter():
    stage = open_level("default", game="nine-ball", race="1")
    stage.post(SetParameter("race", "7"))
    assert stage.scene.play.racks_to_win == 7
