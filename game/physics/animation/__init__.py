"""Animation: key-frames and the curves between them."""

from game.physics.animation.angles import mix_rotations, rotation, shortest_turn
from game.physics.animation.curves import BezierPath, CatmullRom, CubicBezier
from game.physics.animation.easing import EASINGS, Easing
from game.physics.animation.effects import CONSTANT_SPEED, EASING
from game.physics.animation.keyframes import INTERPOLATIONS, Keyframes
from game.physics.animation.piecewise import PiecewiseCubic
from game.physics.animation.playback import Playback

__all__ = [
    "CONSTANT_SPEED",
    "EASING",
    "EASINGS",
    "INTERPOLATIONS",
    "BezierPath",
    "CatmullRom",
    "CubicBezier",
    "Easing",
    "Keyframes",
    "PiecewiseCubic",
    "Playback",
    "mix_rotations",
    "rotation",
    "shortest_turn",
]
