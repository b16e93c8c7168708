"""Broad phase: whatever overlaps is found, of all sizes and wherever it lies; what is excluded is not."""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.solids import Disc, SolidSettings, SolidWorld
from game.physics.solids.effects import CONTACTS


def discs(seed: int, count: int = 30):
    """A world of discs whose sizes go over three decades, on both sides of the origin; places and radii."""
    random = np.random.default_rng(seed)
    places, radii = random.uniform(-3.0, 3.0, (count, 2)), 10.0 ** random.uniform(-2.5, 0.3, count)
    world = SolidWorld(SolidSettings(gravity=(0.0, 0.0), effects=CONTACTS))
    for place, radius in zip(places, radii, strict=True):
        world.add_body(Disc(radius), place)
    return world, places, radii


def found(world) -> set[tuple[int, int]]:
    """Pairs of bodies that the broad phase found, each once."""
    pairs = world.contacts.bodies[: world.contacts.count[0]].tolist()
    assert len(set(map(frozenset, pairs))) == len(pairs)
    return {(min(pair), max(pair)) for pair in pairs}


@pytest.mark.parametrize("seed", range(3))
def test_all_that_overlap_are_found(seed):
    world, places, radii = discs(seed)
    apart = np.hypot(*(places[:, None] - places[None]).T) - radii[:, None] - radii[None]
    overlapping = {(i, j) for i, j in zip(*np.nonzero(np.triu(apart < 0.0, 1)), strict=True)}
    assert len(overlapping) > 15
    world.step(1e-6)
    assert overlapping <= found(world)
    assert len(found(world)) < len(places) ** 2 / 4


def test_what_a_joint_holds_together_is_not_found():
    world, _, _ = discs(0)
    world.step(1e-6)
    before = found(world)
    chosen = sorted(before)[::2]
    for a, b in chosen:
        world.add_joint("pin", a, b, world.bodies.positions[a])
    world.step(1e-6)
    assert found(world) == before - set(chosen)
