"""Pyramids of boxes that have settled, and the same in pymunk with ten iterations."""

from __future__ import annotations

from functools import partial
from typing import Any

from game.lab.benchmarks.scenario import Call, Peer, Scenario
from game.physics.solids import SolidSettings, SolidWorld, box
from game.physics.solids.effects import SLEEP, USUAL

FRAME = 1.0 / 60.0  # s
SETTLED = 120  # steps
ROWS = (20, 50, 100)  # 210, 1,275 and 5,050 boxes


def places(rows: int) -> list[tuple[float, float]]:
    """Centres (m) of boxes of a metre, row by row from the ground."""
    return [(k - 0.5 * (rows - r - 1), 0.5 + r) for r in range(rows) for k in range(rows - r)]


def pyramid(rows: int, substeps: int = 4, steps: int = SETTLED) -> tuple[SolidWorld, int]:
    """A world with a pyramid after so many steps of FRAME, none of it asleep; the box at its top."""
    world = SolidWorld(SolidSettings(substeps=substeps, effects=USUAL.without(SLEEP)))
    world.add_body(box(4.0 * rows, 1.0), (0.0, -0.5), kind="fixed")
    top = [world.add_body(box(1.0, 1.0), place) for place in places(rows)][-1]
    for _ in range(steps):
        world.step(FRAME)
    return world, top


def pymunk_pyramid(rows: int, steps: int = SETTLED) -> tuple[Any, Any]:
    """The same in a pymunk space. ImportError without it."""
    import pymunk

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
    for _ in range(steps):
        space.step(FRAME)
    return space, body


def _own(rows: int) -> Call:
    return partial(pyramid(rows)[0].step, FRAME)


def _pymunk(rows: int) -> Call:
    return partial(pymunk_pyramid(rows)[0].step, FRAME)


SCENARIOS = tuple(
    Scenario(
        f"pyramid-{len(places(rows))}", f"Pyramid of {len(places(rows)):,} boxes, 4 substeps", "step",
        partial(_own, rows), peers=(Peer("pymunk step, 10 iterations", partial(_pymunk, rows)),),
    )
    for rows in ROWS
)  # fmt: skip
