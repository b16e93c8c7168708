"""The state of the colliding spheres, and the way back to one, with other spheres if need be."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.spheres.collisions import CollisionState
from game.physics.spheres.composition import Composition
from game.physics.spheres.spheres import MotionState, SphereBodies
from game.scenes.spheres.model import CollisionModel

NOTHING = np.zeros((0, 3))


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


def state_of(model: CollisionModel) -> SphereState:
    """The arrays themselves."""
    world, exact = model.world, model.exact
    around = world.surroundings
    beside = (exact.positions, exact.velocities) if exact is not None else (NOTHING, NOTHING)
    return SphereState(*world.state(), *world.bodies.composition, around.hung, around.strings, *beside)


def restore(model: CollisionModel, state: SphereState) -> None:
    """Take over a copy of a state."""
    composition = Composition(
        state.masses.copy(), state.inverse_inertias.copy(), state.round_bodies.copy(), state.radii.copy(),
        state.owners.copy(), state.offsets.copy(), state.kinds.copy(),
    )  # fmt: skip
    around = model.world.surroundings
    mine: tuple[Any, ...] = (*model.world.bodies.composition, around.hung, around.strings)
    theirs: tuple[Any, ...] = (*composition, state.hung, state.strings)
    if not all(np.array_equal(a, b) for a, b in zip(mine, theirs, strict=True)):
        motion = MotionState(*(part.copy() for part in state[:4]))
        around = around._replace(hung=state.hung.copy(), strings=state.strings.copy())
        model.take_bodies(SphereBodies.of_parts(composition, motion), around)
    model.world.restore(CollisionState(**{name: getattr(state, name) for name in CollisionState._fields}))
    model.exact = None
    if len(state.exact_places):
        exact = model.begin_exact()
        np.copyto(exact.positions, state.exact_places)
        np.copyto(exact.velocities, state.exact_speeds)
