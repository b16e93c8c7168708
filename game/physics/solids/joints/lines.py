"""Joints by their kinds, as lines: made ready once a step, written anew wherever bodies have moved.

A new kind: a file with ``write_KIND`` on the layout of `layout.Joints`, a line here. All solvers take it
then.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.solids.effects import JOINTS_BIT
from game.physics.solids.joints.distance import write_distance
from game.physics.solids.joints.layout import (
    BROKEN,
    DISTANCE,
    IMPULSES,
    JIIA,
    JIIB,
    JIMA,
    JIMB,
    LA,
    LB,
    LINE,
    LINE_WIDTH,
    MOTOR,
    MOUSE,
    NO_JOINT,
    OFF,
    PIN,
    ROPE,
    SLIDER,
    SPRING,
    SUBSTEP,
    UX,
    UY,
    WELD,
    WITH_A,
)
from game.physics.solids.joints.motor import write_motor
from game.physics.solids.joints.mouse import prepare_mouse, write_mouse
from game.physics.solids.joints.pin import write_pin
from game.physics.solids.joints.points import clear_lines, prepare_points
from game.physics.solids.joints.rope import write_rope
from game.physics.solids.joints.slider import prepare_slider, write_slider
from game.physics.solids.joints.spring import write_spring
from game.physics.solids.joints.weld import write_weld
from game.physics.solids.state import ASLEEP, DYNAMIC, VX, VY, W


@inner_kernel
def prepare_joints(bodies, joints, soft, numbers):
    """Rows of all joints; what is broken or asleep, or all of them by the effect, is switched off."""
    for k in range(joints.kinds.shape[0]):
        joints.rows[k, SUBSTEP] = -1.0
        clear_lines(joints, k)
        if joints.kinds[k] == NO_JOINT or joints.flags[k] & BROKEN or not numbers.mask & JOINTS_BIT:
            continue
        a, b = joints.bodies[k, 0], joints.bodies[k, 1]
        awake_a = bodies.flags[a] & (DYNAMIC | ASLEEP) == DYNAMIC
        awake_b = bodies.flags[b] & (DYNAMIC | ASLEEP) == DYNAMIC
        if not (awake_a or awake_b):
            continue
        prepare_points(bodies, joints, k, soft, numbers.h)
        if joints.kinds[k] == MOUSE:
            prepare_mouse(bodies, joints, k)
        elif joints.kinds[k] == SLIDER:
            prepare_slider(bodies, joints, k)
        joints.rows[k, SUBSTEP] = numbers.h


@inner_kernel
def write_lines(joints, k, motion):
    """The lines of one joint, as its bodies stand now."""
    kind = joints.kinds[k]
    if kind == PIN:
        write_pin(joints, k, motion)
    elif kind == DISTANCE:
        write_distance(joints, k, motion)
    elif kind == MOUSE:
        write_mouse(joints, k, motion)
    elif kind == SLIDER:
        write_slider(joints, k, motion)
    elif kind == WELD:
        write_weld(joints, k, motion)
    elif kind == ROPE:
        write_rope(joints, k, motion)
    elif kind == SPRING:
        write_spring(joints, k, motion)
    elif kind == MOTOR:
        write_motor(joints, k, motion)


@inner_kernel
def write_all_lines(joints, motion):
    """Lines of all joints that are switched on."""
    for k in range(joints.kinds.shape[0]):
        if joints.rows[k, SUBSTEP] > 0.0:
            write_lines(joints, k, motion)


@inner_kernel
def line_speed(joints, k, at, motion):
    """Speed of the line at column ``at`` of joint k, m/s or rad/s."""
    a, b = joints.bodies[k, 0], joints.bodies[k, 1]
    line = joints.lines
    speed = (
        line[k, at + UX] * motion[b, VX] + line[k, at + UY] * motion[b, VY] + line[k, at + LB] * motion[b, W]
    )
    held = (
        line[k, at + UX] * motion[a, VX] + line[k, at + UY] * motion[a, VY] + line[k, at + LA] * motion[a, W]
    )
    return speed - joints.rows[k, WITH_A] * held


@inner_kernel
def push_line(joints, k, at, motion, j):
    """An impulse j (N s or N m s) along a line."""
    a, b = joints.bodies[k, 0], joints.bodies[k, 1]
    row, line = joints.rows, joints.lines
    x, y = j * line[k, at + UX], j * line[k, at + UY]
    motion[a, VX] -= row[k, JIMA] * x
    motion[a, VY] -= row[k, JIMA] * y
    motion[a, W] -= row[k, JIIA] * line[k, at + LA] * j
    motion[b, VX] += row[k, JIMB] * x
    motion[b, VY] += row[k, JIMB] * y
    motion[b, W] += row[k, JIIB] * line[k, at + LB] * j


@inner_kernel
def start_joints_warm(joints, motion):
    """Impulses of the substep before."""
    for k in range(joints.kinds.shape[0]):
        if joints.rows[k, SUBSTEP] < 0.0:
            continue
        write_lines(joints, k, motion)
        for slot in range(IMPULSES):
            if joints.lines[k, slot * LINE_WIDTH + LINE] == OFF:
                joints.impulses[k, slot] = 0.0
            elif joints.impulses[k, slot] != 0.0:
                push_line(joints, k, slot * LINE_WIDTH, motion, joints.impulses[k, slot])


@inner_kernel
def joint_load(joints, k):
    """Impulse (N s) and turning impulse (N m s) that a joint carried in the last substep: their sizes."""
    x, y, turn = 0.0, 0.0, 0.0
    for slot in range(IMPULSES):
        at, j = slot * LINE_WIDTH, joints.impulses[k, slot]
        if joints.lines[k, at + LINE] == OFF:
            continue
        x += j * joints.lines[k, at + UX]
        y += j * joints.lines[k, at + UY]
        if joints.lines[k, at + UX] == 0.0 and joints.lines[k, at + UY] == 0.0:
            turn += j
    return math.sqrt(x * x + y * y), abs(turn)


@lean_kernel
def load_of(joints, k):
    """`joint_load`, for calls from Python."""
    return joint_load(joints, k)
