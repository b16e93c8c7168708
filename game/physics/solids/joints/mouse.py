"""Mouse: a point of b is drawn to a target by a damped spring of limited force; a is only kept company."""

from __future__ import annotations

from game.compiler.decorator import inner_kernel
from game.physics.solids.joints.layout import (
    JAX,
    JAY,
    JIIA,
    JIMA,
    OFFSET_X,
    OFFSET_Y,
    TARGET_X,
    TARGET_Y,
    WITH_A,
)
from game.physics.solids.joints.points import levers_now, write_point_lines
from game.physics.solids.state import DX, DY


@inner_kernel
def prepare_mouse(bodies, joints, k):
    """The target takes the place of a's point: a has no part in it."""
    b = joints.bodies[k, 1]
    row = joints.rows
    row[k, JIMA], row[k, JIIA], row[k, JAX], row[k, JAY] = 0.0, 0.0, 0.0, 0.0
    row[k, WITH_A] = 0.0
    row[k, OFFSET_X] = bodies.positions[b, 0] - joints.parameters[k, TARGET_X]
    row[k, OFFSET_Y] = bodies.positions[b, 1] - joints.parameters[k, TARGET_Y]


@inner_kernel
def write_mouse(joints, k, motion):
    """Lines from the target to b's point; a's motion does not count."""
    a, b = joints.bodies[k, 0], joints.bodies[k, 1]
    levers = levers_now(joints.rows, k, motion, a, b)
    x = joints.rows[k, OFFSET_X] + motion[b, DX] + levers[2]
    y = joints.rows[k, OFFSET_Y] + motion[b, DY] + levers[3]
    write_point_lines(joints, k, (0.0, 0.0, levers[2], levers[3]), x, y)
