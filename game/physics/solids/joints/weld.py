"""Weld: b is fixed to a at one point and in its angle, stiff or as an elastic clamp by its compliance."""

from __future__ import annotations

from game.compiler.decorator import inner_kernel
from game.physics.solids.joints.points import apart_now, levers_now, write_point_lines, write_turn_line


@inner_kernel
def write_weld(joints, k, motion):
    """Lines along x, y, and of the turn."""
    a, b = joints.bodies[k, 0], joints.bodies[k, 1]
    levers = levers_now(joints.rows, k, motion, a, b)
    x, y = apart_now(joints.rows, k, motion, a, b, levers)
    write_point_lines(joints, k, levers, x, y)
    write_turn_line(joints, k, motion)
