"""Joints by sweeps of velocities: EQUAL lines together as one block a joint, limits and drives."""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel
from game.physics.solids.joints.layout import (
    DRIVE,
    EQUAL,
    GIVE,
    HIGH,
    JIIA,
    JIIB,
    JIMA,
    JIMB,
    LA,
    LB,
    LINE,
    LINE_GAP,
    LINE_WIDTH,
    LOW,
    MASS,
    MOST,
    MOUSE,
    OFF,
    OWN,
    PULL_X,
    PULL_Y,
    RATE,
    SPEED,
    SUBSTEP,
    TURN,
    UX,
    UY,
)
from game.physics.solids.joints.lines import line_speed, push_line, write_lines
from game.physics.solids.joints.points import line_weight


@inner_kernel
def line_coupling(joints, k, p, q):
    """Entry of K of two lines (columns p and q) of one joint."""
    row, line = joints.rows, joints.lines
    along = line[k, p + UX] * line[k, q + UX] + line[k, p + UY] * line[k, q + UY]
    coupling = along * (row[k, JIMA] + row[k, JIMB])
    coupling += row[k, JIIA] * line[k, p + LA] * line[k, q + LA]
    return coupling + row[k, JIIB] * line[k, p + LB] * line[k, q + LB]


@inner_kernel
def solve_three(k11, k12, k13, k22, k23, k33, r1, r2, r3):
    """K⁻¹ r of a symmetric positive definite K, by L D Lᵀ."""
    l21, l31 = k12 / k11, k13 / k11
    d2 = k22 - l21 * k12
    l32 = (k23 - l31 * k12) / d2
    d3 = k33 - l31 * k13 - l32 * l32 * d2
    y2 = r2 - l21 * r1
    x3 = (r3 - l31 * r1 - l32 * y2) / d3
    x2 = y2 / d2 - l32 * x3
    return r1 / k11 - l21 * x2 - l31 * x3, x2, x3


@inner_kernel
def wanted(joints, k, slot, motion, pushing):
    """Speed that an EQUAL line must lose, as its spring asks for."""
    at = slot * LINE_WIDTH
    speed = line_speed(joints, k, at, motion)
    if pushing or joints.rows[k, OWN] > 0.0:
        speed += joints.rows[k, RATE] * joints.lines[k, at + LINE_GAP]
    return speed


@inner_kernel
def solve_block(joints, k, motion, pushing):
    """Lines along x, y and of the turn together."""
    line, row, held = joints.lines, joints.rows, joints.impulses
    mass, give = 1.0, 0.0
    if pushing or row[k, OWN] > 0.0:
        mass, give = row[k, MASS], row[k, GIVE]
    x, y, t = PULL_X * LINE_WIDTH, PULL_Y * LINE_WIDTH, TURN * LINE_WIDTH
    kxx, kyy, ktt = 1.0, 1.0, 1.0
    kxy, kxt, kyt = 0.0, 0.0, 0.0
    rx, ry, rt = 0.0, 0.0, 0.0
    if line[k, x + LINE] == EQUAL:
        kxx, rx = line_weight(joints, k, x), wanted(joints, k, PULL_X, motion, pushing)
        if line[k, y + LINE] == EQUAL:
            kxy = line_coupling(joints, k, x, y)
        if line[k, t + LINE] == EQUAL:
            kxt = line_coupling(joints, k, x, t)
    if line[k, y + LINE] == EQUAL:
        kyy, ry = line_weight(joints, k, y), wanted(joints, k, PULL_Y, motion, pushing)
        if line[k, t + LINE] == EQUAL:
            kyt = line_coupling(joints, k, y, t)
    if line[k, t + LINE] == EQUAL:
        ktt, rt = line_weight(joints, k, t), wanted(joints, k, TURN, motion, pushing)
    jx, jy, jt = solve_three(kxx, kxy, kxt, kyy, kyt, ktt, rx, ry, rt)
    jx = (1.0 - give) * held[k, PULL_X] - mass * jx
    jy = (1.0 - give) * held[k, PULL_Y] - mass * jy
    jt = (1.0 - give) * held[k, TURN] - mass * jt
    if joints.kinds[k] == MOUSE:
        jx, jy = within(jx, jy, row[k, SUBSTEP] * joints.parameters[k, MOST])
    push_slot(joints, k, PULL_X, motion, jx)
    push_slot(joints, k, PULL_Y, motion, jy)
    push_slot(joints, k, TURN, motion, jt)


@inner_kernel
def within(x, y, most):
    """(x, y), made as short as most."""
    size = math.sqrt(x * x + y * y)
    if size > most:
        return x * most / size, y * most / size
    return x, y


@inner_kernel
def push_slot(joints, k, slot, motion, j):
    """The impulse of a line becomes j."""
    if joints.lines[k, slot * LINE_WIDTH + LINE] != OFF:
        push_line(joints, k, slot * LINE_WIDTH, motion, j - joints.impulses[k, slot])
        joints.impulses[k, slot] = j


@inner_kernel
def sweep_drive(joints, k, motion):
    """Turn or draw at the drive's speed, by no more than its most."""
    at = DRIVE * LINE_WIDTH
    if joints.lines[k, at + LINE] == OFF:
        return
    most = joints.rows[k, SUBSTEP] * joints.parameters[k, MOST]
    speed = line_speed(joints, k, at, motion) - joints.parameters[k, SPEED]
    j = joints.impulses[k, DRIVE] - speed / line_weight(joints, k, at)
    push_slot(joints, k, DRIVE, motion, max(-most, min(most, j)))


@inner_kernel
def sweep_limit(joints, k, slot, motion, pushing):
    """A limit: what is still open may close in this substep; what is beyond comes back."""
    at = slot * LINE_WIDTH
    if joints.lines[k, at + LINE] == OFF:
        return
    gap = joints.lines[k, at + LINE_GAP]
    speed = line_speed(joints, k, at, motion)
    if gap > 0.0:
        speed += gap / joints.rows[k, SUBSTEP]
    elif pushing:
        speed += 0.2 * gap / joints.rows[k, SUBSTEP]
    j = joints.impulses[k, slot] - speed / line_weight(joints, k, at)
    push_slot(joints, k, slot, motion, max(0.0, j))


@inner_kernel
def sweep_joints(joints, motion, pushing):
    """One sweep over all joints; pushing: also restore what has drifted."""
    for k in range(joints.kinds.shape[0]):
        if joints.rows[k, SUBSTEP] > 0.0:
            write_lines(joints, k, motion)
            sweep_drive(joints, k, motion)
            solve_block(joints, k, motion, pushing)
            sweep_limit(joints, k, LOW, motion, pushing)
            sweep_limit(joints, k, HIGH, motion, pushing)


@inner_kernel
def sweep_bounded(joints, motion, pushing):
    """Only limits and drives, beside the direct solve of the rest."""
    for k in range(joints.kinds.shape[0]):
        if joints.rows[k, SUBSTEP] > 0.0:
            sweep_drive(joints, k, motion)
            sweep_limit(joints, k, LOW, motion, pushing)
            sweep_limit(joints, k, HIGH, motion, pushing)
