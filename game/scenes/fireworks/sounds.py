"""What is to be heard: waves that have met the listener."""

from __future__ import annotations

from game.scenes.fireworks.model import FireworksModel
from game.stage import Hearing
from game.worlds.hearing import ROOM, wind


def hearing(model: FireworksModel) -> Hearing:
    """The sounds heard last, the time of the show, the wind."""
    return Hearing("fireworks", model.system.time_s, model.thunder.sounds(), (ROOM, wind(model.wind)))
