"""Slider: b moves along an axis fixed to a, and does not turn against it; with limits and a drive."""

from __future__ import annotations

from game.compiler.decorator import inner_kernel
from game.physics.solids.arrays import layout
from game.physics.solids.arrays.state import DC, DS
from game.physics.solids.joints.points import (
    apart_now,
    levers_now,
    write_line,
    write_range_lines,
    write_turn_line,
)


@inner_kernel
def prepare_slider(bodies, joints, k):
    """The axis as it lies at the beginning of the step."""
    a = joints.bodies[k, 0]
    c, s = bodies.rotations[a, 0], bodies.rotations[a, 1]
    x, y = joints.parameters[k, layout.AXIS_X], joints.parameters[k, layout.AXIS_Y]
    joints.rows[k, layout.AXIS_NOW_X], joints.rows[k, layout.AXIS_NOW_Y] = c * x - s * y, s * x + c * y


@inner_kernel
def write_slider(joints, k, motion):
    """A line across the axis, one of the turn; limits (m) and drive (m/s) along the axis."""
    a, b = joints.bodies[k, 0], joints.bodies[k, 1]
    levers = levers_now(joints.rows, k, motion, a, b)
    x, y = apart_now(joints.rows, k, motion, a, b, levers)
    px, py = joints.rows[k, layout.AXIS_NOW_X], joints.rows[k, layout.AXIS_NOW_Y]
    c, s = motion[a, DC], motion[a, DS]
    ux, uy = c * px - s * py, s * px + c * py
    # the axis turns with a: its lever reaches to b's point
    ax, ay = levers[0] + x, levers[1] + y
    across = (ax * ux + ay * uy, levers[2] * ux + levers[3] * uy)
    write_line(joints, k, layout.PULL_X, layout.EQUAL, (-uy, ux), across, y * ux - x * uy)
    write_turn_line(joints, k, motion)
    along = (ax * uy - ay * ux, levers[2] * uy - levers[3] * ux)
    write_range_lines(joints, k, (ux, uy), along, x * ux + y * uy)
