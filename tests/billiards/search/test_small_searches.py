"""All stages of a search with next to no effort: few balls, few strokes, and a choice that must be."""

from __future__ import annotations

import pytest

from game.billiards import find_shots, simulate
from game.billiards.game.arrangement import arrange, is_free
from game.billiards.game.frame import new_frame
from game.billiards.game.games import EightBall, NineBall
from game.billiards.game.rules import CUE_BALL, Call, ShotSummary
from game.billiards.game.summary import summarize
from game.billiards.players.opponents import Grade, decide
from game.billiards.search.looking import Effort
from game.billiards.search.strokes import STEADY
from game.billiards.shot.physics import Physics
from tests.billiards.search.search_tables import POOL

LEAST = Effort(
    kinds=("direct",), speeds=(1.2,), ups=(0.0,), lefts=(0.0,), candidates=2, rays=17, finalists=2, samples=2
)
DEEP = LEAST._replace(deep=1, close=2, deep_samples=1, after=LEAST)
LEARNER = Grade("learner", "", "", 0.1, LEAST, LEAST, places=2, safe=2, break_speed=5.0, breaks=1)
STRAIGHT = {0: (0.635, 1.27), 3: (0.3, 0.6), 8: (1.0, 2.0)}  # the three lies before a corner pocket


def turn(game, places):
    """A frame in which it is somebody's turn, no rack being broken."""
    return new_frame(game, seed=1).replace(layout=arrange(places))


def test_a_shot_is_found_and_goes():
    layout = arrange(STRAIGHT)
    found = find_shots(layout, POOL, targets=(3,), first=(3,), noise=STEADY, effort=LEAST)
    assert found and found[0].ball == 3 and found[0].kind in ("direct", "cut")
    fallen = summarize(simulate(layout.shot(POOL, Physics(), found[0].stroke))).pocketing(3)
    assert fallen is not None and fallen.pocket == found[0].pocket


def test_a_ball_of_the_own_group_is_called():
    game = EightBall(opening=False, groups=("solids", "stripes"))
    for learner in (LEARNER, LEARNER._replace(effort=DEEP)):
        thought = decide(turn(game, STRAIGHT), learner, 1, threads=1)
        assert thought.call.safety or (thought.call.ball, thought.call.pocket in range(6)) == (3, True)


def test_the_cue_ball_in_hand_is_put_where_it_may_lie():
    game = EightBall(opening=False, in_hand="anywhere", groups=("solids", "stripes"))
    frame = turn(game, {3: (0.3, 0.6), 8: (1.0, 2.0)})
    thought = decide(frame, LEARNER, 1, threads=1)
    assert is_free(frame.layout, POOL, CUE_BALL, *thought.place, "anywhere")


@pytest.mark.parametrize("game", [EightBall, NineBall])
def test_a_break_is_hard_and_equal_seeds_break_alike(game):
    frame = new_frame(game(), seed=1)
    first, again = (decide(frame, LEARNER, 7, threads=1) for _ in range(2))
    assert first.stroke == again.stroke
    assert first.stroke.cue_speed > 3.0


def test_a_player_without_a_shot_pushes_out_if_that_is_allowed():
    """The 1 stands behind the 9, close to the rail."""
    places = {0: (0.635, 0.3), 9: (0.635, 2.36), 1: (0.635, 2.5)}
    game = NineBall(opening=False, in_hand="", push_out_next=True, on_table=(1, 9))
    assert decide(turn(game, places), LEARNER, 1, threads=1).call.push_out


def test_an_option_is_one_of_those_offered():
    game = EightBall().judge(ShotSummary((1,)), Call()).game
    frame = turn(game, STRAIGHT)
    thought = decide(frame, LEARNER, 1, threads=1)
    assert thought.option in {option.name for option in game.options} and thought.stroke is None
