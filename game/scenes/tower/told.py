"""Words of the tower: readouts beside the law, places for stories, sounds, the tower as a level."""

from __future__ import annotations

import math

import msgspec
import numpy as np

from game.arrays import Point
from game.physics.accretion import LIMIT
from game.scenes.tower.building import COLUMN, NOT_YET, floor_height
from game.scenes.tower.level import TowerContent
from game.scenes.tower.measures import (
    fall_of,
    free_fall_of,
    front_of,
    mass_of,
    paces_of,
    roof_of,
    standing,
    struck,
)
from game.scenes.tower.sounds import HALF, NAMES
from game.scenes.tower.world import TowerWorld
from game.stage import Hearing, Readout
from game.worlds.hearing import ROOM, wind

TONNE = 1000.0  # kg
AIR_HEARD = 0.3  # of the fastest air's speed, as it is far away
RUBBLE_M = 9.0  # so far above the ground a picture's middle has little of the ground in it


def readouts(model: TowerWorld) -> list[Readout]:
    """The fall first, then the debris."""
    took, law, way = fall_of(model)
    mass, paces, frame = mass_of(model), paces_of(model), model.frame
    since = model.time - model.course.fired if model.course.fired != NOT_YET else math.nan
    return [
        Readout("since the firing", since, "s"),
        Readout("storeys standing", standing(model)),
        Readout("whole columns", len(frame.rows((COLUMN,)))),
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
        Readout("pieces", len(frame.rows())),
        Readout("mass", mass / TONNE, "t"),
        Readout("mass lost", abs(mass + model.course.dusted - frame.built_mass) / frame.built_mass, ""),
        Readout("awake", model.solids.awake()),
        Readout("dust in the air", model.air.in_the_air(), "kg"),
        Readout("dust raised", model.course.dusted, "kg"),
        Readout("fastest air", model.air.fastest(), "m/s"),
        Readout("a step", model.watch.median("step"), "s"),
        Readout("a step of the air", model.watch.median("air"), "s"),
    ]


def saved(model: TowerWorld) -> TowerContent:
    """The tower as it was built, with the storey that is cut first as chosen."""
    return msgspec.structs.replace(model.content, first=model.first_storey())


def hearing(model: TowerWorld) -> Hearing:
    """What was heard in the last moments, and the air as it blows."""
    blown = wind(AIR_HEARD * model.air.fastest() if model.air.on else 0.0)
    return Hearing("tower", model.time, model.heard.sounds(NAMES, HALF), (ROOM, blown))


def targets(model: TowerWorld) -> dict[str, Point]:
    """Where the floors meet, the roof as it was and as it is, the storey that is cut first, the rubble; m."""
    content = model.content
    return {
        "front": front_of(model),
        "roof": (0.0, roof_of(model)),
        "top": (0.0, floor_height(content, content.storeys)),
        "charges": (0.0, floor_height(content, model.first_storey()) - 0.5 * content.storey),
        "middle": (0.0, 0.5 * floor_height(content, content.storeys)),
        "rubble": (0.0, max(RUBBLE_M, 0.8 * front_of(model)[1])),
    }


def sizes(model: TowerWorld) -> dict[str, float]:
    """A storey where floors meet and where charges lie, and the height of what stands; m."""
    storey = model.content.storey
    return {"front": storey, "charges": storey, "rubble": roof_of(model)}


def names(model: TowerWorld) -> list[tuple[Point, str]]:
    """The roof by its height, and where the floors meet."""
    roof, (x, y) = roof_of(model), front_of(model)
    found = [((0.0, roof), f"roof, {roof:.1f} m")]
    return found if roof - y < 0.5 * model.content.storey else [*found, ((x, y), f"front, {y:.1f} m")]
