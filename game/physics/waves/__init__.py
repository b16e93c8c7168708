"""Shallow water over a bed, and what is known exactly of it."""

from game.physics.waves.exact import (
    Bowl,
    DamBreak,
    bernoulli_depth,
    conjugate_depth,
    critical_depth,
    dam_break,
)
from game.physics.waves.shallow import ENDS, METHODS, ShallowSettings, ShallowState, ShallowWater

__all__ = [
    "ENDS",
    "METHODS",
    "Bowl",
    "DamBreak",
    "ShallowSettings",
    "ShallowState",
    "ShallowWater",
    "bernoulli_depth",
    "conjugate_depth",
    "critical_depth",
    "dam_break",
]
