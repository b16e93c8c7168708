"""Soft bodies: meshes moved by position based dynamics, that push each other and themselves apart."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.physics.constraints import PositionBasedDynamics, PositionState
from game.physics.constraints.effects import LINKED
from game.physics.deformables.collider import BOTH, MeshCollider
from game.physics.deformables.effects import PUSHING, SOFT
from game.physics.deformables.meshes import MeshStore, mean_edge
from game.physics.deformables.pushing import push_out
from game.physics.effects import EffectSet

MOST_SUBSTEPS = 100


class Pushing(NamedTuple):
    """stiffness: share of a depth that a substep takes away, 0 to 1; friction: coefficient, 0 or more."""

    stiffness: float = 0.5
    friction: float = 0.3


class SoftBodies:
    """Meshes whose edges keep their lengths and whose outlines keep their areas.

    points: (n, 2) m, where they are; rest: (n, 2) m, where they are at rest, else the same.
    inverse_masses: (n,) 1/kg, 0 is fixed. velocities: (n, 2) m/s. effects: of SOFT. settings: fields of
    `constraints.Settings`. ValueError, naming the argument, for nonsense.
    """

    def __init__(
        self,
        store: MeshStore,
        points: ArrayLike,
        inverse_masses: ArrayLike = 1.0,
        *,
        rest: ArrayLike | None = None,
        velocities: ArrayLike | None = None,
        effects: EffectSet = SOFT.known,
        **settings: Any,
    ):
        places = np.array(points, dtype=np.float64)
        calm = places if rest is None else np.array(rest, dtype=np.float64)
        self.store = store
        self.mean_edge = mean_edge(store, calm)
        self.substeps = 1
        self.pushing = Pushing()
        edges = store.topology.edges
        loops = [loop.tolist() for loop in store.loops]
        self.effects = SOFT.checked(effects)
        self.system = PositionBasedDynamics(
            calm, inverse_masses, edges, areas=loops, velocities=velocities, effects=self._of_links(),
            **settings,
        )  # fmt: skip
        self.system.fields[:2, : store.vertices] = places.T
        self.collider = MeshCollider(store, self.mean_edge, 1009, BOTH & self.effects)
        self._shares = np.zeros(store.vertices, dtype=np.int64)
        self._stale = True

    def _of_links(self) -> EffectSet:
        return EffectSet(effect for effect in self.effects if LINKED.mask(effect))

    # -- changes ------------------------------------------------------------------------------------

    def set_effects(self, effects: EffectSet) -> None:
        """Compute these from now on."""
        self.effects = SOFT.checked(effects)
        self.system.change(effects=self._of_links())
        self.collider.set_effects(self.effects)
        self._stale = True

    def set_cells(self, cell_size: float, table_size: int) -> None:
        """Another grid (m) and table (slots)."""
        self.collider.set_cells(cell_size, table_size)
        self._stale = True

    def set_steps(self, substeps: int, pushing: Pushing) -> None:
        """Substeps of a step, and how contacts push. ValueError for nonsense."""
        if isinstance(substeps, bool) or not 1 <= substeps <= MOST_SUBSTEPS:
            raise ValueError(f"substeps = {substeps!r}: expected a whole number, 1 to {MOST_SUBSTEPS}")
        if not 0.0 <= pushing.stiffness <= 1.0:
            raise ValueError(f"stiffness = {pushing.stiffness!r}: expected 0 to 1")
        if not 0.0 <= pushing.friction < math.inf:
            raise ValueError(f"friction = {pushing.friction!r}: expected a finite number of at least 0")
        self.substeps, self.pushing = substeps, pushing

    # -- a step -------------------------------------------------------------------------------------

    def detect(self) -> None:
        """Find contacts where the vertices are now, unless that was done."""
        if self._stale:
            self.collider.find(self.system.fields[:2, : self.store.vertices].T)
            self._stale = False

    def push(self) -> None:
        """Move what is inside of others, or of itself, apart, by where it is now."""
        self.detect()
        collider = self.collider
        if len(collider.contact_keys):
            push_out(
                self.system.fields, collider.points, self.store.topology, collider.contact_keys,
                len(collider.contact_keys), collider.depths, self._shares, *map(float, self.pushing),
            )  # fmt: skip
            self._stale = True

    def step(self, dt: float) -> None:
        """Go on by dt (s): in each substep first apart, then on. ValueError unless finite and above 0."""
        for _ in range(self.substeps):
            if PUSHING in self.effects and self.collider.mask:
                self.push()
            self.system.step(dt / self.substeps)
            self._stale = True

    # -- what there is ------------------------------------------------------------------------------

    @property
    def points(self) -> Floats:
        """(n, 2) m, a copy."""
        return self.system.positions

    def deepest(self) -> float:
        """The depth (m) of the deepest vertex."""
        self.detect()
        return float(np.max(self.collider.depths[0], initial=0.0))

    def state(self) -> PositionState:
        """All that later steps depend on."""
        return self.system.state()

    def restore(self, state: PositionState) -> None:
        """Take over a copy of a state."""
        self.system.restore(state)
        self._stale = True
