"""Many shots at once give what each gives alone, over any number of threads."""

import math

import numpy as np
import pytest

from game.billiards import Physics, SimulationError, Table, make_shot, simulate, simulate_many
from game.billiards.many import CHUNK
from game.billiards.shot.physics import FRICTIONLESS

POOL = Table.pool()


def _shots(count):
    rng = np.random.default_rng(11)
    shots = []
    for k in range(count):
        places = [[0.3, 0.4], [0.7, 1.3], [0.9, 2.0], [0.4, 1.9]][: 2 + k % 3]
        table = POOL if k % 2 else Table.bare(1.27, 2.54)
        shot = make_shot(table, places, physics=Physics("wallace-1988", "restitution"))
        angle = rng.uniform(0.0, 2.0 * math.pi)
        shots.append(
            shot.struck(0, (2.0 * math.cos(angle), 2.0 * math.sin(angle)), rng.uniform(-40.0, 40.0, 3))
        )
    return shots


def test_equal_to_one_by_one_over_any_threads():
    shots = _shots(2 * CHUNK + 37)
    runs = [simulate_many(shots, threads=threads) for threads in (1, 2, 4)]
    for i in range(0, len(shots), 29):
        alone = simulate(shots[i])
        for run in runs:
            assert np.array_equal(run.rows[i], alone.rows)
            assert np.array_equal(run.ends[i], alone.end)
            assert run.end_times[i] == alone.end_time
    assert runs[0][5].digest == simulate(shots[5]).digest
    assert [t.digest for t in runs[1][2:5]] == [simulate(s).digest for s in shots[2:5]]
    assert len(runs[0]) == len(shots)


def test_until_holds_for_all():
    shots = [make_shot(Table.bare(1.0, 1.0), [[0.5, 0.5]], [(1.0, 0.3)], physics=FRICTIONLESS)] * 3
    run = simulate_many(shots, until=10.0)
    assert run.end_times.tolist() == [10.0] * 3 and run[1].end_time == 10.0


def test_more_events_than_first_thought():
    shots = [make_shot(Table.bare(1.0, 1.0), [[0.5, 0.5]], [(3.0, 1.0)], physics=FRICTIONLESS)] * 5
    run = simulate_many(shots, until=1000.0)
    assert all(len(rows) == len(run.rows[0]) > 3000 for rows in run.rows)


def test_limits():
    assert len(simulate_many([])) == 0
    with pytest.raises(ValueError, match="threads"):
        simulate_many(_shots(1), threads=0)
    with pytest.raises(SimulationError, match="more than 5 events"):
        simulate_many(_shots(3), max_events=5)
