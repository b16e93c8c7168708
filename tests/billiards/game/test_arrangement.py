"""Balls put on the table by hand: free places, spots, racks; and frames that play on."""

from __future__ import annotations

import math

import msgspec
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.billiards import Table
from game.billiards.game.arrangement import (
    BallSet,
    Stroke,
    arrange,
    bed_for,
    equal_balls,
    is_free,
    nearest_free,
    racked,
    spotted,
)
from game.billiards.game.frame import new_frame
from game.billiards.game.games import CombinationMatch, Drill, EightBall, NineBall, Practice
from game.billiards.game.goals import Goal, Pot
from game.billiards.game.rules import Call
from game.billiards.table.rack import BALL_RADIUS as R
from game.billiards.table.table import checked_table

POOL = Table.pool()
SPOT = (0.5 * POOL.width, 0.75 * POOL.length)


def overlap(layout):
    """Deepest overlap of two balls, m."""
    worst = -math.inf
    for a in range(len(layout.numbers)):
        for b in range(a):
            reach = 2.0 * math.sqrt(layout.radii[a] * layout.radii[b])
            worst = max(worst, reach - math.dist(layout.positions[a], layout.positions[b]))
    return worst


def test_the_bed_lies_within_the_innermost_straight_rails():
    x0, y0, x1, y1 = 0.1, 0.2, 0.9, 1.7  # of a table of 1 m by 2 m
    rails = [(x0, y0, x0, y1, 1, 0), (x1, y1, x1, y0, -1, 0), (x1, y0, x0, y0, 0, 1), (x0, y1, x1, y1, 0, -1)]
    nothing = np.empty((0, 3))
    table = checked_table(1.0, 2.0, 0.04, np.array(rails, dtype=float), nothing, nothing)
    assert bed_for(table, 0.03) == pytest.approx((x0 + 0.03, x1 - 0.03, y0 + 0.03, y1 - 0.03))


def test_balls_by_number():
    layout = arrange({5: (0.3, 0.4), 0: (0.6, 0.5)})
    assert layout.numbers == (0, 5) and layout.place_of(5) == (0.3, 0.4) and layout.place_of(1) is None
    more = layout.with_ball(3, (1.0, 1.0)).with_ball(0, (0.2, 0.2))
    assert more.numbers == (0, 3, 5) and more.place_of(0) == (0.2, 0.2) and layout.place_of(0) == (0.6, 0.5)
    assert more.without(3, 0).numbers == (5,)
    assert more.shot(POOL, new_frame(EightBall()).physics).ids == ("0", "3", "5")
    with pytest.raises(ValueError, match="16"):
        arrange({16: (0.1, 0.1)})


def test_where_a_ball_may_be_put():
    layout = arrange({0: (0.6, 0.5), 1: (0.6, 1.0)})
    assert is_free(layout, POOL, 0, 0.6, 0.6) and is_free(layout, POOL, 2, 0.6, 0.5 + 2.0 * R + 1e-9)
    assert not is_free(layout, POOL, 0, 0.6, 1.0 + 1.9 * R)
    assert not is_free(layout, POOL, 0, R - 1e-6, 0.6) and is_free(layout, POOL, 0, R, 0.6)
    assert is_free(layout, POOL, 0, 0.6, 0.25 * POOL.length, "behind the line")
    assert not is_free(layout, POOL, 0, 0.6, 0.25 * POOL.length + 1e-9, "behind the line")
    assert not is_free(layout, POOL, 0, math.nan, 0.6)


@given(
    st.floats(-1.0, 3.0),
    st.floats(-1.0, 4.0),
    st.sampled_from(["anywhere", "behind the line"]),
)
def test_the_nearest_free_place_is_free(x, y, hand):
    layout = racked(POOL, seed=2)
    found = nearest_free(layout, POOL, 0, x, y, hand)
    assert is_free(layout, POOL, 0, *found, hand)
    if is_free(layout, POOL, 0, x, y, hand):
        assert found == (x, y)


def test_no_place_at_all():
    small = Table.bare(0.2, 0.2)
    with pytest.raises(ValueError, match="no free place"):
        nearest_free(arrange({1: (0.1, 0.1)}, equal_balls(0.05)), small, 0, 0.1, 0.1)


def test_spotted_balls_lie_behind_one_another():
    layout = spotted(arrange({0: (0.3, 0.3)}), POOL, (9, 3))
    assert layout.place_of(3) == SPOT
    x, y = layout.place_of(9)
    assert x == SPOT[0] and y == pytest.approx(SPOT[1] + 2.0 * R, abs=1e-8)
    blocked = spotted(arrange({0: (SPOT[0], SPOT[1] + 0.5 * R)}), POOL, (8,))
    assert blocked.place_of(8)[1] == pytest.approx(SPOT[1] + 2.5 * R, abs=1e-8)


def test_a_full_line_is_filled_towards_the_middle():
    column = {k: (SPOT[0], SPOT[1] + 2.0 * R * 1.0001 * (k - 1)) for k in range(1, 12)}
    layout = spotted(arrange(column), POOL, (15,))
    assert layout.place_of(15)[1] == pytest.approx(SPOT[1] - 2.0 * R, abs=1e-8)
    assert overlap(layout) <= 1e-12


@given(st.integers(0, 10**6), st.sets(st.integers(1, 15), min_size=1, max_size=5))
def test_spotted_balls_never_overlap(seed, numbers):
    rng = np.random.default_rng(seed)
    balls = BallSet(rng.uniform(0.02, 0.032, 16), np.full(16, 0.17))
    layout = racked(POOL, balls=balls, seed=seed)
    spots = spotted(layout, POOL, tuple(numbers))
    assert spots.numbers == layout.numbers and overlap(spots) < 1e-9


@pytest.mark.parametrize("game", ["eight-ball", "nine-ball"])
def test_racks_of_unlike_balls(game):
    rng = np.random.default_rng(5)
    layout = racked(POOL, game, BallSet(rng.uniform(0.024, 0.03, 16), rng.uniform(0.1, 0.2, 16)), seed=4)
    assert overlap(layout) <= 0.0 and len(layout.numbers) == (10 if game == "nine-ball" else 16)
    left, right, lower, upper = bed_for(POOL, 0.03)
    assert (layout.positions >= [left, lower]).all() and (layout.positions <= [right, upper]).all()


def test_a_break_and_a_choice_in_a_frame():
    frame = new_frame(EightBall(), seed=1).place_cue_ball(0.5, 0.5)
    with pytest.raises(ValueError, match="cue ball"):
        frame.place_cue_ball(0.5, 1.5)
    played = frame.play(Stroke(0.3, math.pi / 2))
    assert [o.name for o in played.verdict.game.options][:1] == ["accept"]
    racked_again = played.frame.choose("break")
    assert racked_again.layout.place_of(8) == pytest.approx(
        (SPOT[0], SPOT[1] + 4.0 * R * math.sqrt(0.75)), abs=1e-3
    )
    assert played.frame.choose("accept").layout.numbers == tuple(range(16))
    with pytest.raises(ValueError, match="must choose"):
        played.frame.play(Stroke(1.0, 0.0))


def test_a_scratch_takes_the_cue_ball_off_until_it_is_put_back():
    frame = new_frame(Practice(rack="", on_table=(1,))).replace(
        layout=arrange({0: (0.3, 1.27), 1: (1.0, 2.0)})
    )
    played = frame.play(Stroke(1.5, math.pi))
    assert played.summary.cue_pocketed and played.frame.layout.numbers == (1,)
    with pytest.raises(ValueError, match="put down first"):
        played.frame.play(Stroke(1.0, 0.0))
    again = played.frame.place_cue_ball(0.5, 0.5)
    assert again.layout.numbers == (0, 1)
    with pytest.raises(ValueError, match="not in hand"):
        frame.play(Stroke(0.1, 0.0)).frame.place_cue_ball(0.5, 0.5)


def test_what_does_not_count_is_put_back():
    frame = new_frame(CombinationMatch(on_table=(1, 2), opening=False, in_hand="")).replace(
        layout=arrange({0: (0.8, 1.27), 1: (0.3, 1.27), 2: (0.9, 0.4)})
    )
    played = frame.play(Stroke(1.0, math.pi))
    assert played.summary.balls_down == (1,) and played.verdict.spot == (1,)
    assert played.frame.layout.place_of(1) == SPOT and played.frame.game.turn == 1


def test_a_drill_goes_back_to_its_set_up():
    layout = arrange({0: (0.8, 1.27), 1: (0.3, 1.27)})
    game = Drill(
        goal=Goal(pots=(Pot(1, 2),)), set_up=(1,), on_table=(1,), more=(Goal(pots=(Pot(1, cushions=1),)),)
    )
    frame = new_frame(Practice()).replace(game=game, layout=layout)
    played = frame.play(Stroke(1.0, math.pi, tip_up=-0.3))
    assert played.verdict.scored == (1,) and played.frame.layout is layout
    assert (played.frame.game.attempts, played.frame.game.made, played.frame.game.best) == (1, 1, 1)
    assert "cushions" in played.verdict.words[1]
    missed = played.frame.play(Stroke(1.0, 0.0))
    assert (missed.frame.game.attempts, missed.frame.game.made, missed.frame.game.streak) == (2, 1, 0)


def test_next_rack_is_that_of_the_game():
    frame = new_frame(NineBall(), seed=3)
    assert frame.layout.numbers == tuple(range(10))
    done = frame.replace(
        game=msgspec.structs.replace(frame.game, winner=0), layout=frame.layout.without(4, 5)
    )
    assert done.next_rack(seed=4).layout.numbers == tuple(range(10))
    with pytest.raises(ValueError, match="over"):
        done.play(Stroke(1.0, 0.0), Call())
