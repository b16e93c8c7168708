"""Where solids touch."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from game.physics.solids import SolidWorld
from game.physics.solids.state import FIRST_POINT, POINT_WIDTH, POINTS, TOUCHING

Floats = NDArray[np.float64]


def contact_places(world: SolidWorld) -> Floats:
    """Points (k, 2) m at which solids touch."""
    contacts, rows = world.contacts, world.bodies
    touching = contacts.marks[:, TOUCHING] == 1
    marks, manifolds = contacts.marks[touching], contacts.manifolds[touching]
    a = contacts.bodies[touching, 0]
    c, s = rows.rotations[a, 0], rows.rotations[a, 1]
    found = [np.zeros((0, 2))]
    for k in range(2):
        here, at = marks[:, POINTS] > k, FIRST_POINT + k * POINT_WIDTH
        x, y = manifolds[here, at], manifolds[here, at + 1]
        cos, sin = c[here], s[here]
        found.append(np.stack([cos * x - sin * y, sin * x + cos * y], axis=1) + rows.positions[a[here]])
    return np.concatenate(found)
