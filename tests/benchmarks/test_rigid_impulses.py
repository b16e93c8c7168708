"""What colliding discs cost when they have settled, beside pymunk in one run.

python -m pytest tests/benchmarks/test_rigid_impulses.py --benchmark-enable

extra_info says how deep discs overlap (radius 0.43 m): the deepest of all while they were measured.
"""

from __future__ import annotations

import numpy as np
import pytest

from game.lab.benchmarks.rigid import FRAME, HEAPS, SETTINGS, heap, pymunk_heap, settled_heap
from game.physics.spheres.collisions import CollidingSpheres
from game.physics.spheres.settings import material_tables, surroundings_of
from game.physics.spheres.spheres import SphereBodies


@pytest.mark.parametrize("name", SETTINGS)
@pytest.mark.parametrize("count", HEAPS)
def test_settled_discs(benchmark, count, name):
    benchmark.group = f"{count} settled discs"
    world = settled_heap(count, name) if benchmark.enabled else heap(count, **SETTINGS[name])
    benchmark.pedantic(world.step, (FRAME,), rounds=200, warmup_rounds=2)
    benchmark.extra_info["deepest overlap"] = world.overlap()
    assert world.overlap() < 0.1
    world.check()


@pytest.mark.parametrize("count", HEAPS)
def test_settled_discs_of_pymunk(benchmark, count):
    pytest.importorskip("pymunk")
    if not benchmark.enabled:
        pytest.skip("the peer is measured only with --benchmark-enable")
    benchmark.group = f"{count} settled discs"
    space, bodies = pymunk_heap(count)
    benchmark.pedantic(space.step, (FRAME,), rounds=200, warmup_rounds=2)
    places = np.array([body.position for body in bodies])
    probe = heap(count)
    probe.bodies.state.positions[:, :2] = places
    benchmark.extra_info["deepest overlap"] = probe.overlap()


def test_a_rack_with_impact_times(benchmark):
    """A break of eleven spheres for a second, divided at each impact."""
    benchmark.group = "break of a rack"
    places = [(-2.0, 0.02)] + [
        (0.866 * 0.49 * i, 0.49 * (k - 0.5 * i)) for i in range(4) for k in range(i + 1)
    ]
    speeds = [(5.0, 0.0)] + [(0.0, 0.0)] * 10
    from game.physics.rigid.effects import WINDOW
    from game.physics.spheres.effects import COLLISIONS, IMPACT_TIMES

    def play():
        world = CollidingSpheres(
            SphereBodies(places, [0.24] * 11, speeds), surroundings_of((-4, -3, 4, 3)),
            material_tables(1.0, 0.0), effects=COLLISIONS | WINDOW | IMPACT_TIMES,
        )  # fmt: skip
        for _ in range(60):
            world.step(FRAME)
        return world

    assert benchmark(play).collisions > 10
