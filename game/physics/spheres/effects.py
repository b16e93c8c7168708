"""What a step of colliding spheres may compute besides gravity, drag, rotation, window and pushes."""

from __future__ import annotations

from game.physics.effects import Room, declare_effect
from game.physics.fields import DRAG, GRAVITY
from game.physics.rigid.effects import PUSHES, ROTATION, WINDOW

COLLISIONS = declare_effect("collisions", "Collisions", "Spheres hit and carry each other.")
FRICTION = declare_effect("sphere-friction", "Friction", "Contacts resist sliding, and so make spheres turn.")
IMPACT_TIMES = declare_effect(
    "impact-times", "Impact times", "A step is divided where the first spheres meet."
)
STRINGS = declare_effect("strings", "Strings", "Spheres hang from threads that only pull.")
LEDGES = declare_effect("ledges", "Ledges", "Straight walls within the window.")

SPHERES = Room(
    "spheres",
    GRAVITY | DRAG | ROTATION | WINDOW | PUSHES | COLLISIONS | FRICTION | IMPACT_TIMES | STRINGS | LEDGES,
)
USUAL = GRAVITY | ROTATION | WINDOW | COLLISIONS | FRICTION | LEDGES
GRAVITY_BIT = SPHERES.bit(GRAVITY)
DRAG_BIT = SPHERES.bit(DRAG)
ROTATION_BIT = SPHERES.bit(ROTATION)
WINDOW_BIT = SPHERES.bit(WINDOW)
COLLISIONS_BIT = SPHERES.bit(COLLISIONS)
FRICTION_BIT = SPHERES.bit(FRICTION)
STRINGS_BIT = SPHERES.bit(STRINGS)
LEDGES_BIT = SPHERES.bit(LEDGES)
