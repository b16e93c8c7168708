"""Rope: two points are never farther apart than a length; slack, it does nothing."""

from __future__ import annotations

from game.compiler.decorator import inner_kernel
from game.physics.solids.arrays.layout import HIGH, LENGTH, ONE_SIDED
from game.physics.solids.joints.distance import rod_now
from game.physics.solids.joints.points import write_line


@inner_kernel
def write_rope(joints, k, motion):
    """A limit from above."""
    length, u, torques = rod_now(joints, k, motion)
    left = joints.parameters[k, LENGTH] - length
    write_line(joints, k, HIGH, ONE_SIDED, (-u[0], -u[1]), (-torques[0], -torques[1]), left)
