"""Cloth and chain, beside numpy and pymunk."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import partial
from typing import Any

import numpy as np

from game.lab.benchmarks.scenario import Call, Peer, Scenario
from game.physics.constraints import LINKS, PositionBasedDynamics, shapes
from game.physics.fields import GRAVITY

SIDE, SWEEPS = 100, 20
FRAME = 1.0 / 60.0  # s


def cloth_system(order: str = "coloured", **settings: Any) -> PositionBasedDynamics:
    """A hanging cloth of 100 x 100 with 20 iterations, unless ``settings`` say otherwise."""
    net = shapes.cloth((0, 0), SIDE, SIDE, 0.01)
    settings = {"iterations": SWEEPS, "effects": GRAVITY | LINKS, **settings}
    return PositionBasedDynamics(*net[:3], order=order, **settings)


class NumpyCloth:
    """The same step with numpy: four colours, whole planes of numbers at a time, in place."""

    def __init__(self) -> None:
        r, c = np.mgrid[0:SIDE, 0:SIDE]
        self.x, self.y = 0.01 * c, -0.01 * r
        self.vx, self.vy = np.zeros((2, SIDE, SIDE))
        w = np.ones((SIDE, SIDE))
        w[0] = 0.0
        self.moves = w
        self.families = []
        for axis in (1, 0):
            for first in (0, 1):
                a = [slice(None), slice(None)]
                b = [slice(None), slice(None)]
                a[axis], b[axis] = slice(first, SIDE - 1, 2), slice(first + 1, SIDE, 2)
                wa, wb = w[tuple(a)], w[tuple(b)]
                share = np.where(wa + wb > 0, 1.0 / np.maximum(wa + wb, 1e-300), 0.0)
                self.families.append((tuple(a), tuple(b), wa * share, wb * share))

    def step(self, h: float) -> None:
        """One step of gravity and links."""
        x, y = self.x.copy(), self.y.copy()
        self.vy -= 9.81 * h
        self.x += h * self.vx * self.moves
        self.y += h * self.vy * self.moves
        for _ in range(SWEEPS):
            for a, b, part_a, part_b in self.families:
                xa, ya, xb, yb = self.x[a], self.y[a], self.x[b], self.y[b]
                dx, dy = xb - xa, yb - ya
                stretch = 1.0 - 0.01 / np.sqrt(dx * dx + dy * dy)
                dx *= stretch
                dy *= stretch
                xa += part_a * dx
                ya += part_a * dy
                xb -= part_b * dx
                yb -= part_b * dy
        self.vx, self.vy = (self.x - x) / h, (self.y - y) / h


def pymunk_net(
    positions: Sequence[Sequence[float]], fixed: set[int], pairs: Iterable[tuple[int, int]]
) -> tuple[Any, list[Any]]:
    """pymunk's space with a body for each particle and a pin joint for each link; and the bodies."""
    import pymunk

    space = pymunk.Space()
    space.gravity = 0, -9.81
    space.iterations = SWEEPS
    bodies = []
    for i, (x, y) in enumerate(positions):
        body = space.static_body if i in fixed else pymunk.Body(1.0, 1.0)
        if i not in fixed:
            body.position = x, y
            space.add(body)
        bodies.append(body)
    for a, b in pairs:
        ends = [(positions[i][0], positions[i][1]) if i in fixed else (0.0, 0.0) for i in (a, b)]
        space.add(pymunk.PinJoint(bodies[a], bodies[b], *ends))
    return space, bodies


def pymunk_cloth() -> Any:
    """pymunk's space with the cloth."""
    net = shapes.cloth((0, 0), SIDE, SIDE, 0.01)
    fixed = set(np.flatnonzero(net.inverse_masses == 0.0).tolist())
    pairs = [(a, b) for a, b in net.links.tolist() if not (a in fixed and b in fixed)]
    return pymunk_net(net.positions.tolist(), fixed, pairs)[0]


def pymunk_chain() -> tuple[Any, list[Any]]:
    """pymunk's space with a chain of 100 links, and its bodies."""
    rope = shapes.rope((0, 0), (10, 0), 100)
    return pymunk_net(rope.positions.tolist(), {0}, rope.links.tolist())


def chain_system(**settings: Any) -> PositionBasedDynamics:
    """A chain of 100 links, horizontal at first."""
    return PositionBasedDynamics(*shapes.rope((0, 0), (10, 0), 100)[:3], effects=GRAVITY | LINKS, **settings)


def _chain() -> Call:
    return partial(chain_system(substeps=4, iterations=2, solver="direct").step, FRAME)


SCENARIOS = (
    Scenario(
        "cloth", "Cloth of 100 x 100, 20 iterations", "step", lambda: partial(cloth_system().step, FRAME),
        peers=(
            Peer("numpy, coloured", lambda: partial(NumpyCloth().step, FRAME)),
            Peer("pymunk pin joints", lambda: partial(pymunk_cloth().step, FRAME)),
        ),
    ),
    Scenario(
        "chain", "Chain of 100 links, direct solve", "step", _chain,
        peers=(Peer("pymunk pin joints, 20 iterations", lambda: partial(pymunk_chain()[0].step, FRAME)),),
    ),
)  # fmt: skip
