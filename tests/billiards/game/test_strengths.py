"""Ratings on FargoRate's scale: closed forms of two players, and of players with known results."""

import math

import pytest

from game.billiards.game.rating import rating_of
from game.billiards.game.strengths import Series, bradley_terry, chance_of, rating_against


def test_a_hundred_points_are_two_to_one():
    assert chance_of(100.0) == pytest.approx(2.0 / 3.0, rel=1e-12)
    assert chance_of(-200.0) == pytest.approx(1.0 / 5.0, rel=1e-12)
    assert chance_of(130.0) + chance_of(-130.0) == pytest.approx(1.0, rel=1e-12)


@pytest.mark.parametrize(("won", "lost"), [(7, 3), (0, 5), (12, 0), (4, 4)])
def test_against_one_opponent_it_is_the_closed_form(won, lost):
    found = rating_against([Series(520.0, won, lost)])
    known = rating_of(won, lost)
    assert found.points == pytest.approx(520.0 + known.points, abs=1e-6)
    assert found.error == pytest.approx(known.error, rel=1e-6)


def test_opponents_that_stand_apart_weigh_by_what_was_to_be_expected():
    # equal results against 400 and 600: by symmetry in the middle
    found = rating_against([Series(400.0, 5, 5), Series(600.0, 5, 5)])
    assert found.points == pytest.approx(500.0, abs=1e-6)
    # one win expected of each three, and had: exactly 100 points above
    assert rating_against([Series(400.0, 200, 100)]).points == pytest.approx(
        400.0 + 100.0 * math.log2(200.5 / 100.5), abs=1e-6
    )
    assert rating_against([]) is None
    with pytest.raises(ValueError, match="fewer games"):
        rating_against([Series(400.0, -1, 2)])


def test_two_players_have_the_closed_form_round_the_mean():
    found = bradley_terry({("a", "b"): 9, ("b", "a"): 2}, 500.0)
    apart = 100.0 * math.log2(9.5 / 2.5)
    assert found["a"].points == pytest.approx(500.0 + 0.5 * apart, abs=1e-6)
    assert found["b"].points == pytest.approx(500.0 - 0.5 * apart, abs=1e-6)
    # the error of a difference of d = 2 r is twice that of r
    assert 2.0 * found["a"].error == pytest.approx(rating_of(9, 2).error, rel=1e-6)


def test_a_chain_of_players_adds_its_steps():
    # where each pair is met by one way only, the differences are those of the pairs (a tree has no cycles)
    won = {("a", "b"): 6, ("b", "a"): 3, ("c", "b"): 8, ("b", "c"): 1}
    found = bradley_terry(won, 500.0)
    assert found["a"].points - found["b"].points == pytest.approx(rating_of(6, 3).points, abs=1e-6)
    assert found["c"].points - found["b"].points == pytest.approx(rating_of(8, 1).points, abs=1e-6)
    assert sum(one.points for one in found.values()) == pytest.approx(1500.0, abs=1e-6)


def test_strengths_are_stationary_with_cycles():
    won = {("a", "b"): 6, ("b", "a"): 4, ("b", "c"): 7, ("c", "b"): 3, ("c", "a"): 2, ("a", "c"): 8}
    found = bradley_terry(won, 0.0)
    for one in "abc":
        expected = sum(
            (won[one, other] + won[other, one] + 1.0) * chance_of(found[one].points - found[other].points)
            for other in "abc" if other != one
        )  # fmt: skip
        had = sum(won[one, other] + 0.5 for other in "abc" if other != one)
        assert expected == pytest.approx(had, abs=1e-6)


def test_players_that_never_met_cannot_be_compared():
    with pytest.raises(ValueError, match="has met none"):
        bradley_terry({("a", "b"): 1, ("c", "d"): 1}, 500.0)
