"""XPBD with small steps: places are predicted, then corrected until contacts and joints are kept.

Macklin, Storey, Lu, Terdiman, Chentanez, Jeschke, Müller 2019, "Small Steps in Physics Simulation", section
4. Rigid bodies by Müller, Macklin, Chentanez, Jeschke, Kim 2020, "Detailed Rigid Body Simulation with
Extended Position Based Dynamics", section 3. A substep: forces, predicted places, ``iterations`` (one, as
printed) sweeps of positions from impulses of zero, velocities from what was moved. Last, the speed that
parting an overlap gave is taken out. Friction is static and sliding in one: a correction within the cone of
the normal one. Joints take their compliance as it is (section 3 of Macklin, Müller, Chentanez 2016), never
more than a sweep a substep.

What it cannot do: nothing is kept from substep to substep, so a column sinks, and joints stretch, as the
square of their number and of the substep: chains under heavy loads need very many substeps, and a box 1,000
times heavier than the one below crushes it. Two points are solved together, as in `impulses`.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.solids.arrays import layout, state
from game.physics.solids.joints.lines import prepare_joints, write_lines
from game.physics.solids.joints.points import line_weight
from game.physics.solids.solvers.impacts import BOUNCES, resolve_impacts
from game.physics.solids.solvers.impulses import gap_now, gap_speed, push_point, solve_two
from game.physics.solids.solvers.motion import accelerate, move
from game.physics.solids.solvers.positions import (
    clear_impulses,
    note_gaps,
    remember,
    shift_point,
    slide_now,
    turn_body,
    velocities_from_places,
)

SECOND = state.ROW_POINT + state.ROW_POINT_WIDTH


@inner_kernel
def sweep_places(rows, motion, scratch, parting):
    """One sweep over contacts. parting: m, how much of an old overlap a substep may take away."""
    row, ends, before = rows.rows, rows.ends, scratch.before
    for c in range(rows.count[0]):
        a, b = ends[c, state.END_A], ends[c, state.END_B]
        at, second = state.ROW_POINT, SECOND
        g1 = gap_now(row, c, at, motion, a, b) - min(0.0, scratch.points[c, 0] + parting)
        n1 = row[c, at + state.JN]
        if ends[c, state.END_POINTS] == 1:
            shift_point(row, c, at, motion, a, b, max(n1 - g1 / row[c, at + state.STIFF_N], 0.0) - n1, 0.0)
            row[c, at + state.JN] = max(n1 - g1 / row[c, at + state.STIFF_N], 0.0)
        else:
            g2 = gap_now(row, c, second, motion, a, b) - min(0.0, scratch.points[c, 1] + parting)
            n2, k12 = row[c, second + state.JN], row[c, state.COUPLING]
            k1, k2 = row[c, at + state.STIFF_N], row[c, second + state.STIFF_N]
            j1, j2 = solve_two(k1, k12, k2, g1 - k1 * n1 - k12 * n2, g2 - k12 * n1 - k2 * n2)
            row[c, at + state.JN], row[c, second + state.JN] = j1, j2
            shift_point(row, c, at, motion, a, b, j1 - n1, 0.0)
            shift_point(row, c, second, motion, a, b, j2 - n2, 0.0)
        for k in range(ends[c, state.END_POINTS]):
            at = state.ROW_POINT + k * state.ROW_POINT_WIDTH
            most, old = row[c, state.ROW_MU] * row[c, at + state.JN], row[c, at + state.JT]
            slid = slide_now(row, c, at, a, b, motion, before)
            j = max(-most, min(most, old - row[c, at + state.MASS_T] * slid))
            row[c, at + state.JT] = j
            shift_point(row, c, at, motion, a, b, 0.0, j - old)


@inner_kernel
def line_shift(joints, k, at, motion, before):
    """How far the line at column ``at`` of joint k has moved since ``before``, m or rad."""
    a, b, line = joints.bodies[k, 0], joints.bodies[k, 1], joints.lines
    shift = line[k, at + layout.UX] * (motion[b, state.DX] - before[b, state.DX])
    shift += line[k, at + layout.UY] * (motion[b, state.DY] - before[b, state.DY])
    shift += line[k, at + layout.LB] * (motion[b, state.DA] - before[b, state.DA])
    held = line[k, at + layout.UX] * (motion[a, state.DX] - before[a, state.DX])
    held += line[k, at + layout.UY] * (motion[a, state.DY] - before[a, state.DY])
    held += line[k, at + layout.LA] * (motion[a, state.DA] - before[a, state.DA])
    return shift - joints.rows[k, layout.WITH_A] * held


@inner_kernel
def shift_line(joints, k, at, motion, j):
    """Move both bodies of a joint by j along a line, kg m."""
    a, b = joints.bodies[k, 0], joints.bodies[k, 1]
    row, line = joints.rows, joints.lines
    x, y = j * line[k, at + layout.UX], j * line[k, at + layout.UY]
    motion[a, state.DX] -= row[k, layout.JIMA] * x
    motion[a, state.DY] -= row[k, layout.JIMA] * y
    motion[b, state.DX] += row[k, layout.JIMB] * x
    motion[b, state.DY] += row[k, layout.JIMB] * y
    turn_body(motion, a, -row[k, layout.JIIA] * line[k, at + layout.LA] * j)
    turn_body(motion, b, row[k, layout.JIIB] * line[k, at + layout.LB] * j)


@inner_kernel
def correct_line(joints, k, slot, motion, before):
    """The correction of one line, its compliance and bounds kept."""
    at, h, held = slot * layout.LINE_WIDTH, joints.rows[k, layout.SUBSTEP], joints.impulses
    kind, gap = joints.lines[k, at + layout.LINE], joints.lines[k, at + layout.LINE_GAP]
    weight, give, damp, most = line_weight(joints, k, at), 0.0, 0.0, math.inf
    shift = line_shift(joints, k, at, motion, before)
    if kind == layout.EQUAL and joints.parameters[k, layout.HERTZ] > 0.0:
        turn = 2.0 * math.pi * joints.parameters[k, layout.HERTZ] * h
        give, damp = weight / (turn * turn), 2.0 * joints.parameters[k, layout.DAMPING] / turn
    if kind == layout.DRIVING:
        gap = shift - h * joints.parameters[k, layout.SPEED]
    if kind == layout.DRIVING or joints.kinds[k] == layout.MOUSE:
        most = h * h * joints.parameters[k, layout.MOST]
    j = held[k, slot] - (gap + give * held[k, slot] + damp * shift) / ((1.0 + damp) * weight + give)
    j = max(0.0, j) if kind == layout.ONE_SIDED else max(-most, min(most, j))
    shift_line(joints, k, at, motion, j - held[k, slot])
    held[k, slot] = j


@inner_kernel
def sweep_joint_places(joints, motion, before):
    """One sweep over joints."""
    for k in range(joints.kinds.shape[0]):
        if joints.rows[k, layout.SUBSTEP] < 0.0:
            continue
        for slot in range(layout.IMPULSES):
            write_lines(joints, k, motion)
            if joints.lines[k, slot * layout.LINE_WIDTH + layout.LINE] != layout.OFF:
                correct_line(joints, k, slot, motion, before)


@inner_kernel
def scale_impulses(rows, joints, h):
    """Impulses in N s."""
    row = rows.rows
    for c in range(rows.count[0]):
        for k in range(rows.ends[c, state.END_POINTS]):
            at = state.ROW_POINT + k * state.ROW_POINT_WIDTH
            row[c, at + state.JN] /= h
            row[c, at + state.JT] /= h
            rows.rare[c, state.MOST_0 + k] = max(rows.rare[c, state.MOST_0 + k], row[c, at + state.JN])
    for k in range(joints.kinds.shape[0]):
        for slot in range(layout.IMPULSES):
            joints.impulses[k, slot] /= h


@inner_kernel
def stop_parting(rows, motion):
    """What was pushed apart does not go on parting (Müller and others 2020, section 3.6, restitution 0).

    Both points of a row together, as they were pushed; each impulse only takes energy.
    """
    row, ends = rows.rows, rows.ends
    for c in range(rows.count[0]):
        a, b, at = ends[c, state.END_A], ends[c, state.END_B], state.ROW_POINT
        v1 = gap_speed(row, c, at, motion, a, b) if row[c, at + state.JN] > 0.0 else 0.0
        if ends[c, state.END_POINTS] == 1 or not row[c, SECOND + state.JN] > 0.0:
            push_point(row, c, at, motion, a, b, -max(0.0, v1) / row[c, at + state.STIFF_N], 0.0)
        elif not row[c, at + state.JN] > 0.0:
            v2 = gap_speed(row, c, SECOND, motion, a, b)
            push_point(row, c, SECOND, motion, a, b, -max(0.0, v2) / row[c, SECOND + state.STIFF_N], 0.0)
        else:
            v2 = gap_speed(row, c, SECOND, motion, a, b)
            k1, k2 = row[c, at + state.STIFF_N], row[c, SECOND + state.STIFF_N]
            j1, j2 = solve_two(k1, row[c, state.COUPLING], k2, -v1, -v2)
            push_point(row, c, at, motion, a, b, -j1, 0.0)
            push_point(row, c, SECOND, motion, a, b, -j2, 0.0)


@inner_kernel
def clear_joint_impulses(joints):
    """A substep begins without impulses."""
    for k in range(joints.kinds.shape[0]):
        for slot in range(layout.IMPULSES):
            joints.impulses[k, slot] = 0.0


@lean_kernel
def solve_xpbd(bodies, contacts, rows, joints, scratch, numbers):
    """All substeps of one step. See the package."""
    motion, h = scratch.motion, numbers.h
    prepare_joints(bodies, joints, (0.0, 1.0, 0.0), numbers)
    for _ in range(numbers.substeps):
        accelerate(scratch, numbers)
        resolve_impacts(rows, scratch, numbers, BOUNCES)
        remember(motion, scratch.before)
        note_gaps(rows, motion, scratch.points)
        clear_impulses(rows)
        clear_joint_impulses(joints)
        move(motion, h)
        for _ in range(numbers.iterations):
            sweep_joint_places(joints, motion, scratch.before)
            sweep_places(rows, motion, scratch, h * numbers.push)
        velocities_from_places(bodies, motion, scratch.before, h)
        stop_parting(rows, motion)
        scale_impulses(rows, joints, h)
