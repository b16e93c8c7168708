"""Collision detection of deformable meshes by spatial hashing, with all buffers kept."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats, Longs
from game.physics.deformables.depth import DEPTH_ROWS, measure_depths
from game.physics.deformables.edges import RimTable, find_crossings
from game.physics.deformables.effects import MESH_CONTACTS, SELF_CONTACTS, SOFT
from game.physics.deformables.hashing import LOAD, SLOT_COLUMNS, STAMP
from game.physics.deformables.meshes import MeshStore
from game.physics.deformables.naive import all_edges, all_vertices
from game.physics.deformables.vertices import COUNTERS, VertexTable, count_work, find_vertices, place_vertices
from game.physics.effects import EffectSet
from game.physics.kernels.finite import finite_doubles

MOST_SLOTS = 1 << 26
LAST_STAMP = 1 << 30
BOTH = MESH_CONTACTS | SELF_CONTACTS


class Counts(NamedTuple):
    """Work of the last pass over vertices; see `hashing`."""

    used: int  # slots
    visited: int  # cells that triangles looked at
    strangers: int  # vertices of other cells that they met there
    tested: int  # vertices tested against a triangle
    longest: int  # chain


class MeshCollider:
    """Finds, for places of all vertices of a store, vertices in triangles and edges that cross the rim.

    cell_size: m. table_size: slots, 1 or more; prime or not. effects: of MESH_CONTACTS, SELF_CONTACTS.
    ValueError, naming the argument, for nonsense.
    """

    def __init__(
        self, store: MeshStore, cell_size: float, table_size: int, effects: EffectSet = BOTH
    ) -> None:
        self.store = store
        n, edges = store.vertices, len(store.topology.edges)
        self.points: Floats = np.zeros((n, 2))
        self.inside = np.zeros(n, dtype=np.uint8)
        self.depths: Floats = np.zeros((DEPTH_ROWS, n))
        self.rings = 0
        self._contacts: Longs = np.zeros(2 * n + 65, dtype=np.int64)
        self._crossings: Longs = np.zeros(edges + 64, dtype=np.int64)
        self._counters = np.zeros(COUNTERS, dtype=np.int64)
        self._found = self._crossed = 0
        self._worked: tuple[Counts, Longs] | None = None  # counted when first asked for
        self._stamp = 0
        self.set_effects(effects)
        self.set_cells(cell_size, table_size)

    # -- what it is made of -------------------------------------------------------------------------

    def set_cells(self, cell_size: float, table_size: int) -> None:
        """Another grid and table from now on; what was found stays until the next `find`."""
        if not 0.0 < cell_size < math.inf or not 0.0 < 1.0 / cell_size < math.inf:
            raise ValueError(f"cell_size = {cell_size!r}: expected a finite number above 0 m")
        if (
            isinstance(table_size, bool)
            or not isinstance(table_size, int)
            or not 1 <= table_size <= MOST_SLOTS
        ):
            raise ValueError(f"table_size = {table_size!r}: expected a whole number, 1 to {MOST_SLOTS}")
        self.cell_size = cell_size
        self.slots = np.zeros((table_size, SLOT_COLUMNS), dtype=np.int32)
        self._stamp = 0
        self._worked = None
        n = self.store.vertices
        self._vertices = VertexTable(
            self.slots, np.zeros(n, dtype=np.int32), np.zeros((n, 2), dtype=np.int32), np.zeros((n, 2)),
            np.zeros(n, dtype=np.int32),
        )  # fmt: skip
        self._set_rim_room(6 * len(self.store.topology.rim) + 64)

    def _set_rim_room(self, places: int) -> None:
        self._rim = RimTable(
            self.slots, np.zeros(places, dtype=np.int32), np.zeros((places, 2), dtype=np.int32),
            np.zeros((places, 4)), np.zeros(places + 1, dtype=np.int32),
        )  # fmt: skip

    def set_effects(self, effects: EffectSet) -> None:
        """What is looked for from now on."""
        self.mask = SOFT.mask(effects) & SOFT.mask(BOTH)

    # -- detection ----------------------------------------------------------------------------------

    def find(self, points: ArrayLike) -> None:
        """Detect for vertices at (n, 2) m. ValueError unless all are finite."""
        self.points[:] = points
        self._worked = None
        if not finite_doubles(self.points.reshape(-1).view(np.uint64)):
            raise ValueError("points: expected finite numbers")
        self._find_contacts()
        self._find_crossings()
        self.rings = measure_depths(
            self.points, self.inside, self.store.topology, self._crossings, self._crossed, self.depths
        )

    def _next_stamp(self) -> int:
        if self._stamp == LAST_STAMP:
            self.slots[:, STAMP] = 0
            self._stamp = 0
        self._stamp += 1
        return self._stamp

    def _find_contacts(self) -> None:
        while True:
            found = find_vertices(
                self.mask, self.points, self.store.topology, self._vertices, 1.0 / self.cell_size,
                self._next_stamp(), self._contacts,
            )  # fmt: skip
            if found <= len(self._contacts) - self.store.vertices - 1:
                break
            self._contacts = np.zeros(2 * found + self.store.vertices + 1, dtype=np.int64)
        self._found = found
        self.contact_keys.sort()
        self.inside[:] = 0
        self.inside[self.contact_keys & 0xFFFF_FFFF] = 1

    def _find_crossings(self) -> None:
        while True:
            found = find_crossings(
                self.mask, self.points, self.inside, self.store.topology, self._rim, 1.0 / self.cell_size,
                self._next_stamp(), self._crossings,
            )  # fmt: skip
            if found < 0:
                self._set_rim_room(-2 * found)
            elif found > len(self._crossings):
                self._crossings = np.zeros(2 * found, dtype=np.int64)
            else:
                break
        self._crossed = found
        self.crossing_keys.sort()

    # -- what was found -----------------------------------------------------------------------------

    @property
    def contact_keys(self) -> Longs:
        """(c,) triangle << 32 | vertex in it, ascending; a view, good until the next `find`."""
        return self._contacts[: self._found]

    @property
    def crossing_keys(self) -> Longs:
        """(c,) edge << 32 | edge of the rim that it crosses, ascending; a view as above."""
        return self._crossings[: self._crossed]

    def _work(self) -> tuple[Counts, Longs]:
        """Counts of a pass over vertices at the places of now, and the loads of all slots, (slots,)."""
        if self._worked is not None:
            return self._worked
        scale, stamp = 1.0 / self.cell_size, self._next_stamp()
        place_vertices(self.points, self._vertices, scale, stamp)
        count_work(self.points, self.store.topology, self._vertices, scale, stamp, self._counters)
        loads = np.where(self.slots[:, STAMP] == stamp, self.slots[:, LOAD], 0).astype(np.int64)
        self._worked = Counts(*self._counters.tolist()), loads
        return self._worked

    @property
    def counts(self) -> Counts:
        """The work that a pass over vertices is, counted apart from it."""
        return self._work()[0]

    @property
    def loads(self) -> Longs:
        """(slots,) how many vertices each slot has."""
        return self._work()[1]

    def naive(self) -> tuple[Longs, Longs]:
        """What all pairs tested give for the places of the last `find`: contact and crossing keys, sorted."""
        contacts, crossings = self._contacts.copy(), self._crossings.copy()
        while (found := all_vertices(self.mask, self.points, self.store.topology, contacts)) > len(contacts):
            contacts = np.zeros(found, dtype=np.int64)
        contacts = np.sort(contacts[:found])
        inside = np.zeros_like(self.inside)
        inside[contacts & 0xFFFF_FFFF] = 1
        while (crossed := all_edges(self.mask, self.points, inside, self.store.topology, crossings)) > len(
            crossings
        ):
            crossings = np.zeros(crossed, dtype=np.int64)
        return contacts, np.sort(crossings[:crossed])
