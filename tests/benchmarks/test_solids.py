"""What a settled pyramid of boxes costs, beside pymunk in one run.

python -m pytest tests/benchmarks/test_solids.py --benchmark-enable

extra_info says how far the top has sunk, m.
"""

from __future__ import annotations

import pytest

from game.lab.benchmarks.solids import FRAME, ROWS, SETTLED, places, pymunk_pyramid, pyramid


@pytest.mark.parametrize("substeps", [4, 12])
@pytest.mark.parametrize("rows", ROWS)
def test_pyramid(benchmark, rows, substeps):
    benchmark.group = f"pyramid of {len(places(rows))}"
    world, top = pyramid(rows, substeps, SETTLED if benchmark.enabled else 2)
    benchmark.pedantic(world.step, (FRAME,), rounds=60, warmup_rounds=2)
    sink = rows - 0.5 - float(world.bodies.positions[top, 1])
    benchmark.extra_info["sink"] = sink
    assert sink < 1.0
    world.check()


@pytest.mark.parametrize("rows", ROWS)
def test_pyramid_of_pymunk(benchmark, rows):
    pytest.importorskip("pymunk")
    if not benchmark.enabled:
        pytest.skip("the peer is measured only with --benchmark-enable")
    benchmark.group = f"pyramid of {len(places(rows))}"
    space, top = pymunk_pyramid(rows)
    benchmark.pedantic(space.step, (FRAME,), rounds=60, warmup_rounds=2)
    benchmark.extra_info["sink"] = rows - 0.5 - top.position.y
