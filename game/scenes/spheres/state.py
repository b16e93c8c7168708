"""The state of the colliding spheres."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats


class SphereState(NamedTuple):
    """All that moves (see `CollisionState`), and what spheres there are (see `Composition`)."""

    positions: Floats
    orientations: Floats
    momenta: Floats
    spins: Floats
    pairs: NDArray[np.int64]
    found_at: Floats
    keys: NDArray[np.int64]
    held: Floats
    pulls: Floats
    ring: Floats
    counters: Floats
    masses: Floats
    inverse_inertias: Floats
    round_bodies: NDArray[np.uint8]
    radii: Floats
    owners: NDArray[np.int64]
    offsets: Floats
    kinds: NDArray[np.int64]
    hung: NDArray[np.int64]
    strings: Floats
    exact_places: Floats  # (s, 3) m of the event-driven run; empty without one
    exact_speeds: Floats  # (s, 3) m/s
