"""Sequential impulses: sweeps of velocities with warm start, overlap driven apart by a bias (Catto 2005).

A substep: forces, last impulses again, ``iterations`` sweeps in which overlap beyond a slop adds 0.2 of
itself, each substep, as speed (Baumgarte 1972), places. The bias stays in the velocities: this is what the
soft step takes out. Impacts come first (`impacts`).
"""

from __future__ import annotations

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.solids.arrays import state
from game.physics.solids.joints.direct import solve_joints
from game.physics.solids.joints.geometric import steady_turns
from game.physics.solids.joints.lines import prepare_joints, start_joints_warm
from game.physics.solids.solvers.impacts import ALONE, resolve_impacts
from game.physics.solids.solvers.impulses import start_warm, sweep_contacts
from game.physics.solids.solvers.motion import accelerate, move

BAUMGARTE = 0.2  # part of an overlap that becomes speed in one substep


@inner_kernel
def leave_slop(rows, slop):
    """Count gaps from a little overlap on, which keeps contacts alive."""
    for c in range(rows.count[0]):
        for k in range(rows.ends[c, state.END_POINTS]):
            rows.rows[c, state.ROW_POINT + k * state.ROW_POINT_WIDTH + state.SEP] += slop


@lean_kernel
def solve_sequential_impulses(bodies, contacts, rows, joints, scratch, numbers):
    """All substeps of one step. See the package."""
    motion = scratch.motion
    rate = BAUMGARTE / numbers.h
    hard = (rate, 1.0, 0.0)
    springs = (hard, hard, numbers.push, 1.0 / numbers.h)
    prepare_joints(bodies, joints, hard, numbers)
    leave_slop(rows, numbers.slop)
    for _ in range(numbers.substeps):
        accelerate(scratch, numbers)
        resolve_impacts(rows, scratch, numbers, ALONE)
        start_joints_warm(joints, motion)
        steady_turns(bodies, joints, scratch, numbers.h)
        start_warm(rows, motion)
        for _ in range(numbers.iterations):
            solve_joints(joints, scratch.plan, motion, True)
            sweep_contacts(rows, motion, springs, True, True)
        move(motion, numbers.h)
