"""What colliding spheres remember from step to step."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from game.arrays import Floats, Longs


class CollisionState(NamedTuple):
    """All that later steps depend on. The arrays are the world's own, not copies."""

    positions: Floats  # (n, 3) m
    orientations: Floats  # (n, 4)
    momenta: Floats  # (n, 3) kg m/s
    spins: Floats  # (n, 3) kg m²/s
    pairs: Longs  # (p, 2) candidates
    found_at: Floats  # (s, 3) m, where spheres were when these were found
    keys: Longs  # (m,) contacts of the last step
    held: Floats  # (m, 4) their impulses, kg m/s
    pulls: Floats  # (n, 6) forces N and torques N m of the next step
    ring: Floats  # (LEDGER_ROWS, LEDGER_COLUMNS) last collisions
    counters: Floats  # (8,): see steps.py


def entries_in_order(ring: Floats, made: int) -> Floats:
    """The entries (k, columns) that a ring (capacity, columns) still holds, of so many made; oldest first."""
    if made <= len(ring):
        return ring[:made].copy()
    return np.roll(ring, -(made % len(ring)), axis=0)
