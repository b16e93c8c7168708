"""Long-range attachments: reach by links, against a naive relaxation; no stretch of the whole."""

from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from game.physics.constraints import ATTACHMENTS, LINKS, PositionBasedDynamics, shapes
from game.physics.fields import GRAVITY


def naive_reaches(count, links, rest, fixed):
    """Bellman and Ford, as many rounds as there are particles."""
    reach = np.where(fixed, 0.0, np.inf)
    for _ in range(count):
        for (a, b), length in zip(links, rest, strict=True):
            reach[a] = min(reach[a], reach[b] + length)
            reach[b] = min(reach[b], reach[a] + length)
    return reach


@settings(max_examples=30)
@given(st.integers(2, 12), st.integers(0, 10_000))
def test_reaches_are_shortest_ways_along_links(count, seed):
    rng = np.random.default_rng(seed)
    positions = rng.uniform(-1, 1, (count, 2))
    weights = np.where(rng.random(count) < 0.25, 0.0, 1.0)
    pairs = [(a, b) for a in range(count) for b in range(a + 1, count) if rng.random() < 0.3]
    system = PositionBasedDynamics(positions, weights, pairs, effects=LINKS | ATTACHMENTS)
    system.step(1e-3)
    expected = naive_reaches(count, pairs, system.links.rest, weights == 0.0)
    assert np.allclose(system._net.reaches, expected, rtol=1e-12, atol=0)
    assert np.array_equal(system._net.pins < 0, np.isinf(expected))


def test_a_rope_does_not_stretch_as_a_whole():
    """100 links and a single sweep: the tip stays within the length of the rope."""
    rope = shapes.rope((0, 0), (5, 0), 100)
    reach = {}
    for name, effects in (("without", GRAVITY | LINKS), ("with", GRAVITY | LINKS | ATTACHMENTS)):
        system = PositionBasedDynamics(*rope[:3], iterations=1, effects=effects, damping=0.5)
        furthest = 0.0
        for _ in range(240):
            system.step(1 / 60)
            furthest = max(furthest, float(np.linalg.norm(system.positions[-1])))
        reach[name] = furthest
    assert reach["without"] > 7.5
    assert reach["with"] <= 5.0 + 1e-9


def test_what_is_torn_off_is_not_held():
    rope = shapes.rope((0, 0), (1, 0), 4)
    system = PositionBasedDynamics(*rope[:3], effects=GRAVITY | LINKS | ATTACHMENTS)
    system.cut(1)
    for _ in range(120):
        system.step(1 / 60)
    assert system.positions[1, 1] > -0.3
    assert system.positions[2, 1] < -10
