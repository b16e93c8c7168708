"""The arrays of contacts: those of this step, and the impulses of the last one by which solving begins."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats, Longs
from game.physics.spheres.composition import Composition
from game.physics.spheres.contact_rows import ROW_COLUMNS
from game.physics.spheres.contacts import Contacts, PastContacts, find_contacts
from game.physics.spheres.planar_impulses import PLANAR_COLUMNS
from game.physics.spheres.settings import Surroundings


class ContactBuffers:
    """Arrays for so many contacts; they grow by doubling and are kept.

    contacts: of this step, the first ``count`` of them. past: what is remembered of the last one, whose keys
    and impulses are in arrays of their own.
    """

    def __init__(self, capacity: int):
        self.count = 0
        self._make(capacity)
        self.past = PastContacts(self.contacts.keys[:0], self.contacts.impulses[:0])

    def _make(self, capacity: int) -> None:
        """Arrays for so many contacts; what the last step left stays where it is."""
        self.contacts = Contacts(
            np.zeros((capacity, 4)),
            np.zeros((capacity, 2), dtype=np.int32),
            np.zeros((capacity, 2), dtype=np.uint32),
            np.zeros(capacity, dtype=np.int64),
            np.zeros((capacity, 4)),
            np.zeros(capacity),
        )
        self._others = self.contacts._replace(
            keys=np.zeros(capacity, dtype=np.int64), impulses=np.zeros((capacity, 4))
        )
        self._general = np.zeros((0, ROW_COLUMNS))
        self._planar = np.zeros((0, PLANAR_COLUMNS))

    @property
    def capacity(self) -> int:
        """Contacts that there is space for."""
        return len(self.contacts.keys)

    def general_rows(self) -> Floats:
        """(capacity, ROW_COLUMNS) rows for the solver in space; made when first asked for."""
        if len(self._general) < self.capacity:
            self._general = np.zeros((self.capacity, ROW_COLUMNS))
        return self._general

    def planar_rows(self) -> Floats:
        """(capacity, PLANAR_COLUMNS) rows for the solver in a plane; made when first asked for."""
        if len(self._planar) < self.capacity:
            self._planar = np.zeros((self.capacity, PLANAR_COLUMNS))
        return self._planar

    def find(
        self,
        places: Floats,
        composition: Composition,
        pairs: Longs,
        surroundings: Surroundings,
        mask: int,
        margin: float,
    ) -> int:
        """Write the contacts of spheres at places (s, 3) m, of candidates (p, 2), with gaps up to margin (m).

        mask: effects. Returns how many there are.
        """
        while True:
            self.count = find_contacts(places, composition, pairs, surroundings, mask, margin, self.contacts)
            if self.count <= self.capacity:
                return self.count
            self._make(2 * self.count)

    def turn_over(self) -> None:
        """What was of this step is of the last one."""
        m, done = self.count, self.contacts
        self.past = PastContacts(done.keys[:m], done.impulses[:m])
        self.contacts, self._others = self._others, done

    def take(self, keys: Longs, impulses: Floats) -> None:
        """Take over copies of keys (m,) and impulses (m, 4) of a last step."""
        if len(keys) > self.capacity:
            self._make(2 * len(keys))
        self.past = PastContacts(keys.copy(), impulses.copy())
