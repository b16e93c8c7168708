"""Animation: key-frames and curves; skeletons, skinning and inverse kinematics."""

from game.physics.animation.angles import mix_rotations, rotation, shortest_turn
from game.physics.animation.curves import BezierPath, CatmullRom, CubicBezier
from game.physics.animation.easing import EASINGS, Easing
from game.physics.animation.effects import CONSTANT_SPEED, EASING, JOINT_LIMITS, SKINNING
from game.physics.animation.ik.inverse_kinematics import Solution, Solutions, Solver, solve_ik
from game.physics.animation.ik.solver import METHODS as IK_METHODS
from game.physics.animation.ik.two_links import two_link_angles
from game.physics.animation.keyframes import INTERPOLATIONS, Keyframes
from game.physics.animation.piecewise import PiecewiseCubic
from game.physics.animation.playback import Playback
from game.physics.animation.skeleton import Skeleton, SkeletonError, chain_skeleton
from game.physics.animation.skinning import BLENDS, Skinner, skin
from game.physics.animation.weights import Binding, WeightError, bind_given, bind_weights

__all__ = [
    "BLENDS",
    "CONSTANT_SPEED",
    "EASING",
    "EASINGS",
    "IK_METHODS",
    "INTERPOLATIONS",
    "JOINT_LIMITS",
    "SKINNING",
    "BezierPath",
    "Binding",
    "CatmullRom",
    "CubicBezier",
    "Easing",
    "Keyframes",
    "PiecewiseCubic",
    "Playback",
    "Skeleton",
    "SkeletonError",
    "Skinner",
    "Solution",
    "Solutions",
    "Solver",
    "WeightError",
    "bind_given",
    "bind_weights",
    "chain_skeleton",
    "mix_rotations",
    "rotation",
    "shortest_turn",
    "skin",
    "solve_ik",
    "two_link_angles",
]
