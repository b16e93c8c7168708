"""What is to be heard: wood on wood, balls, thuds on the floor."""

from __future__ import annotations

from game.scenes.domino.hearing import BALL, THUD, WOOD
from game.scenes.domino.model import DominoModel
from game.stage import Hearing
from game.worlds.hearing import sounds_of

NAMES = {WOOD: "wood", BALL: "ball", THUD: "thud"}
HALF = 12.0  # m to either side of the front, from the left to the right


def hearing_of(model: DominoModel) -> Hearing:
    """Contacts that began in the last moments, from the left or the right of the front."""
    middle = model.front()[0]
    return Hearing("dominoes", model.time, sounds_of(model.heard, NAMES, HALF, middle))
