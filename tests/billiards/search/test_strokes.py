"""Many strokes at once are what each is alone, and their summaries are the referee's."""

from __future__ import annotations

import math
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from game.billiards import Physics, simulate, strike
from game.billiards.game.arrangement import Stroke, arrange, racked
from game.billiards.game.summary import summarize
from game.billiards.laws.state import BALL_BALL
from game.billiards.search.outcomes import (
    CHAIN,
    CONTACTS,
    CUSHIONED,
    CUSHIONS,
    CUSHIONS_FIRST,
    DOWN,
    FIRST_BALLS,
    GIVEN_UP,
    NOWHERE,
    POCKET,
    SCRATCH,
)
from game.billiards.search.strokes import (
    CHUNK,
    LARGEST_TIP,
    STEADY,
    TIP_LEFT,
    TIP_UP,
    Board,
    Noise,
    draw_noise,
    strike_all,
    with_noise,
)
from tests.billiards.search.search_tables import POOL, random_strokes, scattered, unlike_balls

PHYSICS = Physics()


def bits(rows):
    """Rows as bits."""
    return sum(1 << row for row in rows)


def check_against_referee(layout, strokes, outcomes):
    """Every outcome says what `summarize` says of the same stroke played alone; how many were compared."""
    row_of = {number: row for row, number in enumerate(layout.numbers)}
    for s, stroke in enumerate(strokes.tolist()):
        trajectory = simulate(layout.shot(POOL, PHYSICS, Stroke(*stroke)))
        summary = summarize(trajectory)
        facts, histories = outcomes.facts[s], outcomes.histories[s]
        assert facts[FIRST_BALLS] == bits(row_of[n] for n in summary.first)
        assert bool(facts[SCRATCH]) == (summary.cue_pocketed or bool(summary.off_table))
        assert facts[GIVEN_UP] == 0
        assert facts[DOWN] == bits(row_of[n] for n in summary.balls_down)
        assert bool(facts[CUSHIONED]) == bool(summary.cushioned)
        before = [kind for kind, _ in summary.cue_path]
        first = before.index("ball") if "ball" in before else len(before)
        assert facts[CUSHIONS_FIRST] == first
        rows = trajectory.rows[trajectory.rows[:, 1] == BALL_BALL]
        met = [int((rows[:, 2:] == row).sum()) for row in range(len(layout.numbers))]
        assert histories[:, CONTACTS].tolist() == met
        for fallen in summary.pocketed:
            history = histories[row_of[fallen.ball]]
            assert history[POCKET] == fallen.pocket and history[CUSHIONS] == fallen.cushions
            assert history[CHAIN] == bits(row_of[n] for n in fallen.chain)
        for number, x, y in summary.rest:
            assert outcomes.places[s, row_of[number]] == pytest.approx((x, y), abs=1e-9)
        down = [row_of[n] for n in summary.balls_down]
        assert (outcomes.places[s, down] == NOWHERE).all() and (histories[:, POCKET] >= 0).sum() == len(
            down
        ) + summary.cue_pocketed
    return len(strokes)


@pytest.mark.parametrize("count", [2, 16])
def test_outcomes_are_those_of_the_referee(count):
    layout = scattered(count, count)
    strokes = random_strokes(count, 60)
    assert check_against_referee(layout, strokes, Board(layout, POOL).play(strokes)) == 60


def test_outcomes_with_unlike_balls_some_of_which_are_down():
    layout = scattered(5, 16, unlike_balls(1)).without(2, 3, 9)
    strokes = random_strokes(3, 40)
    assert check_against_referee(layout, strokes, Board(layout, POOL).play(strokes)) == 40


def test_outcomes_of_breaks():
    layout = racked(POOL, seed=2)
    strokes = np.array([[7.0, math.pi / 2 + 0.004 * k, 0.0, 0.0, 0.1] for k in range(-4, 5)])
    board = Board(layout, POOL)
    outcomes = board.play(strokes)
    for s, stroke in enumerate(strokes.tolist()):
        summary = summarize(simulate(layout.shot(POOL, PHYSICS, Stroke(*stroke))))
        assert outcomes.facts[s, FIRST_BALLS] == bits(summary.first)


@pytest.mark.compiled
def test_threads_and_chunks_make_no_difference():
    board = Board(scattered(1), POOL)
    strokes = random_strokes(1, 2 * CHUNK + 9)
    alone = board.play(strokes)
    with ThreadPoolExecutor(3) as pool:
        shared = board.play(strokes, pool)
    for a, b in zip(alone, shared, strict=True):
        assert np.array_equal(a, b)
    single = board.play(strokes[-1:])
    assert all(np.array_equal(a[0], b[-1]) for a, b in zip(single, alone, strict=True))


def test_the_kernel_strikes_as_the_cue_does():
    strokes = random_strokes(8, 20)
    base = Board(arrange({0: (0.5, 0.5)}, unlike_balls(3)), POOL).base
    balls = np.empty((20, 1, 11))
    strike_all(strokes, base, 0, 0.0057, 0.567, balls)
    for row, stroke in zip(balls[:, 0], strokes.tolist(), strict=True):
        made = strike(
            *stroke, ball_radius=base[0, 7], ball_mass=base[0, 8], cue_mass=0.567, cue_end_mass=0.0057
        )
        assert row[2:7] == pytest.approx((*made.velocity[:2], *made.spin), abs=1e-12)


def test_a_moved_board_is_the_board_of_the_moved_balls():
    layout = scattered(4)
    strokes = random_strokes(2, 20)
    places = Board(layout, POOL).play(strokes[:1]).places[0]
    kept = np.flatnonzero(places[:, 0] > -1.0)
    moved = Board(scattered(9), POOL).moved(places, kept).play(strokes)
    numbers = tuple(kept.tolist())
    other = arrange({n: tuple(places[n]) for n in numbers})
    assert np.array_equal(moved.facts, Board(other, POOL).play(strokes).facts)


def test_noise_has_the_deviations_it_says():
    draws = draw_noise(1, 4000)
    assert np.abs(draws.mean(axis=0)).max() < 1e-12
    meant = np.array([[2.0, 0.3, 0.2, 0.1, -0.1]])
    noise = Noise()
    noisy = with_noise(meant, draws, noise, 0.028575)
    spread = (noisy - meant).std(axis=0)
    expected = [noise.speed, noise.azimuth, noise.elevation, noise.tip / 0.028575, noise.tip / 0.028575]
    assert spread == pytest.approx(expected, rel=4.0 / math.sqrt(2.0 * 4000))  # four standard errors
    assert np.array_equal(with_noise(meant, draws[:3], STEADY, 0.03), np.repeat(meant, 3, axis=0))
    assert Noise().scaled(2.0).azimuth == 2.0 * Noise().azimuth


def test_noise_keeps_a_stroke_possible():
    wild = Noise().scaled(200.0)
    noisy = with_noise(np.array([[0.1, 0.0, 0.0, 0.4, 0.4]]), draw_noise(3, 500), wild, 0.028575)
    tips = np.hypot(noisy[:, TIP_LEFT], noisy[:, TIP_UP])
    assert (noisy[:, 0] > 0.0).all() and (noisy[:, 2] >= 0.0).all() and tips.max() <= LARGEST_TIP + 1e-12
    assert np.isfinite(noisy).all()


def test_no_cue_ball():
    with pytest.raises(ValueError, match="no cue ball"):
        Board(arrange({1: (0.5, 0.5)}), POOL)
