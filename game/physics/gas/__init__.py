"""Gas on a staggered grid: smoke, fire and wind."""

from game.physics.gas.arrays import GasState
from game.physics.gas.effects import GAS, USUAL
from game.physics.gas.gas import FIELDS, Gas, Report
from game.physics.gas.settings import ADVECTIONS, QUALITIES, GasSettings

__all__ = ["ADVECTIONS", "FIELDS", "GAS", "QUALITIES", "USUAL", "Gas", "GasSettings", "GasState", "Report"]
