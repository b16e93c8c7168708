"""What is to be heard: waves that have met the listener."""

from __future__ import annotations

from game.scenes.fireworks.model import FireworksModel
from game.stage import Hearing


def hearing(model: FireworksModel) -> Hearing:
    """The sounds heard last, and the time of the show."""
    return Hearing("fireworks", model.system.time_s, model.thunder.sounds())
