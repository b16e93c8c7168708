"""What is measured of soft bodies and of their detection."""

from __future__ import annotations

import numpy as np

from game.scenes.deformables.model import DeformablesModel
from game.stage import Readout


def readouts_of(model: DeformablesModel) -> tuple[Readout, ...]:
    """Sizes, contacts, depth, and the work of the table."""
    bodies = model.bodies
    counts = model.counts()
    met = counts.tested + counts.strangers
    found = [
        Readout("triangles", len(bodies.store.topology.triangles)),
        Readout("vertices inside", int(np.count_nonzero(bodies.collider.inside))),
        Readout("contacts", len(model.contacts)),
        Readout("self-contacts", model.of_self()),
        Readout("edges crossing", len(model.crossings)),
        Readout("deepest", bodies.deepest(), "m"),
        Readout("turned over", model.inverted()),
        Readout("cells looked at", counts.visited),
        Readout("tests", counts.tested),
        Readout("false cells", counts.strangers / met if met else 0.0, "of all met"),
        Readout("slots in use", counts.used),
        Readout("longest chain", counts.longest),
        Readout("cell size", bodies.collider.cell_size, "m"),
    ]
    wrong = model.wrong()
    if wrong is not None:
        found.append(Readout("missed or false", wrong))
    return tuple(found)
