"""What a step of rigid bodies may compute besides gravity and drag."""

from __future__ import annotations

from game.physics.effects import Room, declare_effect
from game.physics.fields import DRAG, GRAVITY

ROTATION = declare_effect("rotation", "Rotation", "Bodies turn; else they only translate.")
WINDOW = declare_effect("window", "Window", "Bodies stay in a box, mirrored at its walls.")
PUSHES = declare_effect("pushes", "Pushes", "Forces by hand act at their points.")

BODIES = Room("rigid bodies", GRAVITY | DRAG | ROTATION | WINDOW | PUSHES)
GRAVITY_BIT = BODIES.bit(GRAVITY)
DRAG_BIT = BODIES.bit(DRAG)
ROTATION_BIT = BODIES.bit(ROTATION)
WINDOW_BIT = BODIES.bit(WINDOW)
