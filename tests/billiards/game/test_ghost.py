"""The ghost against written cases: who has the rack after a stroke, and what a count of racks is worth."""

import math

import numpy as np
import pytest

from game.billiards.game.frame import new_frame
from game.billiards.game.games.ghost import BALLS, Ghost, new_ghost
from game.billiards.game.rating import rating_of
from game.billiards.game.rules import Call, Pocketing, ShotSummary
from game.billiards.table.rack import BALL_RADIUS, FOOT_SPOT, ten_ball_rack
from game.billiards.table.table import Table


def shot(
    *down: int, first: int = 1, pocket: int = 0, scratch: bool = False, cushioned=(1, 2, 3, 4)
) -> ShotSummary:
    """A stroke that pots these balls, one cushion contact beside."""
    return ShotSummary(
        first=(first,) if first else (), pocketed=tuple(Pocketing(ball, pocket) for ball in down),
        cue_pocketed=scratch, cushioned=tuple(cushioned),
    )  # fmt: skip


def after_break(kind: str, *left: int, group: str = "") -> Ghost:
    """A rack after the break with these balls on the table."""
    from msgspec.structs import replace

    state = new_ghost(kind)  # type: ignore[arg-type]
    return replace(state, opening=False, in_hand="anywhere", on_table=left, group=group)


class TestBreak:
    @pytest.mark.parametrize("kind", BALLS)
    @pytest.mark.parametrize(
        "played", [shot(), shot(2, 3), shot(2, scratch=True), shot(cushioned=()), shot(first=0)]
    )
    def test_whatever_it_brings_the_cue_ball_is_in_hand_and_nobody_has_won(self, kind, played):
        verdict = new_ghost(kind).judge(played)
        game = verdict.game
        assert game.in_hand == "anywhere" and not game.opening and not game.over and game.won == (0, 0)
        assert set(game.on_table) == set(BALLS[kind]) - set(played.balls_down)
        assert game.turn == 0 and "ghost wins" in verdict.words[-1]

    def test_the_9_wins_without_a_foul_and_is_put_back_with_one(self):
        assert new_ghost("nine-ball").judge(shot(9)).game.winner == 0
        fouled = new_ghost("nine-ball").judge(shot(9, scratch=True))
        assert fouled.game.winner is None and fouled.spot == (9,) and 9 in fouled.game.on_table

    @pytest.mark.parametrize(("kind", "last"), [("ten-ball", 10), ("eight-ball", 8)])
    def test_the_10_and_the_8_are_put_back(self, kind, last):
        verdict = new_ghost(kind).judge(shot(last, 3))
        assert verdict.spot == (last,) and last in verdict.game.on_table and 3 not in verdict.game.on_table
        assert not verdict.game.over


class TestNineBall:
    def test_one_plays_on_from_ball_to_ball_and_wins_with_the_9(self):
        game = after_break("nine-ball", 4, 7, 9)
        assert game.legal_first() == (4,)
        game = game.judge(shot(4, first=4)).game
        assert game.on_table == (7, 9) and game.in_hand == "" and not game.over
        game = game.judge(shot(7, first=7)).game
        verdict = game.judge(shot(9, first=9))
        assert verdict.game.winner == 0 and verdict.game.won == (1, 0) and verdict.scored == (9,)

    def test_a_combination_on_the_9_wins(self):
        assert after_break("nine-ball", 2, 5, 9).judge(shot(9, first=2)).game.winner == 0

    @pytest.mark.parametrize(
        ("played", "why"),
        [(shot(first=4), "Nothing went down."), (shot(4, first=4, scratch=True), "The cue ball went down."),
         (shot(7, first=7), "The 7 was hit first, not the 4."),
         (shot(first=0), "The cue ball touched no ball."),
         (shot(first=4, cushioned=()), "After the contact"), (shot(9, first=7), "The 7 was hit first"),
         (shot(9, first=4, scratch=True), "The cue ball went down.")],
    )  # fmt: skip
    def test_one_miss_or_foul_and_the_ghost_has_it(self, played, why):
        verdict = after_break("nine-ball", 4, 7, 9).judge(played)
        assert verdict.game.winner == 1 and verdict.game.won == (0, 1) and verdict.scored == ()
        assert verdict.words[0].startswith(why) and verdict.words[-1] == "The ghost wins the rack."


class TestTenBall:
    def test_ball_and_pocket_are_called_from_the_break_on(self):
        assert not new_ghost("ten-ball").needs_call()
        game = after_break("ten-ball", 3, 6, 10)
        assert game.needs_call()
        assert not game.judge(shot(3, first=3, pocket=2), Call(3, 2)).game.over
        for call in (Call(), Call(3), Call(3, 1), Call(6, 2)):
            assert game.judge(shot(3, first=3, pocket=2), call).game.winner == 1

    def test_the_10_wins_called_and_comes_back_otherwise(self):
        game = after_break("ten-ball", 3, 10)
        assert game.judge(shot(10, first=3, pocket=2), Call(10, 2)).game.winner == 0
        other = game.judge(shot(3, 10, first=3, pocket=2), Call(3, 2))
        assert not other.game.over and other.spot == (10,) and other.game.on_table == (10,)


class TestEightBall:
    def test_the_group_that_falls_first_is_ones_own(self):
        game = after_break("eight-ball", 2, 8, 11, 12)
        verdict = game.judge(shot(11, first=2))
        assert verdict.game.group == "stripes" and verdict.game.legal_first() == (12,)
        assert verdict.game.judge(shot(2, first=12)).game.winner == 1
        assert verdict.game.judge(shot(12, first=2)).game.winner == 1

    def test_the_8_is_for_the_end(self):
        assert after_break("eight-ball", 2, 8, 12, group="solids").judge(shot(8, first=2)).game.winner == 1
        assert after_break("eight-ball", 2, 8, 12).judge(shot(8, first=2)).game.winner == 1
        cleared = after_break("eight-ball", 8, 12, group="solids")
        assert cleared.legal_first() == cleared.targets() == (8,)
        assert cleared.judge(shot(8, first=8)).game.winner == 0


class TestSet:
    def test_ten_racks_and_the_player_breaks_each(self):
        game = new_ghost("nine-ball", "Ada")
        for rack in range(10):
            assert not game.set_over and game.opening and game.in_hand == "behind the line" and game.final
            lost = game.judge(shot()).game.judge(shot(first=1) if rack % 3 else shot(9, first=1))
            assert lost.game.over
            game = lost.game
            verdict = game.next_rack()
            assert verdict.rack and verdict.game.won == game.won and verdict.game.turn == 0
            if rack < 9:
                game = verdict.game
        assert game.set_over and game.won == (4, 6) and game.players == ("Ada", "Ghost")

    @pytest.mark.parametrize("kind", BALLS)
    def test_it_is_racked_with_its_own_balls(self, kind):
        frame = new_frame(new_ghost(kind), seed=5)
        assert frame.layout.numbers == (0, *BALLS[kind]) and frame.cue_ball is not None

    def test_the_ten_ball_rack_is_a_triangle_round_the_10(self):
        table = Table.pool()
        for seed in (None, 1, 2):
            places = ten_ball_rack(table, seed=seed)
            assert places.shape == (11, 2)
            assert places[1] == pytest.approx((0.5 * table.width, FOOT_SPOT * table.length))
            apart = np.linalg.norm(places[1:, None] - places[None, 1:], axis=2)[~np.eye(10, dtype=bool)]
            assert apart.min() == pytest.approx(2.0 * BALL_RADIUS, abs=1e-12)
            assert np.sum(np.linalg.norm(places[1:] - places[10], axis=1) < 2.01 * BALL_RADIUS) == 7


class TestRating:
    def test_a_hundred_points_double_the_odds(self):
        assert rating_of(5, 5).points == 0.0
        for won, lost in ((3, 7), (10, 0), (0, 10), (63, 37)):
            odds = 2.0 ** (rating_of(won, lost).points / 100.0)
            assert odds == pytest.approx((won + 0.5) / (lost + 0.5))
            assert rating_of(won, lost).points == pytest.approx(-rating_of(lost, won).points)
        assert rating_of(10, 0).points == pytest.approx(439.2, abs=0.1)

    def test_its_error_is_that_of_many_draws(self):
        draws = np.random.default_rng(4).binomial(100, 0.4, 4000)
        points = [rating_of(int(won), 100 - int(won)).points for won in draws]
        assert np.std(points) == pytest.approx(rating_of(40, 60).error, rel=0.05)
        assert np.mean(points) == pytest.approx(100.0 * math.log2(2.0 / 3.0), abs=2.0)

    def test_less_than_nothing_is_refused(self):
        with pytest.raises(ValueError, match="-1 won"):
            rating_of(-1, 3)
