"""Mouse: a point of b is drawn to a target by a damped spring of limited force; a is only kept company."""

from __future__ import annotations

from game.compiler.decorator import inner_kernel
from game.physics.solids.arrays import layout
from game.physics.solids.arrays.state import DX, DY
from game.physics.solids.joints.points import levers_now, write_point_lines


@inner_kernel
def prepare_mouse(bodies, joints, k):
    """The target takes the place of a's point: a has no part in it."""
    b = joints.bodies[k, 1]
    row = joints.rows
    row[k, layout.JIMA], row[k, layout.JIIA], row[k, layout.JAX], row[k, layout.JAY] = 0.0, 0.0, 0.0, 0.0
    row[k, layout.WITH_A] = 0.0
    row[k, layout.OFFSET_X] = bodies.positions[b, 0] - joints.parameters[k, layout.TARGET_X]
    row[k, layout.OFFSET_Y] = bodies.positions[b, 1] - joints.parameters[k, layout.TARGET_Y]


@inner_kernel
def write_mouse(joints, k, motion):
    """Lines from the target to b's point; a's motion does not count."""
    a, b = joints.bodies[k, 0], joints.bodies[k, 1]
    levers = levers_now(joints.rows, k, motion, a, b)
    x = joints.rows[k, layout.OFFSET_X] + motion[b, DX] + levers[2]
    y = joints.rows[k, layout.OFFSET_Y] + motion[b, DY] + levers[3]
    write_point_lines(joints, k, (0.0, 0.0, levers[2], levers[3]), x, y)
