"""What linked particles cost: cloth and chain against numpy and pymunk in one run.

python -m pytest tests/benchmarks/test_constraints.py --benchmark-enable
"""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.constraints import ATTACHMENTS, DAMPING, LINKS, PositionBasedDynamics, shapes
from game.physics.fields import GRAVITY

SIDE, SWEEPS = 100, 20
ORDERS = {"coloured": "coloured", "natural order": "natural"}


def cloth_system(order="coloured", **settings):
    net = shapes.cloth((0, 0), SIDE, SIDE, 0.01)
    settings = {"iterations": SWEEPS, "effects": GRAVITY | LINKS, **settings}
    return PositionBasedDynamics(*net[:3], order=order, **settings)


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


class NumpyCloth:
    """The same step with numpy: four colours, whole planes of numbers at a time, in place."""

    def __init__(self):
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

    def step(self, h):
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


def pymunk_net(pymunk, positions, fixed, pairs, joint):
    space = pymunk.Space()
    space.gravity = 0, -9.81
    space.iterations = SWEEPS
    bodies = []
    for i, place in enumerate(positions):
        body = space.static_body if i in fixed else pymunk.Body(1.0, 1.0)
        if i not in fixed:
            body.position = tuple(place)
            space.add(body)
        bodies.append(body)
    for a, b in pairs:
        ends = [(0, 0) if bodies[i] is not space.static_body else tuple(positions[i]) for i in (a, b)]
        space.add(joint(bodies[a], bodies[b], *ends))
    return space, bodies


def test_cloth_with_pymunk(benchmark):
    pymunk = pytest.importorskip("pymunk")
    if not benchmark.enabled:
        pytest.skip("the peer is measured only with --benchmark-enable")
    benchmark.group = "cloth of 100 x 100, 20 iterations"
    net = shapes.cloth((0, 0), SIDE, SIDE, 0.01)
    fixed = set(np.flatnonzero(net.inverse_masses == 0.0).tolist())
    pairs = [(a, b) for a, b in net.links.tolist() if not (a in fixed and b in fixed)]
    space, _ = pymunk_net(pymunk, net.positions, fixed, pairs, pymunk.PinJoint)
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
    pymunk = pytest.importorskip("pymunk")
    if not benchmark.enabled:
        pytest.skip("the peer is measured only with --benchmark-enable")
    benchmark.group = "chain of 100 links"
    rope = shapes.rope((0, 0), (10, 0), 100)
    space, bodies = pymunk_net(pymunk, rope.positions, {0}, rope.links.tolist(), pymunk.PinJoint)
    start = rope.positions[0]
    benchmark.extra_info["worst strain"] = stretch_of(
        space.step, lambda: np.array([start, *(tuple(body.position) for body in bodies[1:])])
    )
    benchmark(space.step, 1 / 60)


def test_every_effect_at_once(benchmark):
    benchmark.group = "cloth of 100 x 100, 20 iterations"
    system = cloth_system(effects=GRAVITY | LINKS | DAMPING | ATTACHMENTS, damping=0.1)
    benchmark(system.step, 1 / 60)
    system.check()
