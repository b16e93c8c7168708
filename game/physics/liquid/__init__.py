"""A liquid with a free surface: particles that meet on the cells of a grid."""

from game.physics.liquid.liquid import Liquid, LiquidState
from game.physics.liquid.settings import CARRIERS, SURFACES, LiquidSettings

__all__ = ["CARRIERS", "SURFACES", "Liquid", "LiquidSettings", "LiquidState"]
