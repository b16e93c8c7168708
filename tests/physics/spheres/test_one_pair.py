"""One pair of spheres for one step, askew, by the kernels of space and of the plane, against closed forms."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.spheres import ledger
from game.physics.spheres.settings import MOST_SHIFT, SHARES
from game.physics.spheres.spheres import SphereBodies
from tests.physics.spheres.colliding import two, world_of

both = pytest.mark.parametrize("path", ["general", "planar"])
TURNED = np.array([math.cos(0.7), math.sin(0.7), 0.0])


@both
@pytest.mark.parametrize("friction", [0.0, 0.3])
def test_the_ledger_of_two_that_both_move(path, friction):
    """Speed of the gap before and after (Newton's law), and what the kinetic energy has changed by."""
    velocities = [(0.5, 0.8, 0.0), (0.3, -1.2, 0.0)]
    bodies = two(TURNED, velocities, [1.0, 2.5], [(0.0, 0.0, 1.5), (0.0, 0.0, -0.7)], inertias=[0.1, 0.25])
    world = world_of(bodies, restitution=0.6, friction=friction, path=path)
    world.step(1e-9)
    assert world.planar() == (path == "planar")
    entry = world.ledger()[0]
    closing = (np.array(velocities[1]) - velocities[0]) @ TURNED
    assert entry[ledger.BEFORE] == pytest.approx(closing, rel=1e-9)
    assert entry[ledger.AFTER] == pytest.approx(-0.6 * closing, rel=1e-9)
    before = 0.5 * (0.5**2 + 0.8**2) + 0.5 * 2.5 * (0.3**2 + 1.2**2) + 0.5 * (0.1 * 1.5**2 + 0.25 * 0.7**2)
    after = world.totals().translational + world.totals().rotational
    assert entry[ledger.CHANGE] == pytest.approx(after - before, rel=1e-7)


@both
def test_overlap_is_parted_along_the_normal_and_by_the_masses(path):
    deep, masses = 0.2, np.array([1.0, 3.0])
    places = [(0.0, 0.0), (1.0 - deep) * TURNED[:2]]
    bodies = SphereBodies(places, [0.5, 0.5], masses=masses)
    world = world_of(bodies, correction="split", path=path, passes=1)
    world.step(1.0 / 60.0)
    moved = bodies.state.positions - np.array([(*place, 0.0) for place in places])
    parted = SHARES["split"] * (deep - world.settings.slop * 0.5)
    assert parted < MOST_SHIFT * 0.5
    assert moved[0] == pytest.approx(-0.75 * parted * TURNED, rel=1e-9, abs=1e-15)
    assert moved[1] == pytest.approx(0.25 * parted * TURNED, rel=1e-9, abs=1e-15)
