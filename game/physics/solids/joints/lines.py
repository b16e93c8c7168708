"""Joints by their kinds, as lines: made ready once a step, written anew wherever bodies have moved.

A new kind: a file with ``write_KIND`` on the layout of `layout.Joints`, a line here. All solvers take it
then.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.solids.arrays import layout, state
from game.physics.solids.effects import JOINTS_BIT
from game.physics.solids.joints.distance import write_distance
from game.physics.solids.joints.motor import write_motor
from game.physics.solids.joints.mouse import prepare_mouse, write_mouse
from game.physics.solids.joints.pin import write_pin
from game.physics.solids.joints.points import clear_lines, prepare_points
from game.physics.solids.joints.rope import write_rope
from game.physics.solids.joints.slider import prepare_slider, write_slider
from game.physics.solids.joints.spring import write_spring
from game.physics.solids.joints.weld import write_weld


@inner_kernel
def prepare_joints(bodies, joints, soft, numbers):
    """Rows of all joints; what is broken or asleep, or all of them by the effect, is switched off."""
    for k in range(joints.kinds.shape[0]):
        joints.rows[k, layout.SUBSTEP] = -1.0
        clear_lines(joints, k)
        if (
            joints.kinds[k] == layout.NO_JOINT
            or joints.flags[k] & layout.BROKEN
            or not numbers.mask & JOINTS_BIT
        ):
            continue
        a, b = joints.bodies[k, 0], joints.bodies[k, 1]
        awake_a = bodies.flags[a] & (state.DYNAMIC | state.ASLEEP) == state.DYNAMIC
        awake_b = bodies.flags[b] & (state.DYNAMIC | state.ASLEEP) == state.DYNAMIC
        if not (awake_a or awake_b):
            continue
        prepare_points(bodies, joints, k, soft, numbers.h)
        if joints.kinds[k] == layout.MOUSE:
            prepare_mouse(bodies, joints, k)
        elif joints.kinds[k] == layout.SLIDER:
            prepare_slider(bodies, joints, k)
        joints.rows[k, layout.SUBSTEP] = numbers.h


@inner_kernel
def write_lines(joints, k, motion):
    """The lines of one joint, as its bodies stand now."""
    kind = joints.kinds[k]
    if kind == layout.PIN:
        write_pin(joints, k, motion)
    elif kind == layout.DISTANCE:
        write_distance(joints, k, motion)
    elif kind == layout.MOUSE:
        write_mouse(joints, k, motion)
    elif kind == layout.SLIDER:
        write_slider(joints, k, motion)
    elif kind == layout.WELD:
        write_weld(joints, k, motion)
    elif kind == layout.ROPE:
        write_rope(joints, k, motion)
    elif kind == layout.SPRING:
        write_spring(joints, k, motion)
    elif kind == layout.MOTOR:
        write_motor(joints, k, motion)


@inner_kernel
def write_all_lines(joints, motion):
    """Lines of all joints that are switched on."""
    for k in range(joints.kinds.shape[0]):
        if joints.rows[k, layout.SUBSTEP] > 0.0:
            write_lines(joints, k, motion)


@inner_kernel
def line_speed(joints, k, at, motion):
    """Speed of the line at column ``at`` of joint k, m/s or rad/s."""
    a, b = joints.bodies[k, 0], joints.bodies[k, 1]
    line = joints.lines
    speed = (
        line[k, at + layout.UX] * motion[b, state.VX]
        + line[k, at + layout.UY] * motion[b, state.VY]
        + line[k, at + layout.LB] * motion[b, state.W]
    )
    held = (
        line[k, at + layout.UX] * motion[a, state.VX]
        + line[k, at + layout.UY] * motion[a, state.VY]
        + line[k, at + layout.LA] * motion[a, state.W]
    )
    return speed - joints.rows[k, layout.WITH_A] * held


@inner_kernel
def push_line(joints, k, at, motion, j):
    """An impulse j (N s or N m s) along a line."""
    a, b = joints.bodies[k, 0], joints.bodies[k, 1]
    row, line = joints.rows, joints.lines
    x, y = j * line[k, at + layout.UX], j * line[k, at + layout.UY]
    motion[a, state.VX] -= row[k, layout.JIMA] * x
    motion[a, state.VY] -= row[k, layout.JIMA] * y
    motion[a, state.W] -= row[k, layout.JIIA] * line[k, at + layout.LA] * j
    motion[b, state.VX] += row[k, layout.JIMB] * x
    motion[b, state.VY] += row[k, layout.JIMB] * y
    motion[b, state.W] += row[k, layout.JIIB] * line[k, at + layout.LB] * j


@inner_kernel
def start_joints_warm(joints, motion):
    """Impulses of the substep before."""
    for k in range(joints.kinds.shape[0]):
        if joints.rows[k, layout.SUBSTEP] < 0.0:
            continue
        write_lines(joints, k, motion)
        for slot in range(layout.IMPULSES):
            if joints.lines[k, slot * layout.LINE_WIDTH + layout.LINE] == layout.OFF:
                joints.impulses[k, slot] = 0.0
            elif joints.impulses[k, slot] != 0.0:
                push_line(joints, k, slot * layout.LINE_WIDTH, motion, joints.impulses[k, slot])


@inner_kernel
def joint_load(joints, k, resting=False):
    """Impulse (N s) and turning impulse (N m s) that a joint carried in the last substep: their sizes.

    resting: its bodies sleep, so that its lines are off. What held them when they fell asleep holds them.
    """
    x, y, turn = 0.0, 0.0, 0.0
    for slot in range(layout.IMPULSES):
        at, j = slot * layout.LINE_WIDTH, joints.impulses[k, slot]
        if j == 0.0 or (joints.lines[k, at + layout.LINE] == layout.OFF and not resting):
            continue
        x += j * joints.lines[k, at + layout.UX]
        y += j * joints.lines[k, at + layout.UY]
        if joints.lines[k, at + layout.UX] == 0.0 and joints.lines[k, at + layout.UY] == 0.0:
            turn += j
    return math.sqrt(x * x + y * y), abs(turn)


@lean_kernel
def load_of(joints, k, resting):
    """`joint_load`, for calls from Python."""
    return joint_load(joints, k, resting)
