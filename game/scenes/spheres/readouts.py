"""What is measured of colliding spheres: energy, momenta, overlap, the ledger, the exact run beside."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from game.physics.spheres.ledger import LOST_MOMENTUM
from game.stage import Readout

if TYPE_CHECKING:
    from game.scenes.spheres.scene import SphereCollisions

ROUNDING = 1e-9  # m of overlap that is none


def readouts_of(scene: SphereCollisions) -> list[Readout]:
    """All measured values, the four of the top bar first."""
    world = scene.world
    totals = world.totals()
    gaps = world.touches[0][:, 3]
    deepest = float(np.max(-gaps, initial=0.0))
    return [
        Readout("spheres", len(world.bodies.makeup.radii)),
        Readout("collisions", world.collisions),
        Readout("sum", totals.energy, "J"),
        Readout("touches", len(gaps)),
        Readout("moving", totals.moving, "J"),
        Readout("turning", totals.turning, "J"),
        Readout("P x", totals.momentum[0], "kg m/s"),
        Readout("P y", totals.momentum[1], "kg m/s"),
        Readout("L z", totals.spin[2], "kg m²/s"),
        Readout("deepest", deepest if deepest > ROUNDING else 0.0, "m"),
        Readout("rounds", world.rounds),
        *_beside_exact(scene),
        *_weighed(scene),
        Readout("pair tests a step", world.tests),
        Readout("parts of a step", world.parts),
    ]


def _weighed(scene: SphereCollisions) -> list[Readout]:
    """The most momentum that a collision of the ledger made or lost."""
    world = scene.world
    entries = world.ring[: min(world.collisions, len(world.ring))]
    return [Readout("momentum lost", float(entries[:, LOST_MOMENTUM].max(initial=0.0)), "kg m/s")]


def _beside_exact(scene: SphereCollisions) -> list[Readout]:
    """How far the spheres are from the event-driven run."""
    if scene.exact is None:
        return []
    off = scene.exact.positions - scene.world.bodies.state.positions
    return [Readout("beside exact", float(np.sqrt((off * off).sum(axis=1).max())), "m")]
