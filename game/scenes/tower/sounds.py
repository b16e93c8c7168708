"""What is to be heard: stone on stone, floors on floors."""

from __future__ import annotations

from game.scenes.shared.heard import sounds_of
from game.scenes.tower.hearing import STONE, THUD
from game.scenes.tower.model import TowerModel
from game.stage import Hearing

NAMES = {STONE: "stone", THUD: "thud"}
HALF = 25.0  # m to either side, from the left to the right


def hearing_of(model: TowerModel) -> Hearing:
    """Contacts that began in the last moments."""
    return Hearing("tower", model.time, sounds_of(model.heard, NAMES, HALF))
