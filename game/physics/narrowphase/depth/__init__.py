"""Penetration depth of shapes of convex parts, by translation alone and with rotation (object norm)."""

from game.physics.narrowphase.depth.pair import Escape, ShapePair
from game.physics.narrowphase.depth.presets import PRESETS, preset
from game.physics.narrowphase.depth.shape import Shape

__all__ = ["PRESETS", "Escape", "Shape", "ShapePair", "preset"]
