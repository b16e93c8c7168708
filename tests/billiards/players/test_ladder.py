"""The ladder: its players differ in style and in strength, and their ratings come from games."""

import numpy as np
import pytest

from game.billiards.game.frame import Frame
from game.billiards.game.games import EightBall
from game.billiards.game.rules import CUE_BALL
from game.billiards.players.graded import carom_players, pool_players, snooker_players
from game.billiards.players.ladder import BY_NAME, FAMILIES, LADDER, ladder_of
from game.billiards.players.ladder_ratings import MEAN, ladder_ratings, ratings_of
from game.billiards.players.opponents import decide
from game.billiards.players.taste import Hand
from game.billiards.players.weighing import noise_of
from game.billiards.search.strokes import Noise
from game.lab.ladder import Told, play_game, style_of
from game.lab.players import broken_table


def table(seed: int) -> Frame:
    """A rack of eight-ball after its break; the cue ball lies where the numbered ball of a seed was."""
    frame = broken_table(seed)
    layout, numbers = frame.layout, frame.layout.numbers
    taken = numbers[seed % len(numbers)] if numbers[seed % len(numbers)] != 8 else 1
    place = layout.place_of(taken) if taken in numbers else layout.place_of(numbers[0])
    left = layout.without(taken).with_ball(CUE_BALL, place)
    on_table = tuple(number for number in left.numbers if number != CUE_BALL)
    return frame.replace(game=EightBall(opening=False, in_hand="", on_table=on_table), layout=left)


@pytest.fixture(scope="module")
def styles():
    """What four players decide on the same tables."""
    frames = [table(seed) for seed in range(14)]
    found = {}
    for name in ("rocco", "greta", "ines", "kenji"):
        made = [decide(frame, pool_players()[name], seed, threads=1) for seed, frame in enumerate(frames)]
        found[name] = style_of([Told(name, one.kind, one.chance) for one in made])
    return found


def test_the_safety_player_plays_safe_most_often(styles):
    assert styles["greta"].safeties > styles["kenji"].safeties >= styles["ines"].safeties
    assert styles["greta"].safeties >= styles["ines"].safeties + 0.2


def test_the_gambler_banks_most_often(styles):
    assert styles["rocco"].banks >= 0.1
    assert styles["rocco"].banks > max(styles[name].banks for name in ("greta", "ines", "kenji"))


def test_the_potter_takes_surer_balls_than_the_position_player_thinks_his(styles):
    # of all pots there are the potter takes the surest: with the same table, and a steadier aim
    assert styles["ines"].chance > styles["rocco"].chance
    assert styles["ines"].safeties == 0.0 or styles["ines"].safeties < styles["greta"].safeties


def test_a_decision_tells_its_chance_and_the_safety_beside_it():
    made = decide(table(3), pool_players()["greta"], 5, threads=1)
    assert 0.0 <= made.chance <= 1.0
    assert made.kind in ("direct", "cut", "bank", "kick", "combination", "safety")
    assert np.isnan(made.safe) or 0.0 <= made.safe <= 1.0


@pytest.mark.parametrize(("better", "worse"), [("vera", "rocco"), ("kenji", "tom")])
def test_a_higher_player_beats_a_lower_one(better, worse):
    won = 0
    for seed in range(7):
        pair = (better, worse) if seed % 2 else (worse, better)
        won += play_game("carom", pair, seed).winner == better
    assert won >= 5


def test_the_champion_beats_the_beginner_at_pool():
    pairs = (("vera", "tom"), ("tom", "vera"))
    assert [play_game("billiards", pair, seed).winner for seed, pair in enumerate(pairs)] == ["vera"] * 2


def test_the_table_serves_all_three_games():
    assert len(LADDER) == 8 == len(BY_NAME)
    for family, players in zip(FAMILIES, (pool_players(), snooker_players(), carom_players()), strict=True):
        names = [player.name for player in ladder_of(family)]
        assert len(names) >= 6
        assert set(names) <= set(players)
        assert [players[name].title for name in names] == [BY_NAME[name].title for name in names]


def test_a_hand_is_divided_among_aim_speed_and_spin():
    usual = Noise()
    noise = noise_of(Hand(aim=2.0, speed=3.0, spin=0.5), 1.5)
    assert noise == Noise(0.75 * usual.tip, 0.75 * usual.elevation, 3.0 * usual.azimuth, 4.5 * usual.speed)


def test_what_a_player_believes_of_its_hand_changes_no_stroke_of_it():
    rocco = pool_players()["rocco"]
    assert rocco.supposed.azimuth == pytest.approx(rocco.noise.azimuth / rocco.taste.confidence)


@pytest.mark.parametrize("family", ["", *FAMILIES])
def test_measured_ratings_rise_from_the_beginner_to_the_champion(family):
    ratings = ladder_ratings(family)
    names = [player.name for player in (ladder_of(family) if family else LADDER)]
    assert set(ratings) == set(names)
    assert sum(one.points for one in ratings.values()) / len(ratings) == pytest.approx(MEAN)
    assert ratings["vera"].points > ratings["kenji"].points > ratings["tom"].points
    assert min(ratings, key=lambda name: ratings[name].points) == "tom"
    assert all(10.0 < one.error < 200.0 for one in ratings.values())


def test_ratings_need_games():
    with pytest.raises(ValueError, match="family"):
        play_game("bowls", ("vera", "tom"), 1)
    assert ratings_of(()) == {}
