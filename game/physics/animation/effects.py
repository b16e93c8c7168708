"""What a step of an animation may compute beside sampling the keys."""

from __future__ import annotations

from game.physics.effects import Room, declare_effect

EASING = declare_effect("easing", "Easing", "The whole motion follows a timing curve.")
CONSTANT_SPEED = declare_effect(
    "constant-speed",
    "Constant speed",
    "Time is spread by arc length: equal ways in equal times.",
)
SKINNING = declare_effect("skinning", "Skinning", "The skin follows the bones.")
JOINT_LIMITS = declare_effect("joint-limits", "Joint limits", "Bones turn only as far as their joints allow.")
PLAYBACKS = Room("playbacks", EASING | CONSTANT_SPEED)
