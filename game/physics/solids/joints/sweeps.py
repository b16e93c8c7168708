"""Joints by their kinds: made ready once a step, swept in each substep by solvers that sweep velocities.

A new kind: a file with ``warm_KIND`` and ``sweep_KIND`` on the layout of `layout.Joints`, a line in each
kernel here.
"""

from __future__ import annotations

from game.physics.kernels.lean import inner_kernel
from game.physics.solids.joints.distance import sweep_distance, warm_distance
from game.physics.solids.joints.layout import BROKEN, DISTANCE, MOUSE, NO_JOINT, PIN, SUBSTEP
from game.physics.solids.joints.mouse import prepare_mouse, sweep_mouse, warm_mouse
from game.physics.solids.joints.pin import sweep_pin, warm_pin
from game.physics.solids.joints.points import prepare_points
from game.physics.solids.state import ASLEEP, DYNAMIC


@inner_kernel
def prepare_joints(bodies, joints, soft, h):
    """Rows of all joints; what is broken or asleep is switched off."""
    for k in range(joints.kinds.shape[0]):
        joints.rows[k, SUBSTEP] = -1.0
        if joints.kinds[k] == NO_JOINT or joints.flags[k] & BROKEN:
            continue
        a, b = joints.bodies[k, 0], joints.bodies[k, 1]
        moves = (
            bodies.flags[a] & (DYNAMIC | ASLEEP) == DYNAMIC or bodies.flags[b] & (DYNAMIC | ASLEEP) == DYNAMIC
        )
        if not moves:
            continue
        prepare_points(bodies, joints, k, soft, h)
        if joints.kinds[k] == MOUSE:
            prepare_mouse(bodies, joints, k)
        joints.rows[k, SUBSTEP] = h


@inner_kernel
def start_joints_warm(joints, motion):
    """Impulses of the substep before."""
    for k in range(joints.kinds.shape[0]):
        if joints.rows[k, SUBSTEP] < 0.0:
            continue
        kind = joints.kinds[k]
        if kind == PIN:
            warm_pin(joints, k, motion)
        elif kind == DISTANCE:
            warm_distance(joints, k, motion)
        elif kind == MOUSE:
            warm_mouse(joints, k, motion)


@inner_kernel
def sweep_joints(joints, motion, pushing):
    """One sweep over all joints; pushing: also restore what has drifted."""
    for k in range(joints.kinds.shape[0]):
        if joints.rows[k, SUBSTEP] < 0.0:
            continue
        kind = joints.kinds[k]
        if kind == PIN:
            sweep_pin(joints, k, motion, pushing)
        elif kind == DISTANCE:
            sweep_distance(joints, k, motion, pushing)
        elif kind == MOUSE:
            sweep_mouse(joints, k, motion, joints.rows[k, SUBSTEP])
