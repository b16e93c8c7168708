"""What a step of a fluid of particles may compute."""

from __future__ import annotations

from game.physics.effects import Room, declare_effect
from game.physics.fields import GRAVITY

DRAGGING = declare_effect("liquid-viscosity", "Viscosity", "Particles of liquid drag one another along.")
TENSION = declare_effect("surface-tension", "Surface tension", "Liquid of a kind holds together.")
SPRINGS = declare_effect("liquid-springs", "Springs", "Slime springs back until its springs yield.")
WARMTH = declare_effect("liquid-heat", "Heat", "Heat spreads in liquid, makes it light, and boils it.")
AIR_ON_DEMAND = declare_effect("trapped-air", "Trapped air", "Air is made where falling liquid encloses it.")

PARTICLE_FLUIDS = Room("particle-fluids", GRAVITY | DRAGGING | TENSION | SPRINGS | WARMTH | AIR_ON_DEMAND)
