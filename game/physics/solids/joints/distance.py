"""Distance: a massless rod between two points, stiff or a spring by its compliance."""

from __future__ import annotations

import math

from game.physics.kernels.lean import inner_kernel
from game.physics.solids.joints.layout import GIVE, HERTZ, JIIA, JIIB, JIMA, JIMB, LENGTH, MASS, PULL_X, RATE
from game.physics.solids.joints.points import apart_now, levers_now, push_points, speed_apart


@inner_kernel
def direction(x, y):
    """Length and unit vector of (x, y); along x where it has no length."""
    length = math.sqrt(x * x + y * y)
    if length > 1e-12:
        return length, x / length, y / length
    return length, 1.0, 0.0


@inner_kernel
def warm_distance(joints, k, motion):
    """Apply the impulse of the substep before."""
    a, b = joints.bodies[k, 0], joints.bodies[k, 1]
    levers = levers_now(joints.rows, k, motion, a, b)
    x, y = apart_now(joints.rows, k, motion, a, b, levers)
    _, ux, uy = direction(x, y)
    j = joints.impulses[k, PULL_X]
    push_points(joints.rows, k, motion, a, b, levers, j * ux, j * uy)


@inner_kernel
def sweep_distance(joints, k, motion, pushing):
    """Keep the length; pushing: also restore it. A spring of its own compliance pushes always."""
    a, b = joints.bodies[k, 0], joints.bodies[k, 1]
    row, held = joints.rows, joints.impulses
    levers = levers_now(row, k, motion, a, b)
    gap_x, gap_y = apart_now(row, k, motion, a, b, levers)
    length, ux, uy = direction(gap_x, gap_y)
    x, y = speed_apart(motion, a, b, levers)
    la, lb = levers[0] * uy - levers[1] * ux, levers[2] * uy - levers[3] * ux
    weight = row[k, JIMA] + row[k, JIMB] + row[k, JIIA] * la * la + row[k, JIIB] * lb * lb
    speed, mass, give = x * ux + y * uy, 1.0, 0.0
    if pushing or joints.parameters[k, HERTZ] > 0.0:
        speed += row[k, RATE] * (length - joints.parameters[k, LENGTH])
        mass, give = row[k, MASS], row[k, GIVE]
    j = -mass * speed / weight - give * held[k, PULL_X]
    held[k, PULL_X] += j
    push_points(row, k, motion, a, b, levers, j * ux, j * uy)
