"""Computer players: they play by the rules of every game, and the better ones play better."""

from __future__ import annotations

import math

import msgspec
import numpy as np
import pytest

from game.billiards.game.arrangement import Stroke, arrange, is_free
from game.billiards.game.frame import Frame, new_frame
from game.billiards.game.games import CombinationMatch, EightBall, NineBall, Practice
from game.billiards.game.rules import CUE_BALL, Call, ShotSummary
from game.billiards.players.opponents import CLUB, EXPERT, GRADES, MASTER, NOVICE, decide, stroke_of_hand
from game.lab.players import broken_table, measure_clearing, measure_series, play_rack, visit, with_hand
from tests.billiards.search.search_tables import POOL, scattered

pytestmark = pytest.mark.compiled

MIDDLE = MASTER._replace(
    name="middle", effort=CLUB.effort._replace(deep=2, close=16, deep_samples=2, after=CLUB.placing), places=4
)


def test_grades_are_in_order():
    assert list(GRADES) == ["novice", "club", "expert", "master"]
    unsteady = [grade.unsteady for grade in GRADES.values()]
    assert unsteady == sorted(unsteady, reverse=True) and unsteady[-1] == 1.0
    assert all(grade.title and grade.about for grade in GRADES.values())


@pytest.mark.parametrize("game", [EightBall, NineBall, CombinationMatch])
def test_racks_come_to_their_end_by_the_rules(game):
    """Two quick players; whatever they decide is allowed, or `play_rack` would raise."""
    frame = new_frame(game(), seed=3)
    last, strokes = play_rack(frame, (NOVICE, CLUB), 5, most=24)
    assert strokes and (last.game.over or len(strokes) > 12)
    assert set(last.layout.numbers) - {CUE_BALL} <= set(game().on_table)


def test_a_decision_depends_on_nothing_but_frame_grade_and_seed():
    frame = _turn(EightBall(opening=False, in_hand="", groups=("solids", "stripes")))
    first = decide(frame, MIDDLE, 7, threads=1)
    assert first == decide(frame, MIDDLE, 7, threads=3)
    assert first.considered and first.considered[0].worth >= first.considered[-1].worth
    assert first.option == "" and first.place is None


def _turn(game, seed=8):
    """A frame in the middle of a rack."""
    layout = scattered(seed, 1 + max(game.on_table))
    return Frame(game, layout.without(*(n for n in layout.numbers if n and n not in game.on_table)), POOL)


@pytest.mark.parametrize("grade", [NOVICE, CLUB, MIDDLE], ids=lambda grade: grade.name)
def test_calls_name_ball_and_pocket_or_a_safety(grade):
    for seed in (1, 2, 3):
        game = EightBall(opening=False, in_hand="", groups=("solids", "stripes"), calling="all")
        frame = _turn(game, seed)
        thought = decide(frame, grade, seed)
        if not thought.call.safety:
            assert thought.call.ball in game.legal_first() and 0 <= thought.call.pocket <= 5
            assert thought.worth > 0.0


def test_ball_in_hand_is_put_on_a_free_place():
    game = EightBall(opening=False, in_hand="behind the line", groups=("solids", "stripes"))
    frame = _turn(game).replace(layout=scattered(8).without(0))
    for grade in (NOVICE, MIDDLE):
        thought = decide(frame, grade, 1)
        assert is_free(frame.layout, POOL, CUE_BALL, *thought.place, "behind the line")


def test_an_open_table_is_looked_at_for_both_groups():
    """Solids are shut in behind their rail, stripes lie before pockets: the call is a stripe."""
    places = {0: (0.6, 1.0), 1: (0.03, 0.9), 9: (1.1, 1.27), 10: (1.15, 2.4), 8: (0.6, 2.0)}
    game = EightBall(opening=False, in_hand="", on_table=(1, 8, 9, 10), calling="all")
    thought = decide(Frame(game, arrange(places), POOL), MIDDLE, 1)
    assert thought.call.ball in (9, 10)


def test_options_are_chosen_among_those_offered():
    for game, offered in (
        (EightBall(), {"accept", "break", "other breaks"}),
        (NineBall(opening=False, in_hand="", push_out_next=True), {"play", "pass back"}),
    ):
        asked = game.judge(ShotSummary((1,)), Call(push_out=isinstance(game, NineBall))).game
        frame = _turn(asked)
        thought = decide(frame, CLUB, 2)
        assert thought.option in offered and thought.stroke is None
        assert frame.choose(thought.option, 3).game.options == ()


def test_a_nine_ball_player_without_a_shot_pushes_out():
    """The 1 is walled in; the first stroke after the break may be pushed out."""
    ring = {k + 2: (0.635 + 0.075 * math.cos(k), 1.9 + 0.075 * math.sin(k)) for k in range(6)}
    game = NineBall(opening=False, in_hand="", push_out_next=True, on_table=(1, *range(2, 8), 9))
    layout = arrange({0: (0.635, 0.3), 1: (0.635, 1.9), 9: (0.2, 2.3), **ring})
    thought = decide(Frame(game, layout, POOL), CLUB, 1)
    assert thought.call.push_out and thought.stroke is not None
    later = msgspec.structs.replace(game, push_out_next=False)
    assert not decide(Frame(later, layout, POOL), CLUB, 1).call.push_out


def test_nobody_plays_on_when_the_rack_is_over():
    frame = _turn(EightBall(opening=False, in_hand="", winner=1))
    with pytest.raises(ValueError, match="over"):
        decide(frame, NOVICE)


def test_no_time_still_gives_a_decision():
    frame = _turn(EightBall(opening=False, in_hand="anywhere", groups=("solids", "stripes")))
    thought = decide(frame.replace(layout=frame.layout.without(0)), MIDDLE, 1, seconds=0.0)
    assert thought.stroke is not None and thought.place is not None


def test_practice_is_played_alone():
    frame = _turn(Practice(opening=False, in_hand=""))
    assert decide(frame, CLUB, 1).stroke is not None


def test_a_hand_is_as_unsteady_as_its_grade():
    meant = Stroke(2.0, 0.5, 0.0, 0.1, 0.1)
    for grade in (NOVICE, EXPERT):
        made = np.array([stroke_of_hand(meant, grade, seed) for seed in range(400)])
        spread = (made[:, 1] - meant.azimuth).std()
        assert spread == pytest.approx(grade.noise.azimuth, rel=4.0 / math.sqrt(800))
    assert stroke_of_hand(meant, MASTER, 3) == stroke_of_hand(meant, MASTER, 3)
    assert stroke_of_hand(meant, with_hand(MASTER, 0.0), 3) == meant


def test_broken_tables_repeat_and_have_the_eight():
    frame = broken_table(4)
    again = broken_table(4)
    assert frame.game == again.game and np.array_equal(frame.layout.positions, again.layout.positions)
    assert (
        8 in frame.layout.numbers
        and CUE_BALL not in frame.layout.numbers
        and frame.game.in_hand == "anywhere"
    )
    assert frame.game.on_table == frame.layout.numbers


def test_a_steadier_hand_pots_more():
    """The same way to think, without noise and with four times the usual one."""
    steady, wild = (measure_clearing(with_hand(CLUB, hand), range(3)) for hand in (0.0, 4.0))
    assert steady.potted > wild.potted and steady.success > wild.success
    assert visit(1, with_hand(CLUB, 0.0)) == visit(1, with_hand(CLUB, 0.0), threads=1)


def test_a_club_player_beats_a_novice():
    series = measure_series(CLUB, NOVICE, range(13, 23))  # of 43 it wins 32: three games said little
    assert series.first + series.second == 10 and series.first >= 6 and series.strokes > 5.0
