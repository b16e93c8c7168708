"""Pin: two points are one; both bodies turn about it freely, or between limits."""

from __future__ import annotations

from game.compiler.decorator import inner_kernel
from game.physics.solids.joints.points import (
    apart_now,
    levers_now,
    turned_now,
    write_point_lines,
    write_range_lines,
)


@inner_kernel
def write_pin(joints, k, motion):
    """Lines along x and y; limits (rad) and drive (rad/s) of the turn of b against a."""
    a, b = joints.bodies[k, 0], joints.bodies[k, 1]
    levers = levers_now(joints.rows, k, motion, a, b)
    x, y = apart_now(joints.rows, k, motion, a, b, levers)
    write_point_lines(joints, k, levers, x, y)
    write_range_lines(joints, k, (0.0, 0.0), (1.0, 1.0), turned_now(joints.rows, k, motion, a, b))
