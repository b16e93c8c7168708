"""What a step of bodies with circle trees may compute."""

from __future__ import annotations

from game.physics.constraints.effects import CONTACTS
from game.physics.effects import Room, declare_effect
from game.physics.fields import GRAVITY

SPACE_TIME = declare_effect(
    "space-time-bounds", "Time bounds", "No pair is tested before the time at which it may touch."
)

TIMED = Room("bodies with circle trees", SPACE_TIME | CONTACTS | GRAVITY)
