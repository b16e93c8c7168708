"""Fluids of particles: drops, honey, slime, two liquids, boiling."""

from game.physics.particle_fluids.fluid import ParticleFluid
from game.physics.particle_fluids.packing import lattice
from game.physics.particle_fluids.search import SEARCHES, NeighbourSearch
from game.physics.particle_fluids.settings import LAWS, FluidSettings, Liquid
from game.physics.particle_fluids.store import FluidState
from game.physics.particle_fluids.walls import WALLS

__all__ = [
    "LAWS",
    "SEARCHES",
    "WALLS",
    "FluidSettings",
    "FluidState",
    "Liquid",
    "NeighbourSearch",
    "ParticleFluid",
    "lattice",
]
