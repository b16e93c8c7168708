"""What the referee calls at each table, and the card at the end of a frame."""

from __future__ import annotations

from types import SimpleNamespace

import msgspec
import pygame
import pytest

from game.billiards.game.games.carom import Carom, CaromVerdict
from game.billiards.game.games.eight_ball import EightBall
from game.billiards.game.games.nine_ball import NineBall
from game.billiards.game.rules import Call, Foul, Verdict
from game.billiards.game.snooker.rules import AGAIN, FREE, REPLAY, Snooker
from game.billiards.players.remarks import FOUL as ABOUT_FOUL
from game.billiards.players.remarks import REMARKS, Happened
from game.scenes.billiards import layout
from game.scenes.shared.tables.boxes import look_of, rect_of
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
from game.scenes.shared.tables.referee.remark import AFTER_S, SHOWN_S, draw_remark, happened_at, said
from game.stage import Action, SetParameter
from game.ui.canvas.camera import Camera
from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look
from game.ui.look.theme import DARK
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


def test_a_player_of_the_ladder_says_a_word_below_its_name_and_no_other_does():
    seen = {}
    for grade in ("person", "tom"):
        stage = pool.straight_pot("nine-ball")
        stage.post(SetParameter("second_player", grade))
        stage.scene.aiming.point_along(2.0)
        stage.scene.parameters.power = 0.3
        stage.post(Action("strike"))
        pool.until_aiming(pool.seconds(stage, 0.3))
        happened = happened_at(stage.scene.play)
        assert (happened.by, happened.scored, happened.foul, happened.winner) == (0, False, True, None)
        seen[grade] = said(stage.scene.play)
    assert seen == {"person": "", "tom": REMARKS["tom"][ABOUT_FOUL][1 % len(REMARKS["tom"][ABOUT_FOUL])]}
    assert stage.scene.model.frame.strokes == 1


@pytest.mark.parametrize("size", [(1280, 720), (1920, 1080), (900, 506)])
def test_a_remark_lies_on_the_table_beside_the_call_and_below_the_board(size):
    stage = pool.straight_pot("nine-ball")
    surface = pygame.Surface(size, 0, 32)
    canvas, camera = Canvas(Look(DARK, size[0] / 1280.0)), Camera(quarter_turns=1)
    camera.fit(stage.scene.frame(), surface.get_rect(), 0.0)
    canvas.begin(surface, surface.get_rect(), camera)
    look, table = look_of(canvas, layout.PIXELS), rect_of(canvas, layout.TABLE)
    longest = max((one for words in REMARKS.values() for few in words.values() for one in few), key=len)
    place = draw_remark(canvas, look, layout.TABLE, longest, 2.0)
    assert place.w > look.px(100) and table.inflate(0, look.px(8)).contains(place)
    assert place.left > table.centerx + look.px(150)
    for age_s in (0.0, AFTER_S - 0.01, SHOWN_S):
        assert draw_remark(canvas, look, layout.TABLE, longest, age_s).w == 0


def course_after(before, verdict, call=None, runs=(0, 2)):
    """What is known after a stroke: runs after and before it of each player at a pool table."""
    after, then = (SimpleNamespace(game=before, tallies=[SimpleNamespace(run=run)] * 2) for run in runs)
    last = SimpleNamespace(frame=then, call=call or Call())
    frame = SimpleNamespace(game=verdict.game, last=last)
    return SimpleNamespace(
        model=SimpleNamespace(frame=frame, played=SimpleNamespace(verdict=verdict, frame=after))
    )


def test_who_played_what_counted_and_whether_it_was_to():
    nine = NineBall(players=("Ada", "Tom"), turn=1, opening=False)
    missed = Verdict(msgspec.structs.replace(nine, turn=0))
    assert happened_at(course_after(nine, missed)) == Happened(1, False, False, 0, 2)
    assert happened_at(course_after(nine, missed), tried=False).safe
    assert happened_at(course_after(nine, missed, Call(safety=True))).safe
    assert happened_at(course_after(nine, missed, Call(push_out=True))).safe
    assert happened_at(course_after(msgspec.structs.replace(nine, opening=True), missed)).safe
    won = Verdict(msgspec.structs.replace(nine, winner=1), scored=(9,))
    assert happened_at(course_after(nine, won, runs=(3, 2))) == Happened(1, True, False, 3, 2, winner=1)
    alone = NineBall(players=("Ada",), opening=False)
    assert happened_at(course_after(alone, Verdict(alone))) is None
    break_of = snooker((8, 0), run=8)
    gone_on = Verdict(msgspec.structs.replace(break_of, run=9), scored=(1,))
    assert happened_at(course_after(break_of, gone_on)) == Happened(0, True, False, 9, 8)


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
