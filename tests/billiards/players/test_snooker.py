"""Computer players at snooker: what they play for, choose, and how they keep out of fouls."""

import math

import msgspec
import numpy as np
import pytest

from game.billiards.game.arrangement import Stroke
from game.billiards.game.rules import Call
from game.billiards.game.snooker.frame import SnookerFrame, new_snooker_frame
from game.billiards.game.snooker.rules import new_snooker
from game.billiards.players.snooker import SNOOKER_GRADES, decide_snooker, hand_of
from game.billiards.players.snooker_ideas import ideas_of
from game.billiards.table.snooker import BALL_RADIUS, SPOTS, in_the_d
from tests.billiards.game.snooker.referee import BLACK, BLUE, BROWN, GREEN, PINK, YELLOW, game, order

R = BALL_RADIUS
CLUB, MASTER = SNOOKER_GRADES["club"], SNOOKER_GRADES["master"]
SMALL = CLUB._replace(effort=CLUB.effort._replace(candidates=2, finalists=4, samples=8), safe=4)


def lying(state, places) -> SnookerFrame:
    numbers = tuple(sorted(ball for ball in places if ball))
    return new_snooker_frame(msgspec.structs.replace(state, on_table=numbers), places)


def rows(frame, bits):
    """Balls of a set of rows."""
    return {number for row, number in enumerate(frame.layout.numbers) if bits >> row & 1}


ALL = {ball: SPOTS[ball] for ball in (YELLOW, GREEN, BROWN, BLUE, PINK, BLACK)}


def test_what_is_played_for_follows_what_is_on():
    places = {0: (0.3, 1.5), 1: (1.4, 2.0), 2: (1.5, 2.4), **ALL}
    (red,) = ideas_of(lying(game(), places))
    frame = lying(game(), places)
    assert rows(frame, red.aims.first) == {1, 2} and red.points == 1 and red.call == Call()
    assert rows(frame, red.aims.lose) == set(ALL) and rows(frame, red.following) == set(ALL)
    colours = ideas_of(lying(game(stage="colour"), places))
    assert [idea.points for idea in colours] == [2, 3, 4, 5, 6, 7]
    assert [idea.call.ball for idea in colours] == list(ALL)
    assert rows(frame, colours[-1].following) == {1, 2} == rows(frame, colours[-1].others)
    last = lying(order(PINK, BLACK), {0: (0.3, 1.5), PINK: SPOTS[PINK], BLACK: SPOTS[BLACK]})
    (pink,) = ideas_of(last)
    assert rows(last, pink.aims.first) == {PINK} and rows(last, pink.following) == {BLACK}
    free = ideas_of(lying(game(free_ball=True), places))
    assert len(free) == 7 and free[-1].call == Call(BLACK) and free[-1].points == 1


def test_the_black_is_nominated_and_potted_where_it_lies_well():
    places = {0: (0.45, 3.11), 1: (1.4, 2.0), **ALL, BLACK: (0.2, 3.36)}
    frame = lying(game(stage="colour"), places)
    made = decide_snooker(frame, SMALL, threads=1)
    assert made.call == Call(BLACK)
    assert frame.play(made.stroke, made.call).verdict.game.points == (7, 0)


def test_the_same_is_decided_for_the_same_seed():
    frame = lying(game(), {0: (0.3, 1.5), 1: (0.5, 2.9), **ALL})
    first, second = (decide_snooker(frame, SMALL, 5, threads=1) for _ in range(2))
    assert first.stroke == second.stroke and first.call == second.call
    assert (
        hand_of(first.stroke, SMALL, 1) == hand_of(first.stroke, SMALL, 1) != hand_of(first.stroke, SMALL, 2)
    )


def test_a_player_plays_away_from_a_touching_ball():
    places = {0: (0.7, 2.0), 1: (0.7, 2.0 + 2.0 * R), 2: (1.2, 2.4), **ALL}
    frame = lying(game(), places)
    made = decide_snooker(frame, SMALL, threads=1)
    assert frame.play(made.stroke, made.call).verdict.legal


def test_a_player_escapes_from_a_snooker():
    places = {0: (0.889, 0.55), 1: (0.889, 2.9), **ALL}
    frame = lying(game(), places)
    made = decide_snooker(frame, MASTER, threads=1)
    assert frame.play(made.stroke, made.call).verdict.legal


def test_in_hand_the_cue_ball_is_put_into_the_d_and_the_break_off_is_safe():
    frame = new_snooker_frame(new_snooker())
    made = decide_snooker(frame, SMALL, threads=1)
    assert made.place is not None and in_the_d(*made.place)
    played = frame.move_cue_ball(*made.place).play(made.stroke, made.call)
    assert played.verdict.legal and not played.summary.balls_down
    in_off = lying(game(in_hand="in the D"), {1: (0.5, 2.9), **ALL})
    made = decide_snooker(in_off, SMALL, threads=1)
    assert in_the_d(*made.place)


def test_choices_after_a_foul():
    hidden = {0: (0.889, 3.3), 1: (0.889, 2.0), **ALL}
    shown = {0: (0.45, 3.11), 1: (0.2, 3.36), **ALL}
    for places, wanted in ((shown, "play"), (hidden, "replay")):
        frame = lying(game(), places)
        (x, y), (bx, by) = frame.cue_ball, SPOTS[BLUE]
        struck = frame.play(Stroke(0.01, math.atan2(by - y, bx - x)))  # stops short: a miss
        assert [option.name for option in struck.frame.game.options] == ["play", "again", "replay"]
        assert decide_snooker(struck.frame, SMALL, threads=1).option == wanted


def test_a_lost_frame_is_conceded_and_not_before():
    places = {0: (0.3, 1.5), PINK: SPOTS[PINK], BLACK: SPOTS[BLACK]}
    lost = lying(order(PINK, BLACK, points=(0, 60)), places)
    assert decide_snooker(lost, SMALL, threads=1).option == "concede"
    behind = lying(order(PINK, BLACK, points=(0, 20)), places)
    assert decide_snooker(behind, SMALL, threads=1).stroke is not None
    with pytest.raises(ValueError, match="over"):
        decide_snooker(lying(order(BLACK, winner=0), {0: (0.3, 1.5), BLACK: SPOTS[BLACK]}), SMALL)


def test_stronger_grades_have_steadier_hands():
    noises = [grade.unsteady for grade in SNOOKER_GRADES.values()]
    assert noises == sorted(noises, reverse=True) and len(noises) == 4
    meant = Stroke(2.0, 1.0)
    off = [
        np.std([hand_of(meant, grade, seed).azimuth for seed in range(60)])
        for grade in SNOOKER_GRADES.values()
    ]
    assert off == sorted(off, reverse=True)
