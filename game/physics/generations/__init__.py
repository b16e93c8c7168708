"""Stars that are born of stars: a table of kinds, births at their own instant, drag, wind, thrust."""

from game.physics.generations.effects import BURNING, GENERATIONS, THRUST, TRAILS
from game.physics.generations.flight import METHODS, Air
from game.physics.generations.kinds import Birth, Kind
from game.physics.generations.system import CALM, EVERYTHING, StarState, StarSystem

__all__ = [
    "BURNING",
    "CALM",
    "EVERYTHING",
    "GENERATIONS",
    "METHODS",
    "THRUST",
    "TRAILS",
    "Air",
    "Birth",
    "Kind",
    "StarState",
    "StarSystem",
]
