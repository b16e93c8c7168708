"""Air on demand: particles of air where falling liquid closes over them (Müller and others 2005).

Air above a liquid weighs nothing here and is not computed. Where the surface looks down and moves, air would
be enclosed: a particle of it is made there. One that has no liquid above it any more is taken away.
"""

from __future__ import annotations

import numpy as np

from game.arrays import Flags, Floats, Longs
from game.physics.particle_fluids.fluid import ParticleFluid
from game.physics.particle_fluids.sums import fill_gradients
from game.physics.particle_fluids.walls import is_held

DOWNWARDS = 0.5  # least share of the outward direction that points down
STEEP = 0.25  # least change of density over a support: at a surface
LEAST_SPEED = 1.0  # sqrt(g spacing)
NEAR = 0.8  # spacings: no air is made nearer than that to anything
MOST_AT_ONCE = 8
COVERED = 0.35  # share of liquid in a particle's surroundings below which air is free


def air_kind(fluid: ParticleFluid) -> int:
    """The kind that is air on demand, or -1."""
    return next((number for number, one in enumerate(fluid.liquids) if one.air), -1)


def renew_air(fluid: ParticleFluid) -> tuple[int, int]:
    """Make air where it is about to be enclosed, take away what is free; how many of each."""
    kind = air_kind(fluid)
    if kind < 0 or not len(fluid.place):
        return 0, 0
    work = fluid.scratch()
    work.gather(fluid)
    outward = np.zeros((len(work.order), 2))
    fill_gradients(work.pairs, work.felt, work.body, outward)
    free = _free(fluid, work.pairs.start, work.pairs.other, work.felt.weight, kind)
    gone = np.zeros(len(fluid.place), dtype=bool)
    gone[work.order[(work.kind == kind) & free & (work.body.light > 0.0)]] = True
    steep = np.sqrt(np.sum(np.square(outward), axis=1))
    down = np.maximum(outward[:, 1], 0.0) / np.maximum(steep, 1e-12)
    least = LEAST_SPEED * np.sqrt(fluid.settings.gravity * fluid.spacing)
    falling = -work.velocity[:, 1] > least
    wanted = np.flatnonzero(
        (work.kind != kind) & (work.body.light > 0.0) & falling
        & (down > DOWNWARDS) & (steep * fluid.support > STEEP)
    )  # fmt: skip
    made = _make(fluid, kind, work.place, work.velocity, -outward / np.maximum(steep, 1e-12)[:, None], wanted)
    number = int(np.sum(gone))
    if number:
        fluid.remove(np.concatenate([gone, np.zeros(made, dtype=bool)]))
    return made, number


def _free(fluid: ParticleFluid, start: Longs, other: Longs, weight: Floats, kind: int) -> Flags:
    """(n,) sorted: whether next to no liquid is around."""
    count = len(start) - 1
    first = np.repeat(np.arange(count), np.diff(start))
    second, felt = other[: len(first)], weight[: len(first)] * fluid.spacing * fluid.spacing
    liquid = fluid.scratch().kind != kind
    around = np.bincount(first, felt * liquid[second], count) + np.bincount(
        second, felt * liquid[first], count
    )
    return np.asarray(around < COVERED)


def _make(
    fluid: ParticleFluid, kind: int, place: Floats, velocity: Floats, outward: Floats, wanted: Longs
) -> int:
    """Air at a spacing from the surface, a few at once, where there is space; how many."""
    made = 0
    for i in wanted[np.argsort(place[wanted, 1], kind="stable")]:
        at = place[i] + fluid.spacing * outward[i]
        nearest = float(np.min(np.sum(np.square(fluid.place - at), axis=1)))
        if nearest < NEAR * NEAR * fluid.spacing * fluid.spacing or not is_held(fluid.edges, at):
            continue
        fluid.add([at], kind, velocity[i])
        made += 1
        if made == MOST_AT_ONCE:
            break
    return made
