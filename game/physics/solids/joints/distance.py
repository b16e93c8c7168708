"""Distance: a massless rod between two points, stiff or elastic; with limits a telescope."""

from __future__ import annotations

from game.compiler.decorator import inner_kernel
from game.physics.solids.arrays import layout
from game.physics.solids.joints.points import (
    apart_now,
    direction,
    levers_now,
    write_line,
    write_range_lines,
)


@inner_kernel
def rod_now(joints, k, motion):
    """Length, direction and torques of the line between both points."""
    a, b = joints.bodies[k, 0], joints.bodies[k, 1]
    levers = levers_now(joints.rows, k, motion, a, b)
    x, y = apart_now(joints.rows, k, motion, a, b, levers)
    length, ux, uy = direction(x, y)
    return length, (ux, uy), (levers[0] * uy - levers[1] * ux, levers[2] * uy - levers[3] * ux)


@inner_kernel
def write_distance(joints, k, motion):
    """A line along the rod; between limits it is left free."""
    length, u, torques = rod_now(joints, k, motion)
    if not joints.flags[k] & layout.LIMITED:
        write_line(
            joints, k, layout.PULL_X, layout.EQUAL, u, torques, length - joints.parameters[k, layout.LENGTH]
        )
    write_range_lines(joints, k, u, torques, length)
