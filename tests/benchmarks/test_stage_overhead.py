"""What the stage adds to a scene's own step: time, snapshots, digests and the test for NaN included."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import pytest

from game.stage import Readout, Scene, Stage


class Sixteen(NamedTuple):
    """As many arrays as a table of sixteen balls has."""

    positions: np.ndarray
    velocities: np.ndarray
    orientations: np.ndarray
    spins: np.ndarray
    radii: np.ndarray
    masses: np.ndarray
    pocketed: np.ndarray


class Idle(Scene):
    """Its step does nothing, so that all that is measured is the stage."""

    name, task, title = "idle", "X06", "Idle"

    def build(self, level):
        self.arrays = Sixteen(
            *(np.zeros((16, width)) for width in (2, 2, 4, 3)),
            *np.zeros((2, 16)),
            np.zeros(16, dtype=np.int64),
        )

    def advance(self, dt):
        pass

    def state(self):
        return self.arrays

    def readouts(self):
        return [Readout("energy", 1.0, "J"), Readout("momentum", 1.0, "kg m/s")]


@pytest.mark.parametrize("record", [True, False])
def test_a_thousand_steps(benchmark, record: bool) -> None:
    stage = Stage(Idle, record=record)
    stage.run(1000)
    benchmark.pedantic(stage.run, (1000,), rounds=20)
    assert stage.fault is None


@pytest.mark.parametrize("bodies", [16, 1000, 100_000])
def test_is_it_finite(benchmark, bodies: int) -> None:
    from game.stage.watch import FiniteWatch

    class State(NamedTuple):
        positions: np.ndarray
        velocities: np.ndarray

    watch, state = FiniteWatch(), State(np.zeros((bodies, 2)), np.zeros((bodies, 2)))
    watch.first_bad(state)
    assert benchmark(watch.first_bad, state) is None
