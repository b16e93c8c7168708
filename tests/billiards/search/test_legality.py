"""Referee, map, aim and computer players say the same of a stroke: whether it breaks a rule."""

import math

import numpy as np
import pytest

from game.billiards.game.arrangement import Stroke, arrange
from game.billiards.game.frame import Frame
from game.billiards.game.games import CombinationMatch, EightBall, NineBall, Practice
from game.billiards.game.games.ghost import Ghost
from game.billiards.game.rules import Call
from game.billiards.map.pool import pool_map
from game.billiards.search.aims import aims_of
from game.billiards.search.legality import board_of, legality_of
from game.billiards.search.rating import FOULED, LOST
from game.billiards.search.strokes import Board, Noise
from game.billiards.search.view import View
from game.billiards.table.rack import HEAD_SPOT
from game.billiards.table.table import Table

pytestmark = pytest.mark.compiled

POOL = Table.pool()
LINE = HEAD_SPOT * POOL.length
BEHIND = {0: (0.6, 0.3), 6: (0.3, 0.5), 2: (0.9, 1.2), 11: (0.5, 2.0), 8: (0.2, 1.7), 9: (0.65, 0.6355)}
ON = (2, 6, 8, 9, 11)
OPEN = {"on_table": ON, "opening": False}


def frame_of(game) -> Frame:
    return Frame(game, arrange(BEHIND), POOL)


GAMES = [
    game_type(**OPEN, **more, in_hand=hand)
    for hand in ("behind the line", "anywhere", "")
    for game_type, more in (
        (EightBall, {}),
        (EightBall, {"groups": ("solids", "stripes")}),
        (NineBall, {}),
        (CombinationMatch, {}),
        (Ghost, {"discipline": "eight-ball"}),
    )
]


def strokes_all_round(count: int = 600) -> np.ndarray:
    """Strokes in all directions, some curved, some off two cushions and back behind the line."""
    random = np.random.default_rng(5)
    strokes = np.zeros((count, 5))
    strokes[:, 0] = random.uniform(0.6, 4.5, count)
    strokes[:, 1] = random.uniform(-math.pi, math.pi, count)
    strokes[: count // 3, 2] = random.uniform(0.0, 0.5, count // 3)
    strokes[:, 3:] = random.uniform(-0.4, 0.4, (count, 2))
    return strokes


@pytest.mark.parametrize("game", GAMES, ids=lambda game: f"{type(game).__name__}-{game.in_hand}")
def test_the_same_strokes_are_fouls_for_all(game):
    frame = frame_of(game)
    strokes = strokes_all_round()
    board, legality = board_of(frame), legality_of(frame)
    outcomes = board.play(strokes)
    found = legality.fouls(board, outcomes)
    short = 0
    for row, stroke in enumerate(strokes.tolist()):
        played = frame.play(Stroke(*stroke), Call())
        kinds = {foul.kind for foul in played.verdict.fouls}
        short += "behind the line" in kinds
        if kinds == {"no cushion"} or (not kinds and not outcomes.facts[row, 2]):
            continue  # a ball that lay against a cushion: the search counts it as driven there
        early = bool(set(legality.barred) & set(played.summary.balls_down))
        assert bool(found[row]) == (bool(kinds) or early), (stroke, kinds, outcomes.facts[row])
    assert (short > 20) == (game.in_hand == "behind the line")


@pytest.mark.parametrize("game", GAMES[:5], ids=lambda game: type(game).__name__)
def test_computer_players_class_what_the_referee_calls_a_foul_as_one(game):
    frame = frame_of(game)
    board, legality = board_of(frame), legality_of(frame)
    outcomes = board.play(strokes_all_round(200))
    meant = np.full((200, 2), -1, np.int64)
    for aims in aims_of(frame.game, frame.layout.numbers):
        kinds = View(board, Noise()).classes(outcomes, aims, meant)
        assert np.isin(kinds[legality.fouls(board, outcomes)], (FOULED, LOST)).all()


def test_a_ball_behind_the_line_is_no_pot_of_the_map_unless_it_is_played_off_a_rail():
    frame = frame_of(NineBall(on_table=(6, 9), opening=False, in_hand="behind the line"))
    frame = frame.replace(layout=arrange({0: (0.45, 0.45), 6: (0.2, 0.2), 9: (0.9, 1.9)}))
    board = board_of(frame)
    listed = pool_map(board, Noise(), legality_of(frame)).pots
    free = pool_map(Board(frame.layout, POOL), Noise()).pots
    assert any(pot.ball == 6 and len(pot.chain) == 2 and pot.chance > 0.5 for pot in free)
    for pot in listed:
        assert frame.play(pot.stroke).verdict.legal, pot
    again = frame.replace(game=Practice(on_table=(6, 9), opening=False, in_hand="behind the line", rack=""))
    assert {pot.ball for pot in pool_map(board_of(again), Noise(), legality_of(again)).pots} == {6, 9}


def test_the_eight_before_its_turn_is_no_pot_of_the_map():
    places = {0: (0.6, 1.0), 3: (0.63, 1.3), 8: (0.64, 1.36), 12: (1.1, 0.3)}
    game = EightBall(on_table=(3, 8, 12), opening=False, in_hand="", groups=("solids", "stripes"))
    frame = Frame(game, arrange(places), POOL)
    board = board_of(frame)
    drawn = pool_map(board, Noise(), legality_of(frame))
    assert legality_of(frame).barred == (8,) and all(pot.ball != 8 for pot in drawn.pots)
    assert any(pot.ball == 8 for pot in pool_map(board, Noise()).pots)
    only = EightBall(on_table=(8, 12), opening=False, in_hand="", groups=("solids", "stripes"))
    assert only.barred() == () and EightBall().barred() == ()


def test_a_cue_ball_that_crosses_by_its_middle_may_come_back():
    """Straight up to the far rail and back onto the ball behind the line: legal; straight at it: a foul."""
    places = {0: (0.6, 0.6), 9: (0.6, 0.3)}
    frame = Frame(NineBall(on_table=(9,), opening=False, in_hand="behind the line"), arrange(places), POOL)
    strokes = np.array([(4.0, 0.5 * math.pi, 0, 0, 0), (1.5, -0.5 * math.pi, 0, 0, 0)], dtype=float)
    board = board_of(frame)
    outcomes = board.play(strokes)
    assert outcomes.facts[:, -1].tolist() == [0, 1]
    for row, stroke in enumerate(strokes.tolist()):
        assert frame.play(Stroke(*stroke)).summary.short == bool(outcomes.facts[row, -1])
