"""Shallow water over a bed, what is known exactly of it, and low waves of any length."""

from game.physics.waves.airy import AiryTank, wave_rate
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
    "AiryTank",
    "Bowl",
    "DamBreak",
    "ShallowSettings",
    "ShallowState",
    "ShallowWater",
    "bernoulli_depth",
    "conjugate_depth",
    "critical_depth",
    "dam_break",
    "wave_rate",
]
