"""What the referee calls at each table, and the card at the end of a frame."""

from __future__ import annotations

import msgspec
import pytest

from game.billiards.game.games.carom import Carom, CaromVerdict
from game.billiards.game.games.eight_ball import EightBall
from game.billiards.game.games.nine_ball import NineBall
from game.billiards.game.rules import Foul, Verdict
from game.billiards.game.snooker.rules import AGAIN, FREE, REPLAY, Snooker
from game.scenes.shared.tables.referee.calls import (
    END,
    FOUL,
    Spoken,
    carom_call,
    frame_ball,
    game_ball,
    pool_call,
    snooker_call,
)
from game.scenes.shared.tables.referee.card import share_words, time_words
from game.stage import Action
from tests.scenes.billiards import billiards_stages as pool
from tests.scenes.shared.test_eye import differ, drawn

SCRATCH = Foul("scratch", "The cue ball went down.")
REDS = tuple(range(1, 16))
COLOURS = tuple(range(16, 22))


def snooker(points, stage="red", reds=REDS, **more) -> Snooker:
    """A frame with so many reds left."""
    return Snooker(
        players=("Ada", "Ben"), points=points, on_table=(*reds, *COLOURS), stage=stage, opening=False, **more
    )


def test_pool_calls_fouls_runs_and_the_last_ball():
    nine = NineBall(players=("Ada", "Ben"), on_table=(7, 9), opening=False)
    assert pool_call(Verdict(nine), 0) == Spoken()
    assert pool_call(Verdict(nine, scored=(6,)), 1) == Spoken()
    assert pool_call(Verdict(nine, scored=(6,)), 3) == Spoken("Run of 3")
    hand = msgspec.structs.replace(nine, in_hand="anywhere")
    assert pool_call(Verdict(hand, fouls=(SCRATCH,)), 0) == Spoken("Foul: scratch, ball in hand", FOUL)
    last = msgspec.structs.replace(nine, on_table=(9,))
    assert pool_call(Verdict(last, scored=(7,)), 4) == Spoken("Run of 4, game ball")
    won = msgspec.structs.replace(last, winner=1)
    assert pool_call(Verdict(won, scored=(9,)), 5) == Spoken("Ben wins the rack", END)
    assert pool_call(Verdict(won, scored=(9,)), 5, match_over=True) == Spoken("Ben wins the match", END)


def test_the_eight_is_the_game_ball_of_who_has_no_other():
    game = EightBall(players=("Ada", "Ben"), on_table=(8, 9, 10), groups=("solids", "stripes"), opening=False)
    assert game_ball(game)
    assert not game_ball(msgspec.structs.replace(game, turn=1))


@pytest.mark.parametrize(
    ("points", "stage", "reds", "colours", "called"),
    [
        ((60, 24), "red", (1,), COLOURS, False),  # 36 against 35 is won already
        ((59, 24), "red", (1,), COLOURS, True),  # 35 level with 35 left; a red makes it 36 against 27
        ((40, 24), "red", (1,), COLOURS, False),  # 17 against 27
        ((51, 24), "red", (1,), COLOURS, True),  # 27 against 35, then 28 against 27
        ((50, 24), "red", (1,), COLOURS, False),  # 26 against 35, then 27 against 27: not yet
        ((14, 0), "order", (), (20, 21), False),  # 14 against 13 is won already
        ((10, 0), "order", (), (20, 21), True),  # 10 against 13; the pink: 16 against 7
        ((0, 0), "order", (), (20, 21), False),  # then 6 against 7
        ((0, 0), "order", (), (21,), True),
    ],
)
def test_the_frame_ball_by_hand(points, stage, reds, colours, called):
    game = msgspec.structs.replace(snooker(points, stage, reds), on_table=(*reds, *colours))
    assert frame_ball(game) is called


def test_snooker_calls_the_break_the_foul_the_miss_and_the_free_ball():
    before = snooker((0, 0))
    scored = msgspec.structs.replace(before, points=(8, 0), run=8)
    assert snooker_call(before, Verdict(scored, scored=(21,))) == Spoken("8")
    fouled = msgspec.structs.replace(
        before, points=(0, 4), turn=1, options=(FREE, AGAIN, REPLAY), free_ball=True
    )
    foul = Verdict(fouled, fouls=(Foul("wrong ball", ""),))
    assert snooker_call(before, foul) == Spoken("Foul, 4 and a miss, free ball", FOUL)
    over = msgspec.structs.replace(scored, winner=0, best_of=1, won=(1, 0))
    assert snooker_call(before, Verdict(over, scored=(21,))) == Spoken("Frame and match, Ada", END)


def test_carom_calls_the_run_and_what_is_to_go():
    game = Carom(players=("Ada", "Ben"), target=15, points=(9, 3), run=4, opening=False)
    assert carom_call(CaromVerdict(game, (), True)) == Spoken("4")
    assert carom_call(CaromVerdict(msgspec.structs.replace(game, points=(13, 3)), (), True)) == Spoken(
        "4 and 2 to go"
    )
    assert carom_call(CaromVerdict(game, ())) == Spoken()
    ended = msgspec.structs.replace(game, ended=True, winner=0)
    assert carom_call(CaromVerdict(ended, (), True)) == Spoken("Ada wins", END)


def test_a_call_is_seen_over_the_rail_and_goes():
    stage = pool.straight_pot("nine-ball")
    stage.scene.aiming.point_along(2.0)
    stage.scene.parameters.power = 0.3
    stage.post(Action("strike"))
    pool.until_aiming(pool.seconds(stage, 0.3))
    assert stage.scene.model.frame.foul
    early = drawn(stage)
    pool.seconds(stage, 4.0)
    late = drawn(stage)
    assert 0.002 < differ(early, late) < 0.05


def test_figures_of_the_card():
    assert share_words(3, 4) == "75 % of 4"
    assert time_words(125.9) == "2:05 min"


def test_the_time_of_a_rack_runs_until_it_is_over_and_begins_again():
    stage = pool.straight_pot("nine-ball")
    pool.seconds(stage, 2.0)
    assert stage.scene.play.rack_s == pytest.approx(2.0)
    stage.post(Action("rack"))
    pool.seconds(stage, 0.5)
    assert stage.scene.play.rack_s == pytest.approx(0.5, abs=0.02)
