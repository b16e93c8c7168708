"""What is measured of the tower, beside what the law says."""

from __future__ import annotations

import math

from game.physics.accretion import LIMIT
from game.scenes.tower.model import NOT_FIRED, TowerModel
from game.stage import Readout

TONNE = 1000.0  # kg


def readouts(model: TowerModel) -> list[Readout]:
    """The fall first, then the debris."""
    took, law, way = model.fall()
    mass = model.mass()
    since = model.time - model.fired if model.fired != NOT_FIRED else math.nan
    return [
        Readout("since the firing", since, "s"),
        Readout("storeys standing", model.standing()),
        Readout("floors struck", model.struck()),
        Readout("fall", took, "s"),
        Readout("law", law, "s"),
        Readout("law error", 100.0 * (took / law - 1.0), "%"),
        Readout("front", 2.0 * way / (took * took), "m/s²"),
        Readout("front by law", 2.0 * way / (law * law), "m/s²"),
        Readout("a third of g", LIMIT * model.gravity(), "m/s²"),
        Readout("roof", model.roof(), "m"),
        Readout("pieces", model.pieces()),
        Readout("mass", mass / TONNE, "t"),
        Readout("mass lost", abs(mass - model.built_mass) / model.built_mass, ""),
        Readout("awake", model.awake()),
        Readout("dust in the air", model.air.in_the_air(), "kg"),
        Readout("dust raised", float(model.air.dust[0]), "kg"),
        Readout("fastest air", model.air.fastest(), "m/s"),
        Readout("a step", model.watch.median("step"), "s"),
        Readout("a step of the air", model.watch.median("air"), "s"),
    ]
