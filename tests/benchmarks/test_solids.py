"""What a settled pyramid of boxes costs, beside pymunk in one run.

python -m pytest tests/benchmarks/test_solids.py --benchmark-enable

extra_info says how far the top has sunk, m.
"""

from __future__ import annotations

import pytest

from game.physics.solids import SolidSettings, SolidWorld, box
from game.physics.solids.effects import SLEEP, USUAL

FRAME = 1.0 / 60.0
ROWS = (20, 50, 100)  # 210, 1,275 and 5,050 boxes


def places(rows):
    """Centres of unit boxes, row by row from the ground."""
    return [(k - 0.5 * (rows - r - 1), 0.5 + r) for r in range(rows) for k in range(rows - r)]


@pytest.mark.parametrize("substeps", [4, 12])
@pytest.mark.parametrize("rows", ROWS)
def test_pyramid(benchmark, rows, substeps):
    benchmark.group = f"pyramid of {len(places(rows))}"
    world = SolidWorld(SolidSettings(substeps=substeps, effects=USUAL.without(SLEEP)))
    world.add_body(box(4.0 * rows, 1.0), (0.0, -0.5), kind="fixed")
    bodies = [world.add_body(box(1.0, 1.0), place) for place in places(rows)]
    for _ in range(120 if benchmark.enabled else 2):
        world.step(FRAME)
    benchmark.pedantic(world.step, (FRAME,), rounds=60, warmup_rounds=2)
    sink = rows - 0.5 - float(world.bodies.positions[bodies[-1], 1])
    benchmark.extra_info["sink"] = sink
    assert sink < 1.0
    world.check()


@pytest.mark.parametrize("rows", ROWS)
def test_pyramid_of_pymunk(benchmark, rows):
    pymunk = pytest.importorskip("pymunk")
    if not benchmark.enabled:
        pytest.skip("the peer is measured only with --benchmark-enable")
    benchmark.group = f"pyramid of {len(places(rows))}"
    space = pymunk.Space()
    space.gravity = 0.0, -9.81
    space.iterations = 10
    ground = pymunk.Poly(space.static_body, [(-400, -1), (400, -1), (400, 0), (-400, 0)])
    ground.friction = 0.6
    space.add(ground)
    for place in places(rows):
        body = pymunk.Body(1.0, 1.0 / 6.0)
        body.position = place
        shape = pymunk.Poly.create_box(body, (1.0, 1.0))
        shape.friction = 0.6
        space.add(body, shape)
    for _ in range(120):
        space.step(FRAME)
    benchmark.pedantic(space.step, (FRAME,), rounds=60, warmup_rounds=2)
    benchmark.extra_info["sink"] = rows - 0.5 - max(float(body.position.y) for body in space.bodies)
