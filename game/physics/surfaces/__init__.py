"""The surface by which rooms meet: points are sampled, impulses and heat are taken; none knows another's
classes.
"""

from game.physics.surfaces.adapters import BallSurface, DiscSurface, SphereSurface
from game.physics.surfaces.exits import EXIT_REASONS, Exits
from game.physics.surfaces.key_frames import KeyFrames
from game.physics.surfaces.ledger import Ledger
from game.physics.surfaces.sample_fields import ConstantField, Field, FunctionField, GridField
from game.physics.surfaces.solid_surface import SolidSurface
from game.physics.surfaces.surface import FAR, Sample, Surface, empty_sample

__all__ = [
    "EXIT_REASONS",
    "FAR",
    "BallSurface",
    "ConstantField",
    "DiscSurface",
    "Exits",
    "Field",
    "FunctionField",
    "GridField",
    "KeyFrames",
    "Ledger",
    "Sample",
    "SolidSurface",
    "SphereSurface",
    "Surface",
    "empty_sample",
]
