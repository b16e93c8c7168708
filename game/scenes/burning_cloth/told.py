"""What a story says of the cloth beside readouts: places for stories, sounds, and the cloth as a level."""

from __future__ import annotations

import msgspec
import numpy as np

from game.arrays import Point
from game.physics.cloth import layout
from game.scenes.burning_cloth.level import BurningClothContent
from game.scenes.burning_cloth.model import BurningClothModel
from game.scenes.burning_cloth.tables import BOX, HALF, TABLE
from game.stage import Hearing
from game.worlds.hearing import ROOM, fire, wind

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
