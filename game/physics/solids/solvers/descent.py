"""Block descent: each body in turn goes to where its inertia and all forces upon it balance (3 x 3 Newton
step).

What `augmented_vertex_block_descent` and `compliant_lagrangian` share: what touches what, the sweep over
bodies, and how forces are kept between sweeps. They differ in stiffnesses and in what is remembered of
forces. Chen, Liu, Yang, Yuksel 2024, "Vertex Block Descent", section 3. Forces are kept as impulses of a
substep.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel
from game.physics.solids.arrays import layout, state
from game.physics.solids.joints.lines import write_lines
from game.physics.solids.joints.points import line_weight
from game.physics.solids.joints.sweeps import solve_three
from game.physics.solids.solvers.impulses import gap_now
from game.physics.solids.solvers.positions import slide_now, turn_body
from game.physics.solids.solvers.xpbd import line_shift

# columns of Scratch.points: gaps of both points when the substep began, their stiffnesses along normal and
# tangent
GAP_0, STIFFNESS_N, STIFFNESS_T = 0, 2, 4


@inner_kernel
def count_touching(bodies, rows, joints, scratch):
    """Which rows, then joints, each body takes part in: lists one after the other."""
    starts, touching = scratch.starts, scratch.touching
    n = bodies.flags.shape[0]
    for i in range(n + 1):
        starts[i] = 0
    for c in range(rows.count[0]):
        starts[rows.ends[c, state.END_A]] += 1
        starts[rows.ends[c, state.END_B]] += 1
    for k in range(joints.kinds.shape[0]):
        if joints.rows[k, layout.SUBSTEP] > 0.0:
            starts[joints.bodies[k, 0]] += 1
            starts[joints.bodies[k, 1]] += 1
    total = 0
    for i in range(n + 1):
        total += starts[i]
        starts[i] = total
    for back in range(joints.kinds.shape[0]):
        k = joints.kinds.shape[0] - 1 - back
        if joints.rows[k, layout.SUBSTEP] > 0.0:
            for end in range(2):
                starts[joints.bodies[k, end]] -= 1
                touching[starts[joints.bodies[k, end]]] = -1 - k
    for back in range(rows.count[0]):
        c = rows.count[0] - 1 - back
        for end in (state.END_A, state.END_B):
            starts[rows.ends[c, end]] -= 1
            touching[starts[rows.ends[c, end]]] = c


@inner_kernel
def aim(motion, scratch, h):
    """Where inertia and outer forces alone would bring each body: columns VX, VY, W of ``before``.

    A body that may touch something begins on its way without the forces of this substep, so that what rests
    is not shaken. Any other is there already.
    """
    before = scratch.before
    for i in range(motion.shape[0]):
        x, y, turn = h * before[i, state.VX], h * before[i, state.VY], h * before[i, state.W]
        before[i, state.VX] = motion[i, state.DX] + h * motion[i, state.VX]
        before[i, state.VY] = motion[i, state.DY] + h * motion[i, state.VY]
        before[i, state.W] = motion[i, state.DA] + h * motion[i, state.W]
        if scratch.starts[i] == scratch.starts[i + 1]:
            x, y, turn = h * motion[i, state.VX], h * motion[i, state.VY], h * motion[i, state.W]
        motion[i, state.DX] += x
        motion[i, state.DY] += y
        turn_body(motion, i, turn)


@inner_kernel
def point_force(row, c, k, motion, scratch, ends, rule):
    """Normal impulse and slide of a point now. rule: part of an old overlap that is left, h."""
    at, a, b = state.ROW_POINT + k * state.ROW_POINT_WIDTH, ends[c, state.END_A], ends[c, state.END_B]
    keep, h = rule
    gap = gap_now(row, c, at, motion, a, b) - keep * min(0.0, scratch.points[c, GAP_0 + k])
    slid = slide_now(row, c, at, a, b, motion, scratch.before)
    return max(0.0, row[c, at + state.JN] - h * scratch.points[c, STIFFNESS_N + k] * gap), gap, slid


@inner_kernel
def friction_force(row, c, k, slid, scratch, h):
    """Tangential impulse of a point, and whether it holds: within the cone of its last normal impulse."""
    at = state.ROW_POINT + k * state.ROW_POINT_WIDTH
    most = row[c, state.ROW_MU] * row[c, at + state.JN]
    j = row[c, at + state.JT] - h * scratch.points[c, STIFFNESS_T + k] * slid
    return max(-most, min(most, j)), abs(j) < most


@inner_kernel
def add_contact(row, c, i, motion, scratch, ends, rule, system):
    """Forces and stiffnesses of a row upon body i, added to system = (gradient 3, matrix 6)."""
    g0, g1, g2, k00, k01, k02, k11, k12, k22 = system
    h = rule[1]
    nx, ny = row[c, state.ROW_NX], row[c, state.ROW_NY]
    is_b = ends[c, state.END_B] == i
    sign = 1.0 if is_b else -1.0
    for k in range(ends[c, state.END_POINTS]):
        at = state.ROW_POINT + k * state.ROW_POINT_WIDTH
        cross, dot = (
            (row[c, at + state.CROSS_B], row[c, at + state.DOT_B])
            if is_b
            else (
                row[c, at + state.CROSS_A],
                row[c, at + state.DOT_A],
            )
        )
        rounded = dot + (row[c, state.ROUND_B] if is_b else row[c, state.ROUND_A])
        turn = motion[i, state.DC] * cross - motion[i, state.DS] * rounded
        j, _, slid = point_force(row, c, k, motion, scratch, ends, rule)
        if j > 0.0 or row[c, at + state.JN] > 0.0:  # one that just opened still slows what may close it again
            f, stiff = sign * j / h, scratch.points[c, STIFFNESS_N + k]
            g0, g1, g2 = g0 - f * nx, g1 - f * ny, g2 - f * turn
            k00, k01, k02 = k00 + stiff * nx * nx, k01 + stiff * nx * ny, k02 + stiff * nx * turn
            k11, k12 = k11 + stiff * ny * ny, k12 + stiff * ny * turn
            k22 += stiff * turn * turn + abs(f * rounded)
        j = friction_force(row, c, k, slid, scratch, h)[0]
        if row[c, state.ROW_MU] > 0.0 and row[c, at + state.JN] > 0.0:
            f, stiff = sign * j / h, scratch.points[c, STIFFNESS_T + k]
            tx, ty = ny, -nx
            g0, g1, g2 = g0 - f * tx, g1 - f * ty, g2 + f * dot
            k00, k01, k02 = k00 + stiff * tx * tx, k01 + stiff * tx * ty, k02 - stiff * tx * dot
            k11, k12, k22 = k11 + stiff * ty * ty, k12 - stiff * ty * dot, k22 + stiff * dot * dot
    return g0, g1, g2, k00, k01, k02, k11, k12, k22


@inner_kernel
def own_spring(joints, k, at):
    """Stiffness N/m and damping N s/m of a line whose compliance is the joint's own."""
    turn = 2.0 * math.pi * joints.parameters[k, layout.HERTZ]
    mass = 1.0 / line_weight(joints, k, at)
    return mass * turn * turn, 2.0 * mass * joints.parameters[k, layout.DAMPING] * turn


@inner_kernel
def line_force(joints, k, slot, motion, before, keep):
    """Impulse of a line now, the stiffness that it acts with, and its gap; bounds kept."""
    at, h = slot * layout.LINE_WIDTH, joints.rows[k, layout.SUBSTEP]
    kind, gap = joints.lines[k, at + layout.LINE], joints.lines[k, at + layout.LINE_GAP]
    stiff, old = joints.stiffnesses[k, slot], joints.impulses[k, slot]
    if kind == layout.EQUAL and joints.parameters[k, layout.HERTZ] > 0.0:
        stiff, damp = own_spring(joints, k, at)
        j = -h * stiff * gap - damp * line_shift(joints, k, at, motion, before)
        stiff += damp / h
    elif kind == layout.DRIVING:
        gap = line_shift(joints, k, at, motion, before) - h * joints.parameters[k, layout.SPEED]
        j = old - h * stiff * gap
    else:
        start = joints.starts[k, slot]
        gap -= keep * (start if kind == layout.EQUAL else min(0.0, start))
        j = old - h * stiff * gap
    if kind == layout.ONE_SIDED:
        j = max(0.0, j)
    elif kind == layout.DRIVING or joints.kinds[k] == layout.MOUSE:
        most = h * joints.parameters[k, layout.MOST]
        j = max(-most, min(most, j))
    return j, stiff, gap


@inner_kernel
def add_joint_lines(joints, k, i, motion, before, keep, system):
    """Forces and stiffnesses of a joint's lines upon body i."""
    g0, g1, g2, k00, k01, k02, k11, k12, k22 = system
    is_b, h = joints.bodies[k, 1] == i, joints.rows[k, layout.SUBSTEP]
    sign = 1.0 if is_b else -joints.rows[k, layout.WITH_A]
    write_lines(joints, k, motion)
    for slot in range(layout.IMPULSES):
        at = slot * layout.LINE_WIDTH
        if joints.lines[k, at + layout.LINE] == layout.OFF or sign == 0.0:
            continue
        j, stiff, _ = line_force(joints, k, slot, motion, before, keep)
        if (
            joints.lines[k, at + layout.LINE] == layout.ONE_SIDED
            and j == 0.0
            and joints.impulses[k, slot] == 0.0
        ):
            continue
        ux, uy = joints.lines[k, at + layout.UX], joints.lines[k, at + layout.UY]
        turn = joints.lines[k, at + (layout.LB if is_b else layout.LA)]
        f = sign * j / h
        g0, g1, g2 = g0 - f * ux, g1 - f * uy, g2 - f * turn
        k00, k01, k02 = k00 + stiff * ux * ux, k01 + stiff * ux * uy, k02 + stiff * ux * turn
        k11, k12 = k11 + stiff * uy * uy, k12 + stiff * uy * turn
        lever = joint_lever(joints, k, is_b)
        k22 += stiff * turn * turn + abs(f) * lever * math.sqrt(ux * ux + uy * uy)
    return g0, g1, g2, k00, k01, k02, k11, k12, k22


@inner_kernel
def joint_lever(joints, k, is_b):
    """Length of a joint's lever, m."""
    x, y = joints.rows[k, 2 if is_b else 0], joints.rows[k, 3 if is_b else 1]
    return math.sqrt(x * x + y * y)


@inner_kernel
def descend(bodies, rows, joints, scratch, rule):
    """One sweep over bodies: each goes where the sum of its forces is zero, to first order."""
    motion, before, h = scratch.motion, scratch.before, rule[1]
    for i in range(motion.shape[0]):
        im, ii = bodies.inverse_masses[i], bodies.inverse_inertias[i]
        if im == 0.0 or scratch.starts[i] == scratch.starts[i + 1]:
            continue
        m, inertia = 1.0 / (im * h * h), 1.0 / (ii * h * h)
        system = (
            m * (motion[i, state.DX] - before[i, state.VX]), m * (motion[i, state.DY] - before[i, state.VY]),
            inertia * (motion[i, state.DA] - before[i, state.W]), m, 0.0, 0.0, m, 0.0, inertia,
        )  # fmt: skip
        for n in range(scratch.starts[i], scratch.starts[i + 1]):
            c = scratch.touching[n]
            if c >= 0:
                system = add_contact(rows.rows, c, i, motion, scratch, rows.ends, rule, system)
            else:
                system = add_joint_lines(joints, -1 - c, i, motion, before, rule[0], system)
        g0, g1, g2, k00, k01, k02, k11, k12, k22 = system
        x, y, turn = solve_three(k00, k01, k02, k11, k12, k22, g0, g1, g2)
        motion[i, state.DX] -= x
        motion[i, state.DY] -= y
        turn_body(motion, i, -turn)


@inner_kernel
def note_largest(rows):
    """Largest normal impulses of any substep."""
    for c in range(rows.count[0]):
        for k in range(rows.ends[c, state.END_POINTS]):
            j = rows.rows[c, state.ROW_POINT + k * state.ROW_POINT_WIDTH + state.JN]
            rows.rare[c, state.MOST_0 + k] = max(rows.rare[c, state.MOST_0 + k], j)


@inner_kernel
def start_lines(joints, motion):
    """Gaps of all lines when a substep begins; what is off carries nothing."""
    for k in range(joints.kinds.shape[0]):
        if joints.rows[k, layout.SUBSTEP] < 0.0:
            continue
        write_lines(joints, k, motion)
        for slot in range(layout.IMPULSES):
            at = slot * layout.LINE_WIDTH
            joints.starts[k, slot] = joints.lines[k, at + layout.LINE_GAP]
            if joints.lines[k, at + layout.LINE] == layout.OFF:
                joints.impulses[k, slot], joints.stiffnesses[k, slot] = 0.0, 0.0


@inner_kernel
def forget_impacts(rows):
    """The force that stopped an impact is no guess for the next step: it would throw apart what rests."""
    for c in range(rows.count[0]):
        if rows.rare[c, state.IMPACT] > 0.0:
            for k in range(rows.ends[c, state.END_POINTS]):
                at = state.ROW_POINT + k * state.ROW_POINT_WIDTH
                rows.rows[c, at + state.JN], rows.rows[c, at + state.JT] = 0.0, 0.0
