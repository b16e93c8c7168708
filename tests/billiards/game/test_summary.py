"""From played shots to what the referee sees."""

from __future__ import annotations

import numpy as np
import pytest

from game.billiards import Table, make_shot, simulate
from game.billiards.game.arrangement import arrange, racked
from game.billiards.game.summary import pass_on, summarize
from game.billiards.shot.physics import FRICTIONLESS, Physics
from game.billiards.table.rack import BALL_RADIUS as R

POOL = Table.pool()
BARE = Table.bare(1.27, 2.54)
PHYSICS = Physics()


def play(places, velocity, table=POOL, spin=(0.0, 0.0, 0.0), ids=None, physics=PHYSICS):
    """Summary of the first ball struck."""
    return summarize(simulate(make_shot(table, places, ids=ids, physics=physics).struck(0, velocity, spin)))


def test_a_straight_shot_into_the_side_pocket():
    summary = play([[0.8, 1.27], [0.3, 1.27]], (-1.5, 0.0))
    assert summary.first == (1,) and summary.balls_down == (1,)
    fallen = summary.pocketing(1)
    assert fallen.pocket == 2 and fallen.chain == (0, 1) and fallen.cushions == 0
    assert summary.cue_path == (("ball", 1),) and summary.touched == (1,)


def test_by_way_of_another():
    summary = play([[0.9, 1.27], [0.5, 1.27], [0.3, 1.27]], (-2.5, 0.0))
    assert summary.pocketing(2).chain == (0, 1, 2) and summary.first == (1,)
    assert summary.touched == (1, 2)


def test_scratch_and_nothing_touched():
    summary = play([[0.3, 1.27], [1.0, 2.0]], (-2.0, 0.0))
    assert summary.cue_pocketed and summary.first == () and summary.cushioned == ()
    assert [ball for ball, _, _ in summary.rest] == [1]
    assert summary.rest[0][1:] == (1.0, 2.0)


def test_two_at_one_moment_are_both_first():
    gap = R * 1.5
    places = [[0.635, 0.7], [0.635 - gap, 1.2], [0.635 + gap, 1.2]]
    summary = play(places, (0.0, 2.0))
    assert sorted(summary.first) == [1, 2]


def test_cushions_count_only_after_the_first_contact():
    summary = play([[0.6, 0.3], [0.6, 0.8]], (0.0, -1.2), table=BARE)
    assert summary.cue_path[0] == ("cushion", 2) and summary.first == (1,)
    assert summary.cushioned == ()
    assert play([[0.6, 0.3], [0.6, 0.8]], (0.0, 4.0), table=BARE).cushioned[0] == 1


@pytest.mark.parametrize(("distance", "cushioned"), [(R, ()), (R + 0.01, (1,))])
def test_a_ball_that_lay_against_a_cushion_is_not_driven_to_it(distance, cushioned):
    """Pressed into its cushion softly, a frozen ball has not been driven to it (8.4)."""
    summary = play([[distance + 0.3, 1.0], [distance, 1.0]], (-0.35, 0.0), table=BARE)
    assert summary.first == (1,)
    assert summary.cushioned == cushioned


def test_a_frozen_ball_that_leaves_and_returns_is_driven_to_it():
    places = [[R + 0.5, 1.0], [R, 1.0]]
    summary = play(places, (-3.0, 0.0), table=Table.bare(0.8, 2.54))
    assert 1 in summary.cushioned


def test_a_ball_that_stopped_is_not_the_cause_of_what_runs_into_it():
    """2 meets 1, which 0 left lying in its way: 1 goes on by way of 2, which still owes its way to 3."""
    moving = [True, False, True, True]
    chains = [(0,), (0, 1), (0, 3, 2), (0, 3)]
    pass_on([(1, 2)], moving, chains)
    assert chains == [(0,), (0, 3, 2, 1), (0, 3, 2), (0, 3)] and moving[1]


def test_chains_name_no_ball_twice():
    moving, chains = [True, True, True], [(0,), (0, 1), (0, 1, 2)]
    pass_on([(1, 2)], moving, chains)
    assert chains == [(0,), (0, 1), (0, 1, 2)]
    pass_on([(0, 1)], moving, chains)
    assert chains == [(0,), (0, 1), (0, 1, 2)]


def test_contacts_of_one_moment_spread_from_what_moves():
    """A touching row, in whatever order its contacts are listed."""
    for order in ([(0, 1), (1, 2), (2, 3)], [(2, 3), (1, 2), (0, 1)]):
        moving, chains = [True, False, False, False], [(0,), (), (), ()]
        pass_on(order, moving, chains)
        assert chains == [(0,), (0, 1), (0, 1, 2), (0, 1, 2, 3)] and all(moving)


@pytest.mark.parametrize("seed", range(8))
def test_chains_of_a_break_hold_against_the_contacts_one_by_one(seed):
    """Every link is a contact that took place, in order of time; every chain begins with the cue ball."""
    layout = racked(POOL, seed=seed)
    trajectory = simulate(layout.shot(POOL, PHYSICS).struck(0, (0.02 * (seed - 4), 9.0), (-20.0, 0.0, 0.0)))
    summary = summarize(trajectory)
    contacts = [(e.time, {int(k) for k in e.ids}) for e in trajectory.events if e.type == "ball-ball"]
    for fallen in summary.pocketed:
        assert fallen.chain[0] == 0 and fallen.chain[-1] == fallen.ball
        assert len(set(fallen.chain)) == len(fallen.chain) >= 2
        time = -1.0
        for link in zip(fallen.chain[:-1], fallen.chain[1:], strict=True):
            time = next(t for t, pair in contacts if t >= time and pair == set(link))
    left = {ball for ball, _, _ in summary.rest}
    down = {*summary.balls_down, *([0] if summary.cue_pocketed else [])}
    assert left | down == set(range(16)) and not left & down
    apex = min(range(1, 16), key=lambda ball: layout.place_of(ball)[1])
    assert summary.first[0] == apex and len(summary.touched) >= 12


def test_balls_that_were_down_before_are_not_there():
    layout = arrange({0: (0.4, 0.4), 5: (0.4, 1.0), 12: (0.9, 2.0)})
    summary = summarize(
        simulate(layout.shot(POOL, FRICTIONLESS._replace(rolling=0.01, sliding=0.2)).struck(0, (0.0, 1.0)))
    )
    assert summary.first == (5,) and {ball for ball, _, _ in summary.rest} <= {0, 5, 12}


def test_short_of_the_line_is_a_ball_behind_it_that_is_hit_without_crossing():
    behind, beyond = (0.9, 0.4), (0.9, 0.9)
    assert play([[0.5, 0.4], behind], (1.5, 0.0)).short
    assert not play([[0.5, 0.9], beyond], (1.5, 0.0)).short
    assert not play([[0.5, 0.9], behind], (1.5, -1.875)).short
    up_and_back = play([[0.5, 0.3], [0.5, 0.45]], (0.0, -1.5), table=BARE)
    assert up_and_back.first == (1,) and up_and_back.short
    over = Table.bare(1.27, 0.9)
    crossed = play([[0.6, 0.2], [0.6, 0.1]], (0.0, 2.0), table=over)
    assert crossed.first == (1,) and not crossed.short


def test_names_must_be_numbers():
    with pytest.raises(ValueError, match="numbers for names"):
        play([[0.4, 0.4], [0.4, 1.0]], (0.0, 1.0), ids=("white", "red"))


def test_rest_is_the_end_of_the_trajectory():
    shot = make_shot(POOL, [[0.4, 0.4], [0.45, 1.0]]).struck(0, (0.1, 1.0))
    trajectory = simulate(shot)
    places = {ball: (x, y) for ball, x, y in summarize(trajectory).rest}
    assert np.array_equal([places[0], places[1]], trajectory.end[:, :2])
