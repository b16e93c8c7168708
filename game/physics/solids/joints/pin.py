"""Pin: two points are one; both bodies turn about it freely."""

from __future__ import annotations

from game.physics.kernels.lean import inner_kernel
from game.physics.solids.joints.layout import GIVE, MASS, PULL_X, PULL_Y, RATE
from game.physics.solids.joints.points import apart_now, levers_now, push_points, solve_pair, speed_apart


@inner_kernel
def warm_pin(joints, k, motion):
    """Apply the impulse of the substep before."""
    a, b = joints.bodies[k, 0], joints.bodies[k, 1]
    levers = levers_now(joints.rows, k, motion, a, b)
    push_points(joints.rows, k, motion, a, b, levers, joints.impulses[k, PULL_X], joints.impulses[k, PULL_Y])


@inner_kernel
def sweep_pin(joints, k, motion, pushing):
    """Stop the points from parting; pushing: also bring them together."""
    a, b = joints.bodies[k, 0], joints.bodies[k, 1]
    row, held = joints.rows, joints.impulses
    levers = levers_now(row, k, motion, a, b)
    x, y = speed_apart(motion, a, b, levers)
    mass, give = 1.0, 0.0
    if pushing:
        gap_x, gap_y = apart_now(row, k, motion, a, b, levers)
        x, y = x + row[k, RATE] * gap_x, y + row[k, RATE] * gap_y
        mass, give = row[k, MASS], row[k, GIVE]
    jx, jy = solve_pair(row, k, levers, x, y)
    jx, jy = -mass * jx - give * held[k, PULL_X], -mass * jy - give * held[k, PULL_Y]
    held[k, PULL_X] += jx
    held[k, PULL_Y] += jy
    push_points(row, k, motion, a, b, levers, jx, jy)
