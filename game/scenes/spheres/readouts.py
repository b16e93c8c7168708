"""What is measured of colliding spheres: energy, momenta, penetration, the ledger, the exact run beside."""

from __future__ import annotations

import numpy as np

from game.physics.spheres.ledger import LOST_MOMENTUM
from game.scenes.spheres.model import CollisionModel
from game.stage import Readout

ROUNDING = 1e-9  # m of penetration that is none


def readouts_of(model: CollisionModel) -> list[Readout]:
    """All measured values, the one of the top bar first."""
    world = model.world
    totals = world.totals()
    gaps = world.contacts[0][:, 3]
    penetration = float(np.max(-gaps, initial=0.0))
    return [
        Readout("spheres", len(world.bodies.composition.radii)),
        Readout("collisions", world.collisions),
        Readout("total energy", totals.energy, "J"),
        Readout("contacts", len(gaps)),
        Readout("translational energy", totals.translational, "J"),
        Readout("rotational energy", totals.rotational, "J"),
        Readout("P x", totals.momentum[0], "kg m/s"),
        Readout("P y", totals.momentum[1], "kg m/s"),
        Readout("L z", totals.spin[2], "kg m²/s"),
        Readout("maximum penetration", penetration if penetration > ROUNDING else 0.0, "m"),
        Readout("rounds", world.rounds),
        *_off_exact(model),
        *_weighed(model),
        Readout("pair tests per step", world.tests),
        Readout("parts of the step", world.parts),
    ]


def _weighed(model: CollisionModel) -> list[Readout]:
    """The most momentum that a collision of the ledger made or lost."""
    world = model.world
    entries = world.ring[: min(world.collisions, len(world.ring))]
    return [Readout("momentum lost", float(entries[:, LOST_MOMENTUM].max(initial=0.0)), "kg m/s")]


def _off_exact(model: CollisionModel) -> list[Readout]:
    """How far the spheres are from the event-driven run."""
    if model.exact is None:
        return []
    off = model.exact.positions - model.world.bodies.state.positions
    return [Readout("distance to exact", float(np.sqrt((off * off).sum(axis=1).max())), "m")]
