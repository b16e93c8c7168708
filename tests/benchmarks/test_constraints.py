"""What linked particles cost: cloth and chain against numpy and pymunk in one run.

python -m pytest tests/benchmarks/test_constraints.py --benchmark-enable
"""

from __future__ import annotations

import numpy as np
import pytest

from game.lab.benchmarks.constraints import SIDE, NumpyCloth, cloth_system, pymunk_chain, pymunk_cloth
from game.physics.constraints import ATTACHMENTS, DAMPING, LINKS, PositionBasedDynamics, shapes
from game.physics.fields import GRAVITY

ORDERS = {"coloured": "coloured", "natural order": "natural"}


@pytest.mark.parametrize("order", ORDERS)
def test_cloth(benchmark, order):
    benchmark.group = "cloth of 100 x 100, 20 iterations"
    system = cloth_system(ORDERS[order])
    benchmark(system.step, 1 / 60)
    system.check()


def test_cloth_with_compliance(benchmark):
    benchmark.group = "cloth of 100 x 100, 20 iterations"
    system = cloth_system(model="xpbd", compliances=1e-8)
    benchmark(system.step, 1 / 60)
    system.check()


def test_cloth_in_substeps(benchmark):
    benchmark.group = "cloth of 100 x 100, 20 iterations"
    system = cloth_system(substeps=20, iterations=1)
    benchmark(system.step, 1 / 60)
    assert system.measure().worst_strain < 0.5


def test_cloth_with_numpy(benchmark):
    benchmark.group = "cloth of 100 x 100, 20 iterations"
    cloth = NumpyCloth()
    benchmark(cloth.step, 1 / 60)
    assert np.all(np.isfinite(cloth.x))


def test_numpy_twin_goes_the_same_way():
    """The peer does the same work: after three steps both cloths are alike within their residual."""
    twin, system = NumpyCloth(), cloth_system()
    for _ in range(3):
        twin.step(1 / 60)
        system.step(1 / 60)
    mine = system.positions[shapes.cloth_index(SIDE, SIDE)]
    assert np.abs(mine - np.stack([twin.x, twin.y], axis=-1)).max() < 1e-3


def test_cloth_with_pymunk(benchmark):
    pytest.importorskip("pymunk")
    if not benchmark.enabled:
        pytest.skip("the peer is measured only with --benchmark-enable")
    benchmark.group = "cloth of 100 x 100, 20 iterations"
    space = pymunk_cloth()
    benchmark(space.step, 1 / 60)
    assert len(space.bodies) == SIDE * (SIDE - 1)


CHAINS = {
    "one substep of 20": {"substeps": 1, "iterations": 20},
    "20 substeps of one": {"substeps": 20, "iterations": 1},
    "20 substeps, attached": {"substeps": 20, "iterations": 1, "effects": GRAVITY | LINKS | ATTACHMENTS},
    "direct, 4 substeps": {"substeps": 4, "iterations": 2, "solver": "direct"},
}


def stretch_of(step, places, seconds=3.0):
    """Greatest strain of the links of a chain of a hundred while it swings from horizontal."""
    worst = 0.0
    for i in range(round(seconds * 60)):
        step(1 / 60)
        if i % 10 == 9:
            lengths = np.linalg.norm(np.diff(places(), axis=0), axis=1)
            worst = max(worst, float(np.abs(lengths / 0.1 - 1.0).max()))
    return worst


@pytest.mark.parametrize("name", CHAINS)
def test_chain(benchmark, name):
    """100 links: extra_info says how much the worst link stretches while it swings."""
    benchmark.group = "chain of 100 links"
    rope = shapes.rope((0, 0), (10, 0), 100)
    settings = {"effects": GRAVITY | LINKS, **CHAINS[name]}
    system = PositionBasedDynamics(*rope[:3], **settings)
    benchmark.extra_info["worst strain"] = stretch_of(system.step, lambda: system.positions)
    benchmark(system.step, 1 / 60)


def test_chain_with_pymunk(benchmark):
    pytest.importorskip("pymunk")
    if not benchmark.enabled:
        pytest.skip("the peer is measured only with --benchmark-enable")
    benchmark.group = "chain of 100 links"
    space, bodies = pymunk_chain()
    start = np.zeros(2)
    benchmark.extra_info["worst strain"] = stretch_of(
        space.step, lambda: np.array([start, *(tuple(body.position) for body in bodies[1:])])
    )
    benchmark(space.step, 1 / 60)


def test_every_effect_at_once(benchmark):
    benchmark.group = "cloth of 100 x 100, 20 iterations"
    system = cloth_system(effects=GRAVITY | LINKS | DAMPING | ATTACHMENTS, damping=0.1)
    benchmark(system.step, 1 / 60)
    system.check()
