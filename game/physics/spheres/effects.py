"""What a step of colliding spheres may compute besides gravity, drag, rotation, window and pushes."""

from __future__ import annotations

from game.physics.effects import declare_effect
from game.physics.fields import DRAG, GRAVITY
from game.physics.rigid.effects import PUSHES, ROTATION, WINDOW

COLLISIONS = declare_effect("rigid", "collisions", 31, "Collisions", "Spheres hit and bear each other.")
FRICTION = declare_effect(
    "rigid", "sphere-friction", 32, "Friction", "Contacts resist sliding, and so make spheres turn."
)
IMPACT_TIMES = declare_effect(
    "rigid", "impact-times", 33, "Impact times", "A step is divided where the first spheres meet."
)
STRINGS = declare_effect("rigid", "strings", 34, "Strings", "Spheres hang from threads that only pull.")
LEDGES = declare_effect("rigid", "ledges", 35, "Ledges", "Straight walls within the window.")

GRAVITY_BIT = GRAVITY.mask
DRAG_BIT = DRAG.mask
ROTATION_BIT = ROTATION.mask
WINDOW_BIT = WINDOW.mask
COLLISIONS_BIT = COLLISIONS.mask
FRICTION_BIT = FRICTION.mask
STRINGS_BIT = STRINGS.mask
LEDGES_BIT = LEDGES.mask
KNOWN = GRAVITY | DRAG | ROTATION | WINDOW | PUSHES | COLLISIONS | FRICTION | IMPACT_TIMES | STRINGS | LEDGES
USUAL = GRAVITY | ROTATION | WINDOW | COLLISIONS | FRICTION | LEDGES
