"""Soft step: substeps, contacts as stiff damped springs, and a relaxing sweep that takes the spring's push
out.

Catto 2023, "Solver2D". A substep: forces, last impulses again, one soft sweep, places, one sweep without
push. Overlap is compliance, not error: it falls as 1/f² with the frequency f
(`settings.USUAL_HERTZ`). Impacts come first in each substep (`impacts`). The step is then made passive
(`governor`).
"""

from __future__ import annotations

from typing import Any

from game.compiler.decorator import lean_kernel
from game.physics.solids.joints.direct import solve_joints
from game.physics.solids.joints.geometric import steady_turns
from game.physics.solids.joints.lines import prepare_joints, start_joints_warm
from game.physics.solids.rows import VIOLENT, copy_rows, kinds_seen
from game.physics.solids.solvers.abreast import (
    put_back,
    sweep_batches,
    take_impulses,
    warm_batches,
)
from game.physics.solids.solvers.governor import note_going, start_going
from game.physics.solids.solvers.impacts import ALONE, resolve_impacts
from game.physics.solids.solvers.impulses import soft_springs
from game.physics.solids.solvers.motion import accelerate, move
from game.physics.solids.solvers.passive import (
    FREE,
    PUSHED,
    excuse,
    hold_energy,
    hold_push,
    note_speeds,
)


def _soft_step(joined: bool) -> Any:
    """The solver; without what joints need, where there are none: that is a quarter of its code."""

    @lean_kernel
    def solve_soft_step(bodies, contacts, rows, joints, scratch, numbers):
        """All substeps of one step. See the package."""
        motion, batches, springs = scratch.motion, scratch.batches, soft_springs(numbers)
        if joined:
            soft = (numbers.joint_rate, numbers.joint_mass, numbers.joint_give)
            prepare_joints(bodies, joints, soft, numbers)
        start_going(scratch.going)
        excuse(bodies, rows, joints, scratch)
        seen = kinds_seen(batches)
        # in piles at rest there is nothing to watch, and what settles there by overlap alone is let be
        violent = seen & VIOLENT != 0
        if violent:
            copy_rows(rows, batches)
        for _ in range(numbers.substeps):
            accelerate(scratch, numbers)
            if violent:
                if resolve_impacts(rows, scratch, numbers, ALONE):
                    take_impulses(rows, batches)
                note_speeds(motion, scratch.speeds, FREE)
            if joined:
                start_joints_warm(joints, motion)
                steady_turns(bodies, joints, scratch, numbers.h)
            warm_batches(batches, motion)
            for _ in range(numbers.iterations):
                if joined:
                    solve_joints(joints, scratch.plan, motion, True)
                sweep_batches(batches, motion, springs, True, violent)
            if violent:
                note_speeds(motion, scratch.speeds, PUSHED)
            move(motion, numbers.h)
            for _ in range(numbers.iterations):
                if joined:
                    solve_joints(joints, scratch.plan, motion, False)
                sweep_batches(batches, motion, springs, False, True)
            if violent:
                put_back(rows, batches)
                hold_energy(bodies, rows, scratch, numbers)
                take_impulses(rows, batches)
                hold_push(bodies, scratch, numbers)
            note_going(motion, scratch.going)

    return solve_soft_step


solve_soft_step = _soft_step(True)
solve_unjoined_soft_step = _soft_step(False)
