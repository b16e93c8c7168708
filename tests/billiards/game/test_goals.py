"""Goals of trick shots as tables: what was done, and what is missing."""

from __future__ import annotations

import msgspec
import pytest

from game.billiards.game.games import Drill
from game.billiards.game.goals import Goal, Pot, Zone, described, missed
from game.billiards.game.rules import Pocketing, ShotSummary
from game.billiards.table.table import POCKET_NAMES

BANK = Pocketing(1, 3, (0, 1), cushions=1)
COMBINATION = Pocketing(2, 0, (0, 1, 2))
CAROM = (("cushion", 0), ("ball", 1), ("cushion", 2), ("cushion", 1), ("ball", 2))

CASES = [
    (Goal(pots=(Pot(1),)), ShotSummary((1,), (BANK,)), ""),
    (Goal(pots=(Pot(1),)), ShotSummary((1,)), "1 did not go down"),
    (Goal(pots=(Pot(1, 3),)), ShotSummary((1,), (BANK,)), ""),
    (Goal(pots=(Pot(1, 2),)), ShotSummary((1,), (BANK,)), "another pocket"),
    (Goal(pots=(Pot(1, cushions=1),)), ShotSummary((1,), (BANK,)), ""),
    (Goal(pots=(Pot(1, cushions=2),)), ShotSummary((1,), (BANK,)), "1 of 2 cushions"),
    (Goal(pots=(Pot(2, by_way_of=1),)), ShotSummary((1,), (COMBINATION,)), ""),
    (Goal(pots=(Pot(2, by_way_of=2),)), ShotSummary((1,), (COMBINATION,)), "in between"),
    (Goal(pots=(Pot(1), Pot(2))), ShotSummary((1,), (COMBINATION,)), "1 did not"),
    (Goal(down=2), ShotSummary((1,), (BANK, COMBINATION)), ""),
    (Goal(down=3), ShotSummary((1,), (BANK, COMBINATION)), "2 of 3 balls"),
    (Goal(pots=(Pot(1),)), ShotSummary((1,), (BANK,), cue_pocketed=True), "cue ball went down"),
    (Goal(scratch=True), ShotSummary((1,), cue_pocketed=True), ""),
    (Goal(scratch=True), ShotSummary((1,)), "did not go down"),
    (Goal(cue_touches=(1, 2)), ShotSummary((1,), cue_path=CAROM), ""),
    (Goal(cue_touches=(2, 1)), ShotSummary((1,), cue_path=CAROM), "did not touch the 1"),
    (Goal(cue_touches=(3,)), ShotSummary((1,), cue_path=CAROM), "did not touch the 3"),
    (Goal(cue_touches=(1, 2), cushions_between=3), ShotSummary((1,), cue_path=CAROM), ""),
    (Goal(cue_touches=(1, 2), cushions_between=4), ShotSummary((1,), cue_path=CAROM), "3 of 4 cushions"),
    (Goal(cushions_first=1), ShotSummary((1,), cue_path=CAROM), ""),
    (Goal(cushions_first=2), ShotSummary((1,), cue_path=CAROM), "1 of 2 cushions before"),
    (Goal(cushions_first=1), ShotSummary((), cue_path=CAROM[:1]), "cushions before a ball"),
    (Goal(direct=True), ShotSummary((1,), cue_path=CAROM[1:]), ""),
    (Goal(direct=True), ShotSummary((1,), cue_path=CAROM), "a cushion before any ball"),
    (Goal(untouched=(5,)), ShotSummary((1,), touched=(1,)), ""),
    (Goal(untouched=(5,)), ShotSummary((1,), touched=(1, 5)), "5 was touched"),
    (Goal(zones=(Zone(0, 0.5, 0.5, 0.1),)), ShotSummary(rest=((0, 0.5, 0.6),)), ""),
    (Goal(zones=(Zone(0, 0.5, 0.5, 0.1),)), ShotSummary(rest=((0, 0.5, 0.8),)), "20 cm outside"),
    (Goal(zones=(Zone(3, 0.5, 0.5, 0.1),)), ShotSummary(rest=((0, 0.5, 0.5),)), "3 is not on the table"),
]


@pytest.mark.parametrize(("goal", "shot", "lacking"), CASES)
def test_what_is_missing(goal, shot, lacking):
    found = missed(goal, shot)
    if lacking:
        assert len(found) == 1 and lacking in found[0]
    else:
        assert found == ()


@pytest.mark.parametrize("goal", [case[0] for case in CASES])
def test_goals_are_described_and_kept(goal):
    lines = described(goal, POCKET_NAMES)
    assert lines and all(line[0].isupper() and line.endswith(".") for line in lines)
    assert msgspec.json.decode(msgspec.json.encode(goal), type=Goal) == goal


def test_in_words():
    goal = Goal(pots=(Pot(1, 3, by_way_of=1, cushions=2),), down=1, untouched=(4, 5))
    assert described(goal, POCKET_NAMES) == (
        "Pot the 1, middle right pocket, by way of one other ball, off two cushions.",
        "One ball goes down.",
        "Nothing touches the 4 or the 5.",
    )
    assert described(Goal(pots=(Pot(1),), cushions_first=1)) == (
        "Pot the 1.", "The cue ball touches one cushion before any ball.",
    )  # fmt: skip


def test_a_direct_way_in_words():
    assert described(Goal(cue_touches=(1, 2), direct=True)) == (
        "The cue ball touches no cushion, then the 1, then the 2.",
    )
    assert described(Goal(direct=True)) == ("The cue ball touches no cushion before any ball.",)


def test_stars_come_in_their_order():
    game = Drill(goal=Goal(pots=(Pot(1),)), more=(Goal(pots=(Pot(1, 3),)), Goal(down=2)))
    assert game.stars(ShotSummary((1,), (COMBINATION,))) == 0
    assert game.stars(ShotSummary((1,), (Pocketing(1, 0), COMBINATION))) == 1
    assert game.stars(ShotSummary((1,), (BANK,))) == 2
    assert game.stars(ShotSummary((1,), (BANK, COMBINATION))) == 3


def test_wrong_goals_are_refused():
    for text in (b'{"pots": [{"ball": 22}]}', b'{"pots": [{"ball": 1, "pocket": 6}]}', b'{"aim": 1}'):
        with pytest.raises(msgspec.ValidationError):
            msgspec.json.decode(text, type=Goal)
