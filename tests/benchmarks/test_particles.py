"""What particles cost: against numpy, effect by effect. Ratios are printed; nothing fails for a slow machine.

python -m pytest tests/benchmarks/test_particles.py --benchmark-enable
"""

from __future__ import annotations

import pytest

from game.lab.benchmarks.particles import NumpySwarm, live_fountain, swarm
from game.physics.effects import EffectSet
from game.physics.fields import DRAG, GRAVITY, GROUND, WIND
from game.physics.particles import METHODS, OBSTACLES

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
    system = live_fountain(100_000)
    benchmark(system.step, 1 / 120)
    assert len(system) == 100_000
