"""Plates and leaves in the air: how they flutter, tumble, bend, land and are carried by the wind."""

from game.physics.plates.checks import PlateSettings
from game.physics.plates.flight import METHODS
from game.physics.plates.law import Plate
from game.physics.plates.plates import Plates, PlateState
from game.physics.plates.wind import Gust, GustyWind

__all__ = ["METHODS", "Gust", "GustyWind", "Plate", "PlateSettings", "PlateState", "Plates"]
