"""Bodies that keep apart, and walls beside the ground."""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.constraints import CONTACTS, PositionBasedDynamics
from game.physics.constraints.bodies import bodies_of
from game.physics.constraints.shapes import block, joined, ring
from game.physics.constraints.system import PositionState
from game.physics.fields import GROUND

NONE = np.zeros(0, dtype=np.int64)


def partition(members, starts):
    return {frozenset(part.tolist()) for part in np.split(members, starts[1:-1])}


def system_of(parts, **settings):
    shape = joined(parts)
    return PositionBasedDynamics(
        *shape[:3], areas=shape.areas, floor=0.0, substeps=8, iterations=2, damping=0.2, **settings
    )


def test_bodies_are_what_links_and_outlines_hold_together():
    pairs = np.array([[0, 5], [5, 2], [3, 4]])
    members, starts = bodies_of(9, pairs, np.array([6, 8, 3]), np.array([0, 3]))
    assert partition(members, starts) == {frozenset(part) for part in ((0, 2, 5), (3, 4, 6, 8), (1,), (7,))}
    members, starts = bodies_of(3, np.zeros((0, 2), dtype=np.int64), NONE, np.zeros(1, dtype=np.int64))
    assert partition(members, starts) == {frozenset((i,)) for i in range(3)}


def test_bodies_agree_with_a_search_from_each_particle():
    random = np.random.default_rng(7)
    for _ in range(20):
        count = int(random.integers(1, 60))
        pairs = random.integers(0, count, (int(random.integers(0, count)), 2))
        reach = np.eye(count, dtype=bool)
        reach[pairs[:, 0], pairs[:, 1]] = reach[pairs[:, 1], pairs[:, 0]] = True
        for _ in range(count):
            reach = reach @ reach
        expected = {frozenset(np.flatnonzero(row).tolist()) for row in reach}
        assert partition(*bodies_of(count, pairs, NONE, np.zeros(1, dtype=np.int64))) == expected


def smallest_gap(system, first: int) -> float:
    """Smallest distance (m) between the particles before and from ``first`` on."""
    a, b = system.positions[:first], system.positions[first:]
    return float(np.sqrt(((a[:, None] - b[None]) ** 2).sum(axis=2)).min())


@pytest.mark.parametrize("scheme", ["euler", "bdf2"])
def test_a_jelly_that_falls_on_another_comes_to_rest_on_it(scheme):
    parts = [block((0.0, 0.0), 16, 5, 0.2), ring((1.5, 2.2), 0.5, 32)]
    system = system_of(parts, body_distance=0.14, scheme=scheme)
    system.change(effects=system.settings.effects.with_(CONTACTS))
    for _ in range(300):
        system.step(1 / 60)
        assert smallest_gap(system, 80) > 0.1
    assert system.positions[80:, 1].min() > 0.8
    system.change(effects=system.settings.effects.without("contacts"))
    for _ in range(120):
        system.step(1 / 60)
    assert system.positions[80:, 1].min() < 0.5


def test_what_pushes_bodies_apart_is_equal_and_opposite():
    """Momentum of two free jellies that collide, of unequal masses, stays what it was."""
    light, heavy = block((0.0, 0.0), 5, 5, 0.2, 0.5), block((1.2, 0.1), 4, 6, 0.2, 3.0)
    shape = joined([light, heavy])
    velocities = np.zeros_like(shape.positions)
    velocities[:25] = (6.0, 0.5)
    system = PositionBasedDynamics(
        *shape[:3], areas=shape.areas, velocities=velocities, body_distance=0.14, substeps=8, iterations=4
    )
    effects = system.settings.effects.with_(CONTACTS).without("gravity").without("damping")
    system.change(effects=effects.without(GROUND.name))
    before = system.momentum()
    for _ in range(120):
        system.step(1 / 60)
    assert system.momentum()[:2] == pytest.approx(before[:2], rel=0, abs=1e-9 * abs(before[0]))
    assert system.velocities[25:, 0].mean() > 0.5


def test_walls_hold_what_is_thrown_and_are_switched_with_the_ground():
    system = system_of([block((0.0, 0.0), 6, 4, 0.2)], left=-1.0, right=2.0, speed_limit=60.0)
    system.fields[2, : system.count] = 40.0
    for _ in range(120):
        system.step(1 / 60)
        x = system.positions[:, 0]
        assert x.min() >= -1.0 and x.max() <= 2.0
    system.change(effects=system.settings.effects.without(GROUND.name), gravity=0.0)
    system.fields[2, : system.count] = 40.0
    for _ in range(60):
        system.step(1 / 60)
    assert system.positions[:, 0].min() > 5.0


def test_bodies_and_walls_step_again_from_a_state():
    def made():
        parts = [block((0.0, 0.3), 6, 4, 0.2), ring((0.6, 1.7), 0.4, 24)]
        return system_of(parts, left=-0.1, right=1.2, body_distance=0.14, effects=LATER)

    LATER = system_of([block((0.0, 0.0), 2, 2, 0.2)]).settings.effects.with_(CONTACTS)
    system = made()
    for _ in range(40):
        system.step(1 / 60)
    state = PositionState(*(part.copy() for part in system.state()))
    for _ in range(40):
        system.step(1 / 60)
    again = made()
    again.restore(state)
    for _ in range(40):
        again.step(1 / 60)
    assert np.array_equal(again.fields, system.fields)


@pytest.mark.parametrize(
    ("field", "value"), [("body_distance", -1.0), ("body_distance", np.nan), ("left", 3.0), ("right", np.inf)]
)
def test_nonsense_is_refused(field, value):
    with pytest.raises(ValueError, match=field):
        system_of([block((0.0, 0.0), 2, 2, 0.2)], **{"right": 2.0, field: value})
