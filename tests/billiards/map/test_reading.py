"""What is read off strokes that were played: routes at carom, keys of pots at pool, from lists of events."""

from __future__ import annotations

from itertools import product
from types import SimpleNamespace

import numpy as np
import pytest

from game.billiards.laws.state import (
    BALL_BALL,
    BALL_CUSHION,
    END_TIME,
    EVENTS_END,
    FINISHED,
    IN_X,
    IN_Y,
    STATUS,
)
from game.billiards.map.pool import pot_keys
from game.billiards.map.routes import CUSHIONS, FIRST, INTO, KISSES, Routes, read_routes
from game.billiards.search import outcomes
from game.billiards.search.legality import Legality

LEFT, RIGHT, LOWER, UPPER = range(4)
CUE, OTHER, RED = range(3)


def read(*touches, against=0):
    """The facts, code and time of one shot, given as (kind, ball, what) in order, 0.1 s apart."""
    events = np.array([(0.1 * (k + 1), *touch) for k, touch in enumerate(touches)], dtype=float)
    ends, final = np.zeros((1, END_TIME + 1)), np.zeros((1, 3, max(IN_X, IN_Y) + 1))
    ends[0, EVENTS_END], ends[0, STATUS] = len(events), FINISHED
    routes = Routes.empty(1)
    read_routes(events, ends, final, against, *routes)
    return routes.facts[0], int(routes.codes[0]), float(routes.times[0])


def test_cushions_kisses_and_the_order_of_touches():
    facts, code, time = read(
        (BALL_BALL, CUE, OTHER), (BALL_CUSHION, CUE, LEFT), (BALL_CUSHION, CUE, UPPER),
        (BALL_BALL, OTHER, RED), (BALL_BALL, CUE, OTHER), (BALL_CUSHION, RED, LEFT),
        (BALL_CUSHION, CUE, RIGHT), (BALL_BALL, CUE, RED), (BALL_BALL, OTHER, RED),
    )  # fmt: skip
    assert (facts[CUSHIONS], facts[FIRST], facts[KISSES], facts[INTO]) == (3, OTHER, 2, 0)
    assert code == int("514526", 8)  # 1 to 4 for the rails, 5 and 6 for the balls
    assert time == pytest.approx(0.8)


def test_a_route_that_does_not_end_at_both_balls_has_no_code():
    facts, code, time = read((BALL_CUSHION, CUE, LOWER), (BALL_BALL, CUE, RED), (BALL_BALL, RED, OTHER))
    assert (facts[CUSHIONS], facts[FIRST], facts[KISSES]) == (-1, -RED, 1)
    assert (code, time) == (0, -1.0)


def test_a_ball_played_into_what_it_lies_against():
    facts, code, _ = read((BALL_BALL, CUE, RED), (BALL_BALL, CUE, OTHER), against=1 << (4 + RED))
    assert facts[INTO] == 1 and facts[CUSHIONS] == 0 and code == int("65", 8)
    facts, code, _ = read(
        (BALL_CUSHION, CUE, LEFT), (BALL_BALL, CUE, RED), (BALL_BALL, CUE, OTHER), against=1 << LEFT
    )
    assert facts[INTO] == 0 and facts[CUSHIONS] == 0 and code == int("65", 8)


def test_pots_have_one_key_by_ball_pocket_cushions_and_chain():
    numbers = (0, 1, 2, 3)
    board = SimpleNamespace(layout=SimpleNamespace(numbers=numbers), count=len(numbers))
    cases = list(product((1, 2, 3), range(6), range(4), (0b1, 0b11, 0b101)))
    facts = np.zeros((len(cases), outcomes.FACTS), np.int64)
    histories = np.zeros((len(cases), len(numbers), outcomes.HISTORY_COLUMNS), np.int64)
    for k, (row, pocket, cushions, chain) in enumerate(cases):
        facts[k, outcomes.DOWN], facts[k, outcomes.FIRST_BALLS] = 1 << row, 1 << row
        histories[k, row, outcomes.POCKET] = pocket
        histories[k, row, outcomes.CUSHIONS], histories[k, row, outcomes.CHAIN] = cushions, chain
    given = SimpleNamespace(facts=facts, histories=histories)
    keys = pot_keys(board, given)
    assert len(np.unique(keys)) == len(cases) and keys.min() > 0
    assert [(key - 1) % 16 for key in keys.tolist()] == [row for row, _, _, _ in cases]
    assert [(key - 1) // 16 % 8 for key in keys.tolist()] == [pocket for _, pocket, _, _ in cases]
    only = pot_keys(board, given, Legality((2,)))
    assert np.array_equal(only > 0, [row == 2 for row, _, _, _ in cases])
    for foul in (outcomes.SCRATCH, outcomes.GIVEN_UP):
        facts[:, foul] = 1
        assert not pot_keys(board, given).any()
        facts[:, foul] = 0
