"""Effects that the rooms of bounding volumes and of closest points share."""

from __future__ import annotations

from game.physics.effects import declare_effect

SHAPE_MOTION = declare_effect(
    "proximity",
    "shape-motion",
    55,
    "Own motion",
    "Shapes drift and turn by themselves when nobody holds them.",
)
COHERENCE = declare_effect(
    "proximity", "coherence", 56, "Coherence", "A query begins with what the last one ended with."
)
EXACT_ANSWER = declare_effect(
    "proximity", "exact-answer", 57, "Exact answer", "What may touch is tested, or measured, exactly."
)
