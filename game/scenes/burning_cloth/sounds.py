"""What is to be heard: the match being struck, threads that part."""

from __future__ import annotations

from game.scenes.burning_cloth.model import BurningClothModel
from game.scenes.burning_cloth.tables import HALF
from game.stage import Hearing
from game.worlds.hearing import sounds_of

NAMES = {1: "wood", 2: "thud"}


def hearing_of(model: BurningClothModel) -> Hearing:
    """Crackles of the last moments, from the left or the right."""
    return Hearing("dominoes", model.time, sounds_of(model.heard, NAMES, HALF))
