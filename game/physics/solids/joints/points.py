"""What kinds of joints share: where their two points are now, and impulses at them."""

from __future__ import annotations

import math

from game.physics.kernels.lean import inner_kernel
from game.physics.solids.joints.layout import (
    DAMPING,
    GIVE,
    HERTZ,
    JAX,
    JAY,
    JBX,
    JBY,
    JIIA,
    JIIB,
    JIMA,
    JIMB,
    MASS,
    OFFSET_X,
    OFFSET_Y,
    RATE,
)
from game.physics.solids.state import DC, DS, DX, DY, VX, VY, W


@inner_kernel
def prepare_points(bodies, joints, k, soft, h):
    """Levers, masses and spring of one joint. soft: rate, mass, give of joints without a compliance."""
    a, b = joints.bodies[k, 0], joints.bodies[k, 1]
    row, anchors = joints.rows, joints.anchors
    ca, sa, cb, sb = (
        bodies.rotations[a, 0],
        bodies.rotations[a, 1],
        bodies.rotations[b, 0],
        bodies.rotations[b, 1],
    )
    row[k, JAX] = ca * anchors[k, 0] - sa * anchors[k, 1]
    row[k, JAY] = sa * anchors[k, 0] + ca * anchors[k, 1]
    row[k, JBX] = cb * anchors[k, 2] - sb * anchors[k, 3]
    row[k, JBY] = sb * anchors[k, 2] + cb * anchors[k, 3]
    row[k, OFFSET_X] = bodies.positions[b, 0] - bodies.positions[a, 0]
    row[k, OFFSET_Y] = bodies.positions[b, 1] - bodies.positions[a, 1]
    row[k, JIMA], row[k, JIIA] = bodies.inverse_masses[a], bodies.inverse_inertias[a]
    row[k, JIMB], row[k, JIIB] = bodies.inverse_masses[b], bodies.inverse_inertias[b]
    row[k, RATE], row[k, MASS], row[k, GIVE] = soft
    if joints.parameters[k, HERTZ] > 0.0:
        omega = 2.0 * math.pi * joints.parameters[k, HERTZ]
        a1 = 2.0 * joints.parameters[k, DAMPING] + h * omega
        a2 = h * omega * a1
        row[k, RATE], row[k, MASS], row[k, GIVE] = omega / a1, a2 / (1.0 + a2), 1.0 / (1.0 + a2)


@inner_kernel
def levers_now(row, k, motion, a, b):
    """Both levers as they have turned by now: rax, ray, rbx, rby."""
    ca, sa, cb, sb = motion[a, DC], motion[a, DS], motion[b, DC], motion[b, DS]
    ax, ay, bx, by = row[k, JAX], row[k, JAY], row[k, JBX], row[k, JBY]
    return ca * ax - sa * ay, sa * ax + ca * ay, cb * bx - sb * by, sb * bx + cb * by


@inner_kernel
def apart_now(row, k, motion, a, b, levers):
    """From a's point to b's, m."""
    x = row[k, OFFSET_X] + motion[b, DX] - motion[a, DX] + levers[2] - levers[0]
    y = row[k, OFFSET_Y] + motion[b, DY] - motion[a, DY] + levers[3] - levers[1]
    return x, y


@inner_kernel
def speed_apart(motion, a, b, levers):
    """Velocity of b's point against a's, m/s."""
    x = motion[b, VX] - motion[b, W] * levers[3] - motion[a, VX] + motion[a, W] * levers[1]
    y = motion[b, VY] + motion[b, W] * levers[2] - motion[a, VY] - motion[a, W] * levers[0]
    return x, y


@inner_kernel
def push_points(row, k, motion, a, b, levers, x, y):
    """An impulse (x, y) N s at b's point, and against it at a's."""
    motion[a, VX] -= row[k, JIMA] * x
    motion[a, VY] -= row[k, JIMA] * y
    motion[a, W] -= row[k, JIIA] * (levers[0] * y - levers[1] * x)
    motion[b, VX] += row[k, JIMB] * x
    motion[b, VY] += row[k, JIMB] * y
    motion[b, W] += row[k, JIIB] * (levers[2] * y - levers[3] * x)


@inner_kernel
def solve_pair(row, k, levers, x, y):
    """The impulse that changes the points' velocity against each other by (x, y): K⁻¹ (x, y)."""
    ima, iia, imb, iib = row[k, JIMA], row[k, JIIA], row[k, JIMB], row[k, JIIB]
    rax, ray, rbx, rby = levers
    k11 = ima + imb + iia * ray * ray + iib * rby * rby
    k12 = -iia * rax * ray - iib * rbx * rby
    k22 = ima + imb + iia * rax * rax + iib * rbx * rbx
    over = 1.0 / (k11 * k22 - k12 * k12)
    return over * (k22 * x - k12 * y), over * (k11 * y - k12 * x)
