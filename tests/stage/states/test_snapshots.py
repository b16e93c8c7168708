"""The budget of snapshots is a promise about memory; the rest of the ring is about order."""

from __future__ import annotations

import gc
import tracemalloc
from typing import NamedTuple

import numpy as np
import pytest

from game.stage import Scene, Stage
from game.stage.states.memory import Memory
from game.stage.states.snapshots import INTERVAL, Snapshot, SnapshotRing
from tests.stage.example_scene import KICK, BouncingBall


class Heavy(NamedTuple):
    """numbers: (n,)."""

    numbers: np.ndarray


class HeavyScene(Scene):
    """A state of half a megabyte."""

    name, task, title = "heavy", "X03", "Heavy"

    def build(self, level):
        self.heavy = Heavy(np.zeros(65_536))

    def advance(self, dt):
        self.heavy.numbers[0] += dt

    def state(self):
        return self.heavy


def snapshot(step: int, numbers: int = 100) -> Snapshot:
    return Snapshot(step, 0.01, 0.0, 0, 0, {}, None, Heavy(np.zeros(numbers)), Memory({}, 0))


class TestBudget:
    @pytest.mark.parametrize("budget", [600_000, 2_000_000, 8_000_000])
    def test_it_holds_for_what_is_counted(self, budget: int) -> None:
        stage = Stage(HeavyScene, snapshot_bytes=budget)
        for _ in range(40):
            stage.run(100)
            assert stage.snapshot_bytes <= budget
        while stage.step_back() and stage.step_number > 3700:
            assert stage.snapshot_bytes <= budget

    def test_it_holds_for_memory_as_measured(self) -> None:
        budget = 8_000_000
        stage = Stage(HeavyScene, snapshot_bytes=budget, record=False)
        stage.run(100)
        gc.collect()
        tracemalloc.start()
        try:
            stage.run(10_000)
            gc.collect()
            taken, _ = tracemalloc.get_traced_memory()
        finally:
            tracemalloc.stop()
        assert 0.5 * budget < taken < 1.05 * budget

    def test_what_small_snapshots_are_counted_as_is_no_less_than_what_they_take(self) -> None:
        stage = Stage(BouncingBall, snapshot_bytes=300_000, record=False)
        stage.run(100)
        gc.collect()
        tracemalloc.start()
        try:
            stage.run(20_000)
            gc.collect()
            taken, _ = tracemalloc.get_traced_memory()
        finally:
            tracemalloc.stop()
        assert taken < 1.05 * 300_000

    def test_the_newest_is_kept_even_if_it_is_too_large(self) -> None:
        stage = Stage(HeavyScene, snapshot_bytes=0)
        stage.run(100)
        assert stage.first_step > 0
        while stage.step_back():
            pass
        assert stage.step_number == stage.first_step

    def test_memory_stays_flat_over_a_simulated_hour(self) -> None:
        stage = Stage(BouncingBall, snapshot_bytes=200_000, record=False, dt=0.1)
        stage.run(18_000)
        gc.collect()
        tracemalloc.start()
        try:
            before, _ = tracemalloc.get_traced_memory()
            for _ in range(18):
                stage.post(KICK)
                stage.run(1_000)
            gc.collect()
            after, _ = tracemalloc.get_traced_memory()
        finally:
            tracemalloc.stop()
        assert after - before < 250_000

    @pytest.mark.parametrize("budget", [-1, 1.5, True, None])
    def test_a_budget_is_a_count_of_bytes(self, budget) -> None:
        with pytest.raises(ValueError, match="snapshot_bytes"):
            SnapshotRing(budget)


class TestRing:
    def test_the_latest_before_a_step(self) -> None:
        ring = SnapshotRing(1 << 20)
        for step in (0, 30, 60):
            ring.add(snapshot(step))
        assert [ring.before(step).step for step in (0, 29, 30, 59, 60, 1000)] == [0, 0, 30, 30, 60, 60]

    def test_out_of_reach(self) -> None:
        ring = SnapshotRing(2_500)
        for step in (0, 30, 60):
            ring.add(snapshot(step))
        assert ring.first_step > 0
        with pytest.raises(LookupError, match="out of reach"):
            ring.before(0)

    def test_one_for_each_step(self) -> None:
        ring = SnapshotRing(1 << 20)
        ring.add(snapshot(5))
        ring.add(snapshot(5))
        assert len(ring) == 1

    def test_the_dense_ones_serve_too(self) -> None:
        ring = SnapshotRing(1 << 20)
        ring.add(snapshot(0))
        ring.add_dense(snapshot(7))
        assert ring.before(9).step == 7

    def test_walking_back_copies_no_more_than_it_can_keep(self) -> None:
        """Eight of these states fit into the dense share: each ninth step back or so goes to a snapshot."""
        copies = []

        class Counted(HeavyScene):
            def advance(self, dt):
                copies.append("step")
                super().advance(dt)

        stage = Stage(Counted, snapshot_bytes=8 * 8 * 600_000)
        stage.run(300)
        copies.clear()
        for _ in range(64):
            stage.step_back()
        interval = SnapshotRing(0).interval(stage._session._snapshot())
        assert len(copies) <= (64 / 8 + 1) * interval

    def test_forgetting_what_comes_after(self) -> None:
        ring = SnapshotRing(1 << 20)
        for step in (0, 30, 60):
            ring.add(snapshot(step))
        ring.add_dense(snapshot(31))
        ring.forget_after(30)
        assert ring.before(99).step == 30

    def test_large_states_are_copied_more_rarely(self) -> None:
        ring = SnapshotRing(1 << 20)
        assert ring.interval(snapshot(0)) == INTERVAL
        assert ring.interval(snapshot(0, 1_000_000)) > 400
