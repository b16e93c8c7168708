"""Effects that the rooms of bounding volumes and of closest points share."""

from __future__ import annotations

from game.physics.effects import declare_effect

SHAPE_MOTION = declare_effect(
    "shape-motion",
    "Own motion",
    "Shapes drift and turn by themselves when no hand holds them.",
)
COHERENCE = declare_effect("coherence", "Coherence", "A query begins with what the last one ended with.")
EXACT_ANSWER = declare_effect(
    "exact-answer", "Exact answer", "What may touch is tested, or measured, exactly."
)
