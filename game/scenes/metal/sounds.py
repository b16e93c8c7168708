"""What is to be heard: steel on steel, on rails, on wood; rolling."""

from __future__ import annotations

from game.scenes.metal.hearing import RAIL, ROLL, STEEL, WOOD
from game.scenes.metal.model import MetalModel
from game.stage import Hearing
from game.worlds.hearing import sounds_of

NAMES = {STEEL: "steel", WOOD: "wood", RAIL: "rail", ROLL: "roll"}


def hearing_of(model: MetalModel) -> Hearing:
    """Contacts that began in the last moments, from the left or the right of the whole run."""
    view = model.content.view
    middle, half = 0.5 * (view.left + view.right), max(0.5 * (view.right - view.left), 1e-9)
    return Hearing("metal", model.time, sounds_of(model.heard, NAMES, half, middle))
