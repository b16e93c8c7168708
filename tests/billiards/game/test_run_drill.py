"""Drills of many strokes, and drills in sets, against written cases."""

from itertools import pairwise

import numpy as np
import pytest
from msgspec.structs import replace

from game.billiards.game.arrangement import Stroke, arrange
from game.billiards.game.frame import Frame
from game.billiards.game.games.drill import Drill
from game.billiards.game.games.run_drill import RunDrill
from game.billiards.game.goals import Goal, Pot
from game.billiards.game.rules import Pocketing, ShotSummary
from game.billiards.game.table_lengths import table_lengths
from game.billiards.shot.physics import Physics
from game.billiards.shot.shot import make_shot
from game.billiards.simulation import simulate
from game.billiards.table.rack import BALL_MASS, BALL_RADIUS
from game.billiards.table.table import BED_LENGTH, BED_WIDTH, Table

PLACES = ((0, 0.3, 0.6), (1, 0.4, 1.0), (2, 0.6, 1.2), (3, 0.8, 1.4))


def drill(**more) -> RunDrill:
    return RunDrill(set_up=PLACES, on_table=(1, 2, 3), in_hand="anywhere", hand="anywhere", **more)


def shot(*down: int, first: int = 1, pocket: int = 0, scratch: bool = False, path=()) -> ShotSummary:
    return ShotSummary(
        (first,), tuple(Pocketing(ball, pocket) for ball in down), scratch, cue_path=tuple(path)
    )


class TestRun:
    def test_a_try_goes_on_while_balls_fall_and_ends_with_the_last(self):
        game = drill().judge(shot(2, first=2)).game
        assert (game.on_table, game.run, game.in_hand, game.attempts) == ((1, 3), 1, "", 0)
        game = game.judge(shot(1, 3)).game
        assert (game.attempts, game.potted, game.best, game.run) == (1, 3, 3, 0)
        assert game.on_table == (1, 2, 3) and game.in_hand == "anywhere"

    def test_a_miss_ends_it_and_all_balls_are_put_back(self):
        game = drill().judge(shot(2, first=2)).game
        verdict = game.judge(shot(first=1))
        assert verdict.words == ("Nothing went down.", "1 of 3.") and verdict.places == PLACES
        assert (verdict.game.attempts, verdict.game.potted, verdict.game.best) == (1, 1, 1)

    @pytest.mark.parametrize(
        ("rule", "played", "why"),
        [({}, shot(1, scratch=True), "The cue ball went down."),
         ({"ordered": True}, shot(2, first=2), "The 1 was not hit first."),
         ({"ordered": True}, shot(2, first=1), "The 1 did not go down."),
         ({"pocket": 3}, shot(1, pocket=2), "A ball went into another pocket."),
         ({"off_cushions": True}, shot(1, path=(("ball", 1), ("cushion", 0))),
          "The cue ball touched a cushion.")],
    )  # fmt: skip
    def test_what_else_ends_it(self, rule, played, why):
        assert drill(**rule).judge(played).words == (why, "0 of 3.")
        assert drill().judge(shot(1, path=(("cushion", 0),))).game.run == 1

    def test_a_set_counts_balls_and_ends(self):
        game = drill(tries=2, needed=4)
        assert game.final and not drill().final
        game = game.judge(shot(1, 2, 3)).game
        verdict = game.judge(shot(2, first=2)).game.judge(shot(first=1))
        assert verdict.game.over and verdict.game.set_over and verdict.game.best == 3
        assert verdict.words[0] == "4 of 6 balls: 4 were needed, met."
        fresh = verdict.game.next_rack()
        assert (fresh.game.attempts, fresh.game.potted, fresh.game.over) == (0, 0, False)
        assert fresh.places == PLACES

    def test_the_frame_puts_the_balls_back(self):
        layout = arrange({ball: (x, y) for ball, x, y in PLACES})
        frame = Frame(drill(), layout, Table.pool())
        played = frame.play(Stroke(0.5, 0.0))
        assert played.frame.layout.places == layout.places and played.frame.game.attempts == 1


class TestDrillInSets:
    def test_so_many_tries_and_then_it_is_over(self):
        game = Drill(goal=Goal(pots=(Pot(1),)), set_up=(1,), on_table=(1,), tries=3, needed=2)
        assert game.final and not replace(game, tries=0).final
        game = game.judge(shot(1)).game
        game = game.judge(shot()).game
        assert not game.over
        verdict = game.judge(shot(1))
        assert verdict.game.over and verdict.words[0] == "2 of 3: 2 were needed, met."
        with pytest.raises(ValueError, match="over"):
            verdict.game.judge(shot(1))
        fresh = verdict.game.next_rack().game
        assert (fresh.attempts, fresh.made, fresh.streak, fresh.over) == (0, 0, 0, False)
        missed = game.judge(shot())
        assert missed.words[:2] == ("1 of 3: 2 were needed, not met.", "The 1 did not go down.")


class TestTableLengths:
    def test_without_a_cushion_it_is_what_sliding_and_rolling_give(self):
        """12/49 v^2/(mu_s g) until it rolls at 5/7 v, then (5/7 v)^2/(2 mu_r g)."""
        cloth = Physics(sliding=0.3, rolling=0.02)
        for speed in (0.3, 0.8, 1.2):
            way = 12.0 / 49.0 * speed**2 / (0.3 * 9.81) + (5.0 / 7.0 * speed) ** 2 / (2.0 * 0.02 * 9.81)
            assert way < BED_LENGTH - 2.0 * BALL_RADIUS
            assert table_lengths(speed, cloth, BED_WIDTH, BED_LENGTH) == pytest.approx(
                way / BED_LENGTH, rel=1e-9
            )

    @pytest.mark.parametrize("speed", [1.9, 2.6, 3.7, 5.1])
    def test_across_cushions_it_is_the_way_that_the_ball_is_seen_to_run(self, speed):
        """The same ball, looked at 4,000 times: its places are between its cushions, and added up."""
        table = Table.bare(BED_WIDTH, BED_LENGTH, Table.pool().cushion_height)
        start = [[0.5 * BED_WIDTH, BALL_RADIUS]]
        ball = make_shot(table, start, radii=BALL_RADIUS, masses=BALL_MASS, physics=Physics(), ids=("0",))
        course = simulate(ball.struck(0, (0.0, speed, 0.0), (0.0, 0.0, 0.0)))
        times = np.linspace(0.0, course.end_time, 4_000)
        way = np.array([course.state_at(float(time)).positions[0, 1] for time in times])
        seen = float(np.abs(np.diff(way)).sum()) / BED_LENGTH
        # of each meeting with a cushion at most twice what is run between two looks is missed
        turns = int((np.diff(np.sign(np.diff(way))) != 0).sum())
        unseen = 2.0 * turns * speed * (times[1] - times[0]) / BED_LENGTH
        assert turns >= 1
        told = table_lengths(speed, Physics(), BED_WIDTH, BED_LENGTH)
        assert seen <= told + 1e-9 and told <= seen + unseen + 1e-9

    def test_it_grows_evenly_with_the_speed_across_the_cushions(self):
        speeds = [0.5 + 0.05 * k for k in range(80)]
        lengths = [table_lengths(round(v, 2), Physics(), BED_WIDTH, BED_LENGTH) for v in speeds]
        steps = [b - a for a, b in pairwise(lengths)]
        assert min(steps) >= 0.0 and max(steps) < 0.12 and lengths[-1] > 2.0

    def test_cushions_take_their_part(self):
        hard, soft = (Physics(cushion_restitution=e) for e in (0.95, 0.5))
        lengths = [table_lengths(3.0, physics, BED_WIDTH, BED_LENGTH) for physics in (hard, Physics(), soft)]
        assert lengths[0] > lengths[1] > lengths[2] > 1.0
        assert table_lengths(4.0, Physics(), BED_WIDTH, BED_LENGTH) > table_lengths(
            2.0, Physics(), BED_WIDTH, BED_LENGTH
        )
