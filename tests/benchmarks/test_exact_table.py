"""How fast the exact table is: microseconds a shot, and where they go. Run with --benchmark-enable."""

import math

import numpy as np
import pytest

from game.billiards import Physics, Table, make_shot, simulate, simulate_many
from game.billiards.exact.play import play_shots
from game.billiards.many import play_batch
from game.billiards.shot.shot import batch_of
from game.billiards.simulation import MAX_EVENTS, log_for, workspace_for
from game.billiards.table.rack import BALL_RADIUS
from game.lab.benchmarks.billiards import BATCH, break_shot, cut_shot, random_shots
from game.lab.studies.billiards.flights import stroke_at

R = BALL_RADIUS


def _events(run):
    return sum(len(rows) for rows in run.rows)


@pytest.mark.parametrize("gap", [1e-4, 0.0], ids=["spaced rack", "touching rack"])
def testbreak_shot(benchmark, gap):
    """Goal: 60 microseconds, called from Python, with the array of events and all paths."""
    shot = break_shot(gap)
    trajectory = benchmark(simulate, shot)
    benchmark.extra_info["events"] = len(trajectory.rows)
    assert len(trajectory.rows) > 50


def test_break_with_the_list_of_events(benchmark):
    shot = break_shot(1e-4)
    events = benchmark(lambda: simulate(shot).events)
    assert events[0].type in ("ball-ball", "sliding-rolling")


def test_break_in_the_kernel_alone(benchmark):
    shot = break_shot(1e-4)
    log = log_for(1, 16, 4096)
    arguments = (*workspace_for(16), *shot.batch, *log, 0, math.inf, MAX_EVENTS)
    assert benchmark(play_shots, *arguments) == 1
    benchmark.extra_info["events"] = int(log.ends[0, 1])


def test_cut_in_a_batch(benchmark):
    """Goal: 1.5 microseconds a shot."""
    batch = batch_of([cut_shot()] * BATCH)
    benchmark.extra_info["shots"] = BATCH
    parts = benchmark(play_batch, batch, math.inf, MAX_EVENTS)
    assert sum(end - first for _, first, end in parts) == BATCH


@pytest.mark.parametrize("n", [2, 5, 9, 16])
def test_random_shots_in_a_batch(benchmark, n):
    """Goals: 1.1, 1.7, 2.8 and 4 microseconds a shot."""
    shots = random_shots(n)
    batch = batch_of(shots)
    benchmark.extra_info["shots"] = BATCH
    benchmark.extra_info["events"] = _events(simulate_many(shots, threads=1))
    parts = benchmark(play_batch, batch, math.inf, MAX_EVENTS)
    assert sum(end - first for _, first, end in parts) == BATCH


@pytest.mark.parametrize("elevation", [0.1, 40.0], ids=["level", "raised"])
def test_jump_shot(benchmark, elevation):
    """A raised cue pays for some eight bounces; one that makes no ball hop must cost what it did."""
    trajectory = benchmark(simulate, stroke_at(elevation, True))
    benchmark.extra_info["events"] = len(trajectory.rows)
    assert trajectory.shot.flies == (elevation > 1.0)


@pytest.mark.parametrize("balls", [4, 5])
def test_cradle(benchmark, balls):
    """Goal: 200 microseconds for five balls, on cloth: a train that chatters while it is pushed."""
    places = [[0.3, 1.0]] + [[0.6 + 2.0 * R * k, 1.0] for k in range(balls)]
    shot = make_shot(Table.open(), places, physics=Physics("wallace-1988")).struck(0, (1.4, 0.0))
    trajectory = benchmark(simulate, shot)
    benchmark.extra_info["events"] = len(trajectory.rows)
    assert np.argmax(trajectory.end[:, 0]) == balls


def test_state_at_a_time(benchmark):
    """One frame of a picture of 16 balls."""
    trajectory = simulate(break_shot(1e-4))
    state = benchmark(trajectory.state_at, 0.7)
    assert state.positions.shape == (16, 2)


def test_orientations_at_a_time(benchmark):
    trajectory = simulate(break_shot(1e-4))
    turned = benchmark(trajectory.orientations_at, 0.7)
    assert turned.shape == (16, 3, 3)
