"""Mouse: a point of b is drawn to a target by a damped spring of limited force; a is only kept company."""

from __future__ import annotations

import math

from game.physics.kernels.lean import inner_kernel
from game.physics.solids.joints.layout import (
    GIVE,
    JAX,
    JAY,
    JIIA,
    JIMA,
    MASS,
    MOST,
    OFFSET_X,
    OFFSET_Y,
    PULL_X,
    PULL_Y,
    RATE,
    TARGET_X,
    TARGET_Y,
)
from game.physics.solids.joints.points import levers_now, push_points, solve_pair
from game.physics.solids.state import DX, DY, VX, VY, W


@inner_kernel
def prepare_mouse(bodies, joints, k):
    """The target takes the place of a's point: a has no part in it."""
    b = joints.bodies[k, 1]
    row = joints.rows
    row[k, JIMA], row[k, JIIA], row[k, JAX], row[k, JAY] = 0.0, 0.0, 0.0, 0.0
    row[k, OFFSET_X] = bodies.positions[b, 0] - joints.parameters[k, TARGET_X]
    row[k, OFFSET_Y] = bodies.positions[b, 1] - joints.parameters[k, TARGET_Y]


@inner_kernel
def warm_mouse(joints, k, motion):
    """Apply the impulse of the substep before."""
    a, b = joints.bodies[k, 0], joints.bodies[k, 1]
    levers = levers_now(joints.rows, k, motion, a, b)
    push_points(joints.rows, k, motion, a, b, levers, joints.impulses[k, PULL_X], joints.impulses[k, PULL_Y])


@inner_kernel
def sweep_mouse(joints, k, motion, h):
    """Draw b's point to the target, by no more than the most force."""
    a, b = joints.bodies[k, 0], joints.bodies[k, 1]
    row, held = joints.rows, joints.impulses
    levers = levers_now(row, k, motion, a, b)
    x, y = motion[b, VX] - motion[b, W] * levers[3], motion[b, VY] + motion[b, W] * levers[2]
    x += row[k, RATE] * (row[k, OFFSET_X] + motion[b, DX] + levers[2])
    y += row[k, RATE] * (row[k, OFFSET_Y] + motion[b, DY] + levers[3])
    jx, jy = solve_pair(row, k, levers, x, y)
    jx = (1.0 - row[k, GIVE]) * held[k, PULL_X] - row[k, MASS] * jx
    jy = (1.0 - row[k, GIVE]) * held[k, PULL_Y] - row[k, MASS] * jy
    size, most = math.sqrt(jx * jx + jy * jy), h * joints.parameters[k, MOST]
    if size > most:
        jx, jy = jx * most / size, jy * most / size
    push_points(row, k, motion, a, b, levers, jx - held[k, PULL_X], jy - held[k, PULL_Y])
    held[k, PULL_X], held[k, PULL_Y] = jx, jy
