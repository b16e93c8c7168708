"""What a step of the wind tunnel costs on 144 x 72 cells, and a frame of flight by a series.

python -m pytest tests/benchmarks/test_tunnel.py --benchmark-enable
"""

from __future__ import annotations

import numpy as np

from game.physics.plates import Plate
from game.physics.tunnel import DataFlight, SeriesFit, Tunnel, TunnelSettings, shape_named


def test_step(benchmark):
    benchmark.group = "wind tunnel, 144 x 72"
    tunnel = Tunnel(shape_named("aerofoil"), TunnelSettings(reynolds=300.0), 0.4)
    for _ in range(60 if benchmark.enabled else 2):
        tunnel.step()
    benchmark.pedantic(tunnel.step, rounds=60, warmup_rounds=2)
    assert tunnel.gas.report.after <= 1e-3


def test_flight(benchmark):
    benchmark.group = "flight by a series of order 6, a frame"
    coefficients = np.zeros((3, 13))
    coefficients[:, 0] = 1.0, 0.2, 0.0
    flight = DataFlight(Plate(0.05, 1.4), SeriesFit(6, coefficients, np.zeros(3)))
    benchmark(flight.step, 1.0 / 60.0)
    assert np.isfinite(flight.row).all()
