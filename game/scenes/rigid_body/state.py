"""The state of the rigid body scene, and the way back to one, of other spheres if need be."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.scenes.rigid_body.model import RigidModel


class RigidState(NamedTuple):
    """What moves, of what it is made, and what is remembered of it."""

    rows: Floats  # (3, 13)
    accounts: Floats  # (3, 4)
    design: Floats  # (n, 6)
    density: float  # kg/m³
    trail: Floats  # (2, TRAIL, 3): direction of L in the body's frame, by step number modulo TRAIL


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
