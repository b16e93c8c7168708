"""The particles of a fluid, what they are made of, and what is measured of them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats, Longs
from game.physics.effects import EffectSet
from game.physics.fields import GRAVITY
from game.physics.particle_fluids.adhesion import adhesion
from game.physics.particle_fluids.effects import PARTICLE_FLUIDS
from game.physics.particle_fluids.settings import FluidSettings, Liquid
from game.physics.particle_fluids.springs import NO_SPRING, SLOTS
from game.physics.particle_fluids.walls import edges_of, wall_places

SUPPORT = 2.0  # spacings: about 12 neighbours
ROOM_HEAT = 293.15  # K
MOST_PARTICLES = 200_000


class FluidState(NamedTuple):
    """place, velocity: (n, 2) m, m/s; kind (n,); heat: (n,) K; pressure: (2, n) Pa, to begin with.

    partner, length: (n, SLOTS) springs, or (0, SLOTS) where there are none; clock: (3,) s since the start,
    substeps, particles that were brought back from outside.
    """

    place: Floats
    velocity: Floats
    kind: Longs
    heat: Floats
    pressure: Floats
    partner: Longs
    length: Floats
    clock: Floats


class FluidStore:
    """Particles ``spacing`` (m) apart at rest, of some kinds of liquid, in a vessel of closed loops."""

    def __init__(
        self,
        spacing: float,
        liquids: Sequence[Liquid] = (Liquid(),),
        vessel: Sequence[ArrayLike] = (),
        settings: FluidSettings | None = None,
        active: EffectSet = PARTICLE_FLUIDS.known,
    ):
        """ValueError for nonsense. vessel: corners (m, 2) of its outline, then of what stands in it."""
        if not 1e-6 <= spacing <= 1e6:
            raise ValueError(f"spacing = {spacing!r}: expected a length from 1e-6 to 1e6 m")
        self.spacing, self.support = float(spacing), SUPPORT * float(spacing)
        self.settings, self.active = settings or FluidSettings(), active
        self.liquids = tuple(one.checked(len(liquids)) for one in liquids)
        self.edges = edges_of(vessel)
        self.rows = wall_places(self.edges, self.spacing)
        self.place: Floats = np.zeros((0, 2))
        self.velocity: Floats = np.zeros((0, 2))
        self.kind: Longs = np.zeros(0, dtype=np.int64)
        self.heat: Floats = np.zeros(0)
        self.pressure: Floats = np.zeros((2, 0))
        self.partner: Longs = np.full((0, SLOTS), NO_SPRING, dtype=np.int64)
        self.length: Floats = np.zeros((0, SLOTS))
        self.clock: Floats = np.zeros(3)
        self.iterations, self.error, self.worst = 0, 0.0, 0.0
        self._take_liquids()

    def _take_liquids(self) -> None:
        one = self.liquids
        self.densities: Floats = np.array([a.density for a in one])
        self.viscosities: Floats = np.array([a.viscosity for a in one])
        self.swellings: Floats = np.array([a.swelling for a in one])
        self.springy: Longs = np.array([a.springy for a in one], dtype=np.int64)
        self.adhesion = adhesion([a.tension for a in one], self.support)
        self.boiling: Floats = np.array([(a.boils, a.latent) for a in one])

    def set_liquids(self, liquids: Sequence[Liquid]) -> None:
        """Other properties of the kinds that there are. ValueError for another number of kinds."""
        if len(liquids) != len(self.liquids):
            raise ValueError(f"liquids: expected {len(self.liquids)}, not {len(liquids)}")
        self.liquids = tuple(one.checked(len(liquids)) for one in liquids)
        self._take_liquids()

    # -- particles ------------------------------------------------------------------------------------

    def add(self, places: ArrayLike, kind: int = 0, velocity: ArrayLike = (0.0, 0.0),
            heat: float = ROOM_HEAT) -> None:  # fmt: skip
        """More particles at places (n, 2) m. ValueError for nonsense, or more than ``MOST_PARTICLES``."""
        new = np.array(places, dtype=np.float64).reshape(-1, 2)
        if not (np.isfinite(new).all() and np.isfinite(np.asarray(velocity)).all()):
            raise ValueError("places, velocity: expected finite numbers")
        if not 0 <= kind < len(self.liquids):
            raise ValueError(f"kind = {kind!r}: there are {len(self.liquids)}")
        if not 0.0 < heat < math.inf:
            raise ValueError(f"heat = {heat!r}: expected a temperature above 0 K")
        if len(self.place) + len(new) > MOST_PARTICLES:
            raise ValueError(f"particles: expected at most {MOST_PARTICLES}")
        count = len(new)
        self.place = np.concatenate([self.place, new])
        self.velocity = np.concatenate(
            [self.velocity, np.broadcast_to(np.asarray(velocity, float), new.shape)]
        )
        self.kind = np.concatenate([self.kind, np.full(count, kind, dtype=np.int64)])
        self.heat = np.concatenate([self.heat, np.full(count, float(heat))])
        self.pressure = np.concatenate([self.pressure, np.zeros((2, count))], axis=1)
        if len(self.partner):
            self._make_springs(len(self.place))

    def remove(self, which: ArrayLike) -> None:
        """Take particles away; which: (n,) flags."""
        kept = ~np.asarray(which, dtype=bool)
        if self.partner.size:
            number = np.where(kept, np.cumsum(kept) - 1, NO_SPRING)
            partner = np.where(self.partner >= 0, number[self.partner], NO_SPRING)
            self.partner, self.length = partner[kept], self.length[kept]
        self.place, self.velocity = self.place[kept], self.velocity[kept]
        self.kind, self.heat = self.kind[kept], self.heat[kept]
        self.pressure = np.ascontiguousarray(self.pressure[:, kept])

    def _make_springs(self, count: int) -> None:
        partner = np.full((count, SLOTS), NO_SPRING, dtype=np.int64)
        length = np.zeros((count, SLOTS))
        partner[: len(self.partner)], length[: len(self.length)] = self.partner, self.length
        self.partner, self.length = partner, length

    # -- what is there --------------------------------------------------------------------------------

    def masses(self) -> Floats:
        """(n,) kg for each metre of depth: of the kind's density at each particle's temperature."""
        thinner = 1.0 + self.swellings[self.kind] * (self.temperature() - ROOM_HEAT)
        return self.spacing * self.spacing * self.densities[self.kind] / np.maximum(thinner, 0.1)

    def momentum(self) -> Floats:
        """(2,) kg m/s for each metre of depth."""
        return np.asarray(np.sum(self.masses()[:, None] * self.velocity, axis=0))

    def energy(self) -> tuple[float, float]:
        """J for each metre of depth: of motion, and of height above z = 0."""
        mass, weight = self.masses(), self.settings.gravity if GRAVITY in self.active else 0.0
        motion = 0.5 * float(np.sum(mass * np.sum(np.square(self.velocity), axis=1)))
        return motion, weight * float(np.sum(mass * self.place[:, 1]))

    def state(self) -> FluidState:
        """All that later steps depend on."""
        return FluidState(
            self.place,
            self.velocity,
            self.kind,
            self.heat,
            self.pressure,
            self.partner,
            self.length,
            self.clock,
        )

    def restore(self, state: FluidState) -> None:
        """Take over a copy of a state."""
        self.place, self.velocity = state.place.copy(), state.velocity.copy()
        self.kind, self.heat = state.kind.copy(), state.heat.copy()
        self.pressure, self.clock = state.pressure.copy(), state.clock.copy()
        self.partner, self.length = state.partner.copy(), state.length.copy()

    def temperature(self) -> Floats:
        """(n,) K; what boils stays at its boiling point until it has taken the latent heat."""
        points = self.boiling.copy()
        for one in self.liquids:
            if one.vapour >= 0:
                points[one.vapour] = one.boils, one.latent
        boils, latent = points[self.kind].T
        return np.where(self.heat < boils, self.heat, np.maximum(self.heat - latent, boils))
