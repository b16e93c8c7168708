"""What is to be heard: the crackling of wood, its breaking."""

from __future__ import annotations

from game.scenes.fireplace.model import FireplaceModel
from game.scenes.fireplace.tables import HALF
from game.stage import Hearing
from game.worlds.hearing import sounds_of

NAMES = {1: "wood", 2: "thud"}


def hearing_of(model: FireplaceModel) -> Hearing:
    """Pops and breaks of the last moments, from the left or the right."""
    return Hearing("dominoes", model.time, sounds_of(model.heard, NAMES, HALF))
