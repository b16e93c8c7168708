"""What colliding discs cost when they have settled, beside pymunk in one run.

python -m pytest tests/benchmarks/test_rigid_impulses.py --benchmark-enable

extra_info says how deep discs overlap (radius 0.43 m): the deepest of all while they were measured.
"""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.broadphase import UniformGrid
from game.physics.rigid.collision_settings import material_tables, surroundings_of
from game.physics.rigid.collisions import CollidingSpheres
from game.physics.rigid.spheres import SphereBodies

RADIUS, FRAME = 0.43, 1 / 60
HEAPS = {1000: (40, 420), 5000: (100, 600)}  # columns, steps until they have settled
SETTINGS = {
    "projection": {"correction": "projection", "iterations": 8, "passes": 3},
    "split impulses": {"correction": "split", "iterations": 10, "passes": 3},
}


def places_of(count, columns):
    random = np.random.default_rng(1)
    i = np.arange(count)
    shift = random.uniform(-0.05, 0.05, (count, 2))
    return np.stack((0.5 + i % columns, 0.5 + i // columns), axis=1) + shift


def heap(count, columns, **settings):
    rows = -(-count // columns)
    bodies = SphereBodies(
        places_of(count, columns), np.full(count, RADIUS), inertias=np.full(count, 0.5 * RADIUS**2)
    )
    return CollidingSpheres(
        bodies,
        surroundings_of((0.0, 0.0, columns, 4.0 * rows)),
        material_tables(0.0, 0.5),
        UniformGrid((0.0, 0.0), (columns, rows + 2.0), 2.0 * RADIUS + 0.2),
        scheme="semi-implicit",
        **settings,
    )


@pytest.mark.parametrize("name", SETTINGS)
@pytest.mark.parametrize("count", HEAPS)
def test_settled_discs(benchmark, count, name):
    benchmark.group = f"{count} settled discs"
    columns, steps = HEAPS[count]
    world = heap(count, columns, **SETTINGS[name])
    for _ in range(steps if benchmark.enabled else 2):
        world.step(FRAME)
    benchmark.pedantic(world.step, (FRAME,), rounds=200, warmup_rounds=2)
    benchmark.extra_info["deepest overlap"] = world.overlap()
    assert world.overlap() < 0.1
    world.check()


@pytest.mark.parametrize("count", HEAPS)
def test_settled_discs_of_pymunk(benchmark, count):
    pymunk = pytest.importorskip("pymunk")
    if not benchmark.enabled:
        pytest.skip("the peer is measured only with --benchmark-enable")
    benchmark.group = f"{count} settled discs"
    columns, steps = HEAPS[count]
    space = pymunk.Space()
    space.gravity, space.iterations = (0, -9.81), 10
    high = 4.0 * count / columns
    for a, b in (((0, 0), (columns, 0)), ((0, 0), (0, high)), ((columns, 0), (columns, high))):
        wall = pymunk.Segment(space.static_body, a, b, 0.0)
        wall.friction = 0.5
        space.add(wall)
    bodies = []
    for place in places_of(count, columns).tolist():
        body = pymunk.Body(1.0, 0.5 * RADIUS**2)
        body.position = tuple(place)
        disc = pymunk.Circle(body, RADIUS)
        disc.friction = 0.5
        space.add(body, disc)
        bodies.append(body)
    for _ in range(steps):
        space.step(FRAME)
    benchmark.pedantic(space.step, (FRAME,), rounds=200, warmup_rounds=2)
    places = np.array([body.position for body in bodies])
    probe = heap(count, columns)
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
    from game.physics.rigid.sphere_effects import COLLISIONS, IMPACT_TIMES

    def play():
        world = CollidingSpheres(
            SphereBodies(places, [0.24] * 11, speeds), surroundings_of((-4, -3, 4, 3)),
            material_tables(1.0, 0.0), effects=COLLISIONS | WINDOW | IMPACT_TIMES,
        )  # fmt: skip
        for _ in range(60):
            world.step(FRAME)
        return world

    assert benchmark(play).collisions > 10
