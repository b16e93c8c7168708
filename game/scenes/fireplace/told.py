"""What a story says of the fireplace beside readouts: places for stories, sounds, and the fire as a level."""

from __future__ import annotations

import math

import msgspec
import numpy as np

from game.arrays import Point
from game.physics.heat.nodes import TEMPERATURE, WATER
from game.scenes.fireplace import tables
from game.scenes.fireplace.level import FireplaceContent, WoodEntry
from game.scenes.fireplace.match import KEYS
from game.scenes.fireplace.model import BREAK, FALL, POP, TICK, FireplaceModel
from game.stage import Hearing
from game.worlds.hearing import ROOM, fire

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
    head = model.match.place(model.time)
    found = {
        "match": head[0] if head is not None else KEYS[0][:2],
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
