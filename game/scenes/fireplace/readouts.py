"""What is measured at the fireplace."""

from __future__ import annotations

import math

import numpy as np

from game.physics.heat.nodes import FUEL, TEMPERATURE
from game.scenes.fireplace.model import FireplaceModel
from game.stage import Readout


def readouts_of(model: FireplaceModel) -> list[Readout]:
    """The fire first, then the wood, the ember and its law, the books of heat."""
    wood, air, books, vapour = model.wood, model.air, model.books(), model.vapour()
    hot = wood.nodes.nodes[TEMPERATURE, : wood.count]
    burning = int(np.count_nonzero(wood.nodes.burning()[: wood.count]))
    logs = wood.is_log()
    made, given = max(books["made"], 1.0), max(vapour["given"], 1e-6)
    law, piece = float(model.ember[1]), int(model.ember[0])
    ember = float(hot[piece]) if 0 <= piece < len(hot) else math.nan
    rows = [
        Readout("power", max(model.shine, 0.0), "W/m"),
        Readout("flame height", model.flame_height(), "m"),
        Readout("puffs", model.beat(), "Hz"),
        Readout("burning pieces", burning),
        Readout("burning logs", int(np.count_nonzero(wood.nodes.burning()[: wood.count] & logs))),
        Readout("burnt", 100.0 * model.burnt_share(), "%"),
        Readout("broken welds", int(wood.nodes.torn.sum())),
        Readout("hottest wood", float(np.max(hot, initial=0.0)), "K"),
        Readout("hottest gas", float(np.max(air.temperature)), "K"),
        Readout("hottest gas so far", model.most_hot, "K"),
        Readout("most power", model.most_power, "W/m"),
        Readout("highest flame", model.most_height, "m"),
        Readout("ember", ember, "K"),
        Readout("ember by T⁴", law if piece >= 0 else math.nan, "K"),
        Readout("off the law", 100.0 * abs(ember / law - 1.0) if piece >= 0 and law > 0.0 else math.nan, "%"),
        Readout("ember at first", float(model.ember[2]) if piece >= 0 else math.nan, "K"),
        Readout("water left", 1e3 * float(np.sum(wood.nodes.water[: wood.count])), "g/m"),
        Readout("fuel left", 1e3 * float(np.sum(wood.nodes.nodes[FUEL, : wood.count])), "g/m"),
        Readout("match", 1.0 if model.match.lit(model.time) else 0.0),
    ]
    rows += [
        Readout("heat made", books["made"], "J/m"),
        Readout("radiated", 100.0 * books["radiated"] / made, "%"),
        Readout("up the flue", 100.0 * books["flue"] / made, "%"),
        Readout("heat in the wood", 100.0 * books["wood"] / made, "%"),
        Readout("lost in carrying", 100.0 * books["carrying"] / made, "%"),
        Readout("covered by logs", 100.0 * books["covered"] / made, "%"),
        Readout("open share", 100.0 * books["open"] / made, "%"),
        Readout("left as coal", 100.0 * model.coal_share(), "%"),
        Readout("vapour given off", 1e3 * vapour["given"], "g/m"),
        Readout("vapour burnt", 100.0 * vapour["burnt"] / given, "%"),
        Readout("vapour up the flue", 100.0 * vapour["flue"] / given, "%"),
        Readout("vapour covered", 100.0 * vapour["covered"] / given, "%"),
        Readout("vapour lost", 100.0 * vapour["carrying"] / given, "%"),
        Readout("vapour open", 100.0 * vapour["open"] / given, "%"),
        Readout("divergence left", air.gas.report.after, ""),
        Readout("puffs of a round pool", 1.5 / math.sqrt(0.6), "Hz"),
    ]
    return rows
