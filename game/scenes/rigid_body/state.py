"""The state of the rigid body scene, and the way back to one, of other spheres if need be."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.scenes.rigid_body.model import RigidModel

Array = NDArray[np.float64]


class RigidState(NamedTuple):
    """What moves, of what it is made, and what is remembered of it."""

    rows: Array  # (3, 13)
    accounts: Array  # (3, 4)
    design: Array  # (n, 6)
    density: float  # kg/m³
    trail: Array  # (2, TRAIL, 3): direction of L in the body's frame, by step number modulo TRAIL


def state_of(model: RigidModel) -> RigidState:
    """The model's own arrays, not copies."""
    bodies = model.bodies
    return RigidState(bodies.rows, bodies.accounts, bodies.design, bodies.density, model.trail)


def restore(model: RigidModel, state: RigidState) -> None:
    """Put a state back; bodies of another design are made again."""
    model.bodies.take(state.rows, state.design, float(state.density))
    np.copyto(model.bodies.accounts, state.accounts)
    np.copyto(model.trail, state.trail)
    model.configure()
