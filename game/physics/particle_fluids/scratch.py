"""Sorted copies of a fluid's particles, wall particles among them, and what their pairs feel."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats, Longs
from game.physics.fields import GRAVITY
from game.physics.particle_fluids.pressure import Work
from game.physics.particle_fluids.search import NeighbourSearch, Pairs, gather
from game.physics.particle_fluids.settings import MUELLER
from game.physics.particle_fluids.smoothing import POLY6, SPIKY, fill_kernel
from game.physics.particle_fluids.store import FluidStore
from game.physics.particle_fluids.sums import Body, Felt, fill_density, weigh
from game.physics.particle_fluids.walls import Contacts, fill_shares, wall_table

ROW_SHARE = 0.8  # of the plane's volume that a row of wall particles stands for, within its kernels


class Scratch:
    """Arrays of one size; rows from ``count`` on are wall particles before they are sorted."""

    def __init__(self, count: int, walls: Floats, spacing: float, search: NeighbourSearch):
        self.count, self.walls, self.search = count, walls, search
        rows = count + len(walls)
        self.all_places: Floats = np.zeros((rows, 2))
        self.all_places[count:] = walls
        self.volumes: Floats = np.full(rows, spacing * spacing)
        self.volumes[count:] = row_volumes(walls, search.support)
        self.body = Body(
            np.zeros(rows), np.zeros(rows), np.zeros(rows), np.zeros((rows, 2)), np.zeros((rows, 2))
        )
        self.velocity: Floats = np.zeros((rows, 2))
        self.spare: Floats = np.zeros((rows, 2))
        self.vectors: Floats = np.zeros((4, rows, 2))
        self.spread: Floats = np.zeros((3, rows))
        self.contacts = Contacts(np.zeros((rows, 2, 2)), np.full((rows, 2), np.inf))
        self.kind: Longs = np.zeros(rows, dtype=np.int64)
        self.pressure: Floats = np.zeros((2, rows))
        self.work = Work(
            np.zeros((rows, 2)), np.zeros((rows, 2)), np.zeros(rows), np.zeros(rows), np.zeros(rows),
            np.zeros(rows),
        )  # fmt: skip
        self.wall_drag: Floats = np.zeros(rows)
        self.pair_drag: Floats = np.zeros(0)
        self.now: Floats = np.zeros((0, 4))
        self.felt = Felt(np.zeros(0), np.zeros((0, 2)))
        self.pairs: Pairs = search.pairs

    def fits(self, count: int, walls: int, method: str) -> bool:
        """Whether it is of that size and search."""
        return (self.count, len(self.walls), self.search.method) == (count, walls, method)

    @property
    def order(self) -> Longs:
        """Which particle stands where."""
        return self.search.order

    @property
    def place(self) -> Floats:
        """Sorted, m."""
        return self.search.place

    def sorted_rows(self, values: Floats) -> Floats:
        """Values (n,) of particles in sorted order, 0 for wall particles."""
        found = np.zeros(len(self.all_places))
        found[: self.count] = values
        return found[self.order]

    def unsort_rows(self, values: Floats, target: Floats) -> None:
        """Give sorted values back to particles (n,)."""
        found = np.empty(len(self.all_places))
        found[self.order] = values
        target[:] = found[: self.count]

    def gather(self, fluid: FluidStore) -> None:
        """Sort the particles of a fluid, find their pairs, and what these feel."""
        self.all_places[: self.count] = fluid.place
        self.pairs = self.search.find(self.all_places)
        order = self.order
        fluid_first = self.spare
        fluid_first[:], fluid_first[: self.count] = 0.0, fluid.velocity
        gather(order, fluid_first, self.velocity)
        self.body.volume[:] = self.volumes[order]
        self.body.light[:] = self.sorted_rows(1.0 / fluid.masses())
        kinds = np.zeros(len(order), dtype=np.int64)
        kinds[: self.count] = fluid.kind
        self.kind[:] = kinds[order]
        for row in range(2):
            self.pressure[row] = self.sorted_rows(fluid.pressure[row])
        self.body.origin[:] = self.place
        self.feel(fluid)

    def feel(self, fluid: FluidStore) -> None:
        """Kernels of the pairs and of the walls, by the fluid's settings; then the relative densities."""
        made = len(self.pairs.other)
        if len(self.felt.weight) != made:
            self.felt = Felt(np.zeros(made), np.zeros((made, 2)))
            self.pair_drag = np.zeros(made)
            self.now = np.zeros((made, 4))
        kinds = (POLY6, SPIKY) if fluid.settings.law == MUELLER else (fluid.settings.kernel,) * 2
        support = self.search.support
        weigh(self.pairs, support, kinds, self.felt)
        fill_shares(
            self.place, fluid.edges, (fluid.settings.walls, kinds[0], support), wall_table(kinds[0]),
            self.body.share, self.body.push,
        )  # fmt: skip
        fill_density(self.pairs, self.felt, self.body, own_weight(kinds[0], support), self.work.density)

    def scatter(self, fluid: FluidStore) -> None:
        """Give places, velocities and pressures back."""
        for values, target in ((self.place, fluid.place), (self.velocity, fluid.velocity)):
            self.spare[self.order] = values
            target[:] = self.spare[: self.count]
        for row in range(2):
            self.unsort_rows(self.pressure[row], fluid.pressure[row])


def own_weight(kind: int, support: float) -> float:
    """A kernel at its own place, 1/m²."""
    value = np.zeros(1)
    fill_kernel(kind, np.zeros(1), value, np.zeros(1))
    return float(value[0]) / (support * support)


def row_volumes(walls: Floats, support: float) -> Floats:
    """(m,) m³ for 1 m of depth: what each wall particle stands for."""
    if not len(walls):
        return np.zeros(0)
    search = NeighbourSearch(support)
    pairs = search.find(walls)
    felt = Felt(np.zeros(len(pairs.other)), np.zeros((len(pairs.other), 2)))
    weigh(pairs, support, (0, 0), felt)
    none, nowhere = np.zeros(len(walls)), np.zeros((len(walls), 2))
    ones = Body(np.ones(len(walls)), none, none, nowhere, nowhere)
    total, found = np.zeros(len(walls)), np.zeros(len(walls))
    fill_density(pairs, felt, ones, own_weight(0, support), total)
    found[search.order] = ROW_SHARE / total
    return found


def weight_of(fluid: FluidStore) -> float:
    """m/s² downwards, as it acts."""
    return fluid.settings.gravity if GRAVITY in fluid.active else 0.0
