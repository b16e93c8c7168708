"""What a step of an animation may compute beside sampling the keys."""

from __future__ import annotations

from game.physics.effects import declare_effect

EASING = declare_effect("animation", "easing", 48, "Easing", "The whole motion follows a timing curve.")
CONSTANT_SPEED = declare_effect(
    "animation",
    "constant-speed",
    49,
    "Even speed",
    "Time is spread by arc length: equal ways in equal times.",
)
SKINNING = declare_effect("animation", "skinning", 50, "Skinning", "The skin follows the bones.")
JOINT_LIMITS = declare_effect(
    "animation", "joint-limits", 51, "Joint limits", "Bones turn only as far as their joints allow."
)
