"""What a step of shallow water costs: ns a cell, by the processor's time; in a channel and in a basin.

python -m pytest tests/benchmarks/test_waves.py --benchmark-enable
"""

from __future__ import annotations

import time
import timeit

import numpy as np
import pytest

from game.physics.waves import ShallowSettings, ShallowWater


def waving(ny: int, nx: int, method: int) -> ShallowWater:
    """Water with a hump that spreads over an uneven bed, some steps old."""
    y, x = np.mgrid[0:ny, 0:nx] * (10.0 / nx)
    bed = 0.2 * np.sin(3.0 * x) * np.cos(2.0 * y)
    depth = 1.0 - bed + 0.4 * np.exp(-((x - 5.0) ** 2 + (y - y.mean()) ** 2))
    water = ShallowWater(depth, bed, 10.0 / nx, ShallowSettings(method=method))
    water.advance(0.05)
    return water


@pytest.mark.parametrize("method", [0, 1], ids=["constant", "linear"])
@pytest.mark.parametrize(("ny", "nx"), [(1, 2000), (128, 128)], ids=["channel", "basin"])
def test_step(benchmark, ny, nx, method):
    benchmark.group = "shallow water"
    water = waving(ny, nx, method)
    volume = water.volume()
    dt = 0.5 * water.longest_step()
    benchmark.pedantic(water.step, (dt,), rounds=60, warmup_rounds=2)
    if benchmark.enabled:
        quickest = min(timeit.repeat(lambda: water.step(dt), time.thread_time, number=1, repeat=300))
        benchmark.extra_info["ns a cell"] = 1e9 * quickest / (nx * ny)
    assert water.volume() == pytest.approx(volume, rel=1e-12)
