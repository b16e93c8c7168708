"""Whether and how a body floats at an angle: draft, righting arm, metacentre (Bouguer 1746).

A free body's level is where it displaces its mass. Weight acts at G, the centre of mass, and lift at B, that
of what is displaced. Their distance sideways is the righting arm. For small turns lift passes through M, the
metacentre, at I/A above B: I is the second moment of the waterline, A the area below it.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats, Point
from game.physics.hydrostatics.bodies import Floater
from game.physics.hydrostatics.cut import arm_root, cut, depth_for, ends, measure_arms
from game.physics.kernels import elementary

SAMPLES = 720  # of the whole circle
NEUTRAL = 1e-4  # of a body's reach: smaller arms are none, as a disc's


class Pose(NamedTuple):
    """A body at an angle (rad). depth: of its centre below the level; draft: of its lowest point, m; arm: the
    righting one, m; height: GM of the metacentre, m; buoyancy: place of B from G, m; width: of the waterline,
    m; energy: to be had by sinking, m: that of body and water over the weight; floats: whether it does.
    """

    angle: float
    depth: float
    draft: float
    arm: float
    height: float
    buoyancy: Point
    width: float
    energy: float
    floats: bool

    @property
    def stable(self) -> bool:
        """Whether a small turn is undone."""
        return self.height > 0.0


class Curve(NamedTuple):
    """Righting arms (n,) m over angles (n,) rad, and where they are 0; neutral: where no angle is better."""

    angles: Floats
    arms: Floats
    poses: list[Pose]
    neutral: bool


def pose_at(floater: Floater, angle: float, density: float = 1000.0) -> Pose:
    """Of a body at an angle (rad) in water of a density, kg/m³; sunk, just below the level."""
    c, s = elementary.cos(angle), elementary.sin(angle)
    displaced = floater.mass / density
    floats = displaced < floater.area
    low, high, _, _ = ends(floater.corners, c, s)
    level = float(depth_for(floater.corners, c, s, displaced)) if floats else high
    area, moment, deep, width, first, second, *_ = map(float, cut(floater.corners, c, s, level))
    if area <= 0.0:
        return Pose(angle, level, level - low, 0.0, 0.0, (0.0, 0.0), 0.0, 0.0, floats)
    x, h = moment / area, deep / area + level  # from the centre of mass
    stiff = second - first * first / width if width > 0.0 else 0.0
    metacentre = h + stiff / area
    return Pose(angle, level, level - low, -x, metacentre, (x, h), width, -h, floats)


def curve_of(floater: Floater, density: float = 1000.0, samples: int = SAMPLES) -> Curve:
    """From -180 to 180 degrees. What sinks has no arms and no poses."""
    angles = math.pi * (2.0 * np.arange(samples + 1) / samples - 1.0)
    arms, displaced = np.zeros(samples + 1), floater.mass / density
    if displaced >= floater.area:
        return Curve(angles, arms, [], False)
    measure_arms(floater.corners, displaced, angles, arms)
    if float(np.abs(arms).max()) < NEUTRAL * floater.reach:
        return Curve(angles, arms, [], True)
    return Curve(angles, arms, poses_of(floater, density, angles, arms), False)


def poses_of(floater: Floater, density: float, angles: Floats, arms: Floats) -> list[Pose]:
    """Those at rest, by where sampled arms (n,) over angles (n,) change their sign."""
    displaced, least, found = floater.mass / density, 1e-12 * floater.reach, list[Pose]()
    small = np.abs(arms) <= least
    for k in range(len(angles) - 1):
        if small[k]:
            found.append(pose_at(floater, float(angles[k]), density))
        elif not small[k + 1] and arms[k] * arms[k + 1] < 0.0:
            root = float(arm_root(floater.corners, displaced, float(angles[k]), float(angles[k + 1])))
            found.append(pose_at(floater, root, density))
    return found


def lowest_pose(curve: Curve) -> Pose | None:
    """That of least energy, where the body ends if it is shaken long enough; None where there is none."""
    return min((one for one in curve.poses), key=lambda one: one.energy, default=None)
