"""Soft step: substeps, contacts as stiff damped springs, and a relaxing sweep that takes the spring's push
out.

Catto 2023, "Solver2D". A substep: forces, last impulses again, one soft sweep, places, one sweep without
push. Overlap is compliance, not error: it falls as 1/f² with the frequency f, a quarter of the substeps a
second. Impacts bounce once, at the end of the step.
"""

from __future__ import annotations

from game.physics.kernels.lean import lean_kernel
from game.physics.solids.joints.sweeps import prepare_joints, start_joints_warm, sweep_joints
from game.physics.solids.solvers.impulses import bounce_contacts, soft_springs, start_warm, sweep_contacts
from game.physics.solids.solvers.motion import accelerate, move


@lean_kernel
def solve_soft_step(bodies, rows, joints, scratch, numbers):
    """All substeps of one step. See the package."""
    motion, springs = scratch.motion, soft_springs(numbers)
    soft = (numbers.joint_rate, numbers.joint_mass, numbers.joint_give)
    prepare_joints(bodies, joints, soft, numbers.h)
    for _ in range(numbers.substeps):
        accelerate(scratch, numbers)
        start_joints_warm(joints, motion)
        start_warm(rows, motion)
        for _ in range(numbers.iterations):
            sweep_joints(joints, motion, True)
            sweep_contacts(rows, motion, springs, True, False)
        move(motion, numbers.h)
        for _ in range(numbers.iterations):
            sweep_joints(joints, motion, False)
            sweep_contacts(rows, motion, springs, False, True)
    bounce_contacts(rows, motion, numbers)
