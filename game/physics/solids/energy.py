"""Energy of a world of solids, as a ledger needs it.

Soft contacts count by what sinking has paid into their springs, not by their overlap: most of that comes from
impacts, which took the energy of motion for good. See solvers/governor.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from game.physics.solids.arrays.state import DYNAMIC, Bodies
from game.physics.solids.settings import Numbers


class Energy(NamedTuple):
    """J, of all dynamic bodies."""

    kinetic: float
    potential: float  # in gravity, 0 at the origin
    elastic: float = 0.0  # in the springs of soft contacts

    @property
    def total(self) -> float:
        """Of all kinds."""
        return self.kinetic + self.potential + self.elastic


def energy_of(bodies: Bodies, numbers: Numbers) -> Energy:
    """What there is now. numbers: of the steps."""
    rows = np.flatnonzero(bodies.flags & DYNAMIC)
    mass, inertia = 1.0 / bodies.inverse_masses[rows], 1.0 / bodies.inverse_inertias[rows]
    kinetic = 0.5 * (
        mass * (bodies.velocities[rows] * bodies.velocities[rows]).sum(axis=1)
        + inertia * (bodies.spins[rows] * bodies.spins[rows])
    )
    x, y = bodies.positions[rows].T
    height = -(bodies.gravity_scales[rows] * mass * (x * numbers.gravity_x + y * numbers.gravity_y))
    return Energy(float(kinetic.sum()), float(height.sum()), float(bodies.stored[rows].sum()))
