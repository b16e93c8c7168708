"""The newcomers' cup: whom one meets, how likely it is won, and that it is over within half an hour."""

from __future__ import annotations

import pytest

from game.billiards.career.career import CupResult, Player, strength_of
from game.billiards.career.handicap import race_chance
from game.billiards.career.matches import (
    beginners_strength,
    cup_match,
    fair_head_start,
    is_newcomer,
    length_of,
    new_cup,
    opponents_at,
)
from game.billiards.game.register import REGISTER
from game.billiards.game.strengths import chance_of
from tests.scenes.shared.newcomers import WHEN, cup_s

HALF_AN_HOUR_S = 1800.0


def chance_of_cup(game: str, newcomers: bool, points: float) -> float:
    """Chance that a person of so many points wins a cup, all opponents met being the strongest in it."""
    player = new_cup(Player("Mia"), game, 1, newcomers)
    needed = length_of(REGISTER[player.cup.game], newcomers).needed
    field = sorted(strength_of(name, player.cup.game) for name in player.cup.knockout.field if name != "Mia")
    rounds = len(player.cup.knockout.rounds)
    chance = 1.0
    for other in field[-rounds:]:
        chance *= race_chance(chance_of(points - other), needed, needed)
    return chance


@pytest.mark.parametrize("game", REGISTER)
def test_opponents_are_of_the_lower_half_and_matches_short(game):
    player = new_cup(Player("Mia"), game, 1, newcomers=True)
    cup = player.cup
    ladder = [one.name for one in opponents_at(cup.game)]
    others = [name for name in cup.knockout.field if name != "Mia"]
    assert len(others) == 3 and set(others) <= set(ladder[: len(ladder) // 2])
    assert REGISTER[cup.game].family == REGISTER[game].family
    assert length_of(REGISTER[cup.game], short=True).needed == 1
    assert cup_match(player).cup and cup.knockout.round_name == "Semi-final"
    assert abs(fair_head_start(player, others[0], cup.game, short=True)) < 3


def test_it_is_won_far_more_often_than_the_tournament_of_eight():
    weakest, _, third = (strength_of(one.name, "eight-ball") for one in opponents_at("eight-ball")[:3])
    assert weakest == beginners_strength("eight-ball")
    assert chance_of_cup("eight-ball", True, third) > 0.25, "the strongest there is met as an equal"
    assert chance_of_cup("eight-ball", False, third) < 0.02
    of_eight = chance_of_cup("eight-ball", False, weakest)
    assert chance_of_cup("eight-ball", True, weakest) > 0.05 > 1e6 * of_eight


def test_one_is_a_newcomer_until_a_cup_is_won():
    lost = Player("Mia", cups=(CupResult("eight-ball", WHEN, 2, newcomers=True),))
    won = Player("Mia", cups=(CupResult("eight-ball", WHEN, 3, newcomers=True),))
    assert is_newcomer(Player("Mia")) and is_newcomer(lost) and not is_newcomer(won)


@pytest.mark.parametrize("game", ["eight-ball", "three-cushion"])
def test_it_is_over_within_half_an_hour(game):
    """A club player's hand in the person's place, who looks at the table for a while before each stroke."""
    cups = [cup_s(game, "club", seed) for seed in (1, 2, 3)]
    assert all(60.0 < took < HALF_AN_HOUR_S for took, _ in cups)
    assert any(won for _, won in cups) or game != "eight-ball", (
        "cups that were lost at once take half as long"
    )
