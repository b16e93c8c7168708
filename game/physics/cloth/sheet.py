"""A cloth that hangs and is blown about, in space: position based dynamics in short substeps.

Threads keep their length, meshes their angles (softly), and folds are not flat (a link over four meshes that
only pushes). Each substep makes one sweep (Macklin and others 2019, "Small steps in physics simulation"),
with compliance as α / h² (XPBD; Macklin, Müller and Chentanez 2016). Threads are swept row against row, so
that no node comes twice in an inner loop. One sweep lets a long cloth stretch under its weight. To make up
for it no node is farther from a hook than along the cloth (Kim, Chentanez and Müller-Fischer 2012, "Long
range attachments").

Air drags by the part of its velocity that is normal to the cloth, and less along it.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.cloth import layout
from game.physics.cloth.effects import (
    ATTACHMENTS_BIT,
    FOLDS_BIT,
    GRAVITY_BIT,
    GROUND_BIT,
    LINKS_BIT,
    SHEAR_BIT,
)
from game.physics.kernels import elementary

TINY = 1e-12  # m
OVER = 4  # meshes that a link against folds reaches over
GRIP = 0.35  # of its velocity along the ground, and in depth, that a node keeps where it lies


class Motion(NamedTuple):
    """The numbers of a step."""

    mask: int
    substeps: int
    h: float  # s, of a substep
    gravity: float  # m/s²
    spacing: float  # m between threads
    shear: float  # α / h² of a mesh's diagonals, 1/kg
    folds: float  # α / h² of links over some meshes, 1/kg
    floor: float  # m
    calm: float  # 1/s at which a cloth loses velocity by its own friction


class Breeze(NamedTuple):
    """The air at a cloth: in its plane on a grid of gas, and across it as a wave that runs along."""

    lower_x: float  # m, the grid's corner
    lower_y: float
    cell: float  # m
    deep: float  # m/s across the plane, towards the viewer
    swell: float  # m/s, of a wave on it
    wave: float  # 1/m
    phase: float
    press: float  # kg/m², of air that a unit of normal velocity pushes: half density times coefficient
    brush: float  # the same along the cloth


@inner_kernel
def _pull_row(nodes, above, below, shift, hold, goal):
    """Links from node i of a row to node i + shift of another, none twice; goal: rest m, α / h² 1/kg."""
    rest, soft = goal
    count = hold.shape[0]
    first, second = max(-shift, 0), max(shift, 0)
    xa, ya, za = (
        nodes[layout.X, above, first:],
        nodes[layout.Y, above, first:],
        nodes[layout.Z, above, first:],
    )
    xb, yb, zb = (
        nodes[layout.X, below, second:],
        nodes[layout.Y, below, second:],
        nodes[layout.Z, below, second:],
    )
    wa, wb = nodes[layout.INVERSE, above, first:], nodes[layout.INVERSE, below, second:]
    for i in range(count):
        dx, dy, dz = xb[i] - xa[i], yb[i] - ya[i], zb[i] - za[i]
        length = math.sqrt(dx * dx + dy * dy + dz * dz) + TINY
        pull = hold[i] * (1.0 - rest / length) / (wa[i] + wb[i] + soft + TINY)
        xa[i] += wa[i] * pull * dx
        ya[i] += wa[i] * pull * dy
        za[i] += wa[i] * pull * dz
        xb[i] -= wb[i] * pull * dx
        yb[i] -= wb[i] * pull * dy
        zb[i] -= wb[i] * pull * dz


@inner_kernel
def _pull(nodes, ja, ia, jb, ib, goal, pushes):
    """One link; with ``pushes`` it only resists being shorter."""
    rest, soft = goal
    wa, wb = nodes[layout.INVERSE, ja, ia], nodes[layout.INVERSE, jb, ib]
    dx, dy = (
        nodes[layout.X, jb, ib] - nodes[layout.X, ja, ia],
        nodes[layout.Y, jb, ib] - nodes[layout.Y, ja, ia],
    )
    dz = nodes[layout.Z, jb, ib] - nodes[layout.Z, ja, ia]
    length = math.sqrt(dx * dx + dy * dy + dz * dz) + TINY
    pull = (1.0 - rest / length) / (wa + wb + soft + TINY)
    if pushes and pull > 0.0:
        return
    nodes[layout.X, ja, ia] += wa * pull * dx
    nodes[layout.Y, ja, ia] += wa * pull * dy
    nodes[layout.Z, ja, ia] += wa * pull * dz
    nodes[layout.X, jb, ib] -= wb * pull * dx
    nodes[layout.Y, jb, ib] -= wb * pull * dy
    nodes[layout.Z, jb, ib] -= wb * pull * dz


@inner_kernel
def _sweep(nodes, ties, motion):
    """All links once, from the upper edge down."""
    rows, columns = nodes.shape[1], nodes.shape[2]
    thread = (motion.spacing, 0.0)
    for j in range(rows):
        if motion.mask & LINKS_BIT:
            for parity in range(2):
                for i in range(parity, columns - 1, 2):
                    if ties.across[j, i] > 0.0:
                        _pull(nodes, j, i, j, i + 1, thread, False)
            if j + 1 < rows:
                _pull_row(nodes, j, j + 1, 0, ties.along[j], thread)
        if motion.mask & SHEAR_BIT and j + 1 < rows:
            diagonal = (motion.spacing * math.sqrt(2.0), motion.shear)
            _pull_row(nodes, j, j + 1, 1, ties.whole[j], diagonal)
            _pull_row(nodes, j, j + 1, -1, ties.whole[j], diagonal)
        if motion.mask & FOLDS_BIT:
            fold = (OVER * motion.spacing, motion.folds)
            unbroken = 0
            for i in range(columns - 1):
                unbroken = unbroken + 1 if ties.across[j, i] > 0.0 else 0
                if unbroken >= OVER:
                    _pull(nodes, j, i + 1 - OVER, j, i + 1, fold, True)
            if j + OVER < rows:
                for i in range(columns):
                    hold = ties.along[j, i] * ties.along[j + 1, i]
                    if hold * ties.along[j + 2, i] * ties.along[j + 3, i] > 0.0:
                        _pull(nodes, j, i, j + OVER, i, fold, True)


@inner_kernel
def _hold_back(nodes, reach):
    """No node farther from a hook, which is an upper corner, than along the cloth."""
    last = nodes.shape[2] - 1
    for k in range(2):
        column = last * k
        hx, hy, hz = nodes[layout.X, 0, column], nodes[layout.Y, 0, column], nodes[layout.Z, 0, column]
        for j in range(nodes.shape[1]):
            for i in range(nodes.shape[2]):
                dx, dy, dz = (
                    nodes[layout.X, j, i] - hx,
                    nodes[layout.Y, j, i] - hy,
                    nodes[layout.Z, j, i] - hz,
                )
                square, most = dx * dx + dy * dy + dz * dz, reach[k, j, i]
                if square > most * most and nodes[layout.INVERSE, j, i] > 0.0:
                    part = most / math.sqrt(square)
                    nodes[layout.X, j, i] = hx + part * dx
                    nodes[layout.Y, j, i] = hy + part * dy
                    nodes[layout.Z, j, i] = hz + part * dz


@lean_kernel
def move_sheet(nodes, ties, motion, held, target):
    """All substeps of a step. held (2,): row and column of the node in the hand, or below 0; target (3,) m:
    where it is to be at the end.
    """
    h = motion.h
    fall = motion.gravity if motion.mask & GRAVITY_BIT else 0.0
    keep = 1.0 / (1.0 + motion.calm * h)
    for turn in range(motion.substeps):
        for j in range(nodes.shape[1]):
            for i in range(nodes.shape[2]):
                for axis in range(3):
                    nodes[layout.WAS_X + axis, j, i] = nodes[layout.X + axis, j, i]
                if nodes[layout.INVERSE, j, i] > 0.0:
                    nodes[layout.VY, j, i] -= h * fall
                    nodes[layout.X, j, i] += h * keep * nodes[layout.VX, j, i]
                    nodes[layout.Y, j, i] += h * keep * nodes[layout.VY, j, i]
                    nodes[layout.Z, j, i] += h * keep * nodes[layout.VZ, j, i]
        if held[0] >= 0:
            for axis in range(3):
                here = nodes[layout.X + axis, held[0], held[1]]
                nodes[layout.X + axis, held[0], held[1]] = here + (target[axis] - here) / (
                    motion.substeps - turn
                )
        _sweep(nodes, ties, motion)
        if motion.mask & ATTACHMENTS_BIT:
            _hold_back(nodes, ties.reach)
        for j in range(nodes.shape[1]):
            for i in range(nodes.shape[2]):
                low = motion.mask & GROUND_BIT and nodes[layout.Y, j, i] < motion.floor
                if low and nodes[layout.INVERSE, j, i] > 0.0:
                    nodes[layout.Y, j, i] = motion.floor
                    nodes[layout.X, j, i] -= (1.0 - GRIP) * (
                        nodes[layout.X, j, i] - nodes[layout.WAS_X, j, i]
                    )
                    nodes[layout.Z, j, i] -= (1.0 - GRIP) * (
                        nodes[layout.Z, j, i] - nodes[layout.WAS_Z, j, i]
                    )
                nodes[layout.VX, j, i] = (nodes[layout.X, j, i] - nodes[layout.WAS_X, j, i]) / h
                nodes[layout.VY, j, i] = (nodes[layout.Y, j, i] - nodes[layout.WAS_Y, j, i]) / h
                nodes[layout.VZ, j, i] = (nodes[layout.Z, j, i] - nodes[layout.WAS_Z, j, i]) / h


@inner_kernel
def normal_at(nodes, j, i):
    """Unit normal of the cloth at a node, from the neighbours that are there; (0, 0, 1) where it has none."""
    rows, columns = nodes.shape[1], nodes.shape[2]
    left, right, up, down = max(i - 1, 0), min(i + 1, columns - 1), max(j - 1, 0), min(j + 1, rows - 1)
    left = left if nodes[layout.THERE, j, left] > 0.0 else i
    right = right if nodes[layout.THERE, j, right] > 0.0 else i
    up = up if nodes[layout.THERE, up, i] > 0.0 else j
    down = down if nodes[layout.THERE, down, i] > 0.0 else j
    ax, ay = (
        nodes[layout.X, j, right] - nodes[layout.X, j, left],
        nodes[layout.Y, j, right] - nodes[layout.Y, j, left],
    )
    az = nodes[layout.Z, j, right] - nodes[layout.Z, j, left]
    bx, by = (
        nodes[layout.X, up, i] - nodes[layout.X, down, i],
        nodes[layout.Y, up, i] - nodes[layout.Y, down, i],
    )
    bz = nodes[layout.Z, up, i] - nodes[layout.Z, down, i]
    x, y, z = ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx
    length = math.sqrt(x * x + y * y + z * z)
    if length < TINY:
        return 0.0, 0.0, 1.0
    return x / length, y / length, z / length


@lean_kernel
def blow_on(nodes, u, v, breeze, area, dt):
    """The air pushes each node for dt (s); u (gy, gx + 1), v (gy + 1, gx) m/s on faces; area m² of a node.

    The change of velocity is that of a step of backward Euler with the drag of its beginning. So however
    light a node is, it does not overtake the air.
    """
    gy, gx = u.shape[0], v.shape[1]
    for j in range(nodes.shape[1]):
        for i in range(nodes.shape[2]):
            light = nodes[layout.INVERSE, j, i]
            if light <= 0.0:
                continue
            column = min(max(int((nodes[layout.X, j, i] - breeze.lower_x) / breeze.cell), 0), gx - 1)
            row = min(max(int((nodes[layout.Y, j, i] - breeze.lower_y) / breeze.cell), 0), gy - 1)
            wave = elementary.sin(
                breeze.wave * (nodes[layout.X, j, i] + 0.6 * nodes[layout.Y, j, i]) - breeze.phase
            )
            ax = 0.5 * (u[row, column] + u[row, column + 1]) - nodes[layout.VX, j, i]
            ay = 0.5 * (v[row, column] + v[row + 1, column]) - nodes[layout.VY, j, i]
            az = breeze.deep + breeze.swell * wave - nodes[layout.VZ, j, i]
            nx, ny, nz = normal_at(nodes, j, i)
            through = ax * nx + ay * ny + az * nz
            tx, ty, tz = ax - through * nx, ay - through * ny, az - through * nz
            slip = math.sqrt(tx * tx + ty * ty + tz * tz)
            strong = breeze.press * area * light * abs(through) * dt
            weak = breeze.brush * area * light * slip * dt
            normal, along = strong / (1.0 + strong) * through, weak / (1.0 + weak)
            nodes[layout.VX, j, i] += normal * nx + along * tx
            nodes[layout.VY, j, i] += normal * ny + along * ty
            nodes[layout.VZ, j, i] += normal * nz + along * tz
