"""What strokes led to, and what tables are worth: as tables, and by comparison."""

from __future__ import annotations

import numpy as np
import pytest

from game.billiards.game.arrangement import arrange
from game.billiards.game.games import CombinationMatch, EightBall, NineBall, Practice
from game.billiards.search.aims import aims_of, bits_of
from game.billiards.search.deeper import aims_left
from game.billiards.search.outcomes import (
    CHAIN,
    CUSHIONED,
    DOWN,
    FACTS,
    FIRST_BALLS,
    POCKET,
    SCRATCH,
    Outcomes,
)
from game.billiards.search.rating import FOULED, LOST, MISSED, SCORED, WON, Aims
from game.billiards.search.strokes import Board, Noise
from game.billiards.search.view import View
from tests.billiards.search.search_tables import POOL

ROWS = (0, 1, 2, 8, 9)  # numbers on the table, by row
LAYOUT = {0: (0.6, 0.5), 1: (0.3, 1.27), 2: (1.0, 0.4), 8: (1.0, 2.2), 9: (0.5, 2.2)}

GROUPED = EightBall(
    opening=False, in_hand="", on_table=(1, 2, 8, 9), groups=("solids", "stripes"), calling="all"
)
ON_EIGHT = EightBall(opening=False, in_hand="", on_table=(8, 9), groups=("solids", "stripes"), calling="all")
NINE = NineBall(opening=False, in_hand="", on_table=(1, 2, 8, 9))


def outcome(first, down=(), scratch=False, cushioned=True, chains=None):
    """One outcome at the table above: numbers hit first; (ball, pocket) down; chains by ball."""
    facts = np.zeros((1, FACTS), np.int64)
    histories = np.zeros((1, 5, 4), np.int64)
    histories[:, :, POCKET] = -1
    facts[0, FIRST_BALLS] = bits_of(ROWS, first)
    facts[0, SCRATCH] = scratch
    facts[0, CUSHIONED] = cushioned
    for ball, pocket in down:
        row = ROWS.index(ball)
        facts[0, DOWN] |= 1 << row
        histories[0, row, POCKET] = pocket
        histories[0, row, CHAIN] = bits_of(ROWS, (0, *((chains or {}).get(ball, ())), ball))
    return Outcomes(facts, histories, np.zeros((1, 5, 2)))


def kind_of(game, result, meant):
    """Class of an outcome."""
    layout = arrange(LAYOUT)
    view = View(Board(layout, POOL), Noise())
    row = [ROWS.index(meant[0]), meant[1]] if meant else [-1, -1]
    numbers = tuple(number if number in (0, *game.on_table) else -1 for number in ROWS)
    return int(view.classes(result, aims_of(game, numbers)[0], np.array([row]))[0])


CASES = [
    (GROUPED, outcome((1,), [(1, 2)]), (1, 2), SCORED),
    (GROUPED, outcome((1,), [(1, 3)]), (1, 2), MISSED),
    (GROUPED, outcome((1,), [(2, 0)]), (1, 2), MISSED),
    (GROUPED, outcome((9,), [(1, 2)]), (1, 2), FOULED),
    (GROUPED, outcome((1,), [(1, 2)], scratch=True), (1, 2), FOULED),
    (GROUPED, outcome((1,), cushioned=False), (1, 2), FOULED),
    (GROUPED, outcome((1,)), (1, 2), MISSED),
    (GROUPED, outcome(()), (1, 2), FOULED),
    (GROUPED, outcome((1,), [(1, 2), (8, 0)]), (1, 2), LOST),
    (GROUPED, outcome((1, 9), [(1, 2)]), (1, 2), SCORED),
    (ON_EIGHT, outcome((8,), [(8, 4)]), (8, 4), WON),
    (ON_EIGHT, outcome((8,), [(8, 3)]), (8, 4), LOST),
    (ON_EIGHT, outcome((8,), [(8, 4)], scratch=True), (8, 4), LOST),
    (ON_EIGHT, outcome((9,), [(8, 4)]), (8, 4), LOST),
    (NINE, outcome((1,), [(2, 0)]), (1, 2), SCORED),
    (NINE, outcome((1,), [(9, 0)]), (1, 2), WON),
    (NINE, outcome((2,), [(9, 0)]), (1, 2), FOULED),
    (NINE, outcome((2,), [(2, 0)]), (1, 2), FOULED),
    (CombinationMatch(on_table=(1, 2, 8, 9)), outcome((1,), [(2, 0)], chains={2: (1,)}), (2, 0), SCORED),
    (CombinationMatch(on_table=(1, 2, 8, 9)), outcome((1,), [(1, 0)]), (1, 0), MISSED),
    (Practice(), outcome((9,), [(9, 0)]), None, SCORED),
]


@pytest.mark.parametrize(("game", "result", "meant", "expected"), CASES)
def test_what_a_stroke_led_to(game, result, meant, expected):
    assert kind_of(game, result, meant) == expected


def worth(places, aims, kind=SCORED, noise=Noise()):  # noqa: B008
    """Worth of a table by rating."""
    layout = arrange(places)
    view = View(Board(layout, POOL), noise)
    outcomes = Outcomes(
        np.zeros((1, FACTS), np.int64), np.zeros((1, len(places), 4), np.int64), layout.positions[None]
    )
    return float(view.worth(outcomes, aims, np.array([kind]))[0])


TWO = {0: (0.7, 1.27), 1: (0.4, 1.27), 2: (0.9, 2.2)}
BOTH = Aims(0b110, 0b110, 0b110, other=0, solo=True)


def test_alone_a_miss_is_worth_nothing_and_an_empty_table_all():
    for kind, value in ((MISSED, 0.0), (FOULED, 0.0), (LOST, 0.0), (WON, 1.0)):
        assert worth(TWO, BOTH, kind) == value
    assert worth({0: (0.5, 0.5)}, Aims(0, 0, 0, solo=True)) == 1.0
    assert 0.0 < worth(TWO, BOTH) < 1.0


def test_a_table_is_worth_less_where_it_is_harder():
    hidden = TWO | {1: (0.02 + 0.0286, 1.0)}
    assert worth(hidden, BOTH) < worth(TWO, BOTH)
    assert worth(TWO, BOTH, noise=Noise().scaled(3.0)) < worth(TWO, BOTH)
    far = TWO | {0: (1.2, 0.1)}
    assert worth(far, BOTH) < worth(TWO, BOTH)


def test_at_turn_is_better_than_not_and_in_hand_worst():
    game = Aims(0b0110, 0b0110, 0b0110, other=0b11000)
    places = TWO | {3: (0.3, 0.6), 4: (0.9, 0.7)}
    on, off, hand = (worth(places, game, kind) for kind in (SCORED, MISSED, FOULED))
    assert 1.0 > on > off > 0.0 and off >= hand - 0.05
    fewer = {number: place for number, place in places.items() if number != 2}
    less = Aims(0b010, 0b010, 0b010, other=0b1100)
    assert worth(fewer, less) > on


def test_aims_of_games():
    open_table = aims_of(EightBall(opening=False, in_hand="", on_table=(1, 2, 8, 9)), ROWS)
    assert [aims.score for aims in open_table] == [0b00110, 0b10000]
    assert [aims.needed for aims in open_table] == [0b01110, 0b11000]
    assert all(aims.first == 0b10110 and aims.lose == 0b01000 for aims in open_table)
    (own,) = aims_of(GROUPED, ROWS)
    assert (own.first, own.lose, own.win, own.other) == (0b00110, 0b01000, 0, 0b11000)
    (eight,) = aims_of(ON_EIGHT, (0, 8, 9), solo=True)
    assert (eight.first, eight.win, eight.lose, eight.solo) == (0b010, 0b010, 0, True)
    (nine,) = aims_of(NINE, ROWS)
    assert nine.rotation and nine.first == 0b00010 and nine.win == 0b10000 and not nine.called
    assert aims_of(CombinationMatch(on_table=(9,)), (0, 9))[0].chain == 0
    assert aims_of(CombinationMatch(on_table=(1, 9)), (0, 1, 9))[0].chain == 3
    assert aims_of(Practice(), ROWS)[0].solo


def test_aims_after_some_balls_are_down():
    kept = np.array([0, 2, 3, 4])
    own = aims_left(aims_of(GROUPED, ROWS)[0], kept)
    assert (own.first, own.score, own.needed, own.lose, own.win) == (0b0010, 0b0010, 0b0110, 0b0100, 0)
    last = aims_left(aims_of(GROUPED, ROWS)[0], np.array([0, 3, 4]))
    assert (last.first, last.win, last.lose) == (0b010, 0b010, 0)
    nine = aims_left(aims_of(NINE, ROWS)[0], kept)
    assert (nine.first, nine.needed, nine.win) == (0b0010, 0b1110, 0b1000)
