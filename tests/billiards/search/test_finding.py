"""Shots that are found: they do what they say, whatever the threads, within their time."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.billiards import find_shots, simulate
from game.billiards.game.arrangement import Stroke, arrange, is_free, racked
from game.billiards.game.frame import new_frame
from game.billiards.game.games import EightBall, NineBall
from game.billiards.game.rules import CUE_BALL
from game.billiards.game.summary import summarize
from game.billiards.search.aims import aims_of, all_aims
from game.billiards.search.breaking import apex_of, best_break, list_breaks
from game.billiards.search.candidates import AIM, COLUMNS, SPREAD, WINDOW
from game.billiards.search.deeper import look_deeper, worth_after
from game.billiards.search.fans import make_styles, rays_for, spread_fans, widest_runs
from game.billiards.search.looking import Effort, look
from game.billiards.search.outcomes import FIRST_BALLS
from game.billiards.search.placing import BallInHand, place_cue_ball, places_for_cue_ball
from game.billiards.search.rating import MISSED, SCORED, WON
from game.billiards.search.safety import look_for_push_out, look_for_safety
from game.billiards.search.strokes import STEADY, Board, Noise, draw_noise, with_noise
from game.billiards.search.view import Clock, View
from game.billiards.shot.physics import Physics
from game.billiards.table.rack import HEAD_SPOT
from tests.billiards.search.search_tables import POOL, scattered, unlike_balls

pytestmark = pytest.mark.compiled

PHYSICS = Physics()
QUICK = Effort(
    speeds=(0.9, 1.6), ups=(-0.2, 0.2), lefts=(0.0,), candidates=6, rays=17, finalists=16, samples=32
)


def played(layout, stroke):
    """Summary of a stroke."""
    return summarize(simulate(layout.shot(POOL, PHYSICS, stroke)))


@pytest.mark.parametrize("seed", range(6))
def test_found_shots_pot_what_they_say(seed):
    """Without noise every found shot does what it says."""
    layout = scattered(seed, 10, unlike_balls(seed) if seed % 2 else None)
    for shot in find_shots(layout, POOL, noise=STEADY, effort=QUICK)[:12]:
        summary = played(layout, shot.stroke)
        fallen = summary.pocketing(shot.ball)
        assert fallen is not None and fallen.pocket == shot.pocket and not summary.cue_pocketed
        assert shot.chance == 1.0 and shot.kind in (*KIND_NAMES, "cut")
        assert (shot.via is not None) == (shot.kind == "combination")
        if shot.kind == "kick":
            assert summary.cue_path[0][0] == "cushion"


KIND_NAMES = ("direct", "bank", "kick", "combination")


def test_the_chance_is_the_share_of_noisy_strokes_that_pot():
    """Against 300 strokes of other noise, played one by one: within four standard errors of both."""
    layout = scattered(1, 6)
    found = find_shots(layout, effort=QUICK._replace(samples=256))[:2]
    for shot in found:
        noisy = with_noise(np.array([shot.stroke]), draw_noise(99, 300), Noise(), 0.028575)
        hits = 0
        for stroke in noisy.tolist():
            summary = played(layout, Stroke(*stroke))
            fallen = summary.pocketing(shot.ball)
            hits += fallen is not None and fallen.pocket == shot.pocket and not summary.cue_pocketed
        share = hits / 300
        error = 4.0 * math.sqrt(max(share * (1.0 - share), 0.01) * (1 / 300 + 1 / 256))
        assert abs(share - shot.chance) < error


def test_equal_questions_have_equal_answers_on_any_threads():
    layout = scattered(2)
    answers = [find_shots(layout, effort=QUICK, seed=4, threads=threads) for threads in (1, 2, 3)]
    assert answers[0] == answers[1] == answers[2] and answers[0]
    assert find_shots(layout, effort=QUICK, seed=5) != answers[0]


def test_kinds_targets_and_chains_are_kept():
    layout = scattered(3)
    for kind in KIND_NAMES:
        names = {shot.kind for shot in find_shots(layout, kinds=(kind,), effort=QUICK)}
        assert names <= ({"direct", "cut"} if kind == "direct" else {kind})
    assert {shot.ball for shot in find_shots(layout, targets=(1, 2), effort=QUICK)} <= {
        1,
        2,
    }
    long = {"chain": 3, "kinds": ("combination",)}
    for shot in find_shots(layout, **long, noise=STEADY, effort=QUICK):
        assert len(played(layout, shot.stroke).pocketing(shot.ball).chain) >= 3
    for shot in find_shots(layout, first=(5,), noise=STEADY, effort=QUICK):
        assert 5 in played(layout, shot.stroke).first


def test_what_is_absurd_is_refused():
    layout = scattered(1, 4)
    with pytest.raises(ValueError, match="limit: expected at least 1"):
        find_shots(layout, limit=0)
    with pytest.raises(ValueError, match="kinds"):
        find_shots(layout, kinds=("jump",))
    with pytest.raises(ValueError, match="ball 9"):
        find_shots(layout, targets=(9,))
    with pytest.raises(ValueError, match="ball 0"):
        find_shots(layout, first=(0,))
    with pytest.raises(ValueError, match="cue ball"):
        find_shots(layout.without(0))
    assert find_shots(arrange({0: (0.5, 0.5)})) == []


def test_no_time_still_gives_an_answer():
    layout = scattered(2)
    hurried = find_shots(layout, seconds=0.0)
    assert hurried and Clock(0.0).is_out() and not Clock(None).is_out() and not Clock(100.0).is_out()


def test_fans_spread_evenly_about_their_aim():
    rows = np.zeros((2, COLUMNS))
    rows[:, AIM], rows[:, SPREAD], rows[:, WINDOW] = (1.0, 2.0), (0.1, 0.02), (0.004, 0.02)
    rays = rays_for(rows)
    assert rays.tolist() == [41, 9] and (rays % 2 == 1).all()
    styles = make_styles((1.0, 2.0), (0.1,), (0.0,))
    starts = np.array([0, 82])
    strokes = np.empty((100, 5))
    spread_fans(rows, styles, rays, starts, np.array([0.0, 0.01]), strokes)
    assert strokes[[0, 20, 40], 1] == pytest.approx([0.9, 1.0, 1.1])
    assert strokes[41 + 20, 1] == pytest.approx(0.99) and strokes[82 + 4, 1] == pytest.approx(2.0)
    assert strokes[:41, 0].tolist() == [1.0] * 41 and (strokes[:, 4] == 0.1).all()


def test_the_widest_run_of_a_fan():
    kinds = np.array([MISSED, SCORED, SCORED, MISSED, SCORED, WON, SCORED, SCORED, MISSED, MISSED])
    middles, lengths = np.empty((1, 2), np.int64), np.empty((1, 2))
    widest_runs(kinds, np.array([5]), np.array([0]), 2, middles, lengths)
    assert lengths.tolist() == [[2.0, 3.0]] and middles.tolist() == [[1, 6]]


def test_deeper_knows_what_one_ball_before_the_last_is_worth():
    """Two balls near pockets: looked at more closely the table is worth at least what the estimate says."""
    layout = arrange({0: (0.45, 1.27), 1: (0.2, 1.27), 8: (0.2, 2.3)})
    game = EightBall(opening=False, in_hand="", on_table=(1, 8), groups=("solids", "stripes"), calling="all")
    aims = aims_of(game, layout.numbers, solo=True)[0]
    view = View(Board(layout, POOL), Noise())
    draws = draw_noise(1, 64)
    effort = QUICK._replace(deep=4, close=64, deep_samples=6, after=QUICK)
    looked = look(view, aims, effort, draws)
    deeper = look_deeper(view, aims, looked, effort, draws)
    assert len(deeper.worth) == 4 and (np.diff(deeper.worth) <= 0.0).all()
    assert 0.8 < deeper.worth[0] <= 1.0
    assert look_deeper(view, aims, looked, effort._replace(after=None), draws) is looked
    stuck = np.array([[0.6, 0.6], [-1e3, -1e3], [-1e3, -1e3]])
    assert worth_after(view, aims, stuck, QUICK, draws, 0.25) == 0.25


def test_the_few_that_are_looked_at_closely_are_the_best_of_the_first_idea():
    layout = scattered(3, 10)
    game = EightBall(opening=False, in_hand="", on_table=layout.numbers[1:], calling="all")
    aims = aims_of(game, layout.numbers, solo=True)[0]
    view, draws = View(Board(layout, POOL), Noise()), draw_noise(1, 32)
    many = look(view, aims, QUICK._replace(finalists=200), draws)
    few = look(view, aims, QUICK._replace(finalists=4), draws)
    assert len(many.worth) > 12 and len(few.worth) == 4
    assert many.worth.min() < many.worth.mean() < few.worth.mean()


@pytest.mark.parametrize("hand", ["anywhere", "behind the line"])
def test_the_cue_ball_is_put_where_a_ball_can_be_potted(hand):
    layout = scattered(7, 9).without(0)
    aims = all_aims((0, *layout.numbers), layout.numbers, (), 0)
    ball = BallInHand(layout, POOL, PHYSICS, hand, Noise())
    places = places_for_cue_ball(ball, aims, 12)
    assert 0 < len(places) <= 12 and all(is_free(layout, POOL, 0, x, y, hand) for x, y in places[:, :2])
    draws = draw_noise(1, 32)
    best = place_cue_ball(ball, aims, QUICK, draws, 2, 6)
    assert 1 <= len(best) <= 2
    shots = find_shots(best[0], effort=QUICK)
    assert shots and shots[0].chance > 0.8


def test_a_cue_ball_behind_the_line_pots_a_ball_that_lies_beyond_it():
    # from the head spot the 2 is in the way of the 1; where it may be put down does not bound where it runs
    layout = arrange({1: (1.12, 2.1), 2: (0.85, 1.2)})
    aims = all_aims((0, 1, 2), (1,), (), 0)
    ball = BallInHand(layout, POOL, PHYSICS, "behind the line", Noise())
    places = places_for_cue_ball(ball, aims, 12)
    assert len(places) and all(is_free(layout, POOL, 0, x, y, ball.hand) for x, y in places[:, :2])
    best = place_cue_ball(ball, aims, QUICK, draw_noise(1, 32), 1)[0]
    assert math.dist(best.place_of(CUE_BALL), (0.5 * POOL.width, HEAD_SPOT * POOL.length)) > 0.05
    shots = find_shots(best, effort=QUICK)
    assert shots and shots[0].chance > 0.6


def test_a_cue_ball_that_can_reach_nothing_is_put_down_all_the_same():
    layout = arrange({1: (0.635, 2.5)})
    nothing = all_aims((0, 1), (), (), 0)
    ball = BallInHand(layout, POOL, PHYSICS, "behind the line", Noise())
    (only,) = place_cue_ball(ball, nothing, QUICK, draw_noise(1, 8), 3)
    assert is_free(layout, POOL, CUE_BALL, *only.place_of(CUE_BALL), "behind the line")


def test_a_safe_stroke_is_legal_and_leaves_less_than_any_stroke():
    game = EightBall(opening=False, in_hand="", groups=("solids", "stripes"), calling="all")
    layout = scattered(5)
    aims = aims_of(game, layout.numbers)[0]
    view = View(Board(layout, POOL), Noise())
    looked = look_for_safety(view, aims, 8, draw_noise(2, 24))
    assert (looked.kinds[0] == MISSED).mean() > 0.8
    assert looked.worth[0] >= looked.worth[-1] and looked.candidates[0, 0] == -1.0
    summary = played(layout, Stroke(*looked.strokes[0].tolist()))
    assert summary.first[0] in game.legal_first() and not summary.cue_pocketed


def test_a_push_out_does_not_lose_the_cue_ball():
    layout = scattered(6, 10)
    aims = all_aims(layout.numbers, tuple(range(1, 10)), (1,), 0)._replace(
        solo=False, other=0x3FE, rotation=True
    )
    stroke = look_for_push_out(View(Board(layout, POOL), Noise()), aims, 3)
    assert not played(layout, Stroke(*stroke.tolist())).cue_pocketed


@pytest.mark.parametrize("game", [EightBall, NineBall])
@pytest.mark.parametrize("unsteady", [0.0, 1.0, 4.5])
def test_every_break_meets_the_apex_ball_first(game, unsteady):
    """Under the noise of the worst hand, too."""
    noise = Noise().scaled(unsteady)
    for seed in range(6):
        frame = new_frame(game(), seed=seed)
        breaks = list_breaks(frame.layout, POOL, 6.0)
        assert len(breaks) == 30 and breaks[0].place[0] == pytest.approx(0.5 * POOL.width)
        for one in breaks:
            layout = frame.layout.with_ball(CUE_BALL, one.place)
            assert is_free(frame.layout.without(CUE_BALL), POOL, CUE_BALL, *one.place, "behind the line")
            board = Board(layout, POOL)
            outcomes = board.play(
                with_noise(np.array([one.stroke]), draw_noise(seed, 8), noise, board.radius)
            )
            apex = [math.dist(place, apex_of(layout, POOL)) for place in layout.positions.tolist()].index(0.0)
            assert (outcomes.facts[:, FIRST_BALLS] & (1 << apex) != 0).all()


def test_the_break_is_behind_the_line_and_chosen_by_what_it_does():
    layout = racked(POOL, seed=4)
    aims = all_aims(layout.numbers, tuple(range(1, 16)), (), 0)._replace(called=False)
    place, stroke, merit = best_break(layout, POOL, PHYSICS, aims, Noise(), 6.0, draw_noise(1, 8))
    assert is_free(layout, POOL, 0, *place, "behind the line") and 0.0 < merit <= 1.0
    summary = played(layout.with_ball(0, place), stroke)
    assert summary.first and math.dist(apex_of(layout, POOL), layout.place_of(summary.first[0])) < 1e-9
    plain, straight, nothing = best_break(layout, POOL, PHYSICS, aims, Noise(), 6.0, draw_noise(1, 0))
    assert plain[0] == pytest.approx(POOL.width / 2) and nothing == 0.0 and straight.cue_speed == 6.0
    soft = best_break(layout, POOL, PHYSICS, aims, STEADY, 0.5, draw_noise(1, 1))
    assert soft.merit == -1.0  # so soft a break is not lawful, however it is played
    with pytest.raises(ValueError, match="no free place"):
        wall = arrange({n: (0.08 * n, 0.62) for n in range(1, 16)})
        best_break(wall, POOL, PHYSICS, aims, Noise(), 6.0, draw_noise(1, 0))
