"""The snooker table: its measures, spots, and where colours are put back (WPBSA 1.1, 3.2, 3.5, 3.7)."""

import math

import numpy as np
import pytest

from game.billiards.laws.layout import is_clear
from game.billiards.table.snooker import (
    APART,
    BALL_RADIUS,
    BAULK,
    COLOURS,
    D_RADIUS,
    FROZEN,
    MIDDLE,
    SPOTS,
    in_the_d,
    nearest_in_the_d,
    opening_places,
    respotted,
    touching,
    value_of,
)
from game.billiards.table.table import SNOOKER_LENGTH, Table

YELLOW, GREEN, BROWN, BLUE, PINK, BLACK = COLOURS
R = BALL_RADIUS


def test_measures_are_those_of_the_rules():
    table = Table.snooker()
    assert (table.width, table.length) == (1.778, 3.569) and 2.0 * BALL_RADIUS == 0.0525
    assert [SPOTS[ball][1] for ball in (YELLOW, GREEN, BROWN)] == [0.737] * 3
    assert SPOTS[YELLOW][0] - MIDDLE == pytest.approx(0.292) == MIDDLE - SPOTS[GREEN][0]
    assert SPOTS[BLUE][1] == 0.5 * 3.569 and SPOTS[PINK][1] == 0.75 * 3.569
    assert 3.569 - SPOTS[BLACK][1] == pytest.approx(0.324)
    assert [value_of(ball) for ball in (1, 15, *COLOURS)] == [1, 1, 2, 3, 4, 5, 6, 7]


def test_the_table_is_symmetric_and_its_jaws_keep_off_the_bed():
    table = Table.snooker()
    assert len(table.pockets) == 6 and len(table.jaws) == 12
    assert is_clear(table, BALL_RADIUS)
    for rows in (table.jaws, table.pockets):
        mirrored = rows * (-1.0, 1.0, 1.0) + (table.width, 0.0, 0.0)
        assert {tuple(row) for row in np.round(mirrored, 12)} == {tuple(row) for row in np.round(rows, 12)}


def test_the_reds_lie_as_near_to_the_pink_as_they_can():
    places = opening_places()
    gaps = [math.dist(places[a], places[b]) - 2.0 * R for a in places for b in places if a < b]
    assert min(gaps) > -1e-12 and len(places) == 21
    assert 0.0 < math.dist(places[1], places[PINK]) - 2.0 * R <= 1.01 * APART
    assert touching(places, 1) == (2, 3) and len(opening_places(6)) == 12
    with pytest.raises(ValueError, match="reds"):
        opening_places(4)


def test_the_d():
    assert in_the_d(MIDDLE, BAULK) and in_the_d(MIDDLE + D_RADIUS, BAULK)
    assert not in_the_d(MIDDLE, BAULK + 0.01) and not in_the_d(MIDDLE + 0.25, BAULK - 0.25)
    for asked in ((0.1, 0.1), (MIDDLE, 2.0), (1.7, 0.737), (MIDDLE + 0.1, BAULK - 0.1)):
        assert in_the_d(*nearest_in_the_d(*asked))
    assert nearest_in_the_d(MIDDLE + 0.1, BAULK - 0.1) == (MIDDLE + 0.1, BAULK - 0.1)


def test_a_colour_goes_to_its_own_spot():
    assert respotted({0: (0.3, 0.3)}, (BLUE,))[BLUE] == SPOTS[BLUE]


def test_an_occupied_spot_sends_it_to_the_highest_free_one():
    at = {1: (SPOTS[BLUE][0] + 1.9 * R, SPOTS[BLUE][1])}
    assert respotted(at, (BLUE,))[BLUE] == SPOTS[BLACK]
    assert respotted({**at, 2: SPOTS[BLACK]}, (BLUE,))[BLUE] == SPOTS[PINK]


def test_own_spots_first_then_the_higher_value_has_precedence():
    at = {1: SPOTS[BLUE], 2: SPOTS[BROWN]}
    lying = respotted(at, (BROWN, BLUE, BLACK))
    assert lying[BLACK] == SPOTS[BLACK]
    assert lying[BLUE] == SPOTS[PINK] and lying[BROWN] == SPOTS[GREEN]


def test_when_all_are_occupied_it_lies_behind_its_own_spot_and_touches_nothing():
    at = {k: SPOTS[ball] for k, ball in enumerate(COLOURS, 1)}
    lying = respotted(at, (BLUE,))
    x, y = lying[BLUE]
    assert x == MIDDLE and 0.0 < y - SPOTS[BLUE][1] - 2.0 * R <= 1.01 * APART
    assert not touching(lying, BLUE)


def test_without_room_behind_the_black_it_lies_before_it():
    at = {k: SPOTS[ball] for k, ball in enumerate(COLOURS, 1)}
    black_y = SPOTS[BLACK][1]
    row, y = 7, black_y + 2.0 * R
    while y < SNOOKER_LENGTH - R + 2.0 * R:
        at[row] = (MIDDLE, min(y, SNOOKER_LENGTH - R))
        row, y = row + 1, y + 2.0 * R + 0.001
    lying = respotted(at, (BLACK,))
    assert lying[BLACK][0] == MIDDLE and lying[BLACK][1] < black_y
    assert black_y - lying[BLACK][1] <= 2.0 * R + 1.01 * APART and not touching(lying, BLACK)
    assert min(math.dist(lying[BLACK], place) for k, place in lying.items() if k != BLACK) > 2.0 * R + FROZEN
