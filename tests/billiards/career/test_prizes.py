"""What a career unlocks: matches, ladders, breaks and cups, each for its own tables, and for good."""

import math

import pytest

from game.billiards.career.career import CupResult, Match, Player, Result
from game.billiards.career.matches import with_result
from game.billiards.career.prizes import PRIZES, locked, next_prize, progress, unlocked_of
from game.billiards.game.register import REGISTER
from game.billiards.shot.cloths import CLOTHS, faster
from game.billiards.table.table import Table

WHEN = "2026-01-02T03:04:05"
BY_NAME = {one.name: one for one in PRIZES}


def result(opponent="tom", game="eight-ball", victory=True, start=0, highest=0):
    return Result(Match(game, opponent, start), WHEN, 3, 1, victory, highest)


def names(*results, cups=()):
    return unlocked_of(Player("Mia", results, cups))


def test_without_a_person_or_a_match_all_is_locked():
    assert unlocked_of(None) == names() == names(result(victory=False)) == frozenset()
    assert next_prize(Player("Mia")) == PRIZES[0]


def test_each_prize_is_won_by_its_own_deed():
    assert names(result(start=3)) == {"blue cloth"}
    ladder = [result(name) for name in ("tom", "greta", "a", "b", "c")]
    assert "fast pool" not in names(*ladder[:1], ladder[0])  # the same one twice
    assert "fast pool" not in names(ladder[0], result("greta", start=1))
    assert "fast pool" not in names(*(result(one.match.opponent, "snooker") for one in ladder))
    assert names(*ladder[:2]) == {"blue cloth", "fast pool"}
    assert names(*ladder) == {"blue cloth", "fast pool", "tight pool"}
    assert names(result(game="six-red", victory=False, highest=20)) == {"fast snooker"}
    assert names(result(game="snooker", victory=False, highest=19)) == frozenset()
    assert names(result(game="straight-pool", victory=False, highest=99)) == frozenset()
    assert names(cups=[CupResult("carom", WHEN, 1)]) == frozenset()
    assert names(cups=[CupResult("carom", WHEN, 2)]) == {"olive cloth"}
    assert names(cups=[CupResult("carom", WHEN, 3)]) == {"olive cloth", "slate cloth"}


def test_what_was_won_is_kept_without_the_results():
    after = with_result(Player("Mia", pending=Match("eight-ball", "tom")), result())
    assert after.unlocked == ("blue cloth",)
    assert unlocked_of(after.replace(results=())) == {"blue cloth"}
    assert next_prize(after).name == "fast pool" and progress(after, BY_NAME["fast pool"]) == 1


def test_locks_are_those_of_the_table():
    assert ("felt", "blue") not in locked(None, "carom") and ("felt", "blue") in locked(None, "snooker")
    assert locked(None, "snooker")["table", "fast"].name == "fast snooker"
    beaten = Player("Mia", (result("tom"), result("greta")))
    assert ("table", "fast") not in locked(beaten, "billiards")
    assert ("table", "fast") in locked(beaten, "snooker")
    assert {one.families for one in PRIZES} <= {
        *((family,) for family in {entry.family for entry in REGISTER.values()}),
        ("billiards", "snooker"), ("billiards", "carom", "snooker"),
    }  # fmt: skip


def test_a_fast_cloth_is_faster_as_heating_makes_it():
    fast = faster(CLOTHS["club"])
    for name in ("sliding", "rolling", "spinning"):
        assert getattr(fast, name) == pytest.approx(getattr(CLOTHS["heated"], name))
    assert fast.cushion_restitution == CLOTHS["club"].cushion_restitution


def gap(table, corner):
    """The narrowest opening between two jaws of a pocket: a corner's, or the left middle's."""
    x, y = (0.0, 0.0) if corner else (0.0, 0.5 * table.length)
    near = sorted(table.jaws.tolist(), key=lambda jaw: math.dist(jaw[:2], (x, y)))[:2]
    return math.dist(near[0][:2], near[1][:2]) - near[0][2] - near[1][2]


@pytest.mark.parametrize("kind", [Table.pool, Table.snooker])
def test_tight_pockets_are_tighter_and_still_take_a_ball(kind):
    usual, tight = kind(), kind(tight=True)
    diameter = 0.05715 if kind == Table.pool else 0.0525
    for corner in (True, False):
        assert diameter < gap(tight, corner) < gap(usual, corner) - 0.002
    assert (tight.pockets == usual.pockets).all() and tight.width == usual.width
