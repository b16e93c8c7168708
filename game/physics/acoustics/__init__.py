"""Sound that carries: the field of a phased array of transducers, its potential, grains that it traps."""

from game.physics.acoustics.array import PhasedArray, facing_rows
from game.physics.acoustics.grains import Air, Grain, GrainState, escape_estimate
from game.physics.acoustics.levitator import Levitator, LevitatorSettings
from game.physics.acoustics.paths import FIGURES, figure_path

__all__ = [
    "FIGURES",
    "Air",
    "Grain",
    "GrainState",
    "Levitator",
    "LevitatorSettings",
    "PhasedArray",
    "escape_estimate",
    "facing_rows",
    "figure_path",
]
