"""Straight pool, paragraph by paragraph (WPA 4): what a stroke did, and what follows from it."""

import math

import msgspec
import numpy as np
import pytest

from game.billiards.game.frame import new_frame
from game.billiards.game.games import StraightPool
from game.billiards.game.rules import Call
from game.billiards.table import rack_area as area
from game.billiards.table.rack import BALL_RADIUS
from game.billiards.table.table import Table
from tests.billiards.game.situations import Situation, check_situation, check_verdict, shot

ALL = tuple(range(1, 16))
CALL_1 = Call(1, 0)
OUTSIDE, KITCHEN = (0.3, 1.2), (0.3, 0.3)  # m; before the line, and behind it
INSIDE = (area.FOOT[0], area.FOOT[1] + 0.08)  # m; in the triangle


def pool(**fields) -> StraightPool:
    """A game of which the opening is over."""
    return StraightPool(**{"opening": False, "in_hand": "", **fields})


def last_but_one(ball: tuple[float, float] | None, cue: tuple[float, float], **fields):
    """The verdict on a stroke that pots the 1 as called and leaves the 15 at a place; None: potted too."""
    down = (1,) if ball is not None else (1, 15)
    rest = [(0, *cue)] + ([(15, *ball)] if ball is not None else [])
    return pool(on_table=(1, 15), **fields).judge(shot(1, down=down, rest=tuple(rest)), CALL_1)


SITUATIONS = [
    Situation("4.3: cue ball and two others to a cushion are a lawful opening", StraightPool(),
              shot(1, cushioned=(1, 0, 5)), {"turn": 1, "fouls": [], "points": (0, 0), "options": []},
              Call(safety=True)),
    Situation("4.3: the cue ball and one other are not", StraightPool(), shot(1, cushioned=(1, 0)),
              {"turn": 1, "fouls": ["break"], "points": (-2, 0), "options": ["accept", "other breaks"]}),
    Situation("4.3: two others without the cue ball are not", StraightPool(), shot(1, cushioned=(1, 5)),
              {"fouls": ["break"], "points": (-2, 0)}),
    Situation("4.3: the called ball at the opening counts, whatever reached a cushion", StraightPool(),
              shot(1, down=(1,), cushioned=()), {"turn": 0, "points": (1, 0), "fouls": []}, CALL_1),
    Situation("4.3: an uncalled ball at the opening is put back", StraightPool(),
              shot(1, down=(3,), cushioned=(0, 1, 2)), {"turn": 1, "spot": (3,), "missing": ()}, CALL_1),
    Situation("4.4: who pots the called ball plays on", pool(run=4, points=(4, 0)), shot(1, down=(1,)),
              {"turn": 0, "points": (5, 0), "run": 5, "high": (5, 0), "scored": (1,)}, CALL_1),
    Situation("4.4: a miss ends the turn and the run", pool(run=4, points=(4, 0)), shot(1),
              {"turn": 1, "points": (4, 0), "run": 0}, CALL_1),
    Situation("4.4: the points asked for win", pool(target=20, points=(19, 7)), shot(1, down=(1,)),
              {"winner": 0, "won": (1, 0), "points": (20, 7)}, CALL_1),
    Situation("4.5: any ball may be called", pool(), shot(9, down=((12, 3),)), {"points": (1, 0)},
              Call(12, 3)),
    Situation("4.5: what goes down with a safety is put back", pool(), shot(1, down=(1,)),
              {"turn": 1, "points": (0, 0), "spot": (1,), "missing": ()}, Call(safety=True)),
    Situation("4.6: the called ball in another pocket is put back", pool(), shot(1, down=((1, 3),)),
              {"turn": 1, "spot": (1,), "missing": (), "points": (0, 0)}, CALL_1),
    Situation("4.6: balls off the table are put back", pool(), shot(1, off_table=(4,)),
              {"spot": (4,), "missing": (), "fouls": ["off the table"], "points": (-1, 0)}, CALL_1),
    Situation("4.6: balls potted with a foul are put back", pool(), shot(1, down=(1,), cue_pocketed=True),
              {"spot": (1,), "missing": (), "points": (-1, 0), "scored": ()}, CALL_1),
    Situation("4.7: each other ball of a called stroke is a point", pool(), shot(1, down=(1, 5, 9)),
              {"points": (3, 0), "run": 3, "missing": (1, 5, 9), "scored": (1, 5, 9)}, CALL_1),
    Situation("4.7: points may be below nothing", pool(points=(0, 3)), shot(1, cushioned=()),
              {"points": (-1, 3)}, CALL_1),
    Situation("4.9: no cushion is a point, and the cue ball stays", pool(), shot(1, cushioned=()),
              {"turn": 1, "fouls": ["no cushion"], "in_hand": "", "points": (-1, 0), "row": (1, 0)}, CALL_1),
    Situation("4.9: no ball touched", pool(), shot(), {"fouls": ["no contact"], "points": (-1, 0)}, CALL_1),
    Situation("4.9: the cue ball down is in hand behind the line", pool(), shot(1, cue_pocketed=True),
              {"turn": 1, "fouls": ["scratch"], "in_hand": "behind the line", "points": (-1, 0)}, CALL_1),
    Situation("4.9: from behind the line a ball there is not played at", pool(in_hand="behind the line"),
              shot(1, short=True), {"fouls": ["behind the line"], "points": (-1, 0)}, CALL_1),
    Situation("4.8: but at a new rack any ball is", pool(in_hand="behind the line", new_rack=True),
              shot(1, short=True), {"fouls": [], "new_rack": False}, Call(safety=True)),
    Situation("4.9: any ball may be hit first", pool(), shot(15, down=(1,)), {"points": (1, 0)}, CALL_1),
    Situation("4.10: a breaking foul is none of the three", StraightPool(fouls_in_row=(2, 0)),
              shot(1, cushioned=()), {"row": (2, 0), "points": (-2, 0), "rack": False}),
    Situation("4.11: the third in a row costs fifteen more, all racked, the same opens",
              pool(fouls_in_row=(2, 0), points=(9, 0), on_table=(1, 2, 3)), shot(1, cushioned=()),
              {"points": (-7, 0), "row": (0, 0), "rack": True, "turn": 0, "opening": True,
               "on_table": ALL, "in_hand": "behind the line"}, CALL_1),
    Situation("4.11: a stroke without a foul takes the two away", pool(fouls_in_row=(2, 0)), shot(1),
              {"row": (0, 0), "turn": 1}, CALL_1),
]  # fmt: skip


@pytest.mark.parametrize("situation", SITUATIONS, ids=lambda one: one.name)
def test_what_follows_from_a_stroke(situation):
    check_situation(situation)
    check_verdict(situation)


@pytest.mark.parametrize(("name", "turn", "opening"), [("accept", 1, False), ("other breaks", 0, True)])
def test_4_3_a_breaking_foul_may_be_accepted_or_broken_again(name, turn, opening):
    asked = StraightPool(points=(4, 6)).judge(shot(1, cushioned=(1,))).game
    verdict = asked.choose(name)
    state = verdict.game
    assert (state.turn, state.opening, state.points) == (turn, opening, (2, 6))
    assert verdict.rack == opening


# -- 4.8: where break ball and cue ball lie when fourteen are racked again -----------------------------

AT_HEAD = (area.HEAD[0] + 0.01, area.HEAD[1])
BEFORE_HEAD = (area.HEAD[0], area.HEAD[1] + 0.05)  # m; blocks the head spot, before the line
WHERE = [  # break ball, cue ball, and where they then lie; "hand": behind the line
    (OUTSIDE, KITCHEN, OUTSIDE, KITCHEN),
    (OUTSIDE, AT_HEAD, OUTSIDE, AT_HEAD),
    (INSIDE, OUTSIDE, area.HEAD, OUTSIDE),
    (INSIDE, KITCHEN, area.HEAD, KITCHEN),
    (INSIDE, AT_HEAD, area.CENTRE, AT_HEAD),
    (OUTSIDE, INSIDE, OUTSIDE, "hand"),
    (KITCHEN, INSIDE, KITCHEN, area.HEAD),
    (AT_HEAD, INSIDE, AT_HEAD, area.CENTRE),
    (BEFORE_HEAD, INSIDE, BEFORE_HEAD, area.CENTRE),
]


@pytest.mark.parametrize(("ball", "cue", "ball_to", "cue_to"), WHERE)
def test_4_8_what_lies_in_the_way_of_a_rack(ball, cue, ball_to, cue_to):
    verdict = last_but_one(ball, cue)
    places = {number: (x, y) for number, x, y in verdict.places}
    assert places[15] == ball_to
    assert places.get(0, "hand") == cue_to
    assert verdict.game.in_hand == ("behind the line" if cue_to == "hand" else "")
    assert verdict.game.on_table == ALL and verdict.game.turn == 0 and not verdict.game.opening
    apex = [number for number, place in places.items() if math.dist(place, area.FOOT) < BALL_RADIUS]
    assert not apex  # fourteen are racked without it
    assert len(places) == 16 - (cue_to == "hand")
    assert verdict.game.points == (1, 0) and verdict.game.run == 1 and verdict.game.racks == 1


@pytest.mark.parametrize(("cue", "hand"), [(OUTSIDE, ""), (INSIDE, "behind the line")])
def test_4_8_a_the_fifteenth_down_with_the_fourteenth_all_are_racked(cue, hand):
    verdict = last_but_one(None, cue)
    assert verdict.game.points == (2, 0) and verdict.game.in_hand == hand
    places = {number: (x, y) for number, x, y in verdict.places}
    assert any(math.dist(places[number], area.FOOT) < 1e-9 for number in ALL)


def test_4_8_b_both_in_the_way_all_are_racked_and_the_cue_ball_is_in_hand():
    other = (INSIDE[0] + 0.06, INSIDE[1])
    verdict = last_but_one(INSIDE, other)
    assert verdict.game.in_hand == "behind the line" and not verdict.game.opening
    assert sorted(number for number, _, _ in verdict.places) == list(ALL)


def test_4_2_the_outline_is_that_of_the_racked_balls():
    places = area.rack_places()
    apex, right = places[0], places[14]
    assert area.in_rack_area(tuple(places[4].tolist()))
    for place, out in ((apex, (0.0, -1.0)), (right, (math.cos(math.pi / 6), 0.5))):
        for gap, held in ((2.0 * BALL_RADIUS - 1e-6, True), (2.0 * BALL_RADIUS + 1e-6, False)):
            assert area.in_rack_area(tuple((place + gap * np.array(out)).tolist())) == held


def test_balls_racked_again_lie_apart_and_can_be_played_at():
    verdict = last_but_one(OUTSIDE, KITCHEN)
    frame = new_frame(verdict.game, Table.pool())
    after = frame._layout_after(verdict, frame.layout, None)
    after.shot(frame.table, frame.physics)  # ShotError if balls overlap
    assert after.place_of(15) == OUTSIDE and after.place_of(0) == KITCHEN


def test_1_5_from_behind_the_line_there_is_a_ball_to_play_at():
    """After a scratch with all balls behind the line the nearest to it is put on the foot spot."""
    game = pool(on_table=(2, 3, 15))
    rest = ((2, 0.3, 0.2), (3, 0.8, 0.5), (15, 0.5, 0.1))
    verdict = game.judge(shot(2, cue_pocketed=True, rest=rest), Call(2, 0))
    assert verdict.spot == (3,)
    before = game.judge(shot(2, cue_pocketed=True, rest=(*rest[:2], (15, 0.5, 1.9))), Call(2, 0))
    assert before.spot == ()


def test_the_next_game_is_opened_by_the_other():
    won = pool(target=1).judge(shot(1, down=(1,)), CALL_1).game
    verdict = won.next_rack()
    assert verdict.rack and verdict.game.turn == 1 and verdict.game.points == (0, 0)
    assert verdict.game.won == (1, 0) and verdict.game.target == 1
    assert msgspec.structs.replace(won, winner=None).over is False
