"""What particles cost: against numpy, effect by effect. Ratios are printed; nothing fails for a slow machine.

python -m pytest tests/benchmarks/test_particles.py --benchmark-enable
"""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.effects import EffectSet
from game.physics.fields import DRAG, GRAVITY, GROUND, WIND
from game.physics.particles import METHODS, OBSTACLES, Discs, Emitter, ParticleSystem

EFFECTS = {
    "bare": EffectSet(),
    "gravity": EffectSet([GRAVITY]),
    "gravity, drag": GRAVITY | DRAG,
    "gravity, drag, wind": GRAVITY | DRAG | WIND,
    "gravity, stone": GRAVITY | OBSTACLES,
    "gravity, ground": GRAVITY | GROUND,
    "all": GRAVITY | DRAG | WIND | OBSTACLES | GROUND,
}


def _only_measured(benchmark):
    """Each of these compiles a kernel of its own; other tests show that they are right."""
    if not benchmark.enabled:
        pytest.skip("measured only with --benchmark-enable")


def swarm(count, effects, method="verlet", capacity=0):
    """A fountain in its steady state, made at once: ages spread over the life."""
    system = ParticleSystem(
        capacity or count, solids=Discs([(0.2, 2.4)], [0.45]), effects=effects, method=method, life=1e9
    )
    rng = np.random.default_rng(1)
    age, angle = np.sort(rng.random(count))[::-1] * 1.8, (rng.random(count) - 0.5) * 0.5
    x, y = 9 * np.sin(angle) * age, 9 * np.cos(angle) * age - 4.905 * age**2
    y = np.maximum(y, 0.0)
    x = np.where((x - 0.2) ** 2 + (y - 2.4) ** 2 < 0.46**2, 5.0, x)  # nobody begins in the stone
    system.add(np.stack([x, y], 1), np.stack([9 * np.sin(angle), 9 * np.cos(angle) - 9.81 * age], 1))
    return system


class NumpySwarm:
    """The same Verlet step in place with numpy: the peer."""

    def __init__(self, system):
        (self.x, self.y), (self.vx, self.vy) = system.positions.T.copy(), system.velocities.T.copy()
        self.room = np.empty_like(self.x)

    def step(self, h):
        np.multiply(self.vx, h, out=self.room)
        self.x += self.room
        np.multiply(self.vy, h, out=self.room)
        self.y += self.room
        self.y -= 0.5 * 9.81 * h * h
        self.vy -= 9.81 * h


@pytest.mark.parametrize("count", [10_000, 100_000, 1_000_000])
@pytest.mark.parametrize("who", ["kernel", "numpy"])
def test_gravity_step(benchmark, who, count):
    benchmark.group = f"Verlet, gravity, {count} particles"
    count = count if benchmark.enabled else 100
    system = swarm(count, EFFECTS["gravity"])
    step = system.step if who == "kernel" else NumpySwarm(system).step
    benchmark(step, 1e-6)
    assert len(system) == count


@pytest.mark.parametrize("name", EFFECTS)
def test_effects_of_a_step(benchmark, name):
    """Each effect's cost; one that is not declared costs nothing beside the bare step."""
    _only_measured(benchmark)
    benchmark.group = "effects, 100 000 particles"
    system = swarm(100_000, EFFECTS[name])
    benchmark(system.step, 1e-6)
    system.check()


@pytest.mark.parametrize("method", METHODS)
def test_methods(benchmark, method):
    _only_measured(benchmark)
    benchmark.group = "methods, gravity and drag, 100 000 particles"
    system = swarm(100_000, GRAVITY | DRAG, method)
    benchmark(system.step, 1e-6)
    system.check()


def test_live_fountain_of_a_hundred_thousand(benchmark):
    """Births, deaths, drag, wind, stone and ground: a step of 1/120 s in the steady state."""
    benchmark.group = "live fountain, 100 000 particles"
    system = ParticleSystem(
        110_000, emitters=[Emitter(rate=100_000 / 2.4, spread=0.3)], solids=Discs([(0.2, 2.4)], [0.45]),
        effects=EFFECTS["all"], life=2.4, floor_restitution=0.2,
    )  # fmt: skip
    for _ in range(300):
        system.step(1 / 120)
    benchmark(system.step, 1 / 120)
    assert len(system) == 100_000
