"""What a step of a rigid body costs: ten methods in a batch, beside numpy, and the exact solution.

python -m pytest tests/benchmarks/test_rigid_body.py --benchmark-enable
"""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from game.lab.benchmarks.rigid import BODIES, DT, MOMENTS, STEPS, NumpyBodies, batch, runner
from game.physics.rigid import METHODS, FreeTop
from game.physics.rigid.motion import advance


@pytest.mark.parametrize("method", METHODS)
def test_batch(benchmark, method):
    """Extra info: microseconds for one step of one body; the goal is 1."""
    benchmark.group = f"{STEPS} steps of {BODIES} bodies"
    run, states = runner(method)
    benchmark(run)
    if benchmark.enabled:
        benchmark.extra_info["us a body step"] = benchmark.stats.stats.min / (BODIES * STEPS) * 1e6
    lengths = np.sqrt((states[:, 3:7] ** 2).sum(axis=1))
    assert np.allclose(lengths, 1.0, rtol=0, atol=1e-15 * 4)


def test_batch_with_numpy(benchmark):
    benchmark.group = f"{STEPS} steps of {BODIES} bodies"
    bodies = NumpyBodies(batch()[0])
    benchmark(bodies.run)
    assert np.isfinite(bodies.states).all()


def test_numpy_twin_goes_the_same_way():
    states, constants, loads = batch(50)
    twin = NumpyBodies(states)
    for _ in range(20):
        twin.step(DT)
    advance(0, states, constants, loads, (0.0, 1.0), 1, 1, DT, 20)
    assert np.allclose(twin.states, states, rtol=0, atol=1e-12)


def test_splitting_with_scipy_rotations(benchmark):
    """One body, one step, with a library's rotations: what the batch spares."""
    benchmark.group = "one step of one body by the splitting"
    turn = Rotation.from_quat((0.1, 0.2, 0.3, 0.9))
    angular = np.array((1.0, 2.0, 3.0))

    def step():
        now = turn
        for axis, share in ((0, 0.5), (1, 0.5), (2, 1.0), (1, 0.5), (0, 0.5)):
            body = now.inv().apply(angular)
            vector = np.zeros(3)
            vector[axis] = share * DT * body[axis] / MOMENTS[axis]
            now = now * Rotation.from_rotvec(vector)
        return now

    after = benchmark(step)
    states = np.zeros((1, 13))
    x, y, z, w = turn.as_quat()
    states[0, 3:7], states[0, 10:] = (w, x, y, z), angular
    _, constants, loads = batch(1)
    advance(METHODS.index("splitting"), states, constants, loads, (0.0, 1.0), 1, 1, DT, 1)
    x, y, z, w = after.as_quat()
    mine = states[0, 3:7]
    assert np.allclose(mine, (w, x, y, z), atol=1e-14) or np.allclose(mine, (-w, -x, -y, -z), atol=1e-14)


def test_exact_spin(benchmark):
    benchmark.group = "exact spin at one instant"
    top = FreeTop(MOMENTS, (1.0, 0.5, 2.0))
    spin = benchmark(top.spin, 10.0)
    assert np.allclose(spin, (0.314985781916866, 1.072745989128, 1.92347047831169), rtol=0, atol=1e-12)
