"""What a step of gas may compute."""

from __future__ import annotations

from game.physics.effects import Room, declare_effect

ADVECTION = declare_effect("advection", "Advection", "The gas carries itself and what is in it along.")
PRESSURE = declare_effect("pressure", "Pressure", "What flows into a place flows out of it again.")
BUOYANCY = declare_effect("buoyancy", "Buoyancy", "Hot gas rises, smoke is heavy.")
VISCOSITY = declare_effect("viscosity", "Viscosity", "Layers of gas drag one another along.")
DIFFUSION = declare_effect("diffusion", "Diffusion", "Heat, smoke and the like spread by themselves.")
CONFINEMENT = declare_effect(
    "confinement",
    "Confinement",
    "Of vorticity: puts back eddies that the grid smeared out; makes energy.",
)
EXPANSION = declare_effect("expansion", "Expansion", "Sources of volume push the gas apart.")

GAS = Room("gases", ADVECTION | PRESSURE | BUOYANCY | VISCOSITY | DIFFUSION | CONFINEMENT | EXPANSION)
USUAL = GAS.known.without(CONFINEMENT)
