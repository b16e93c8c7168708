"""Shots that are computed as far as they are asked for: the same as those that are computed at once."""

import math

import numpy as np
import pytest

from game.billiards import ShotError, Table, eight_ball_rack, make_shot, simulate
from game.billiards.growing import GRID_HZ, grow_lecture, grow_stepped, next_stop
from game.billiards.shot.physics import FRICTIONLESS

POOL = Table.pool()


def break_shot(**more):
    shot = make_shot(POOL, eight_ball_rack(POOL), **more)
    return shot.struck(0, (0.05, 8.0), (-30.0, 0.0, 20.0))


def both(shot, dt: float, until: float):
    """Each table's shot, growing and computed at once."""
    return (
        (grow_lecture(shot, dt, until), simulate(shot, "lecture", dt=dt, until=until)),
        (grow_stepped(shot, dt, 4, until), simulate(shot, "stepped", dt=dt, passes=4, until=until)),
    )


def test_it_comes_to_the_same_end():
    for grown, at_once in both(break_shot(), 1 / 120, 60.0):
        assert not grown.complete and grown.end_time == 0.0
        grown.compute(math.inf)
        assert grown.complete
        assert grown.end_time == at_once.end_time
        assert grown.events == at_once.events
        assert grown.final == at_once.final
        assert grown.digest == at_once.digest


@pytest.mark.parametrize("dt", [1 / 30, 1 / 240, 1 / 1000])
def test_in_pieces_or_at_once_it_is_the_same(dt):
    shot = break_shot()
    for (whole, _), (pieces, _) in zip(both(shot, dt, 3.0), both(shot, dt, 3.0), strict=True):
        whole.compute(3.0)
        for time in np.linspace(0.0, 2.0, 97).tolist():
            pieces.compute(time)
            assert pieces.end_time >= time
            there, here = whole.state_at(time), pieces.state_at(time)
            for a, b in zip(there[1:], here[1:], strict=True):
                assert np.array_equal(a, b)
            assert np.array_equal(pieces.orientations_at(time), whole.orientations_at(time))
        assert pieces.events == whole.events[: len(pieces.events)]


def test_samples_lie_around_the_grid_when_steps_are_short():
    dt = 1 / 6997  # never a whole number of steps to the grid
    for grown, _ in both(break_shot(), dt, 2.0):
        grown.compute(1.0)
        times = grown.sample_times
        assert len(times) < 2.1 * GRID_HZ
        for tick in range(1, 120):
            k = int(np.searchsorted(times, tick / GRID_HZ, side="right"))
            assert times[k] - times[k - 1] == pytest.approx(dt, rel=1e-6)


@pytest.mark.parametrize("dt", [0.05, 1 / 240, 1 / 480, 1 / 241, 1 / 20000, 3.7e-4])
def test_stops_go_on(dt):
    step = 0
    for _ in range(2000):
        after = next_stop(step, dt)
        assert step < after <= step + max(1.0, 1.0 / (GRID_HZ * dt))
        step = after


@pytest.mark.parametrize("dt", [1 / 19997, 1 / 6997, 3.7e-4])
def test_stops_are_the_steps_around_each_tick_of_the_grid(dt):
    stops = [0]
    while stops[-1] < 900:
        stops.append(next_stop(stops[-1], dt))
    last = [math.floor(tick / GRID_HZ / dt * (1.0 + 1e-12)) for tick in range(1, 10_000)]
    around = sorted({0, *last, *(step + 1 for step in last)})
    assert stops == around[: len(stops)]


def test_it_is_broken_off_at_a_whole_step():
    for grown, _ in both(break_shot(physics=FRICTIONLESS), 0.03, 1.0):
        grown.compute(5.0)
        assert grown.complete and grown.end_time == pytest.approx(33 * 0.03)


def test_what_is_absurd_is_refused():
    shot = break_shot()
    with pytest.raises(ShotError, match="dt"):
        grow_lecture(shot, 0.0, 60.0)
    with pytest.raises(ShotError, match="until"):
        grow_stepped(shot, 0.01, 4, math.inf)
    with pytest.raises(ShotError, match="passes"):
        grow_stepped(shot, 0.01, 0, 60.0)
