"""Spring: two points are drawn to a distance by a damped spring of its own; limits stop it stiffly."""

from __future__ import annotations

from game.compiler.decorator import inner_kernel
from game.physics.solids.arrays.layout import EQUAL, LENGTH, PULL_X
from game.physics.solids.joints.distance import rod_now
from game.physics.solids.joints.points import write_line, write_range_lines


@inner_kernel
def write_spring(joints, k, motion):
    """A line along it, whose spring is the joint's own, and limits (m)."""
    length, u, torques = rod_now(joints, k, motion)
    write_line(joints, k, PULL_X, EQUAL, u, torques, length - joints.parameters[k, LENGTH])
    write_range_lines(joints, k, u, torques, length)
