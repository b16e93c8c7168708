"""What the burning cloth says of itself: readouts, places for stories, sounds, and the cloth as a level."""

from __future__ import annotations

import math

import msgspec
import numpy as np

from game.arrays import Point
from game.physics.cloth import layout
from game.physics.cloth.layout import THERE, Z
from game.scenes.burning_cloth.level import BurningClothContent
from game.scenes.burning_cloth.model import BurningClothModel
from game.scenes.burning_cloth.tables import BOX, HALF, TABLE
from game.stage import Hearing, Readout
from game.worlds.hearing import ROOM, fire, wind


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


LOUD_FIRE = 40e3  # W
NAMES = {1: "wood", 2: "thud"}


def hearing(model: BurningClothModel) -> Hearing:
    """Crackles of the last moments, from the left or the right; the flames and the wind."""
    steady = (ROOM, fire(float(model.seen[0]), LOUD_FIRE), wind(float(model.air.flows[2])))
    return Hearing("burning cloth", model.time, model.heard.sounds(NAMES, HALF), steady)


def saved(model: BurningClothModel) -> BurningClothContent:
    """The level with what the hand has written and washed out; a new cloth is not burnt."""
    if tuple(model.written) == model.content.dabs and tuple(model.washed) == model.content.washed:
        return model.content
    return msgspec.structs.replace(
        model.content, dabs=tuple(model.written), washed=tuple(model.washed), expected=()
    )


def targets(model: BurningClothModel) -> dict[str, Point]:
    """The cloth's middle, the match's head, its box, the fronts' middle, letters' feet, what falls; m."""
    cloth = model.cloth
    (x, y), _ = model.match.place(model.time)
    found = {
        "cloth": (0.0, 1.1),
        "match": (x, y),
        "box": (0.5 * (BOX[0] + BOX[1]), TABLE + 0.03),
        "embers": embers_of(model),
    }
    for number, (right, down) in enumerate(model.letters.feet.tolist(), start=1):
        found[f"letter {number}"] = model.place_on(right, down)
    found["piece"] = piece_of(model)
    found["lower edge"] = (0.0, float(np.min(cloth.nodes[layout.X + 1, -1])))
    return found


def embers_of(model: BurningClothModel) -> Point:
    """The middle of what glows, or of the cloth."""
    cloth = model.cloth
    hot = (cloth.patches[layout.HOT] > 520.0) & (cloth.patches[layout.FUEL] > 0.0)
    rows, columns = np.nonzero(hot)
    if not len(rows):
        return 0.0, 1.1
    places = cloth.nodes[layout.X : layout.X + 2, rows // layout.PER, columns // layout.PER]
    return float(np.mean(places[0])), float(np.mean(places[1]))


def piece_of(model: BurningClothModel) -> Point:
    """The middle of what holds together and hangs on no hook any more, or of the cloth."""
    cloth = model.cloth
    loose = cloth.loose()
    if not loose.any():
        return 0.0, 1.1
    rows, columns = np.nonzero(loose)
    places = cloth.nodes[layout.X : layout.X + 2, rows, columns]  # each mesh by its upper left node
    return float(np.mean(places[0])), float(np.mean(places[1]))


def names(model: BurningClothModel) -> list[tuple[Point, str]]:
    """The match while it burns, the embers by their speed, and what has come loose."""
    found = []
    if model.match.lit(model.time):
        (x, y), _ = model.match.place(model.time)
        found.append(((x, y), "match"))
    if model.alight and model.front_now > 0.0:
        found.append((embers_of(model), f"embers, {1e3 * model.front_now:.0f} mm/s"))
    loose = model.cloth.fallen()
    return [*found, (piece_of(model), f"{loose} meshes, on no hook")] if loose else found
