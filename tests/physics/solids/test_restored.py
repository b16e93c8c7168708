"""A world that is restored goes on as it would have, to the bit, also where bodies fall asleep and wake."""

from __future__ import annotations

import numpy as np

from game.physics.solids import Chain, Disc, Material, SolidWorld, box
from game.physics.solids.arrays.state import ASLEEP


def test_sleep_does_not_depend_on_contacts_that_are_gone() -> None:
    """A wave of smooth dominoes, each of which meets the next in one point, then in two, then not at all."""
    world = SolidWorld()
    world.add_body(Chain([(-10.0, 0.0), (60.0, 0.0)], material=Material(friction=1e6)), kind="fixed")
    smooth = Material(friction=1e-6)
    rows = [world.add_body(box(0.16, 1.0, material=smooth), (0.76 * k, 0.5)) for k in range(30)]
    world.add_body(Disc(0.4, material=smooth), (-3.0, 0.4))
    for _ in range(60):
        world.step(1.0 / 60.0)
    world.set_velocity(rows[0], (1.6, 0.3), -3.1)
    for _ in range(40):
        begin = world.state()
        first = []
        for _ in range(4):
            world.step(1.0 / 60.0)
            first.append(world.state().bodies)
        world.restore(begin)
        for before in first:
            world.step(1.0 / 60.0)
            for name, a, b in zip(before._fields, before, world.bodies, strict=True):
                assert np.array_equal(a, b[: len(a)]), name
    assert (world.bodies.flags[rows] & ASLEEP == 0).any()
