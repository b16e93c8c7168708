"""What a step of rigid bodies may compute besides gravity and drag."""

from __future__ import annotations

from game.physics.effects import declare_effect
from game.physics.fields import DRAG, GRAVITY

ROTATION = declare_effect("rigid", "rotation", 28, "Rotation", "Bodies turn; else they only shift.")
WINDOW = declare_effect("rigid", "window", 29, "Window", "Bodies stay in a box, mirrored at its walls.")
PUSHES = declare_effect("rigid", "pushes", 30, "Pushes", "Forces by hand act at their points.")

GRAVITY_BIT = GRAVITY.mask
DRAG_BIT = DRAG.mask
ROTATION_BIT = ROTATION.mask
WINDOW_BIT = WINDOW.mask
