"""Joints by sweeps of velocities: EQUAL lines together as one block a joint, limits and drives."""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel
from game.physics.solids.arrays import layout
from game.physics.solids.joints.lines import line_speed, push_line, write_lines
from game.physics.solids.joints.points import line_weight


@inner_kernel
def line_coupling(joints, k, p, q):
    """Entry of K of two lines (columns p and q) of one joint."""
    row, line = joints.rows, joints.lines
    along = line[k, p + layout.UX] * line[k, q + layout.UX] + line[k, p + layout.UY] * line[k, q + layout.UY]
    coupling = along * (row[k, layout.JIMA] + row[k, layout.JIMB])
    coupling += row[k, layout.JIIA] * line[k, p + layout.LA] * line[k, q + layout.LA]
    return coupling + row[k, layout.JIIB] * line[k, p + layout.LB] * line[k, q + layout.LB]


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
    at = slot * layout.LINE_WIDTH
    speed = line_speed(joints, k, at, motion)
    if pushing or joints.rows[k, layout.OWN] > 0.0:
        speed += joints.rows[k, layout.RATE] * joints.lines[k, at + layout.LINE_GAP]
    return speed


@inner_kernel
def solve_block(joints, k, motion, pushing):
    """Lines along x, y and of the turn together."""
    line, row, held = joints.lines, joints.rows, joints.impulses
    mass, give = 1.0, 0.0
    if pushing or row[k, layout.OWN] > 0.0:
        mass, give = row[k, layout.MASS], row[k, layout.GIVE]
    x, y, t = (
        layout.PULL_X * layout.LINE_WIDTH,
        layout.PULL_Y * layout.LINE_WIDTH,
        layout.TURN * layout.LINE_WIDTH,
    )
    kxx, kyy, ktt = 1.0, 1.0, 1.0
    kxy, kxt, kyt = 0.0, 0.0, 0.0
    rx, ry, rt = 0.0, 0.0, 0.0
    if line[k, x + layout.LINE] == layout.EQUAL:
        kxx, rx = line_weight(joints, k, x), wanted(joints, k, layout.PULL_X, motion, pushing)
        if line[k, y + layout.LINE] == layout.EQUAL:
            kxy = line_coupling(joints, k, x, y)
        if line[k, t + layout.LINE] == layout.EQUAL:
            kxt = line_coupling(joints, k, x, t)
    if line[k, y + layout.LINE] == layout.EQUAL:
        kyy, ry = line_weight(joints, k, y), wanted(joints, k, layout.PULL_Y, motion, pushing)
        if line[k, t + layout.LINE] == layout.EQUAL:
            kyt = line_coupling(joints, k, y, t)
    if line[k, t + layout.LINE] == layout.EQUAL:
        ktt, rt = line_weight(joints, k, t), wanted(joints, k, layout.TURN, motion, pushing)
    jx, jy, jt = solve_three(kxx, kxy, kxt, kyy, kyt, ktt, rx, ry, rt)
    jx = (1.0 - give) * held[k, layout.PULL_X] - mass * jx
    jy = (1.0 - give) * held[k, layout.PULL_Y] - mass * jy
    jt = (1.0 - give) * held[k, layout.TURN] - mass * jt
    if joints.kinds[k] == layout.MOUSE:
        jx, jy = within(jx, jy, row[k, layout.SUBSTEP] * joints.parameters[k, layout.MOST])
    push_slot(joints, k, layout.PULL_X, motion, jx)
    push_slot(joints, k, layout.PULL_Y, motion, jy)
    push_slot(joints, k, layout.TURN, motion, jt)


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
    if joints.lines[k, slot * layout.LINE_WIDTH + layout.LINE] != layout.OFF:
        push_line(joints, k, slot * layout.LINE_WIDTH, motion, j - joints.impulses[k, slot])
        joints.impulses[k, slot] = j


@inner_kernel
def sweep_drive(joints, k, motion):
    """Turn or draw at the drive's speed, by no more than its most."""
    at = layout.DRIVE * layout.LINE_WIDTH
    if joints.lines[k, at + layout.LINE] == layout.OFF:
        return
    most = joints.rows[k, layout.SUBSTEP] * joints.parameters[k, layout.MOST]
    speed = line_speed(joints, k, at, motion) - joints.parameters[k, layout.SPEED]
    j = joints.impulses[k, layout.DRIVE] - speed / line_weight(joints, k, at)
    push_slot(joints, k, layout.DRIVE, motion, max(-most, min(most, j)))


@inner_kernel
def sweep_limit(joints, k, slot, motion, pushing):
    """A limit: what is still open may close in this substep; what is beyond comes back."""
    at = slot * layout.LINE_WIDTH
    if joints.lines[k, at + layout.LINE] == layout.OFF:
        return
    gap = joints.lines[k, at + layout.LINE_GAP]
    speed = line_speed(joints, k, at, motion)
    if gap > 0.0:
        speed += gap / joints.rows[k, layout.SUBSTEP]
    elif pushing:
        speed += 0.2 * gap / joints.rows[k, layout.SUBSTEP]
    j = joints.impulses[k, slot] - speed / line_weight(joints, k, at)
    push_slot(joints, k, slot, motion, max(0.0, j))


@inner_kernel
def sweep_joints(joints, motion, pushing):
    """One sweep over all joints; pushing: also restore what has drifted."""
    for k in range(joints.kinds.shape[0]):
        if joints.rows[k, layout.SUBSTEP] > 0.0:
            write_lines(joints, k, motion)
            sweep_drive(joints, k, motion)
            solve_block(joints, k, motion, pushing)
            sweep_limit(joints, k, layout.LOW, motion, pushing)
            sweep_limit(joints, k, layout.HIGH, motion, pushing)


@inner_kernel
def sweep_bounded(joints, motion, pushing):
    """Only limits and drives, beside the direct solve of the rest."""
    for k in range(joints.kinds.shape[0]):
        if joints.rows[k, layout.SUBSTEP] > 0.0:
            sweep_drive(joints, k, motion)
            sweep_limit(joints, k, layout.LOW, motion, pushing)
            sweep_limit(joints, k, layout.HIGH, motion, pushing)
