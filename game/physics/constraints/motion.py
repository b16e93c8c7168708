"""One step of position based dynamics: predict, project, take the velocities from what came of it.

How particles are predicted, and what velocities the projected positions mean: see `schemes`.
A particle begins BDF2 afresh, with one step of Euler, after it has touched the ground or was slowed down.
Substeps in place of sweeps: Macklin and others 2019, "Small steps in physics simulation".

Arrays, (n,) each: x, y, vx, vy (m, m/s) now, ox, oy, ux, uy the same a step earlier, px, py (m) where a step
leads; inverse_mass (1/kg); fresh, 1 where BDF2 begins afresh. Tuples of them: now, x, y, vx, vy; before, ox,
oy, ux, uy; aim, px, py.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.compiler.decorator import lean_kernel
from game.physics.constraints.areas import MULTIPLIER as AREA_MULTIPLIER
from game.physics.constraints.areas import sweep_areas
from game.physics.constraints.attachments import pull_back
from game.physics.constraints.bodies import push_bodies_apart
from game.physics.constraints.chains import solve_chains
from game.physics.constraints.contacts import bounce_pairs, push_apart
from game.physics.constraints.effects import (
    AREAS_BIT,
    ATTACHMENTS_BIT,
    CONTACTS_BIT,
    DAMPING_BIT,
    GRAVITY_BIT,
    GROUND_BIT,
    LINKS_BIT,
)
from game.physics.constraints.links import MULTIPLIER, XPBD, sweep_links
from game.physics.constraints.schemes import EULER, predict_bdf2, predict_euler, settle_bdf2, settle_euler

# rows of the particles' numbers: position (m), velocity (m/s), both of the step before, inverse mass (1/kg),
# 1 if the step before does not count, and the positions that are being projected
X, Y, VX, VY, OLD_X, OLD_Y, OLD_VX, OLD_VY, INVERSE_MASS, FRESH, AIM_X, AIM_Y = range(12)
FIELD_ROWS = 12


class Motion(NamedTuple):
    """The numbers of a step."""

    mask: int  # of effects
    model: int  # PBD, PBD_EVEN or XPBD
    scheme: int  # EULER or BDF2
    direct: int  # 1: chains are solved at once
    substeps: int
    sweeps: int  # in each substep
    ahead: int  # substeps of the step that follow in another call
    h: float  # s, of a substep
    soft_step: float  # s, by which compliance counts as α / step²
    gravity: float  # m/s²
    damping: float  # k_d, N s/m
    floor: float  # m
    left: float  # m, of the walls
    right: float  # m
    body_distance: float  # m, between particles of different bodies; 0: they pass through each other
    speed_limit: float  # m/s
    restitution: float  # of contacts


class Network(NamedTuple):
    """The constraints of a step, in the order of solving."""

    links: NDArray[np.int64]  # (m, 2)
    runs: NDArray[np.int64]  # (r, 3)
    link_rows: NDArray[np.float64]  # (4, m)
    order: NDArray[np.int64]  # (m,) place of each in the order given
    torn: NDArray[np.int64]  # (m,) in the order given
    corners: NDArray[np.int64]
    corner_starts: NDArray[np.int64]  # (k + 1,)
    area_rows: NDArray[np.float64]  # (5, k)
    pins: NDArray[np.int64]  # (n,)
    reaches: NDArray[np.float64]  # (n,) m
    nodes: NDArray[np.int64]
    node_starts: NDArray[np.int64]  # (c + 1,)
    chain_links: NDArray[np.int64]
    work: NDArray[np.float64]  # (5, longest chain)
    pairs: NDArray[np.int64]  # (c, 2) that bounce off each other
    distances: NDArray[np.float64]  # (c,) m
    members: NDArray[np.int64]  # (n,) particles body by body
    body_starts: NDArray[np.int64]  # (b + 1,)
    boxes: NDArray[np.float64]  # (4, b) m, scratch buffer


@lean_kernel
def limit_speeds(vx, vy, fresh, limit):
    """Slow down what is faster than ``limit`` (m/s), each particle by itself.

    A safety net, no physics: what a particle loses here no other gets. So in a substep in which the limit is
    met, momentum and energy of a free network change.
    """
    for i in range(vx.shape[0]):
        square = vx[i] * vx[i] + vy[i] * vy[i]
        if square > limit * limit:
            part = limit / math.sqrt(square)
            vx[i] *= part
            vy[i] *= part
            fresh[i] = 1.0


@lean_kernel
def lift(py, inverse_mass, floor):
    """Push particles above the floor; the fixed ones are where they were put."""
    for i in range(py.shape[0]):
        if inverse_mass[i] > 0.0:
            py[i] = max(py[i], floor)


@lean_kernel
def confine(px, inverse_mass, left, right):
    """Push particles between the walls; the fixed ones are where they were put."""
    for i in range(px.shape[0]):
        if inverse_mass[i] > 0.0:
            px[i] = min(max(px[i], left), right)


@lean_kernel
def carry_held(px, py, held, target, left, furthest):
    """Bring the particle that the hand holds nearer to the target: there in ``left`` substeps if it can."""
    dx = (target[0] - px[held]) / left
    dy = (target[1] - py[held]) / left
    distance = math.sqrt(dx * dx + dy * dy)
    if distance > furthest:
        dx *= furthest / distance
        dy *= furthest / distance
    px[held] += dx
    py[held] += dy


@lean_kernel
def carry_patch(now, aim, patch, held):
    """Lead the patch around the held particle along, each by its weight w of where the hand goes.

    p ← (1 - w) p + w (x + d), with d the held one's way in this substep. patch (k, 3): see `grip`.
    """
    x, y, _, _ = now
    px, py = aim
    dx = px[held] - x[held]
    dy = py[held] - y[held]
    for k in range(patch.shape[0]):
        i = int(patch[k, 0])
        weight = patch[k, 2]
        px[i] += weight * (x[i] + dx - px[i])
        py[i] += weight * (y[i] + dy - py[i])


@lean_kernel
def project(motion, net, px, py, inverse_mass):
    """All sweeps of a substep. px, py (n,) m are written."""
    if motion.model == XPBD:
        net.link_rows[MULTIPLIER][:] = 0.0  # carried over, it would make the links softer step by step
        net.area_rows[AREA_MULTIPLIER][:] = 0.0
    for _ in range(motion.sweeps):
        if motion.mask & LINKS_BIT:
            if motion.direct:
                solve_chains(motion.model, px, py, inverse_mass, net)
            else:
                sweep_links(motion.model, px, py, inverse_mass, net.links, net.runs, net.link_rows)
        if motion.mask & AREAS_BIT:
            sweep_areas(
                motion.model,
                px,
                py,
                inverse_mass,
                net.corners,
                net.corner_starts,
                net.area_rows,
                motion.sweeps,
                motion.soft_step,
            )
        if motion.mask & CONTACTS_BIT:
            push_apart(px, py, inverse_mass, net.pairs, net.distances)
            if motion.body_distance > 0.0:
                push_bodies_apart(
                    px, py, inverse_mass, net.members, net.body_starts, net.boxes, motion.body_distance
                )
        if motion.mask & ATTACHMENTS_BIT:
            pull_back(px, py, inverse_mass, net.pins, net.reaches)
        if motion.mask & GROUND_BIT:
            lift(py, inverse_mass, motion.floor)
            confine(px, inverse_mass, motion.left, motion.right)


@lean_kernel
def advance(fields, count, motion, net, held, target, patch):
    """One step of all substeps. fields (FIELD_ROWS, >= count) is written.

    held: index of the particle that the hand holds, or -1; target (2,) m: where it is to be; patch (k, 3):
    particles led along with it.
    """
    x = fields[X][:count]
    y = fields[Y][:count]
    vx = fields[VX][:count]
    vy = fields[VY][:count]
    ox = fields[OLD_X][:count]
    oy = fields[OLD_Y][:count]
    ux = fields[OLD_VX][:count]
    uy = fields[OLD_VY][:count]
    w = fields[INVERSE_MASS][:count]
    fresh = fields[FRESH][:count]
    px = fields[AIM_X][:count]
    py = fields[AIM_Y][:count]
    now, before, aim = (x, y, vx, vy), (ox, oy, ux, uy), (px, py)
    h = motion.h
    fall = motion.gravity if motion.mask & GRAVITY_BIT else 0.0
    damping = motion.damping if motion.mask & DAMPING_BIT else 0.0
    for turn in range(motion.substeps):
        if motion.mask & CONTACTS_BIT:
            bounce_pairs(now, w, fresh, net.pairs, net.distances, motion.restitution, h)
        if motion.scheme == EULER:
            predict_euler(now, w, aim, h, fall, damping)
        else:
            predict_bdf2(now, before, w, fresh, aim, h, fall, damping)
        if held >= 0:
            carry_held(px, py, held, target, motion.substeps - turn + motion.ahead, motion.speed_limit * h)
            carry_patch(now, aim, patch, held)
        project(motion, net, px, py, w)
        if motion.scheme == EULER:
            settle_euler(now, aim, h)
        else:
            settle_bdf2(now, before, fresh, aim, h)
            if motion.mask & GROUND_BIT:
                for i in range(count):
                    if y[i] <= motion.floor or x[i] <= motion.left or x[i] >= motion.right:
                        fresh[i] = 1.0
        if motion.speed_limit < math.inf:
            limit_speeds(vx, vy, fresh, motion.speed_limit)
