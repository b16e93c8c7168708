"""What kinds of joints share: where their two points are now, and lines at them."""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel
from game.physics.solids.joints.layout import (
    ANGLE,
    DAMPING,
    DRIVE,
    DRIVEN,
    DRIVING,
    EQUAL,
    GIVE,
    HERTZ,
    HIGH,
    IMPULSES,
    JAX,
    JAY,
    JBX,
    JBY,
    JIIA,
    JIIB,
    JIMA,
    JIMB,
    LA,
    LB,
    LIMITED,
    LINE,
    LINE_GAP,
    LINE_WIDTH,
    LOW,
    LOWER,
    MASS,
    OFF,
    OFFSET_X,
    OFFSET_Y,
    ONE_SIDED,
    OWN,
    PULL_X,
    PULL_Y,
    RATE,
    TURN,
    TURNED,
    UPPER,
    UX,
    UY,
    WITH_A,
)
from game.physics.solids.state import DA, DC, DS, DX, DY


@inner_kernel
def prepare_points(bodies, joints, k, soft, h):
    """Levers, masses and spring of one joint. soft: rate, mass, give of joints without a compliance."""
    a, b = joints.bodies[k, 0], joints.bodies[k, 1]
    row, anchors = joints.rows, joints.anchors
    ca, sa = bodies.rotations[a, 0], bodies.rotations[a, 1]
    cb, sb = bodies.rotations[b, 0], bodies.rotations[b, 1]
    row[k, JAX] = ca * anchors[k, 0] - sa * anchors[k, 1]
    row[k, JAY] = sa * anchors[k, 0] + ca * anchors[k, 1]
    row[k, JBX] = cb * anchors[k, 2] - sb * anchors[k, 3]
    row[k, JBY] = sb * anchors[k, 2] + cb * anchors[k, 3]
    row[k, OFFSET_X] = bodies.positions[b, 0] - bodies.positions[a, 0]
    row[k, OFFSET_Y] = bodies.positions[b, 1] - bodies.positions[a, 1]
    row[k, TURNED] = bodies.angles[b] - bodies.angles[a] - joints.parameters[k, ANGLE]
    row[k, JIMA], row[k, JIIA] = bodies.inverse_masses[a], bodies.inverse_inertias[a]
    row[k, JIMB], row[k, JIIB] = bodies.inverse_masses[b], bodies.inverse_inertias[b]
    row[k, RATE], row[k, MASS], row[k, GIVE] = soft
    row[k, OWN], row[k, WITH_A] = 0.0, 1.0
    if joints.parameters[k, HERTZ] > 0.0:
        omega = 2.0 * math.pi * joints.parameters[k, HERTZ]
        a1 = 2.0 * joints.parameters[k, DAMPING] + h * omega
        a2 = h * omega * a1
        row[k, RATE], row[k, MASS], row[k, GIVE] = omega / a1, a2 / (1.0 + a2), 1.0 / (1.0 + a2)
        row[k, OWN] = 1.0


@inner_kernel
def levers_now(row, k, motion, a, b):
    """Both levers as they have turned by now: rax, ray, rbx, rby."""
    ca, sa, cb, sb = motion[a, DC], motion[a, DS], motion[b, DC], motion[b, DS]
    ax, ay, bx, by = row[k, JAX], row[k, JAY], row[k, JBX], row[k, JBY]
    return ca * ax - sa * ay, sa * ax + ca * ay, cb * bx - sb * by, sb * bx + cb * by


@inner_kernel
def apart_now(row, k, motion, a, b, levers):
    """From a's point to b's, m."""
    x = row[k, OFFSET_X] + motion[b, DX] - motion[a, DX] + levers[2] - levers[0]
    y = row[k, OFFSET_Y] + motion[b, DY] - motion[a, DY] + levers[3] - levers[1]
    return x, y


@inner_kernel
def turned_now(row, k, motion, a, b):
    """How far b has turned against a from rest, rad."""
    return row[k, TURNED] + motion[b, DA] - motion[a, DA]


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
    for slot in range(IMPULSES):
        joints.lines[k, slot * LINE_WIDTH + LINE] = OFF


@inner_kernel
def write_line(joints, k, slot, kind, u, torques, gap):
    """One line: its direction u, torques for each newton on a and b, its gap."""
    at = slot * LINE_WIDTH
    line = joints.lines
    line[k, at + LINE] = kind
    line[k, at + UX], line[k, at + UY] = u
    line[k, at + LA], line[k, at + LB] = torques
    line[k, at + LINE_GAP] = gap


@inner_kernel
def write_point_lines(joints, k, levers, x, y):
    """Two points are one: lines along x and y."""
    write_line(joints, k, PULL_X, EQUAL, (1.0, 0.0), (-levers[1], -levers[3]), x)
    write_line(joints, k, PULL_Y, EQUAL, (0.0, 1.0), (levers[0], levers[2]), y)


@inner_kernel
def write_turn_line(joints, k, motion):
    """Both bodies keep the angle between them."""
    turned = turned_now(joints.rows, k, motion, joints.bodies[k, 0], joints.bodies[k, 1])
    write_line(joints, k, TURN, EQUAL, (0.0, 0.0), (1.0, 1.0), turned)


@inner_kernel
def write_range_lines(joints, k, u, torques, place):
    """Limits and drive of a joint whose place (m or rad) along u is this."""
    if joints.flags[k] & LIMITED:
        low, high = place - joints.parameters[k, LOWER], joints.parameters[k, UPPER] - place
        write_line(joints, k, LOW, ONE_SIDED, u, torques, low)
        write_line(joints, k, HIGH, ONE_SIDED, (-u[0], -u[1]), (-torques[0], -torques[1]), high)
    if joints.flags[k] & DRIVEN:
        write_line(joints, k, DRIVE, DRIVING, u, torques, 0.0)


@inner_kernel
def line_weight(joints, k, at):
    """Inverse effective mass of the line at column ``at``, 1/kg (or 1/(kg m²))."""
    row, line = joints.rows, joints.lines
    square = line[k, at + UX] * line[k, at + UX] + line[k, at + UY] * line[k, at + UY]
    weight = square * (row[k, JIMA] + row[k, JIMB])
    return (
        weight
        + row[k, JIIA] * (line[k, at + LA] * line[k, at + LA])
        + row[k, JIIB] * (line[k, at + LB] * line[k, at + LB])
    )
