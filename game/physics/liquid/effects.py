"""What a step of a liquid may compute."""

from __future__ import annotations

from game.physics.effects import Room, declare_effect
from game.physics.fields import GRAVITY

KEEP_VOLUME = declare_effect(
    "keep-volume", "Keep volume", "Particles that crowd are moved apart, so that no volume is lost."
)

LIQUID = Room("liquid", GRAVITY | KEEP_VOLUME)
