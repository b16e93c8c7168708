"""What is to be heard: the match being struck, threads that part."""

from __future__ import annotations

from game.scenes.burning_cloth.model import BurningClothModel
from game.scenes.burning_cloth.tables import HALF
from game.stage import Hearing
from game.worlds.hearing import ROOM, fire, sounds_of, wind

LOUD_FIRE = 40e3  # W
NAMES = {1: "wood", 2: "thud"}


def hearing_of(model: BurningClothModel) -> Hearing:
    """Crackles of the last moments, from the left or the right; the flames and the wind."""
    steady = (ROOM, fire(float(model.seen[0]), LOUD_FIRE), wind(float(model.air.flows[2])))
    return Hearing("burning cloth", model.time, sounds_of(model.heard, NAMES, HALF), steady)
