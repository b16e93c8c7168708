"""What keeps particles apart, by the law that is chosen: velocities and places after a step."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from game.physics.particle_fluids.effects import SPRINGS
from game.physics.particle_fluids.pressure import relieve
from game.physics.particle_fluids.printed import (
    NEAR_STIFFNESS,
    meet_densities,
    relax_twice,
    smooth_velocities,
)
from game.physics.particle_fluids.scratch import Scratch
from game.physics.particle_fluids.settings import CLAVET, DFSPH, MUELLER
from game.physics.particle_fluids.smoothing import POLY6, fill_kernel
from game.physics.particle_fluids.springs import pull_springs
from game.physics.particle_fluids.store import FluidStore
from game.physics.particle_fluids.sums import add_changes, fill_bound, keep_apart, push_by_pressure
from game.physics.particle_fluids.walls import MARGIN, fill_contacts

LEAST_GAP = 0.5  # spacings
STABILISED = 2  # iterations before a step's own
CLUMPING, XSPH = 2e-4, 0.01
GROWS = 0.5  # s that velocities would need to make the error of density that is allowed


def follow_law(fluid: FluidStore, work: Scratch, dt: float) -> int:
    """Move the sorted particles by dt (s). Returns the iterations made."""
    law = fluid.settings.law
    if law == DFSPH:
        return _careful(fluid, work, dt)
    if law == MUELLER:
        return _squeezed(fluid, work, dt)
    return _displaced(fluid, work, dt, law == CLAVET)


def _careful(fluid: FluidStore, work: Scratch, dt: float) -> int:
    settings, common = fluid.settings, (work.pairs, work.felt, work.body)
    fill_contacts(work.place, fluid.edges, fluid.spacing, MARGIN * fluid.spacing, work.contacts)
    fill_bound(*common, work.work.total, work.spread, work.work.response)
    allowed = settings.error * dt / GROWS
    made, _ = relieve(
        *common,
        work.contacts,
        work.velocity,
        work.pressure[1],
        work.work,
        (dt, allowed, settings.iterations, 1),
    )
    work.spare[:] = work.velocity
    work.pressure[0] = 0.0
    more, _ = relieve(
        *common,
        work.contacts,
        work.spare,
        work.pressure[0],
        work.work,
        (dt, 0.3 * settings.error, settings.iterations, 0),
    )
    work.place[:] += dt * work.spare
    keep_apart(work.pairs, work.body, work.place, LEAST_GAP * fluid.spacing, work.spare)
    _pull(fluid, work, dt)
    return int(made + more)


def _squeezed(fluid: FluidStore, work: Scratch, dt: float) -> int:
    """The state p = c² ρ (α - 1); half of the mean of two pressures acts, as printed."""
    excess = work.work.density - 1.0
    stiff = fluid.settings.softness * fluid.settings.softness
    pressure = work.pressure[0]
    pressure[:] = 0.5 * stiff * fluid.densities[work.kind] * np.maximum(excess, 0.0)
    push_by_pressure(work.pairs, work.felt, work.body, pressure, work.work.pushed)
    work.work.pushed[:] *= dt
    add_changes(work.velocity, work.work.pushed, fluid.settings.softness)
    work.place[:] += dt * work.velocity
    _pull(fluid, work, dt)
    return 1


def _displaced(fluid: FluidStore, work: Scratch, dt: float, twice: bool) -> int:
    """Predict places, displace them, and take velocities from what came of it.

    Errors that a step begins with are lessened first, without a velocity (Macklin and others 2014).
    """
    settings, rest = fluid.settings, rest_density(POLY6)
    made = 1 if twice else int(settings.iterations)
    densities = (work.pairs, work.body, work.place, fluid.support, work.work, work.now, (CLUMPING, rest))
    for _ in range(0 if twice else STABILISED):
        meet_densities(*densities)
    before = work.place.copy()
    work.place[:] += dt * work.velocity
    _pull(fluid, work, dt)
    predicted = work.place.copy()
    if twice:
        scale = settings.softness / fluid.support
        relax_twice(
            work.pairs, work.body, work.place, fluid.support, work.spare, work.work,
            (scale * scale, *rest_room(), dt),
        )  # fmt: skip
    else:
        for _ in range(made):
            meet_densities(*densities)
    work.spare[:] = work.place - predicted
    work.place[:] = predicted
    add_changes(work.place, work.spare, settings.softness * dt)
    moving = work.body.light > 0.0
    work.velocity[moving] = (work.place[moving] - before[moving]) / dt
    if not twice:
        smooth_velocities(work.pairs, work.body, work.felt, XSPH, work.velocity, work.spare)
    return made


def _pull(fluid: FluidStore, work: Scratch, dt: float) -> None:
    if SPRINGS not in fluid.active or len(fluid.partner) != len(fluid.place):
        return
    settings = fluid.settings
    before = work.place.copy()
    springy = np.zeros(len(work.order), dtype=np.int64)
    springy[: work.count] = fluid.springy[fluid.kind]
    pull_springs(
        work.pairs, work.order, work.body, work.place,
        (fluid.partner, fluid.length, np.zeros(fluid.partner.shape, dtype=np.int64)),
        (settings.stiffness, settings.borne, settings.flow, 1.5 * fluid.spacing, fluid.support, dt, springy),
    )  # fmt: skip
    work.velocity[:] += (work.place - before) / dt


@lru_cache(maxsize=8)
def rest_density(kind: int) -> float:
    """Relative density of a square lattice of 1 at a support of 2 spacings, as a kernel has it."""
    at = np.arange(-2, 3)
    gaps = np.sqrt(np.add.outer(at * at, at * at).astype(np.float64)).ravel() / 2.0
    value = np.zeros(len(gaps))
    fill_kernel(kind, np.minimum(gaps, 1.0), value, np.zeros(len(gaps)))
    return float(np.sum(value)) / 4.0


@lru_cache(maxsize=1)
def rest_room() -> tuple[float, float]:
    """Σ (1 - q)² of a particle's neighbours on that lattice, and how many times that has no pressure.

    The sum of distance and force over the neighbours is 0: near repulsion against the other's pull.
    """
    at = np.arange(-1, 2)
    gaps = np.sqrt(np.add.outer(at * at, at * at).astype(np.float64)).ravel() / 2.0
    gaps = gaps[gaps > 0.0]
    room = 1.0 - gaps
    rest = float(np.sum(room * room))
    near = NEAR_STIFFNESS * float(np.sum(room * room * room)) / rest
    return rest, 1.0 / (1.0 - near * float(np.sum(gaps * room * room)) / float(np.sum(gaps * room)))
