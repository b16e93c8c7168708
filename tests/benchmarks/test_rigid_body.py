"""What a step of a rigid body costs: ten methods in a batch, beside numpy, and the exact solution.

python -m pytest tests/benchmarks/test_rigid_body.py --benchmark-enable
"""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from game.physics.rigid import METHODS, FreeTop
from game.physics.rigid.motion import advance

BODIES, STEPS, DT = 1_000, 10, 1 / 60
MOMENTS = np.array((1.0, 2.0, 3.0))


def batch(count=BODIES):
    """States (n, 13), constants (n, 7), loads (n, 6) of bodies that all turn differently."""
    generator = np.random.default_rng(12)
    states = np.zeros((count, 13))
    q = generator.standard_normal((count, 4))
    states[:, 3:7] = q / np.sqrt((q * q).sum(axis=1, keepdims=True))
    states[:, 7:] = generator.standard_normal((count, 6))
    constants = np.tile(np.concatenate(((1.0,), MOMENTS, 1.0 / MOMENTS)), (count, 1))
    return states, constants, np.zeros((count, 6))


class NumpyBodies:
    """Explicit Euler of x, q, P, L, all bodies at a time, as one writes it with numpy."""

    def __init__(self, states):
        self.states = states.copy()

    def step(self, dt):
        q, momentum, angular = self.states[:, 3:7], self.states[:, 7:10], self.states[:, 10:]
        w, u = q[:, :1], q[:, 1:]
        t = 2.0 * np.cross(-u, angular)
        body = (angular + w * t + np.cross(-u, t)) / MOMENTS
        t = 2.0 * np.cross(u, body)
        spin = body + w * t + np.cross(u, t)
        self.states[:, :3] += dt * momentum
        change = np.concatenate(
            (-(spin * u).sum(axis=1, keepdims=True), w * spin + np.cross(spin, u)), axis=1
        )
        q = q + 0.5 * dt * change
        self.states[:, 3:7] = q / np.sqrt((q * q).sum(axis=1, keepdims=True))


@pytest.mark.parametrize("method", METHODS)
def test_batch(benchmark, method):
    """Extra info: microseconds for one step of one body; the goal is 1."""
    benchmark.group = f"{STEPS} steps of {BODIES} bodies"
    states, constants, loads = batch()
    start, number = states.copy(), METHODS.index(method)

    def run():
        states[:] = start
        advance(number, states, constants, loads, 0.0, 1.0, 1, 1, DT, STEPS)

    benchmark(run)
    if benchmark.enabled:
        benchmark.extra_info["us a body step"] = benchmark.stats.stats.min / (BODIES * STEPS) * 1e6
    lengths = np.sqrt((states[:, 3:7] ** 2).sum(axis=1))
    assert np.allclose(lengths, 1.0, rtol=0, atol=1e-15 * 4)


def test_batch_with_numpy(benchmark):
    benchmark.group = f"{STEPS} steps of {BODIES} bodies"
    bodies = NumpyBodies(batch()[0])

    def run():
        for _ in range(STEPS):
            bodies.step(DT)

    benchmark(run)
    assert np.isfinite(bodies.states).all()


def test_numpy_twin_goes_the_same_way():
    states, constants, loads = batch(50)
    twin = NumpyBodies(states)
    for _ in range(20):
        twin.step(DT)
    advance(0, states, constants, loads, 0.0, 1.0, 1, 1, DT, 20)
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
    advance(METHODS.index("splitting"), states, constants, loads, 0.0, 1.0, 1, 1, DT, 1)
    x, y, z, w = after.as_quat()
    mine = states[0, 3:7]
    assert np.allclose(mine, (w, x, y, z), atol=1e-14) or np.allclose(mine, (-w, -x, -y, -z), atol=1e-14)


def test_exact_spin(benchmark):
    benchmark.group = "exact spin at one instant"
    top = FreeTop(MOMENTS, (1.0, 0.5, 2.0))
    spin = benchmark(top.spin, 10.0)
    assert np.allclose(spin, (0.314985781916866, 1.072745989128, 1.92347047831169), rtol=0, atol=1e-12)
