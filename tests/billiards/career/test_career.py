"""Careers: chances of races in closed form, the draw, tournaments to the cup, ratings and records."""

from itertools import product
from math import comb

import pytest

from game.billiards.career.bracket import Knockout, draw, play_on, rounds_of
from game.billiards.career.career import (
    Career,
    Match,
    Player,
    Result,
    rating_history,
    rating_of,
    records_of,
    strength_of,
)
from game.billiards.career.handicap import fair_start, needed_of_best, point_chance, race_chance
from game.billiards.career.matches import (
    beginners_strength,
    cup_match,
    fair_head_start,
    length_of,
    new_cup,
    next_opponent,
    opponents_at,
    own_strength,
    with_result,
)
from game.billiards.game.rating import rating_of as against_ghost
from game.billiards.game.register import REGISTER

WHEN = "2026-01-02T03:04:05"


def result(opponent="tom", won=3, lost=1, game="eight-ball", start=0, cup=False, highest=0):
    return Result(Match(game, opponent, start, cup), WHEN, won, lost, won > lost, highest)


# -- races -------------------------------------------------------------------------------------------


def by_counting(chance, mine, theirs):
    """The same by all ways in which so many games can go."""
    total, games = 0.0, mine + theirs - 1
    for outcome in product((0, 1), repeat=games):
        if sum(outcome) >= mine:
            total += chance ** sum(outcome) * (1.0 - chance) ** (games - sum(outcome))
    return total


@pytest.mark.parametrize(("chance", "mine", "theirs"), [(0.5, 3, 3), (0.7, 2, 4), (0.31, 5, 2), (0.9, 1, 1)])
def test_the_chance_of_a_race_is_that_of_all_its_ways(chance, mine, theirs):
    assert race_chance(chance, mine, theirs) == pytest.approx(by_counting(chance, mine, theirs), rel=1e-12)


def test_written_races():
    assert race_chance(2.0 / 3.0, 2, 2) == pytest.approx(20.0 / 27.0)  # best of three at 2:1
    assert race_chance(0.5, 4, 2) == pytest.approx(sum(comb(5, k) for k in (4, 5)) / 32.0)
    assert race_chance(1.0, 3, 1) == 1.0
    assert race_chance(0.0, 3, 1) == 0.0
    assert [needed_of_best(n) for n in (1, 3, 9)] == [1, 2, 5]
    for wrong in ((1.2, 1, 1), (0.5, 0, 1)):
        with pytest.raises(ValueError, match=r"chance|race"):
            race_chance(*wrong)
    with pytest.raises(ValueError, match="odd"):
        needed_of_best(4)


def test_a_fair_start_is_given_to_the_weaker():
    assert fair_start(0.5, 5) == 0
    assert fair_start(1.0 / 3.0, 5) == -fair_start(2.0 / 3.0, 5) > 0
    for chance in (0.2, 0.35, 0.6):
        start = fair_start(chance, 5)
        fair = abs(race_chance(chance, 5 - max(start, 0), 5 - max(-start, 0)) - 0.5)
        for other in range(-4, 5):
            there = race_chance(chance, 5 - max(other, 0), 5 - max(-other, 0))
            assert fair <= abs(there - 0.5) + 1e-12


def test_the_chance_of_a_point_makes_that_of_the_game():
    assert point_chance(0.5, 10) == pytest.approx(0.5)
    assert race_chance(point_chance(0.8, 15), 15, 15) == pytest.approx(0.8)


# -- the draw ----------------------------------------------------------------------------------------

FIELD = {name: 800.0 - 100.0 * k for k, name in enumerate("abcdefgh")}


def test_the_draw_keeps_the_strongest_apart():
    cup = draw(FIELD)
    assert [cup.pair(k) for k in range(4)] == [("a", "h"), ("d", "e"), ("b", "g"), ("c", "f")]
    for pair in ("ah", "de", "bg", "cf"):
        cup = cup.with_winner(min(pair))
    assert [cup.pair(4), cup.pair(5)] == [("a", "d"), ("b", "c")]
    cup = cup.with_winner("a").with_winner("b")
    assert (cup.next_pair, cup.round_name) == (("a", "b"), "Final")
    cup = cup.with_winner("b")
    assert (cup.champion, cup.next_pair) == ("b", None)
    assert [cup.reached(name) for name in "abch"] == [2, 3, 1, 0]
    assert cup.is_out("a")
    assert not cup.is_out("b")
    assert [name for name, _ in rounds_of(cup)] == ["Quarter-final", "Semi-final", "Final"]
    with pytest.raises(ValueError, match="cup is won"):
        cup.with_winner("b")


def test_a_draw_wants_eight_and_a_winner_one_of_the_pair():
    with pytest.raises(ValueError, match="expected 8"):
        draw({"a": 1.0})
    with pytest.raises(ValueError, match="does not play"):
        draw(FIELD).with_winner("b")
    with pytest.raises(ValueError, match="not known"):
        Knockout(tuple("abcdefgh")).pair(4)


def test_others_play_until_the_person_is_at_turn():
    cup = play_on(draw(FIELD), "c", lambda a, b, match: a)
    assert (cup.winners, cup.next_pair) == (("a", "d", "b"), ("c", "f"))


@pytest.mark.parametrize("game", REGISTER)
def test_a_tournament_is_played_from_the_first_card_to_the_cup(game):
    player = new_cup(Player("Mia"), game, seed=7)
    assert len(set(player.cup.knockout.field)) == 8
    with pytest.raises(ValueError, match="goes on"):
        new_cup(player, game, 1)
    rounds = []
    while (match := cup_match(player)) is not None:
        rounds.append(player.cup.knockout.round_name)
        player = with_result(player.replace(pending=match), Result(match, WHEN, 3, 0, True))
    assert rounds == ["Quarter-final", "Semi-final", "Final"]
    assert player.cup is None
    assert [cup.reached for cup in player.cups] == [3]
    assert records_of(player).best_cup == 3
    assert records_of(player).victories == 3
    again = new_cup(Player("Mia"), game, seed=7)
    assert again.cup == new_cup(Player("Mia"), game, seed=7).cup


def test_a_lost_match_ends_the_tournament_with_another_champion():
    player = new_cup(Player("Mia"), "nine-ball", seed=3)
    match = cup_match(player)
    player = with_result(player, Result(match, WHEN, 1, 3, False))
    assert player.cup is None
    assert [cup.reached for cup in player.cups] == [0]


# -- ratings and records -----------------------------------------------------------------------------


def test_a_rating_against_one_opponent_is_the_closed_form():
    player = Player("Mia", (result(won=3, lost=1), result(won=2, lost=3)))
    known = against_ghost(5, 4)
    found = rating_of(player)
    assert found.points == pytest.approx(strength_of("tom", "eight-ball") + known.points, abs=1e-6)
    assert found.error == pytest.approx(known.error, rel=1e-6)
    assert len(rating_history(player)) == 2
    assert rating_history(player)[-1] == found
    assert rating_of(player, "snooker") is None
    assert rating_of(Player("Mia")) is None


def test_a_start_in_points_does_not_count_and_one_in_racks_does():
    assert rating_of(Player("Mia", (result(game="three-cushion", start=4, won=1, lost=0),))) is None
    assert rating_of(Player("Mia", (result(start=1),))) is not None


def test_records_are_the_highest_of_each_game():
    player = Player("Mia", (result(highest=4), result(highest=9), result(game="snooker", highest=31)))
    assert dict(records_of(player).highest) == {"eight-ball": 9, "snooker": 31}
    assert records_of(player).best_cup == -1


def test_the_next_opponent_is_the_weakest_that_is_not_beaten():
    ladder = opponents_at("eight-ball")
    strengths = [strength_of(one.name, "eight-ball") for one in ladder]
    assert strengths == sorted(strengths)
    player = Player("Mia")
    assert next_opponent(player, "eight-ball") == ladder[0]
    player = player.replace(results=(result(ladder[0].name), result(ladder[1].name, start=1)))
    assert next_opponent(player, "eight-ball") == ladder[1]


def test_the_head_start_is_fair_by_the_ratings():
    novice = Player("Mia")
    strongest = opponents_at("eight-ball")[-1].name
    assert (
        own_strength(novice, "eight-ball")
        == beginners_strength("eight-ball")
        == strength_of("tom", "eight-ball")
    )
    assert strength_of(strongest, "eight-ball") > beginners_strength("eight-ball")
    assert fair_head_start(novice, strongest, "eight-ball") > 0
    assert fair_head_start(novice, "tom", "eight-ball") <= 0
    assert fair_head_start(novice, "vera", "three-cushion") > 0
    for entry in REGISTER.values():
        assert length_of(entry).needed >= 1
        assert abs(fair_head_start(novice, "vera", entry.name)) < max(length_of(entry).needed, 10)


def test_players_have_names_of_their_own():
    career = Career().named("  Mia   Berg ").named("Jo")
    assert [player.name for player in career.players] == ["Mia Berg", "Jo"]
    assert career.player.name == "Jo"
    assert career.named("Mia Berg").current == 0
    changed = career.with_player(career.player.replace(results=(result(),)))
    assert [len(player.results) for player in changed.players] == [0, 1]
    with pytest.raises(ValueError, match="name is needed"):
        career.named("  ")
    with pytest.raises(ValueError, match="one name"):
        Career((Player("a"), Player("a"))).check()
