"""Forces that act whatever the law: weight, surface tension, viscosity."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.physics.particle_fluids.dragging import drag_along, fill_drags
from game.physics.particle_fluids.effects import DRAGGING, TENSION
from game.physics.particle_fluids.printed import viscous_force
from game.physics.particle_fluids.scratch import Scratch, weight_of
from game.physics.particle_fluids.settings import MUELLER
from game.physics.particle_fluids.store import FluidStore
from game.physics.particle_fluids.sums import attract

STEADY = 0.02  # of the speed of sound times the support
DRAG_ERROR, MOST_DRAG = 1e-6, 200  # of the conjugate gradients


def act(fluid: FluidStore, work: Scratch, dt: float) -> None:
    """Change the sorted velocities by what acts in dt (s)."""
    moving = work.body.light > 0.0
    work.velocity[moving, 1] -= weight_of(fluid) * dt
    if TENSION in fluid.active and fluid.adhesion.any():
        attract(work.pairs, fluid.support, fluid.adhesion, work.kind, (work.velocity, work.body, dt))
    explicit = fluid.settings.law == MUELLER
    if DRAGGING not in fluid.active or not (explicit or fluid.viscosities.any()):
        return
    if explicit:
        work.spare[:] = work.velocity
        viscous_force(
            work.pairs, work.body, steadied(fluid), work.kind, fluid.support,
            (work.velocity, work.spare, dt),
        )  # fmt: skip
        return
    drags = (work.pair_drag, work.wall_drag)
    values = (fluid.viscosities, work.kind, 0.5 * fluid.spacing, fluid.support, fluid.settings.sticking)
    fill_drags(work.pairs, work.felt, work.body, drags, values)
    drag_along(work.pairs, work.body, drags, work.velocity, tuple(work.vectors), (dt, DRAG_ERROR, MOST_DRAG))


def steadied(fluid: FluidStore) -> Floats:
    """Viscosities (kinds,) Pa s that keep the explicit law stable; without any it gains energy."""
    least = STEADY * fluid.settings.softness * fluid.support
    return np.maximum(fluid.viscosities, least * fluid.densities)
