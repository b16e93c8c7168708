"""Heat in what is solid: conduction, melting and boiling, radiation, things that burn, fronts."""

from game.physics.heat.bodies import BurningBodies, Fuel, NodesState
from game.physics.heat.burning_front import BurningFront
from game.physics.heat.enthalpy import Phases
from game.physics.heat.grid import HeatGrid, HeatState, MeltingGrid, MeltingState
from game.physics.heat.radiation import STEFAN_BOLTZMANN, cooled

__all__ = [
    "STEFAN_BOLTZMANN",
    "BurningBodies",
    "BurningFront",
    "Fuel",
    "HeatGrid",
    "HeatState",
    "MeltingGrid",
    "MeltingState",
    "NodesState",
    "Phases",
    "cooled",
]
