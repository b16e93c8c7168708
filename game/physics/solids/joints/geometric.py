"""Geometric stiffness: what a joint's force does as its lever turns, where a substep is too long for it.

A force f at a lever r turns back a body that turns, by r . f for each radian. A light link under a heavy
load swings faster across its chain than substeps can follow (turns grow where h² r . f > 4 I), and the
chain would tear itself apart. There, and only there, the body's inertia is raised to h² r . f, implicitly,
so that it swings as fast as can be followed (Andrews, Teichmann, Kry 2017, "Geometric stiffness for
real-time constrained multibody dynamics"). This takes energy from such swings, and never gives any.
"""

from __future__ import annotations

from game.compiler.decorator import inner_kernel
from game.physics.solids.arrays import layout
from game.physics.solids.arrays.state import W
from game.physics.solids.joints.points import levers_now


@inner_kernel
def gather_stiffness(joints, motion, stiffness, h):
    """h² r . f of all bodies (n,), kg m², from the impulses of the substep before."""
    for i in range(stiffness.shape[0]):
        stiffness[i] = 0.0
    for k in range(joints.kinds.shape[0]):
        if joints.rows[k, layout.SUBSTEP] < 0.0 or joints.kinds[k] == layout.MOUSE:
            continue
        a, b = joints.bodies[k, 0], joints.bodies[k, 1]
        x, y = 0.0, 0.0
        for slot in range(layout.IMPULSES):
            at, j = slot * layout.LINE_WIDTH, joints.impulses[k, slot]
            if joints.lines[k, at + layout.LINE] != layout.OFF:
                x, y = x + j * joints.lines[k, at + layout.UX], y + j * joints.lines[k, at + layout.UY]
        levers = levers_now(joints.rows, k, motion, a, b)
        stiffness[a] -= h * (levers[0] * x + levers[1] * y)
        stiffness[b] += h * (levers[2] * x + levers[3] * y)


@inner_kernel
def steady_turns(bodies, joints, scratch, h):
    """Raise inertias where they must be; called once a substep, after joints were started warm."""
    motion, stiffness = scratch.motion, scratch.stiffness
    gather_stiffness(joints, motion, stiffness, h)
    for i in range(stiffness.shape[0]):
        ii, raised = bodies.inverse_inertias[i], stiffness[i]
        if raised * ii > 1.0:
            motion[i, W] /= raised * ii
            stiffness[i] = 1.0 / raised
        else:
            stiffness[i] = ii
    for k in range(joints.kinds.shape[0]):
        if joints.rows[k, layout.SUBSTEP] > 0.0:
            joints.rows[k, layout.JIIB] = stiffness[joints.bodies[k, 1]]
            if joints.kinds[k] != layout.MOUSE:
                joints.rows[k, layout.JIIA] = stiffness[joints.bodies[k, 0]]
