"""What wave particles cost: a step, heights on the grid, floats; ns a particle by the processor's time.

python -m pytest tests/benchmarks/test_wave_particles.py --benchmark-enable
"""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.waves.floats import FloatingBodies
from game.physics.waves.wave_particles import ANGLE, WaveParticles, WaveSettings

SIZE, DT = (16.0, 9.0), 1.0 / 60.0


def pond(count: int) -> WaveParticles:
    """So many particles that go on without dividing."""
    water = WaveParticles(SIZE, (0.25,), 0.05, WaveSettings(lowest=0.0, fading=0.0), count)
    rng = np.random.default_rng(2)
    while water.count < count - 100:
        water.drop(tuple((rng.random(2) * SIZE).tolist()), 0.02)
    water.fields[ANGLE] = 0.0
    water.step(DT)
    water.find_heights()
    return water


@pytest.mark.parametrize("count", [10_000, 100_000])
def test_step(benchmark, count):
    benchmark.group = "wave particles"
    water = pond(count)
    before = water.count
    benchmark.pedantic(water.step, (DT,), rounds=30, warmup_rounds=2)
    assert water.count == before


def test_heights(benchmark):
    benchmark.group = "wave particles"
    water = pond(100_000)
    benchmark.pedantic(water.find_heights, rounds=20, warmup_rounds=1)
    assert np.isfinite(water.heights).all()


def test_floats(benchmark):
    benchmark.group = "wave particles"
    water = pond(10_000)
    floats = FloatingBodies(water)
    for x, y in (np.random.default_rng(3).uniform(0.05, 0.95, (300, 2)) * SIZE).tolist():
        floats.add((x, y), 0.15, 0.16, 0.5)
    benchmark.pedantic(floats.step, (DT,), rounds=30, warmup_rounds=2)
    assert np.isfinite(floats.rows).all()
