"""Which balls may meet, and when: whole vectors of balls against one ball at a time."""

import math

import numpy as np
import pytest

from game.billiards import Physics, Table, make_shot, simulate
from game.billiards.exact import pairs
from game.billiards.laws import state as s
from game.billiards.laws.batch import view_workspace, workspace
from game.billiards.laws.lean import lean_kernel
from game.billiards.table.rack import BALL_RADIUS

R = BALL_RADIUS


@lean_kernel
def bits_of(floats, integers, n, i, start, count):
    """`may_meet` of ball i, with an entrance."""
    arrays = view_workspace(floats, integers, n)
    return pairs.may_meet(arrays.state, arrays.modes, arrays.pairs, i, start, count)


@lean_kernel
def time_of(floats, integers, n, i, j, now):
    """`contact_time` of balls i and j, with an entrance."""
    return pairs.contact_time(view_workspace(floats, integers, n).state, i, j, now)


def _moving_balls(n):
    """A workspace of n balls that roll about on 2 m of cloth for 1 s to 2 s; each third of them is pocketed.

    Also its state (rows, n), motions (n,) and which contacts are foreseen (n, n).
    """
    draw = np.random.default_rng(n)
    work = workspace(n)
    state = work.floats[: s.FLOAT_ROWS * n].reshape(s.FLOAT_ROWS, n)
    motions = work.integers[:n]
    state[s.X], state[s.Y] = draw.uniform(0.0, 2.0, (2, n))
    state[s.VX], state[s.VY] = draw.uniform(-3.0, 3.0, (2, n))
    state[s.AX], state[s.AY] = -0.1 * state[s.VX], -0.1 * state[s.VY]
    state[s.RADIUS], state[s.OWN_TIME] = R, draw.uniform(1.0, 2.0, n)
    motions[:] = np.where(np.arange(n) % 3 == 2, s.POCKETED, s.ROLLING)
    foreseen = draw.random((n, n)) < 0.2
    meets = work.floats[s.FLOAT_ROWS * n : (s.FLOAT_ROWS + n) * n].reshape(n, n)
    meets[:] = np.where(foreseen, 0.5, s.NEVER)
    return work, motions, foreseen


@pytest.mark.parametrize("n", [1, 2, 3, 4, 6, 7, 8, 9, 15, 16, 22, 31, 32, 33, 41, 64])
def test_vectors_of_balls_miss_no_contact(n):
    """Each ball's bits stand in their own places, whatever vector it came in; none is beyond the last."""
    work, motions, expected = _moving_balls(n)
    held = met = 0
    for i in range(n):
        for start in range(0, n, pairs.BLOCK):
            count = min(pairs.BLOCK, n - start)
            bits, foreseen = bits_of(*work, n, i, start, count)
            assert bits >> count == 0 == foreseen >> count
            for j in set(range(start, start + count)) - {i}:
                held += bits >> (j - start) & 1
                assert foreseen >> (j - start) & 1 == expected[i, j]
                if motions[j] == s.POCKETED:
                    assert not bits >> (j - start) & 1
                elif time_of(*work, n, i, j, 0.0) < s.AT_REST:
                    assert bits >> (j - start) & 1
                    met += 1
    assert n < 15 or 0 < met <= held < n * n // 3


@pytest.mark.parametrize("cue", [0, 3])
def test_balls_that_lie_still_are_looked_at_when_they_touch(cue):
    """Three that touch are hit as one body, as they are if they spin in place, which changes no path here."""
    places = [[0.6, 1.0], [0.6 - R, 1.0 + R * math.sqrt(3.0)], [0.6 + R, 1.0 + R * math.sqrt(3.0)]]
    places.insert(cue, [0.61, 0.8])

    def end(wz):
        shot = make_shot(Table.open(), places, spins=[[0.0, 0.0, wz]], physics=Physics("elastic"))
        return simulate(shot.struck(cue, (0.0, 2.0)), until=0.3).state_at(0.3)

    still, spinning = end(0.0), end(100.0)
    assert np.all(np.hypot(*still.velocities.T) > 0.005)
    assert np.array_equal(still.velocities, spinning.velocities)
    assert np.array_equal(still.positions, spinning.positions)
