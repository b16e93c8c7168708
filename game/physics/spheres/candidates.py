"""Which spheres may be in contact: from any broad phase over boxes with some air, or each against each.

Boxes are larger than the spheres by a skin, so that pairs serve for several steps: they are found again when
a sphere has gone half of it (Verlet 1967, "Computer experiments on classical fluids", the neighbour list).
"""

from __future__ import annotations

from typing import Any

import numpy as np

from game.arrays import Floats, Longs
from game.physics.broadphase import BroadPhase
from game.physics.spheres.composition import Composition
from game.physics.spheres.contacts import boxes_of, farthest_moved, near_pairs
from game.physics.spheres.time_of_impact import swept_pairs

SKIN = 0.2  # of the smallest radius
NOWHERE = 1e9  # m; where no sphere has been, so that pairs are found at the next step


class Candidates:
    """Pairs of spheres that may be in contact, and where the spheres were when these were found.

    composition: of the bodies. broad_phase: any of game.physics.broadphase, empty; None tests all pairs.
    """

    def __init__(self, composition: Composition, broad_phase: BroadPhase | None):
        s = len(composition.radii)
        self.composition = composition
        self.broad_phase = broad_phase
        self.skin = SKIN * float(composition.radii.min())
        self.pairs: Longs = np.zeros((0, 2), dtype=np.int64)
        self.found_at = np.full((s, 3), NOWHERE)
        self.tests = 0  # of pairs, since the caller has set this to 0
        self._buffer: Longs = np.zeros((max(64, 4 * s), 2), dtype=np.int64)
        self._boxes: Any = None

    def find(self, places: Floats) -> None:
        """Bring ``pairs`` up to date for spheres at places (s, 3) m, if somebody has gone too far."""
        radii = self.composition.radii
        if self.broad_phase is None:
            self.pairs = self._among_all(places, None, 0.0)
        elif farthest_moved(places, self.found_at) <= 0.5 * self.skin:
            return
        else:
            self.pairs = self._among_boxes(*boxes_of(places, radii, 2.0 * self.skin))
            self.tests += len(radii)
        np.copyto(self.found_at, places)

    def that_could_meet(self, places: Floats, work: Floats, h: float) -> Longs:
        """Pairs (p, 2) that could meet within h (s), of spheres at places (s, 3) m.

        work: (n + 1, WORK_COLUMNS) velocities of the bodies, as `gather_velocities` writes them.
        """
        if self.broad_phase is None:
            return self._among_all(places, work, h)
        ends = places[:, :2] + h * work[self.composition.owners, :2]
        reach = self.composition.radii[:, None]
        lower = np.minimum(places[:, :2], ends) - reach
        upper = np.maximum(places[:, :2], ends) + reach
        self.found_at.fill(NOWHERE)
        return self._among_boxes(lower, upper)

    def take(self, pairs: Longs, found_at: Floats) -> None:
        """Take over copies of pairs (p, 2) and of where spheres were when these were found (s, 3) m."""
        self.pairs = pairs.copy()
        np.copyto(self.found_at, found_at)

    def _among_boxes(self, lower: Floats, upper: Floats) -> Longs:
        """Pairs of boxes (s, 2) m that overlap, by the broad phase."""
        assert self.broad_phase is not None
        if self._boxes is None:
            self._boxes = self.broad_phase.add_boxes(lower, upper)
        else:
            self.broad_phase.update_boxes(self._boxes, lower, upper)
        return self.broad_phase.pairs()

    def _among_all(self, places: Floats, work: Floats | None, h: float) -> Longs:
        """Pairs that are nearly in contact, or that could meet within h (s) if there is work; each tested."""
        radii = self.composition.radii
        self.tests += len(radii) * (len(radii) - 1) // 2
        while True:
            if work is None:
                found = near_pairs(places, radii, self.skin, self._buffer)
            else:
                found = swept_pairs(places, self.composition, work, h, self._buffer)
            if found <= len(self._buffer):
                return self._buffer[:found].copy()
            self._buffer = np.zeros((2 * found, 2), dtype=np.int64)
