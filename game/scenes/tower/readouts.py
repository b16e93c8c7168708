"""What is measured of the tower, beside what the law says."""

from __future__ import annotations

import math

import numpy as np

from game.physics.accretion import LIMIT
from game.scenes.tower.measures import (
    fall_of,
    free_fall_of,
    mass_of,
    paces_of,
    pieces_of,
    roof_of,
    standing,
    struck,
    whole_columns,
)
from game.scenes.tower.model import NOT_FIRED, TowerModel
from game.stage import Readout

TONNE = 1000.0  # kg


def readouts(model: TowerModel) -> list[Readout]:
    """The fall first, then the debris."""
    took, law, way = fall_of(model)
    mass, paces = mass_of(model), paces_of(model)
    since = model.time - model.fired if model.fired != NOT_FIRED else math.nan
    return [
        Readout("since the firing", since, "s"),
        Readout("storeys standing", standing(model)),
        Readout("whole columns", whole_columns(model)),
        Readout("floors struck", struck(model)),
        Readout("fall", took, "s"),
        Readout("law", law, "s"),
        Readout("law error", 100.0 * (took / law - 1.0), "%"),
        Readout("free fall", free_fall_of(model), "s"),
        Readout("first pace", float(paces[0]) if len(paces) else math.nan, "m/s"),
        Readout("pace", float(paces[-1]) if len(paces) else math.nan, "m/s"),
        Readout("faster floors", int(np.count_nonzero(np.diff(paces) > 0.0))),
        Readout("front", 2.0 * way / (took * took), "m/s²"),
        Readout("front by law", 2.0 * way / (law * law), "m/s²"),
        Readout("a third of g", LIMIT * model.gravity(), "m/s²"),
        Readout("roof", roof_of(model), "m"),
        Readout("pieces", pieces_of(model)),
        Readout("mass", mass / TONNE, "t"),
        Readout("mass lost", abs(mass + model.dusted - model.built_mass) / model.built_mass, ""),
        Readout("awake", model.awake()),
        Readout("dust in the air", model.air.in_the_air(), "kg"),
        Readout("dust raised", model.dusted, "kg"),
        Readout("fastest air", model.air.fastest(), "m/s"),
        Readout("a step", model.watch.median("step"), "s"),
        Readout("a step of the air", model.watch.median("air"), "s"),
    ]
