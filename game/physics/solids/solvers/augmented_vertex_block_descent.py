"""Augmented vertex block descent, as printed: Giles, Diaz, Yuksel 2025, "Augmented Vertex Block Descent".

Sections 3.1 to 3.7 and their demonstration's constants: a hard contact or joint has a force that is
remembered. Its stiffness grows by 100,000 N/m for each metre of its gap in each sweep, from 1 N/m. Both are
kept from step to step by 0.99 (the force by 0.99 of that again). And 0.99 of the gap that a step begins with
is left to the next steps. Friction is bounded by the normal force of the sweep before. It is meant for one
substep of 1/60 s with 10 sweeps. A sweep begins where velocities lead, without gravity in the place of the
printed estimate of last step's acceleration.

What it cannot do: momentum is kept to 0.5 % only, as bodies move one after the other. What slides rolls late;
stiffness takes time to grow, so what is dropped or loaded sinks first and comes back slowly.
"""

from __future__ import annotations

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.solids.arrays import layout, state
from game.physics.solids.joints.lines import prepare_joints, write_lines
from game.physics.solids.solvers.descent import (
    STIFFNESS_N,
    STIFFNESS_T,
    aim,
    count_touching,
    descend,
    friction_force,
    line_force,
    note_largest,
    point_force,
    start_lines,
)
from game.physics.solids.solvers.impacts import ALL, resolve_impacts
from game.physics.solids.solvers.motion import accelerate
from game.physics.solids.solvers.passive import FREE, excuse, hold_energy, note_speeds
from game.physics.solids.solvers.positions import note_gaps, remember, remember_places, velocities_from_places

LEFT = 0.99  # alpha: of a gap, for the next steps
KEPT = 0.99  # gamma: of forces and stiffnesses
GROWTH = 1e5  # beta: N/m for each m
LEAST, LARGEST = 1.0, 1e9  # N/m
MARGIN = 0.0005  # m, the gap up to which the printed method has a contact at all


@inner_kernel
def start_stiffnesses(contacts, rows, joints, scratch):
    """What is kept of forces and stiffnesses: nothing where two were apart, as if the contact were new.

    The stiffness of an earlier touch would answer a new impact with a force that ten sweeps cannot balance.
    """
    for c in range(rows.count[0]):
        pair = rows.ends[c, state.END_PAIR]
        for k in range(rows.ends[c, state.END_POINTS]):
            at = state.ROW_POINT + k * state.ROW_POINT_WIDTH
            apart = rows.rows[c, at + state.JN] == 0.0 and rows.rows[c, at + state.SEP] > MARGIN
            rows.rows[c, at + state.JN] *= LEFT * KEPT
            rows.rows[c, at + state.JT] *= LEFT * KEPT
            for n in range(2):
                stiff = 0.0 if apart else contacts.manifolds[pair, state.STIFF + 2 * n + k]
                scratch.points[c, STIFFNESS_N + 2 * n + k] = max(LEAST, min(LARGEST, KEPT * stiff))
    for k in range(joints.kinds.shape[0]):
        for slot in range(layout.IMPULSES):
            joints.impulses[k, slot] *= LEFT * KEPT
            joints.stiffnesses[k, slot] = max(LEAST, min(LARGEST, KEPT * joints.stiffnesses[k, slot]))


@inner_kernel
def keep_stiffnesses(contacts, rows, scratch):
    """Back to where the next step finds them."""
    for c in range(rows.count[0]):
        for k in range(rows.ends[c, state.END_POINTS]):
            for n in range(2):
                contacts.manifolds[rows.ends[c, state.END_PAIR], state.STIFF + 2 * n + k] = scratch.points[
                    c, STIFFNESS_N + 2 * n + k
                ]


@inner_kernel
def update_forces(rows, joints, scratch, rule):
    """Forces become what they were found to be; what is not at its bound gets stiffer."""
    row, motion, h = rows.rows, scratch.motion, rule[1]
    for c in range(rows.count[0]):
        for k in range(rows.ends[c, state.END_POINTS]):
            at = state.ROW_POINT + k * state.ROW_POINT_WIDTH
            jn, gap, slid = point_force(row, c, k, motion, scratch, rows.ends, rule)
            jt, holds = friction_force(row, c, k, slid, scratch, h)
            row[c, at + state.JN], row[c, at + state.JT] = jn, jt
            if jn > 0.0:
                stiffen(scratch.points, c, STIFFNESS_N + k, gap)
                if holds:
                    stiffen(scratch.points, c, STIFFNESS_T + k, slid)
    for k in range(joints.kinds.shape[0]):
        if joints.rows[k, layout.SUBSTEP] < 0.0:
            continue
        write_lines(joints, k, motion)
        for slot in range(layout.IMPULSES):
            kind = joints.lines[k, slot * layout.LINE_WIDTH + layout.LINE]
            if kind == layout.OFF:
                continue
            j, _, gap = line_force(joints, k, slot, motion, scratch.before, rule[0])
            joints.impulses[k, slot] = j
            at_bound = (kind == layout.ONE_SIDED and j == 0.0) or (
                kind == layout.DRIVING and abs(j) >= h * joints.parameters[k, layout.MOST]
            )
            if not at_bound and joints.parameters[k, layout.HERTZ] == 0.0:
                stiffen(joints.stiffnesses, k, slot, gap)


@inner_kernel
def stiffen(table, i, n, gap):
    """A stiffness grows with its gap."""
    table[i, n] = min(LARGEST, table[i, n] + GROWTH * abs(gap))


@lean_kernel
def solve_augmented_vertex_block_descent(bodies, contacts, rows, joints, scratch, numbers):
    """All substeps of one step. See the package."""
    motion, h, rule = scratch.motion, numbers.h, (LEFT, numbers.h)
    prepare_joints(bodies, joints, (0.0, 1.0, 0.0), numbers)
    count_touching(bodies, rows, joints, scratch)
    excuse(bodies, rows, joints, scratch)
    for _ in range(numbers.substeps):
        start_stiffnesses(contacts, rows, joints, scratch)
        start_lines(joints, motion)
        remember(motion, scratch.before)
        accelerate(scratch, numbers)
        if resolve_impacts(rows, scratch, numbers, ALL):
            remember_places(motion, scratch.before)
        note_speeds(motion, scratch.speeds, FREE)
        note_gaps(rows, motion, scratch.points)
        aim(motion, scratch, h)
        for _ in range(numbers.iterations):
            descend(bodies, rows, joints, scratch, rule)
            update_forces(rows, joints, scratch, rule)
        velocities_from_places(bodies, motion, scratch.before, h)
        hold_energy(bodies, rows, scratch, numbers)
        note_largest(rows)
        keep_stiffnesses(contacts, rows, scratch)
