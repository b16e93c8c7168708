"""Ten-ball, paragraph by paragraph (WPA 9): what a stroke did, and what follows from it."""

import pytest

from game.billiards.game.games import TenBall
from game.billiards.game.rules import Call
from tests.billiards.game.situations import FOUR, Situation, check_situation, check_verdict, shot

CALL_1, CALL_10 = Call(1, 0), Call(10, 0)


def ten(**fields) -> TenBall:
    """A game of which the break is over."""
    return TenBall(**{"opening": False, "in_hand": "", **fields})


LATE = (9, 10)
SITUATIONS = [
    Situation("9.3: four to a cushion are a legal break", TenBall(), shot(1, cushioned=FOUR),
              {"turn": 1, "fouls": [], "push": True}),
    Situation("9.3: three are not", TenBall(), shot(1, cushioned=(1, 2, 3)),
              {"turn": 1, "fouls": ["break"], "in_hand": "anywhere"}),
    Situation("9.3: a ball down at the break needs no call", TenBall(), shot(1, down=(4,)),
              {"turn": 0, "scored": (4,), "missing": (4,), "push": True}),
    Situation("9.3: the 10 down at the break is put back, the breaker goes on", TenBall(),
              shot(1, down=(10,)), {"turn": 0, "winner": None, "spot": (10,), "missing": ()}),
    Situation("9.3: called or not", TenBall(), shot(1, down=(10,)),
              {"turn": 0, "winner": None, "spot": (10,)}, CALL_10),
    Situation("9.4: after a push-out the other chooses, what fell stays down", ten(push_out_next=True),
              shot(5, down=(5,), cushioned=()),
              {"turn": 1, "options": ["play", "pass back"], "missing": (5,), "fouls": [], "spot": ()},
              Call(push_out=True)),
    Situation("9.4: the 10 down at a push-out is put back", ten(push_out_next=True), shot(1, down=(10,)),
              {"turn": 1, "winner": None, "spot": (10,), "missing": ()}, Call(push_out=True)),
    Situation("9.5: the called ball into its pocket, others with it", ten(), shot(1, down=(1, 7)),
              {"turn": 0, "scored": (1, 7), "missing": (1, 7)}, CALL_1),
    Situation("9.5: any ball may be called, as long as the lowest is hit first", ten(),
              shot(1, down=((6, 3),)), {"turn": 0, "scored": (6,)}, Call(6, 3)),
    Situation("9.6: a safety ends the turn", ten(), shot(1), {"turn": 1, "options": []}, Call(safety=True)),
    Situation("9.6: a ball down with a safety: the other may hand the shot back", ten(), shot(1, down=(1,)),
              {"turn": 1, "options": ["play", "pass back"], "missing": (1,), "scored": ()},
              Call(safety=True)),
    Situation("9.7: the called ball into another pocket", ten(), shot(1, down=((1, 4),)),
              {"turn": 1, "options": ["play", "pass back"], "missing": (1,), "spot": ()}, CALL_1),
    Situation("9.7: another ball than the called one", ten(), shot(1, down=(3,)),
              {"turn": 1, "options": ["play", "pass back"], "missing": (3,)}, CALL_1),
    Situation("9.7: nothing called", ten(), shot(1, down=(1,)),
              {"turn": 1, "options": ["play", "pass back"]}),
    Situation("9.8: nothing down, the other plays from there", ten(), shot(1),
              {"turn": 1, "options": [], "in_hand": ""}, CALL_1),
    Situation("9.8: the called 10 wins at any time", ten(), shot(1, down=(10,)),
              {"winner": 0, "won": (1, 0), "spot": ()}, CALL_10),
    Situation("9.8: and as the last ball", ten(on_table=(10,)), shot(10, down=(10,)), {"winner": 0}, CALL_10),
    Situation("9.9: the 10 uncalled is put back, the called ball counts", ten(on_table=LATE),
              shot(9, down=((9, 0), (10, 2))), {"turn": 0, "winner": None, "spot": (10,), "scored": (9,)},
              Call(9, 0)),
    Situation("9.9: the called 10 in another pocket is put back, the other may hand back",
              ten(on_table=LATE), shot(9, down=((10, 2),)),
              {"turn": 1, "winner": None, "spot": (10,), "options": ["play", "pass back"]}, CALL_10),
    Situation("9.9: the 10 with a foul is put back", ten(), shot(1, down=(10,), cue_pocketed=True),
              {"turn": 1, "winner": None, "spot": (10,), "in_hand": "anywhere"}, CALL_10),
    Situation("9.9: the 10 off the table is put back", ten(), shot(1, off_table=(10,)),
              {"turn": 1, "spot": (10,), "fouls": ["off the table"], "missing": ()}, CALL_10),
    Situation("9.9: no other ball ever is", ten(), shot(1, off_table=(4,)),
              {"turn": 1, "spot": (), "missing": (4,), "fouls": ["off the table"]}, CALL_1),
    Situation("9.10: another ball than the lowest first", ten(), shot(2, down=(2,)),
              {"turn": 1, "fouls": ["wrong ball"], "in_hand": "anywhere", "missing": (2,)}, Call(2, 0)),
    Situation("9.10: no cushion after the contact", ten(), shot(1, cushioned=()),
              {"turn": 1, "fouls": ["no cushion"]}, CALL_1),
    Situation("9.11: the third foul in a row loses the rack", ten(fouls_in_row=(2, 0)), shot(2),
              {"winner": 1, "won": (0, 1), "fouls": ["wrong ball", "three in a row"]}, CALL_1),
]  # fmt: skip


@pytest.mark.parametrize("situation", SITUATIONS, ids=lambda one: one.name)
def test_what_follows_from_a_stroke(situation):
    check_situation(situation)
    check_verdict(situation)


@pytest.mark.parametrize(("name", "turn"), [("play", 1), ("pass back", 0)])
def test_9_7_who_is_handed_the_shot_back_plays_it(name, turn):
    asked = ten().judge(shot(1, down=(3,)), CALL_1).game
    state = asked.choose(name).game
    assert (state.turn, state.options, state.in_hand) == (turn, (), "")


def test_9_4_only_the_first_stroke_after_the_break_may_be_a_push_out():
    after = TenBall().judge(shot(1, down=(4,))).game
    assert after.may_push_out()
    assert not after.judge(shot(1), Call(safety=True)).game.may_push_out()
    with pytest.raises(ValueError, match="push-out"):
        ten().judge(shot(1), Call(push_out=True))


def test_the_break_needs_no_call_and_every_later_stroke_does():
    assert not TenBall().needs_call() and ten().needs_call()


def test_players_break_in_turns():
    won = ten().judge(shot(1, down=(10,)), CALL_10).game
    following = won.next_rack()
    assert following.rack and following.game.turn == 1 and following.game.won == (1, 0)
    assert isinstance(following.game, TenBall) and following.game.opening
