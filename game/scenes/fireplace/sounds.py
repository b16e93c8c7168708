"""What is to be heard: the crackling of wood, its breaking."""

from __future__ import annotations

from game.scenes.fireplace.model import FireplaceModel
from game.scenes.fireplace.tables import HALF
from game.stage import Hearing
from game.worlds.hearing import ROOM, fire, sounds_of

LOUD_FIRE = 250e3  # W/m
NAMES = {1: "wood", 2: "thud"}


def hearing_of(model: FireplaceModel) -> Hearing:
    """Pops and breaks of the last moments, from the left or the right; the flames."""
    steady = (ROOM, fire(model.shine, LOUD_FIRE))
    return Hearing("fireplace", model.time, sounds_of(model.heard, NAMES, HALF), steady)
