"""What is counted of players over a match, and which stroke of a rack is the best."""

import math

import pytest

from game.billiards.game.arrangement import Stroke, arrange
from game.billiards.game.frame import BestStroke, Frame, Struck
from game.billiards.game.games import NineBall
from game.billiards.game.rules import Call, Foul, Game, Pocketing, ShotSummary, Verdict
from game.billiards.game.tally import Tally, balls_between, merit
from tests.billiards.search.search_tables import POOL

GAME, BREAK = Game(on_table=(1, 2, 3)), Game(on_table=(1, 2, 3), opening=True)
FOUL = (Foul("scratch", "The cue ball went down."),)
DIAGONAL = math.atan2(-1.0, -1.0)
STUN = Stroke(1.2, DIAGONAL, 0.0, 0.0, -0.3)  # the cue ball does not follow into the pocket


def verdict(*scored: int, fouls=(), over: bool = False) -> Verdict:
    return Verdict(Game(winner=0 if over else None), tuple(fouls), tuple(scored))


def test_tries_runs_and_fouls_are_counted():
    tally = Tally()
    assert tally.rate is None
    for one in (verdict(1), verdict(2, 3), verdict(), verdict(4), verdict(5, fouls=FOUL), verdict()):
        tally = tally.after(GAME, Call(), one)
    assert tally == Tally(tries=6, scoring=3, run=0, longest=3, fouls=1)
    assert tally.rate == pytest.approx(0.5)


@pytest.mark.parametrize(
    ("game", "call"), [(BREAK, Call()), (GAME, Call(safety=True)), (GAME, Call(push_out=True))]
)
def test_a_break_a_safety_and_a_push_out_are_no_tries_but_their_fouls_count(game, call):
    assert Tally().after(game, call, verdict()) == Tally()
    assert Tally().after(game, call, verdict(fouls=FOUL)) == Tally(fouls=1)


def test_a_stroke_is_worth_more_by_way_of_another_ball_off_a_cushion_and_when_it_wins():
    direct = ShotSummary(pocketed=(Pocketing(5, 0, (0, 5), 0),))
    combined = ShotSummary(pocketed=(Pocketing(5, 0, (0, 3, 5), 0),))
    banked = ShotSummary(pocketed=(Pocketing(5, 0, (0, 5), 2, 2),))
    assert balls_between(direct.pocketed[0]) == 0 and balls_between(combined.pocketed[0]) == 1
    plain = merit(direct, verdict(5))
    assert merit(combined, verdict(5)) > plain and merit(banked, verdict(5)) > plain
    assert merit(direct, verdict(5, over=True)) > plain > 0.0
    assert merit(direct, verdict(5, fouls=FOUL)) == 0.0  # a foul is nothing to be shown again
    assert merit(direct, verdict()) == merit(ShotSummary(), verdict(over=True)) == 0.0


@pytest.mark.compiled
def test_a_frame_counts_for_who_strikes_and_keeps_the_best_stroke_of_its_rack():
    game = NineBall(on_table=(5, 9), opening=False, in_hand="", turn=1)
    first = Frame(game, arrange({0: (0.5, 0.5), 5: (0.22, 0.22), 9: (0.4, 2.0)}), POOL)
    assert first.best is None
    potted = first.play(STUN).frame
    assert potted.tallies[1] == Tally(1, 1, 1, 1, 0) and potted.tallies[0] == Tally()
    assert potted.best.struck.stroke == STUN and potted.best.summary.balls_down == (5,)
    cue_ball = potted.cue_ball
    aim = math.atan2(2.0 - cue_ball[1], 0.4 - cue_ball[0])
    missed = potted.play(Stroke(0.3, aim + 0.5)).frame
    assert missed.tallies[1].tries == 2 and missed.tallies[1].fouls == 1 and missed.tallies[1].run == 0
    assert missed.best is potted.best
    assert missed.earlier.tallies == potted.tallies and missed.earlier.earlier.tallies[1] == Tally()
    won = Frame(game, arrange({0: (0.5, 0.5), 5: (0.4, 0.4), 9: (0.22, 0.22)}), POOL).play(
        Stroke(3.0, DIAGONAL)
    )
    assert won.frame.game.over and won.frame.best.merit > potted.best.merit
    following = won.frame.next_rack(1)
    assert following.best is None and following.tallies == won.frame.tallies


@pytest.mark.compiled
@pytest.mark.parametrize(("before", "replaced"), [(0.5, True), (9.0, False)])
def test_only_a_stroke_that_is_worth_as_much_takes_the_place_of_the_best(before, replaced):
    game = NineBall(on_table=(5, 9), opening=False, in_hand="")
    frame = Frame(game, arrange({0: (0.5, 0.5), 5: (0.22, 0.22), 9: (0.4, 2.0)}), POOL)
    earlier = BestStroke(Struck(frame, STUN), ShotSummary(), before)
    best = frame.replace(best=earlier).play(STUN).frame.best
    assert (best is not earlier) == replaced
