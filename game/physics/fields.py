"""Effects that fill all of space and that several rooms share: gravity, the air, the ground.

Only names and bits stand here; what a room makes of them is in the room.
"""

from __future__ import annotations

from game.physics.effects import declare_effect

GRAVITY = declare_effect("gravity", "Gravity", "A constant acceleration downwards.")
DRAG = declare_effect("drag", "Air drag", "A force against the motion, in proportion to it.")
WIND = declare_effect("wind", "Wind", "The air itself moves; felt only by way of drag.")
QUADRATIC_DRAG = declare_effect(
    "quadratic-drag", "Quadratic drag", "A force against the motion, as the square of the speed."
)
WHIRL = declare_effect("whirl", "Vortex", "Air that turns about a point; felt by way of drag.")
ATTRACTOR = declare_effect("attractor", "Attractor", "A pull to a point, stronger farther off.")
GROUND = declare_effect("ground", "Ground", "A level floor that nothing passes.")
