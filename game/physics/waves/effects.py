"""What a step of shallow water may compute."""

from __future__ import annotations

from game.physics.effects import Room, declare_effect
from game.physics.fields import GRAVITY

BED_FRICTION = declare_effect("bed-friction", "Bed friction", "The bed slows water, thin water most.")
RAIN = declare_effect("rain", "Rain", "Water falls on all of it, evenly.")

WAVES = Room("waves", GRAVITY | BED_FRICTION | RAIN)
