"""What is measured of the cloth, its fire and the air."""

from __future__ import annotations

import math

import numpy as np

from game.physics.cloth.layout import THERE, Z
from game.scenes.burning_cloth.model import BurningClothModel
from game.stage import Readout


def readouts_of(model: BurningClothModel) -> list[Readout]:
    """The front first, then the fire, the cloth, the books of heat."""
    cloth, air, fabric, books = model.cloth, model.air, model.cloth.made_of, model.books()
    made = max(books["made"] + model.heat_at_first, 1e-9)  # all the heat that there was to go
    rows = [
        Readout("front", model.front_now, "m/s"),
        Readout("by its law", fabric.front_speed(), "m/s"),
        Readout("Fisher-KPP", fabric.fisher_speed(), "m/s"),
        Readout("last front", float(model.seen[2]) if model.seen[2] > 0.0 else math.nan, "m/s"),
        Readout("power", max(float(model.seen[0]), 0.0), "W"),
        Readout("most power", float(model.seen[1]), "W"),
        Readout("highest flame", float(model.seen[3]), "m"),
        Readout("letters alight", model.letters_alight()),
        Readout("burning", model.alight),
        Readout("letters burnt", 100.0 * model.burnt_of(1.0), "%"),
        Readout("rest burnt", 100.0 * model.burnt_of(0.0), "%"),
        Readout("char", 100.0 * model.charred(), "%"),
        Readout("holes", cloth.holes(), "m²"),
        Readout("meshes lost", int(np.count_nonzero(cloth.whole <= 0.0))),
        Readout("torn", int(cloth.others[8])),
        Readout("pieces", cloth.pieces),
        Readout("fallen", cloth.fallen()),
        Readout("hottest cloth", model.hottest, "K"),
        Readout("hottest gas", float(np.max(air.temperature)), "K"),
        Readout("water left", 1e3 * cloth.water(), "g"),
        Readout("wind", float(air.flows[2]), "m/s"),
        Readout("match", 1.0 if model.match.lit(model.time) else 0.0),
        Readout("swing", swing_of(model), "m"),
    ]
    rows += [
        Readout("heat made", books["made"], "J"),
        Readout("radiated", 100.0 * books["radiated"] / made, "%"),
        Readout("with the air", 100.0 * books["air"] / made, "%"),
        Readout("in the gas", 100.0 * books["gas"] / made, "%"),
        Readout("in the cloth", 100.0 * books["cloth"] / made, "%"),
        Readout("with ash and steam", 100.0 * (books["ash"] + books["steam"]) / made, "%"),
        Readout("open share", 100.0 * books["open"] / made if made > 1.0 else 0.0, "%"),
        Readout("divergence left", air.gas.report.after, ""),
    ]
    return rows


def swing_of(model: BurningClothModel) -> float:
    """m: how far the lower edge, where it hangs, is out of the plane of the hooks; nan: nothing is there."""
    row = model.cloth.nodes[:, -1]
    there = row[THERE] > 0.0
    return float(np.mean(row[Z, there])) if there.any() else math.nan
