"""What kinds of joints share: where their two points are now, and lines at them."""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel
from game.physics.solids.arrays import layout, state


@inner_kernel
def prepare_points(bodies, joints, k, soft, h):
    """Levers, masses and spring of one joint. soft: rate, mass, give of joints without a compliance."""
    a, b = joints.bodies[k, 0], joints.bodies[k, 1]
    row, anchors = joints.rows, joints.anchors
    ca, sa = bodies.rotations[a, 0], bodies.rotations[a, 1]
    cb, sb = bodies.rotations[b, 0], bodies.rotations[b, 1]
    row[k, layout.JAX] = ca * anchors[k, 0] - sa * anchors[k, 1]
    row[k, layout.JAY] = sa * anchors[k, 0] + ca * anchors[k, 1]
    row[k, layout.JBX] = cb * anchors[k, 2] - sb * anchors[k, 3]
    row[k, layout.JBY] = sb * anchors[k, 2] + cb * anchors[k, 3]
    row[k, layout.OFFSET_X] = bodies.positions[b, 0] - bodies.positions[a, 0]
    row[k, layout.OFFSET_Y] = bodies.positions[b, 1] - bodies.positions[a, 1]
    row[k, layout.TURNED] = bodies.angles[b] - bodies.angles[a] - joints.parameters[k, layout.ANGLE]
    row[k, layout.JIMA], row[k, layout.JIIA] = bodies.inverse_masses[a], bodies.inverse_inertias[a]
    row[k, layout.JIMB], row[k, layout.JIIB] = bodies.inverse_masses[b], bodies.inverse_inertias[b]
    row[k, layout.RATE], row[k, layout.MASS], row[k, layout.GIVE] = soft
    row[k, layout.OWN], row[k, layout.WITH_A] = 0.0, 1.0
    if joints.parameters[k, layout.HERTZ] > 0.0:
        omega = 2.0 * math.pi * joints.parameters[k, layout.HERTZ]
        a1 = 2.0 * joints.parameters[k, layout.DAMPING] + h * omega
        a2 = h * omega * a1
        row[k, layout.RATE], row[k, layout.MASS], row[k, layout.GIVE] = (
            omega / a1,
            a2 / (1.0 + a2),
            1.0 / (1.0 + a2),
        )
        row[k, layout.OWN] = 1.0


@inner_kernel
def levers_now(row, k, motion, a, b):
    """Both levers as they have turned by now: rax, ray, rbx, rby."""
    ca, sa, cb, sb = motion[a, state.DC], motion[a, state.DS], motion[b, state.DC], motion[b, state.DS]
    ax, ay, bx, by = row[k, layout.JAX], row[k, layout.JAY], row[k, layout.JBX], row[k, layout.JBY]
    return ca * ax - sa * ay, sa * ax + ca * ay, cb * bx - sb * by, sb * bx + cb * by


@inner_kernel
def apart_now(row, k, motion, a, b, levers):
    """From a's point to b's, m."""
    x = row[k, layout.OFFSET_X] + motion[b, state.DX] - motion[a, state.DX] + levers[2] - levers[0]
    y = row[k, layout.OFFSET_Y] + motion[b, state.DY] - motion[a, state.DY] + levers[3] - levers[1]
    return x, y


@inner_kernel
def turned_now(row, k, motion, a, b):
    """How far b has turned against a from rest, rad."""
    return row[k, layout.TURNED] + motion[b, state.DA] - motion[a, state.DA]


@inner_kernel
def direction(x, y):
    """Length and unit vector of (x, y); along x where it has no length."""
    length = math.sqrt(x * x + y * y)
    if length > 1e-12:
        return length, x / length, y / length
    return length, 1.0, 0.0


@inner_kernel
def clear_lines(joints, k):
    """No line of a joint is in use."""
    for slot in range(layout.IMPULSES):
        joints.lines[k, slot * layout.LINE_WIDTH + layout.LINE] = layout.OFF


@inner_kernel
def write_line(joints, k, slot, kind, u, torques, gap):
    """One line: its direction u, torques for each newton on a and b, its gap."""
    at = slot * layout.LINE_WIDTH
    line = joints.lines
    line[k, at + layout.LINE] = kind
    line[k, at + layout.UX], line[k, at + layout.UY] = u
    line[k, at + layout.LA], line[k, at + layout.LB] = torques
    line[k, at + layout.LINE_GAP] = gap


@inner_kernel
def write_point_lines(joints, k, levers, x, y):
    """Two points are one: lines along x and y."""
    write_line(joints, k, layout.PULL_X, layout.EQUAL, (1.0, 0.0), (-levers[1], -levers[3]), x)
    write_line(joints, k, layout.PULL_Y, layout.EQUAL, (0.0, 1.0), (levers[0], levers[2]), y)


@inner_kernel
def write_turn_line(joints, k, motion):
    """Both bodies keep the angle between them."""
    turned = turned_now(joints.rows, k, motion, joints.bodies[k, 0], joints.bodies[k, 1])
    write_line(joints, k, layout.TURN, layout.EQUAL, (0.0, 0.0), (1.0, 1.0), turned)


@inner_kernel
def write_range_lines(joints, k, u, torques, place):
    """Limits and drive of a joint whose place (m or rad) along u is this."""
    if joints.flags[k] & layout.LIMITED:
        low, high = place - joints.parameters[k, layout.LOWER], joints.parameters[k, layout.UPPER] - place
        write_line(joints, k, layout.LOW, layout.ONE_SIDED, u, torques, low)
        write_line(joints, k, layout.HIGH, layout.ONE_SIDED, (-u[0], -u[1]), (-torques[0], -torques[1]), high)
    if joints.flags[k] & layout.DRIVEN:
        write_line(joints, k, layout.DRIVE, layout.DRIVING, u, torques, 0.0)


@inner_kernel
def line_weight(joints, k, at):
    """Inverse effective mass of the line at column ``at``, 1/kg (or 1/(kg m²))."""
    row, line = joints.rows, joints.lines
    square = (
        line[k, at + layout.UX] * line[k, at + layout.UX] + line[k, at + layout.UY] * line[k, at + layout.UY]
    )
    weight = square * (row[k, layout.JIMA] + row[k, layout.JIMB])
    return (
        weight
        + row[k, layout.JIIA] * (line[k, at + layout.LA] * line[k, at + layout.LA])
        + row[k, layout.JIIB] * (line[k, at + layout.LB] * line[k, at + layout.LB])
    )
