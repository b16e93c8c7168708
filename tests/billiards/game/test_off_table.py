"""A ball that leaves the table: what the referee sees, the foul, where balls are put back."""

import math

import msgspec
import numpy as np
import pytest

from game.billiards import Physics, Table, make_shot, simulate, summarize
from game.billiards.game.arrangement import Stroke, arrange
from game.billiards.game.carom_frame import new_carom
from game.billiards.game.frame import Frame
from game.billiards.game.games.carom import Carom
from game.billiards.game.games.combination import CombinationMatch
from game.billiards.game.games.drill import Drill
from game.billiards.game.games.eight_ball import ACCEPT, IN_HAND, EightBall
from game.billiards.game.games.nine_ball import NineBall
from game.billiards.game.games.practice import Practice
from game.billiards.game.rules import ShotSummary
from game.billiards.search.strokes import Board, Noise, draw_noise, with_noise
from game.billiards.shot.cue import strike
from game.levels import level_files, load_level
from game.scenes.carom.level import CaromContent, begun

POOL = Table.pool()
OFF = Stroke(4.5, math.pi, math.radians(40.0))  # over the near cushion
PLACES = {0: (0.35, 0.9), 1: (0.9, 1.6), 9: (0.5, 2.0), 12: (0.9, 0.6)}


def frame(game):
    return Frame(game, arrange(PLACES), POOL)


def on(game, **changes):
    return msgspec.structs.replace(game, on_table=(1, 9, 12), opening=False, in_hand="", **changes)


@pytest.mark.parametrize(
    "game", [on(EightBall()), on(NineBall()), on(CombinationMatch()), on(Practice(rack=""))], ids=type
)
def test_the_cue_ball_off_the_table_is_a_foul_and_comes_back_in_hand(game):
    played = frame(game).play(OFF)
    assert played.summary.off_table == (0,) and played.summary.cue_lost
    assert "off the table" in [foul.kind for foul in played.verdict.fouls]
    assert any("left the table" in word for word in played.verdict.words)
    after = played.frame
    assert after.game.in_hand == "anywhere" and after.cue_ball is None
    assert after.game.on_table == (1, 9, 12) and after.layout.numbers == (1, 9, 12)
    assert after.with_cue_ball().cue_ball is not None
    assert played.trajectory.final["0"] == "off the table"
    assert played.trajectory.events[-1].type == "ball-off-table" or played.trajectory.end_time > 0.0


def test_with_the_effect_off_the_cue_ball_stays():
    grounded = frame(on(NineBall())).replace(physics=Physics(airborne=False))
    assert grounded.play(OFF).summary.off_table == ()


def test_at_the_break_the_table_cannot_be_accepted_without_a_cue_ball():
    verdict = EightBall().judge(ShotSummary(first=(1,), off_table=(0,), cushioned=(1, 2, 3, 4)))
    assert not verdict.game.options and verdict.game.in_hand == "behind the line"  # nothing else is left
    verdict = EightBall().judge(ShotSummary(first=(1,), off_table=(3,), cushioned=(1, 2, 3, 4)))
    assert [option.name for option in verdict.game.options] == [ACCEPT.name, IN_HAND.name]


def test_a_numbered_ball_off_the_table_is_seen_and_does_not_rest():
    shot = make_shot(POOL, [(0.9, 0.6), (0.9, 1.6)], ids=("0", "7")).struck(0, (0.0, 0.5))
    summary = summarize(simulate(shot.in_air(1, (4.0, 0.0, 1.0), 0.1)))
    assert summary.off_table == (7,) and summary.numbered_off == (7,) and not summary.cue_lost
    assert [ball for ball, _, _ in summary.rest] == [0]


def test_what_is_put_back():
    assert on(NineBall()).judge(ShotSummary(first=(1,), off_table=(9,))).spot == (9,)
    assert on(NineBall()).judge(ShotSummary(first=(1,), off_table=(0, 12))).spot == ()
    assert on(CombinationMatch()).judge(ShotSummary(first=(1,), off_table=(0, 12))).spot == (12,)
    practice = on(Practice(rack="")).judge(ShotSummary(first=(1,), off_table=(0, 12)))
    assert practice.spot == (12,) and practice.game.on_table == (1, 9, 12)
    assert "The 12 left the table and is put back." in practice.words


def test_a_goal_is_missed_if_a_ball_leaves_the_table():
    path = next(path for path in level_files("billiards") if path.stem == "drill-07-jump")
    from game.scenes.billiards.level import BilliardsContent, game_of

    game = game_of(load_level(path, "billiards", BilliardsContent).content)
    assert isinstance(game, Drill)
    met = ShotSummary(first=(1,), cue_path=(("ball", 1),), touched=(1,))
    assert game.stars(met) >= 1 and game.stars(met._replace(off_table=(1,))) == 0


@pytest.mark.parametrize("kind", ["three-cushion", "straight-rail"])
def test_carom_puts_balls_back_and_passes_the_turn(kind):
    played = new_carom(Carom(kind=kind, opening=False)).play(Stroke(6.0, 0.0, math.radians(40.0)))
    assert played.summary.off_table == (0,)
    assert [foul.kind for foul in played.verdict.fouls] == ["off the table"]
    assert played.frame.game.turn == 1 and "The white ball left the table." in played.verdict.words
    table = played.frame.table
    places = played.frame.positions
    assert ((places > 0.0) & (places < (table.width, table.length))).all()


def test_the_masse_of_carom_scores_and_a_level_cue_does_not():
    path = next(path for path in level_files("carom") if path.stem == "masse")
    level = load_level(path, "carom", CaromContent)
    game, places = begun(level.content, 0, 0)
    at = new_carom(game).replace(places=places)
    chosen = level.parameters
    stroke = Stroke(
        chosen["power"] / 1.4594594594594594, 1.7686970157876107, math.radians(chosen["elevation"]),
        chosen["tip_left"], chosen["tip_up"],
    )  # fmt: skip
    played = at.play(stroke)
    assert played.verdict.scored and not any(kind == "cushion" for kind, _ in played.summary.path)
    assert played.trajectory.shot.flies and not at.play(stroke._replace(elevation=0.0)).verdict.scored


def test_a_search_sees_the_same_flights_and_counts_a_ball_lost_as_a_foul():
    """Strokes of a board, some raised, some level, some shaken: as played alone, whatever flies."""
    layout = arrange(PLACES)
    noisy = with_noise(np.array([[*OFF], [3.0, 1.0, 0.6, 0.1, -0.1], [3.0, 1.0, 0.0, 0.0, 0.0]]),
                       draw_noise(1, 6), Noise(), 0.028575)  # fmt: skip
    for physics in (Physics(), Physics(airborne=False), Physics(cushion_hop=0.5)):
        outcomes = Board(layout, POOL, physics).play(noisy)
        lost = 0
        for row, stroke in enumerate(noisy.tolist()):
            made = strike(*stroke)
            shot = layout.shot(POOL, physics).struck(0, made.pressed(stroke[2]), made.spin)
            trajectory = simulate(shot)
            summary = summarize(trajectory)
            lost += bool(summary.off_table)
            assert bool(outcomes.facts[row, 1]) == (summary.cue_pocketed or bool(summary.off_table))
            for ball, x, y in summary.rest:
                place = outcomes.places[row, layout.numbers.index(ball)]
                assert place == pytest.approx((x, y), abs=1e-6)
        assert (lost > 0) == physics.airborne
