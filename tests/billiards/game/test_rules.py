"""Rules as tables: what a stroke did, and what follows from it."""

from __future__ import annotations

import msgspec
import pytest

from game.billiards.game.games import CombinationMatch, EightBall, NineBall, Practice
from game.billiards.game.rules import Call
from tests.billiards.game.situations import FOUR, Situation, check_situation, check_verdict, shot

SOLIDS = tuple(range(1, 8))
STRIPES = tuple(range(9, 16))


def eight(**fields) -> EightBall:
    """An eight-ball game of which the break is over."""
    return EightBall(**{"opening": False, "in_hand": "", **fields})


def grouped(on_table: tuple[int, ...] = tuple(range(1, 16)), **fields) -> EightBall:
    """The same with groups: the first player has the solids."""
    return eight(groups=("solids", "stripes"), on_table=on_table, **fields)


def nine(**fields) -> NineBall:
    """A nine-ball game of which the break is over."""
    return NineBall(**{"opening": False, "in_hand": "", **fields})


LATE = (8, *STRIPES)  # the first player is on the 8
CALL_1 = Call(1, 0)
CALL_8 = Call(8, 0)

BREAKS = [
    Situation("a ball down: the breaker goes on, the table is open", EightBall(), shot(1, down=(3,)),
              {"turn": 0, "open_table": True, "opening": False, "scored": (3,), "in_hand": ""}),
    Situation("four to a cushion: legal, the other plays", EightBall(), shot(1, cushioned=FOUR),
              {"turn": 1, "options": [], "fouls": [], "in_hand": ""}),
    Situation("the cue ball is no object ball at a cushion", EightBall(), shot(1, cushioned=(0, 1, 2, 3)),
              {"turn": 1, "options": ["accept", "break", "other breaks"], "fouls": []}),
    Situation("any ball may be hit first", EightBall(), shot(12, cushioned=FOUR), {"fouls": [], "turn": 1}),
    Situation("no ball is called at the break", EightBall(calling="all"), shot(1, down=(9,)),
              {"turn": 0, "scored": (9,), "groups": ("", "")}),
    Situation("balls of one group down: the table is open", EightBall(), shot(1, down=(9, 10, 12)),
              {"turn": 0, "groups": ("", "")}),
    Situation("scratch after a lawful break", EightBall(), shot(1, cushioned=FOUR, cue_pocketed=True),
              {"turn": 1, "in_hand": "behind the line", "fouls": ["scratch"], "options": []}),
    Situation("scratch with a ball down: it stays down", EightBall(), shot(1, down=(5,), cue_pocketed=True),
              {"turn": 1, "in_hand": "behind the line", "scored": (), "missing": (5,)}),
    Situation("scratch, and too few at a cushion", EightBall(), shot(1, cushioned=(1,), cue_pocketed=True),
              {"turn": 1, "options": ["in hand", "break", "other breaks"]}),
    Situation("no ball touched", EightBall(), shot(), {"turn": 1, "fouls": ["no contact"],
              "options": ["accept", "in hand", "break", "other breaks"]}),
    Situation("the 8 down: spot it or break again", EightBall(), shot(1, down=(8,)),
              {"turn": 0, "options": ["spot the eight", "break"], "winner": None}),
    Situation("the 8 down and scratch: the other chooses", EightBall(), shot(1, down=(8,), cue_pocketed=True),
              {"turn": 1, "options": ["spot the eight", "break"], "winner": None}),
    Situation("a ball off the table: the other may take the cue ball", EightBall(),
              shot(1, cushioned=FOUR, off_table=(4,)),
              {"turn": 1, "options": ["accept", "in hand"], "fouls": ["off the table"], "missing": (4,)}),
    Situation("the 8 off the table is put back", EightBall(), shot(1, cushioned=FOUR, off_table=(8,)),
              {"turn": 1, "spot": (8,), "missing": (), "winner": None}),
]  # fmt: skip

EIGHT_BALL = [
    Situation("the called ball decides the group", eight(), shot(1, down=((1, 0),)),
              {"turn": 0, "groups": ("solids", "stripes"), "scored": (1,)}, CALL_1),
    Situation("the second player's called stripe", eight(turn=1), shot(9, down=((9, 2),)),
              {"turn": 1, "groups": ("solids", "stripes"), "scored": (9,)}, Call(9, 2)),
    Situation("a stripe first on an open table, for a solid", eight(), shot(9, down=((1, 0),)),
              {"turn": 0, "groups": ("solids", "stripes")}, CALL_1),
    Situation("the called ball in another pocket: still open", eight(), shot(1, down=((1, 3),)),
              {"turn": 1, "groups": ("", ""), "fouls": [], "scored": (), "missing": (1,)}, CALL_1),
    Situation("another ball than called: still open", eight(), shot(1, down=((2, 0),)),
              {"turn": 1, "groups": ("", ""), "missing": (2,)}, CALL_1),
    Situation("nothing called: nothing counts", eight(), shot(1, down=((1, 0),)),
              {"turn": 1, "groups": ("", ""), "scored": ()}),
    Situation("the 8 first on an open table is a foul", eight(), shot(8),
              {"turn": 1, "fouls": ["wrong ball"], "in_hand": "anywhere"}, CALL_1),
    Situation("without calls the first ball down decides", eight(calling="none"), shot(1, down=(9, 1)),
              {"turn": 0, "groups": ("stripes", "solids"), "scored": (9,), "missing": (1, 9)}),
    Situation("both groups down, one called", eight(), shot(1, down=(9, 1)),
              {"groups": ("solids", "stripes"), "scored": (1,), "turn": 0}, CALL_1),
    Situation("a foul on an open table decides nothing", eight(), shot(1, down=(1,), cue_pocketed=True),
              {"turn": 1, "groups": ("", ""), "in_hand": "anywhere", "missing": (1,)}, CALL_1),
    Situation("open, one group is gone: the 8 may be played", eight(on_table=LATE), shot(8, down=((8, 0),)),
              {"winner": 0, "fouls": []}, CALL_8),
    Situation("own ball called and down", grouped(), shot(1, down=(1,)),
              {"turn": 0, "scored": (1,), "missing": (1,)}, CALL_1),
    Situation("own ball down, and one of the other's", grouped(), shot(1, down=(1, 9)),
              {"turn": 0, "scored": (1,), "missing": (1, 9)}, CALL_1),
    Situation("called by way of another own ball", grouped(), shot(2, down=((1, 0, (0, 2, 1)),)),
              {"turn": 0, "scored": (1,)}, CALL_1),
    Situation("the other's ball first", grouped(), shot(9, down=(1,)),
              {"turn": 1, "fouls": ["wrong ball"], "in_hand": "anywhere", "missing": (1,)}, CALL_1),
    Situation("both groups at one moment: no foul", grouped(), shot(1, 9), {"fouls": [], "turn": 1}, CALL_1),
    Situation("the 8 first too soon", grouped(), shot(8), {"fouls": ["wrong ball"], "turn": 1}, CALL_1),
    Situation("a stripe for the second player", grouped(turn=1), shot(9, down=(9,)),
              {"turn": 1, "scored": (9,), "fouls": []}, Call(9, 0)),
    Situation("no cushion after contact", grouped(), shot(1, cushioned=()),
              {"turn": 1, "fouls": ["no cushion"], "in_hand": "anywhere"}, CALL_1),
    Situation("the cue ball at a cushion is enough", grouped(), shot(1, cushioned=(0,)),
              {"turn": 1, "fouls": [], "in_hand": ""}, CALL_1),
    Situation("a ball down needs no cushion", grouped(), shot(1, down=(1,), cushioned=()),
              {"turn": 0, "fouls": []}, CALL_1),
    Situation("no ball touched", grouped(), shot(), {"turn": 1, "fouls": ["no contact"]}, CALL_1),
    Situation("nothing down: the other plays from there", grouped(), shot(1),
              {"turn": 1, "in_hand": "", "fouls": []}, CALL_1),
    Situation("scratch", grouped(), shot(1, cue_pocketed=True),
              {"turn": 1, "fouls": ["scratch"], "in_hand": "anywhere"}, CALL_1),
    Situation("scratch without a cushion is one foul", grouped(), shot(1, cushioned=(), cue_pocketed=True),
              {"fouls": ["scratch"]}, CALL_1),
    Situation("wrong ball and scratch are two", grouped(), shot(9, cue_pocketed=True),
              {"fouls": ["scratch", "wrong ball"], "row": (1, 0)}, CALL_1),
    Situation("a ball off the table stays out", grouped(), shot(1, off_table=(12,)),
              {"turn": 1, "fouls": ["off the table"], "missing": (12,)}, CALL_1),
    Situation("a safety passes the turn, ball down or not", grouped(), shot(1, down=(1,)),
              {"turn": 1, "fouls": [], "missing": (1,), "scored": ()}, Call(safety=True)),
    Situation("without calls any own ball counts", grouped(calling="none"), shot(1, down=(3,)),
              {"turn": 0, "scored": (3,)}),
    Situation("without calls the other's ball does not", grouped(calling="none"), shot(1, down=(9,)),
              {"turn": 1, "scored": (), "fouls": [], "missing": (9,)}),
    Situation("calls for the 8 only: an own ball needs none", grouped(calling="eight"), shot(1, down=(3,)),
              {"turn": 0, "scored": (3,)}),
    Situation("from behind the line a ball that lies there", grouped(in_hand="behind the line"),
              shot(1, down=(1,), short=True), {"turn": 1, "fouls": ["behind the line"]}, CALL_1),
    Situation("from anywhere a ball behind the line", grouped(in_hand="anywhere"),
              shot(1, down=(1,), short=True), {"turn": 0, "fouls": []}, CALL_1),
    Situation("a legal stroke ends a row of fouls", grouped(fouls_in_row=(2, 1)), shot(1), {"row": (0, 1)}),
]  # fmt: skip

THE_EIGHT = [
    Situation("the 8, called and last", grouped(LATE), shot(8, down=(8,)),
              {"winner": 0, "won": (1, 0), "scored": (8,)}, CALL_8),
    Situation("the 8 by the second player", grouped((*SOLIDS, 8), turn=1), shot(8, down=(8,)),
              {"winner": 1, "won": (0, 1)}, CALL_8),
    Situation("the 8 too early", grouped(), shot(1, down=(8,)), {"winner": 1, "won": (0, 1)}, CALL_1),
    Situation("the 8 with the last own ball", grouped((1, 8, *STRIPES)), shot(1, down=(1, 8)),
              {"winner": 1}, CALL_1),
    Situation("the 8 into another pocket", grouped(LATE), shot(8, down=((8, 5),)), {"winner": 1}, CALL_8),
    Situation("the 8 uncalled", grouped(LATE), shot(8, down=(8,)), {"winner": 1}),
    Situation("the 8 uncalled, where calls are off", grouped(LATE, calling="none"), shot(8, down=(8,)),
              {"winner": 0}),
    Situation("the 8 must be called where only it is", grouped(LATE, calling="eight"), shot(8, down=(8,)),
              {"winner": 1}),
    Situation("the 8 and the cue ball", grouped(LATE), shot(8, down=(8,), cue_pocketed=True),
              {"winner": 1, "fouls": ["scratch"]}, CALL_8),
    Situation("the 8 by way of the other's ball", grouped(LATE), shot(9, down=(8,)),
              {"winner": 1, "fouls": ["wrong ball"]}, CALL_8),
    Situation("the 8 off the table", grouped(LATE), shot(8, off_table=(8,)), {"winner": 1}, CALL_8),
    Situation("scratch on the 8 that stays up is a foul only", grouped(LATE), shot(8, cue_pocketed=True),
              {"winner": None, "turn": 1, "in_hand": "anywhere"}, CALL_8),
    Situation("the 8 missed", grouped(LATE), shot(8), {"winner": None, "turn": 1, "fouls": []}, CALL_8),
]  # fmt: skip

NINE_BALL = [
    Situation("break, a ball down", NineBall(), shot(1, down=(4,)),
              {"turn": 0, "push": True, "fouls": [], "scored": (4,)}),
    Situation("break, four at a cushion", NineBall(), shot(1, cushioned=FOUR), {"turn": 1, "push": True}),
    Situation("break, three at a cushion", NineBall(), shot(1, cushioned=(0, 1, 2, 3)),
              {"turn": 1, "fouls": ["break"], "in_hand": "anywhere", "push": False}),
    Situation("break, the 1 is not first", NineBall(), shot(2, cushioned=FOUR),
              {"turn": 1, "fouls": ["wrong ball"], "in_hand": "anywhere"}),
    Situation("break, the 9 down wins", NineBall(), shot(1, down=(9,)), {"winner": 0, "won": (1, 0)}),
    Situation("break, the 9 down with the cue ball", NineBall(), shot(1, down=(9,), cue_pocketed=True),
              {"winner": None, "turn": 1, "spot": (9,), "missing": ()}),
    Situation("break, no ball touched", NineBall(), shot(), {"fouls": ["no contact"], "turn": 1}),
    Situation("push-out: any ball or none, no cushion", nine(push_out_next=True), shot(cushioned=()),
              {"turn": 1, "options": ["play", "pass back"], "fouls": [], "push": False}, Call(push_out=True)),
    Situation("push-out, a ball down stays down", nine(push_out_next=True), shot(5, down=(5,)),
              {"turn": 1, "options": ["play", "pass back"], "missing": (5,)}, Call(push_out=True)),
    Situation("push-out, the 9 is put back", nine(push_out_next=True), shot(9, down=(9,)),
              {"winner": None, "spot": (9,), "missing": ()}, Call(push_out=True)),
    Situation("push-out with a scratch", nine(push_out_next=True), shot(3, cue_pocketed=True),
              {"turn": 1, "options": [], "fouls": ["scratch"], "in_hand": "anywhere"}, Call(push_out=True)),
    Situation("no push-out announced: the rules hold", nine(push_out_next=True), shot(3),
              {"fouls": ["wrong ball"], "push": False}),
    Situation("lowest ball down", nine(), shot(1, down=(1,)), {"turn": 0, "scored": (1,), "next": (2,)}),
    Situation("another ball by way of the lowest", nine(), shot(1, down=(6,)), {"turn": 0, "next": (1,)}),
    Situation("the 9 by way of the lowest wins", nine(), shot(1, down=(9,)), {"winner": 0}),
    Situation("the 9 with a wrong ball first", nine(), shot(2, down=(9,)),
              {"winner": None, "spot": (9,), "turn": 1, "in_hand": "anywhere"}),
    Situation("another ball with a foul stays down", nine(), shot(2, down=(5,)),
              {"spot": (), "missing": (5,), "fouls": ["wrong ball"]}),
    Situation("the lowest is no longer the 1", nine(on_table=(3, 5, 9)), shot(3), {"fouls": [], "turn": 1}),
    Situation("only the 9 is left", nine(on_table=(9,)), shot(9, down=(9,)), {"winner": 0}),
    Situation("the 9 off the table is put back", nine(), shot(1, off_table=(9,)),
              {"spot": (9,), "fouls": ["off the table"], "missing": ()}),
    Situation("no cushion", nine(), shot(1, cushioned=()), {"fouls": ["no cushion"], "in_hand": "anywhere"}),
    Situation("nothing down", nine(), shot(1), {"turn": 1, "in_hand": "", "fouls": []}),
    Situation("a third foul in a row loses", nine(fouls_in_row=(2, 0)), shot(2),
              {"winner": 1, "fouls": ["wrong ball", "three in a row"], "won": (0, 1)}),
    Situation("two fouls, then a legal stroke", nine(fouls_in_row=(2, 0)), shot(1),
              {"winner": None, "row": (0, 0)}),
    Situation("fouls of the other do not count", nine(fouls_in_row=(0, 2)), shot(2),
              {"winner": None, "row": (1, 2)}),
]  # fmt: skip

COMBINATION = [
    Situation("by way of another", CombinationMatch(), shot(1, down=((2, 0, (0, 1, 2)),)),
              {"turn": 0, "scored": (2,), "points": (1, 0), "rounds": 1}),
    Situation("by way of two others", CombinationMatch(), shot(1, down=((2, 0, (0, 1, 5, 2)),)),
              {"turn": 0, "scored": (2,)}),
    Situation("directly: put back", CombinationMatch(), shot(1, down=((1, 0, (0, 1)),)),
              {"turn": 1, "scored": (), "spot": (1,), "missing": (), "points": (0, 0)}),
    Situation("directly and by way of another: both count", CombinationMatch(),
              shot(1, down=((1, 0, (0, 1)), (2, 0, (0, 1, 2)))),
              {"turn": 0, "scored": (1, 2), "points": (2, 0), "rounds": 1}),
    Situation("with a scratch: put back", CombinationMatch(),
              shot(1, down=((2, 0, (0, 1, 2)),), cue_pocketed=True),
              {"turn": 1, "spot": (2,), "in_hand": "anywhere", "points": (0, 0)}),
    Situation("a single last ball directly", CombinationMatch(on_table=(7,), points=(7, 7)),
              shot(7, down=((7, 0, (0, 7)),)), {"winner": 0, "points": (8, 7)}),
    Situation("as many each: who potted the last", CombinationMatch(on_table=(7,), points=(7, 6), turn=1),
              shot(7, down=((7, 0, (0, 7)),)), {"winner": 1, "points": (7, 7)}),
    Situation("the one with more wins", CombinationMatch(on_table=(7,), points=(9, 5), turn=1),
              shot(7, down=((7, 0, (0, 7)),)), {"winner": 0}),
    Situation("the last two in one stroke", CombinationMatch(on_table=(1, 2), points=(6, 7)),
              shot(1, down=((1, 0, (0, 1)), (2, 0, (0, 1, 2)))), {"winner": 0, "points": (8, 7)}),
    Situation("nothing down", CombinationMatch(), shot(1), {"turn": 1, "fouls": [], "opening": False}),
    Situation("no cushion", CombinationMatch(), shot(1, cushioned=()), {"turn": 1, "fouls": ["no cushion"]}),
    Situation("off the table: put back", CombinationMatch(), shot(1, off_table=(4,)),
              {"spot": (4,), "missing": (), "fouls": ["off the table"]}),
]  # fmt: skip

PRACTICE = [
    Situation("any ball in any order", Practice(), shot(12, down=(12,)),
              {"turn": 0, "potted": 1, "run": 1, "strokes": 1}),
    Situation("a miss ends the run", Practice(run=4, potted=9), shot(1), {"run": 0, "potted": 9}),
    Situation("the cue ball down is in hand", Practice(), shot(1, down=(1,), cue_pocketed=True),
              {"in_hand": "anywhere", "run": 0, "potted": 1, "turn": 0}),
    Situation("no contact is no foul", Practice(), shot(), {"fouls": [], "in_hand": ""}),
    Situation("the last ball: racked again", Practice(on_table=(3,)), shot(3, down=(3,)),
              {"rack": True, "opening": True, "winner": None, "on_table": tuple(range(1, 16))}),
    Situation("the last ball of a set-up: over", Practice(on_table=(3,), rack=""), shot(3, down=(3,)),
              {"rack": False, "winner": 0}),
]  # fmt: skip

ALL = BREAKS + EIGHT_BALL + THE_EIGHT + NINE_BALL + COMBINATION + PRACTICE


@pytest.mark.parametrize("situation", ALL, ids=lambda s: f"{s.game.__class__.__name__}: {s.name}")
def test_situation(situation):
    check_situation(situation)


def test_there_are_enough_and_all_differ():
    assert len(ALL) >= 60
    assert len({(type(s.game), s.name, s.game.opening) for s in ALL}) == len(ALL)


@pytest.mark.parametrize("situation", ALL, ids=lambda s: f"{s.game.__class__.__name__}: {s.name}")
def test_every_verdict_has_words_and_can_be_kept(situation):
    check_verdict(situation)


CHOICES = [
    ("accept", EightBall(), shot(1, cushioned=(1,)), {"turn": 1, "opening": False, "in_hand": ""}),
    ("break", EightBall(), shot(1, cushioned=(1,)), {"turn": 1, "opening": True, "breaker": 1}),
    ("other breaks", EightBall(), shot(1, cushioned=(1,)), {"turn": 0, "opening": True, "breaker": 0}),
    ("in hand", EightBall(), shot(1, cushioned=FOUR, off_table=(4,)),
     {"turn": 1, "in_hand": "behind the line"}),
    ("spot the eight", EightBall(), shot(1, down=(8, 3)), {"turn": 0, "in_hand": ""}),
    ("spot the eight", EightBall(), shot(1, down=(8,), cue_pocketed=True),
     {"turn": 1, "in_hand": "behind the line"}),
    ("break", EightBall(), shot(1, down=(8,)), {"turn": 0, "opening": True}),
    ("play", nine(push_out_next=True), shot(5), {"turn": 1}),
    ("pass back", nine(push_out_next=True), shot(5), {"turn": 0}),
]  # fmt: skip


@pytest.mark.parametrize(("name", "game", "stroke", "expected"), CHOICES)
def test_choices(name, game, stroke, expected):
    asked = game.judge(stroke, Call(push_out=isinstance(game, NineBall))).game
    with pytest.raises(ValueError, match="choose"):
        asked.judge(stroke)
    verdict = asked.choose(name)
    assert {field: getattr(verdict.game, field) for field in expected} == expected
    assert verdict.rack == verdict.game.opening
    assert verdict.spot == ((8,) if name == "spot the eight" else ())
    assert set(verdict.spot) <= set(verdict.game.on_table)


def test_a_break_that_is_not_legal_is_called_so():
    for cushioned, legal in ((FOUR, True), ((1, 2, 3), False), ((0, 1, 2, 3), False)):
        words = " ".join(EightBall().judge(shot(1, cushioned=cushioned), Call()).words)
        assert ("Not a legal break" in words) == (not legal)
        assert legal or "3 of 4 balls" in words


def test_what_may_not_be_chosen():
    with pytest.raises(ValueError, match="nothing to choose"):
        EightBall().choose("accept")
    asked = EightBall().judge(shot(1, cushioned=())).game
    with pytest.raises(ValueError, match="accept, break, other breaks"):
        asked.choose("push")
    with pytest.raises(ValueError, match="push_out"):
        nine().judge(shot(1), Call(push_out=True))


@pytest.mark.parametrize("game", [EightBall(), NineBall(), CombinationMatch()])
def test_the_next_rack_is_broken_by_the_other_and_keeps_the_score(game):
    game = msgspec.structs.replace(game, won=(2, 1), players=("Anna", "Ben"), winner=0)
    verdict = game.next_rack()
    assert verdict.rack and verdict.game.turn == 1 and verdict.game.won == (2, 1)
    assert verdict.game.shooter == "Ben" and not verdict.game.over and verdict.game.opening
    assert verdict.game.next_rack().game.turn == 0


def test_what_needs_a_call():
    assert not EightBall().needs_call() and eight().needs_call()
    assert not eight(calling="none").needs_call()
    assert not grouped(calling="eight").needs_call() and grouped(LATE, calling="eight").needs_call()
    assert nine(push_out_next=True).may_push_out() and not nine().may_push_out()


def test_balls_in_words():
    assert eight().judge(shot(8)).words[0].endswith("not the 1 to 7 or the 9 to 15.")
    assert "the 1 to 7" in grouped().judge(shot(9)).words[0]
    assert "the 9 or the 12" in grouped((9, 12, 8, 1), turn=1).judge(shot(1)).words[0]


def test_nine_ball_warns_at_two_fouls_and_ends_at_three():
    """A foul counts one, for who made it; a legal stroke takes them all back (2.8)."""
    game, miss, legal = nine(), shot(), shot(1)
    for count in (1, 2, 3):
        verdict = game.judge(miss)
        assert verdict.game.fouls_in_row == (count, 0)
        assert any("two fouls" in words for words in verdict.words) == (count == 2)
        assert (verdict.game.winner == 1) == (count == 3)
        cleared = msgspec.structs.replace(game, turn=0).judge(legal)
        assert cleared.game.fouls_in_row == (0, 0)
        game = msgspec.structs.replace(verdict.game, turn=0, in_hand="")
