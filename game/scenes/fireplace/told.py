"""What the fireplace says of itself: readouts, places for stories, sounds, and the fire as a level."""

from __future__ import annotations

import math

import msgspec
import numpy as np

from game.arrays import Point
from game.physics.heat.nodes import FUEL, TEMPERATURE, WATER
from game.scenes.fireplace import tables
from game.scenes.fireplace.level import FireplaceContent, WoodEntry
from game.scenes.fireplace.model import BREAK, FALL, POP, TICK, FireplaceModel
from game.stage import Hearing, Readout
from game.worlds.hearing import ROOM, fire


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


LOUD_FIRE, LOUD_COAL = 120e3, 6e3  # W/m: of flames, and of those that are as loud as a bed of coal
NAMES = {POP: "wood", BREAK: "thud", TICK: "stone", FALL: "wood"}


def hearing(model: FireplaceModel) -> Hearing:
    """Pops and breaks of the last moments, from the left or the right; the flames, and coal that hisses."""
    flames = model.shine + model.match.power(model.time)
    steady = (ROOM, fire(max(flames, LOUD_COAL * model.embers_shine()), LOUD_FIRE))
    return Hearing("fireplace", model.time, model.heard.sounds(NAMES, tables.HALF), steady)


def saved(model: FireplaceModel) -> FireplaceContent:
    """The level; where wood has burnt or was moved, each piece by itself, as thick as it is now."""
    if not model.changed:
        return model.content
    wood = model.wood
    entries: list[WoodEntry] = []
    for row, x, y, kelvin, water in zip(
        wood.table, *wood.places().T, wood.nodes.nodes[TEMPERATURE], wood.nodes.nodes[WATER], strict=False
    ):
        thick = float(max(2.0 * row[tables.HALF_THICK] * row[tables.SCALE], 0.008))
        if len(entries) >= 40 or thick < 0.0081:
            continue
        turn = math.degrees(float(wood.world.bodies.angles[int(row[tables.BODY])]))
        entries.append(
            WoodEntry(
                at=(float(x), float(y)), turn=math.remainder(turn, 360.0), pieces=1, thick=thick,
                length=float(max(2.0 * row[tables.HALF_LENGTH] * row[tables.SCALE], 0.01)),
                kelvin=float(min(kelvin, 2000.0)),
                moisture=float(min(water / row[tables.WHOLE], 2.0)),
            )
        )  # fmt: skip
    return msgspec.structs.replace(
        model.content, wood=tuple(entries), damper=float(model.parameters.damper), expected=()
    )


def targets(model: FireplaceModel) -> dict[str, Point]:
    """The match's head, the kindling, the logs' middle, the hottest piece, the flames, the flue; m."""
    match = model.match
    found = {
        "match": match.rest[:2] if match.hidden(model.time) else match.place(model.time)[0],
        "kindling": (0.0, 0.09),
        "hearth": (0.0, 0.32),
        "flue": (0.0, 1.2),
        "flames": (0.0, 0.08 + 0.5 * model.flame_height()),
        "embers": (0.0, 0.12),
    }
    wood = model.wood
    if wood.count:
        x, y = wood.places()[int(np.argmax(wood.nodes.nodes[TEMPERATURE, : wood.count]))].tolist()
        found["hottest"] = (x, y)
    return found


def sizes(model: FireplaceModel) -> dict[str, float]:
    """m: of the match with its flame, of a log on the grate, of the flames, of what glows."""
    flames = max(model.flame_height(), 0.1)
    return {"match": 0.1, "kindling": 0.12, "hearth": 0.4, "flames": flames, "embers": 0.1}


def names(model: FireplaceModel) -> list[tuple[Point, str]]:
    """The hottest piece, and the flames by their height."""
    found, wood = [], model.wood
    if wood.count:
        kelvin = wood.nodes.nodes[TEMPERATURE, : wood.count]
        hottest = int(np.argmax(kelvin))
        x, y = wood.places()[hottest].tolist()
        found.append(((x, y), f"the hottest wood, {float(kelvin[hottest]):.0f} K"))
    if model.flame_height() > 0.0:
        found.append(((0.0, model.flame_height()), f"flames, {model.flame_height():.2f} m"))
    return found
