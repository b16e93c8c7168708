"""The arrays of contacts: those of this step, and the impulses of the last one by which solving begins."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from game.physics.spheres.composition import Composition
from game.physics.spheres.contact_rows import ROW_COLUMNS
from game.physics.spheres.contacts import find_contacts
from game.physics.spheres.planar_impulses import PLANAR_COLUMNS
from game.physics.spheres.settings import Surroundings

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]


class ContactBuffers:
    """Arrays for so many contacts; they grow by doubling and are kept.

    contacts: (capacity, 4) normals and gaps. who: (capacity, 2) spheres. ids: (capacity, 2) bodies.
    keys: (capacity,), by which a contact is known again. held: (capacity, 4) impulses of resting contacts,
    kg m/s. The first ``count`` are those of this step; the first ``old_count`` of ``old_keys`` and
    ``old_held`` are those of the last one.
    """

    def __init__(self, capacity: int):
        self.count = self.old_count = 0
        self.old_keys: Ints = np.zeros(0, dtype=np.int64)
        self.old_held = np.zeros((0, 4))
        self._make(capacity)

    def _make(self, capacity: int) -> None:
        """Arrays for so many contacts; what the last step left is kept."""
        keys, held = self.old_keys, self.old_held
        self.contacts = np.zeros((capacity, 4))
        self.who: NDArray[np.int32] = np.zeros((capacity, 2), dtype=np.int32)
        self.ids: NDArray[np.uint32] = np.zeros((capacity, 2), dtype=np.uint32)
        self.keys: Ints = np.zeros(capacity, dtype=np.int64)
        self.held = np.zeros((capacity, 4))
        self.old_keys = np.zeros(capacity, dtype=np.int64)
        self.old_held = np.zeros((capacity, 4))
        self.old_keys[: len(keys)] = keys
        self.old_held[: len(held)] = held
        self.pushes = np.zeros(capacity)
        self._general = np.zeros((0, ROW_COLUMNS))
        self._planar = np.zeros((0, PLANAR_COLUMNS))

    def general_rows(self) -> Floats:
        """(capacity, ROW_COLUMNS) rows for the solver in space; made when first asked for."""
        if len(self._general) < len(self.keys):
            self._general = np.zeros((len(self.keys), ROW_COLUMNS))
        return self._general

    def planar_rows(self) -> Floats:
        """(capacity, PLANAR_COLUMNS) rows for the solver in a plane; made when first asked for."""
        if len(self._planar) < len(self.keys):
            self._planar = np.zeros((len(self.keys), PLANAR_COLUMNS))
        return self._planar

    def find(
        self,
        places: Floats,
        composition: Composition,
        pairs: Ints,
        surroundings: Surroundings,
        mask: int,
        margin: float,
    ) -> int:
        """Write the contacts of spheres at places (s, 3) m, of candidates (p, 2), with gaps up to margin (m).

        mask: effects. Returns how many there are.
        """
        while True:
            self.count = find_contacts(
                places,
                composition,
                pairs,
                surroundings,
                mask,
                margin,
                self.contacts,
                self.who,
                self.ids,
                self.keys,
            )
            if self.count <= len(self.keys):
                return self.count
            self._make(2 * self.count)

    def turn_over(self) -> None:
        """What was of this step is of the last one."""
        self.keys, self.old_keys = self.old_keys, self.keys
        self.held, self.old_held = self.old_held, self.held
        self.old_count = self.count

    def take(self, keys: Ints, held: Floats) -> None:
        """Take over copies of keys (m,) and impulses (m, 4) of a last step."""
        m = len(keys)
        if m > len(self.old_keys):
            self._make(2 * m)
        self.old_keys[:m], self.old_held[:m] = keys, held
        self.old_count = m
