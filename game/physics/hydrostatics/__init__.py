"""Bodies that float in still water: draft, righting arm, poses, and their heave and roll."""

from game.physics.hydrostatics.bodies import Floater, make_floater
from game.physics.hydrostatics.motion import FloatingBody, FloatingSettings, FloatingState
from game.physics.hydrostatics.stability import Curve, Pose, curve_of, pose_at, poses_of

__all__ = [
    "Curve",
    "Floater",
    "FloatingBody",
    "FloatingSettings",
    "FloatingState",
    "Pose",
    "curve_of",
    "make_floater",
    "pose_at",
    "poses_of",
]
