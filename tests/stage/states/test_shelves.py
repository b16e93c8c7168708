"""What a ring of snapshots keeps, to the byte."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import pytest

from game.stage.states.memory import Memory
from game.stage.states.snapshots import BYTES_PER_STEP, INTERVAL, OVERHEAD, Snapshot, SnapshotRing


class Numbers(NamedTuple):
    """numbers: (n,)."""

    numbers: np.ndarray


def snapshot(step: int, numbers: int = 100, events: int = 0, **values: float) -> Snapshot:
    return Snapshot(step, 0.01, 0.0, 0, events, values, None, Numbers(np.zeros(numbers)), Memory({}, 0))


WEIGHT = snapshot(0).bytes
# seven eighths are for the rare ones, an eighth for those made on the way back
SHARES = [(8 * WEIGHT, 7, 1), (8 * WEIGHT - 8, 6, 0), (16 * WEIGHT, 14, 2)]


def test_a_snapshot_weighs_its_state_its_values_and_what_comes_with_it():
    bare = snapshot(0, 0).bytes
    assert bare >= OVERHEAD and bare + 800 == WEIGHT
    assert snapshot(0, a=1.0, b=2.0).bytes == WEIGHT + 200
    assert snapshot(0)._replace(memory=Memory({}, 55)).bytes == WEIGHT + 55


@pytest.mark.parametrize(("budget", "rare", "dense"), SHARES)
def test_as_many_are_kept_as_the_budget_holds_exactly(budget, rare, dense):
    ring = SnapshotRing(budget)
    for step in range(20):
        ring.add(snapshot(10 * step, events=step))
        assert len(ring) == min(step + 1, rare)
    assert (ring.first_step, ring.last_step) == (10 * (20 - rare), 190)
    assert ring.first_event == 20 - rare and ring.bytes == rare * WEIGHT
    assert ring.dense_room(snapshot(0)) == dense
    for step in (191, 192, 193, 194):
        ring.add_dense(snapshot(step))
    assert ring.bytes == (rare + dense) * WEIGHT and ring.last_step == 190
    assert ring.before(194).step == (194 if dense else 190)
    assert ring.before(193 if dense == 2 else 190).step == (193 if dense == 2 else 190)
    ring.forget_dense_after(190)
    assert ring.before(500).step == 190 and ring.bytes == rare * WEIGHT


def test_the_one_that_is_too_large_stands_alone_and_is_not_kept_on_the_way_back():
    ring = SnapshotRing(8 * WEIGHT)
    for step in range(3):
        ring.add(snapshot(step))
    ring.add(snapshot(3, 10_000))
    assert len(ring) == 1 and ring.first_step == ring.last_step == 3
    ring.add_dense(snapshot(2, 101))
    assert ring.bytes == snapshot(3, 10_000).bytes
    with pytest.raises(LookupError, match=r"^step 2 is out of reach$"):
        ring.before(2)


def test_a_step_is_kept_once_and_later_ones_are_forgotten_with_their_bytes():
    ring = SnapshotRing(80 * WEIGHT)
    for step in (0, 30, 60, 30, 90):
        ring.add(snapshot(step))
    ring.add_dense(snapshot(45))
    assert len(ring) == 4 and ring.bytes == 5 * WEIGHT
    assert [ring.before(step).step for step in (0, 29, 30, 44, 45, 59, 60, 1000)] == [
        0,
        0,
        30,
        30,
        45,
        45,
        60,
        90,
    ]
    ring.forget_after(45)
    assert [ring.before(1000).step, ring.last_step, ring.bytes] == [45, 30, 3 * WEIGHT]
    ring.forget_after(44)
    assert [ring.before(1000).step, ring.bytes] == [30, 2 * WEIGHT]
    ring.forget_after(-1)
    assert ring.bytes == 0 and len(ring) == 0


@pytest.mark.parametrize("budget", [-1, 1.5, True, None])
def test_a_budget_that_is_none_is_refused(budget):
    with pytest.raises(
        ValueError, match=r"^snapshot_bytes = .*: expected a whole number of bytes, 0 or more$"
    ):
        SnapshotRing(budget)
    SnapshotRing(0)


def test_large_states_are_copied_less_often():
    ring = SnapshotRing(0)
    for size, steps in ((10, INTERVAL), (BYTES_PER_STEP * INTERVAL // 8, INTERVAL + 1)):
        assert ring.interval(snapshot(0, size)) == steps
    exact = (BYTES_PER_STEP * 40 - snapshot(0, 0).bytes) // 8
    assert snapshot(0, exact).bytes == BYTES_PER_STEP * 40
    assert (ring.interval(snapshot(0, exact)), ring.interval(snapshot(0, exact + 1))) == (40, 41)
