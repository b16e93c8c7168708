"""Compliant augmented Lagrangian: block descent with forces remembered, and stiffnesses that are known
beforehand.

After the Newton physics engine's rigid solver (2026). A line of stiffness K has the penalty rho = max(H, 9
K), a contact's normal H = 1 / (h² J M⁻¹ Jᵀ): as stiff as inertia makes it in one substep. Its force is k gap
+ s f with k = K rho / (K + rho) and s = K / (K + rho), f the force that is remembered. It becomes s (f + rho
gap) after each sweep and is kept by 0.999 from substep to substep. What is stiff (K without bound) has s = 1
and k = rho. Nothing is ramped, so what is dropped is carried at once. Of a gap that a substep begins with,
0.99 is left to the next ones, so that parting gives no speed.

A line with a compliance of its own acts as that spring, to which the formulas come in the end.

What it cannot do: sliding, which it brakes too much (a slope's slide comes 6 % short); it converges as
sweeps over bodies do, a few bodies a sweep: long columns and chains sink first, and come up as forces are
remembered.
"""

from __future__ import annotations

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.solids.arrays import layout, state
from game.physics.solids.joints.lines import prepare_joints, write_lines
from game.physics.solids.joints.points import line_weight
from game.physics.solids.solvers.descent import (
    STIFFNESS_N,
    STIFFNESS_T,
    aim,
    count_touching,
    descend,
    forget_impacts,
    friction_force,
    line_force,
    note_largest,
    point_force,
    start_lines,
)
from game.physics.solids.solvers.impacts import BOUNCES, resolve_impacts
from game.physics.solids.solvers.motion import accelerate
from game.physics.solids.solvers.positions import note_gaps, remember, remember_places, velocities_from_places

LEFT = 0.99  # of a gap, for the next substeps
KEPT = 0.999  # of forces


@inner_kernel
def start_forces(rows, joints, scratch, h):
    """Stiffnesses by inertia; what is kept of forces."""
    row = rows.rows
    for c in range(rows.count[0]):
        for k in range(rows.ends[c, state.END_POINTS]):
            at = state.ROW_POINT + k * state.ROW_POINT_WIDTH
            row[c, at + state.JN] *= KEPT
            row[c, at + state.JT] *= KEPT
            scratch.points[c, STIFFNESS_N + k] = 1.0 / (row[c, at + state.STIFF_N] * h * h)
            scratch.points[c, STIFFNESS_T + k] = row[c, at + state.MASS_T] / (h * h)
    for k in range(joints.kinds.shape[0]):
        if joints.rows[k, layout.SUBSTEP] < 0.0:
            continue
        for slot in range(layout.IMPULSES):
            at = slot * layout.LINE_WIDTH
            if joints.lines[k, at + layout.LINE] == layout.OFF:
                continue
            joints.impulses[k, slot] *= KEPT
            joints.stiffnesses[k, slot] = 1.0 / (h * h * line_weight(joints, k, at))


@inner_kernel
def update_forces(rows, joints, scratch, rule):
    """Forces become what they were found to be."""
    row, motion, h = rows.rows, scratch.motion, rule[1]
    for c in range(rows.count[0]):
        for k in range(rows.ends[c, state.END_POINTS]):
            at = state.ROW_POINT + k * state.ROW_POINT_WIDTH
            jn, _, slid = point_force(row, c, k, motion, scratch, rows.ends, rule)
            jt = friction_force(row, c, k, slid, scratch, h)[0]
            row[c, at + state.JN], row[c, at + state.JT] = jn, jt
    for k in range(joints.kinds.shape[0]):
        if joints.rows[k, layout.SUBSTEP] < 0.0:
            continue
        write_lines(joints, k, motion)
        for slot in range(layout.IMPULSES):
            if joints.lines[k, slot * layout.LINE_WIDTH + layout.LINE] != layout.OFF:
                joints.impulses[k, slot] = line_force(joints, k, slot, motion, scratch.before, rule[0])[0]


@lean_kernel
def solve_compliant_lagrangian(bodies, contacts, rows, joints, scratch, numbers):
    """All substeps of one step. See the package."""
    motion, h, rule = scratch.motion, numbers.h, (LEFT, numbers.h)
    prepare_joints(bodies, joints, (0.0, 1.0, 0.0), numbers)
    count_touching(bodies, rows, joints, scratch)
    for _ in range(numbers.substeps):
        start_lines(joints, motion)
        start_forces(rows, joints, scratch, h)
        remember(motion, scratch.before)
        accelerate(scratch, numbers)
        if resolve_impacts(rows, scratch, numbers, BOUNCES):
            remember_places(motion, scratch.before)
        note_gaps(rows, motion, scratch.points)
        aim(motion, scratch, h)
        for _ in range(numbers.iterations):
            descend(bodies, rows, joints, scratch, rule)
            update_forces(rows, joints, scratch, rule)
        velocities_from_places(bodies, motion, scratch.before, h)
        note_largest(rows)
    forget_impacts(rows)
