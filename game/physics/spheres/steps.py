"""One part of a step of colliding spheres, from contact to contact.

    find contacts; collisions, by the velocities that there are; forces; resting contacts; positions
    Guendelman, Bridson, Fedkiw 2003, "Nonconvex rigid bodies with stacking"

Collisions come before forces: so what rests is not thrown by a step's worth of gravity. Explicit Euler moves
first, by the velocities of before. The semi-implicit scheme moves last, by the new ones; exact flight by
their mean, which is a parabola.

Arrays: work (n + 1, WORK_COLUMNS), velocities; shifts (n + 1, 4), by how much positions are corrected; pulls
(n, 6) N and N m; counters (COUNTERS,). What goes together: state (`MotionState`), world (`World`), numbers
(`Numbers`), contacts (`Contacts`), log (`Ledger`). For single spheres in a plane there is `planar_steps`.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.rigid.quaternion import exponentiate, multiply, normalize
from game.physics.spheres import spheres
from game.physics.spheres.contact_rows import prepare_rows
from game.physics.spheres.contacts import recall_impulses
from game.physics.spheres.effects import ROTATION_BIT, STRINGS_BIT
from game.physics.spheres.impulses import collide_in_turn
from game.physics.spheres.joint_impulses import collide_at_once
from game.physics.spheres.ledger import spin_of
from game.physics.spheres.position_correction import project_apart, split_apart
from game.physics.spheres.resting_contacts import (
    harden_rows,
    keep_impulses,
    pass_over,
    start_warm,
    sweep_rows,
)
from game.physics.spheres.spheres import gather_velocities

EXPLICIT, SEMI_IMPLICIT, EXACT = range(3)
IN_TURN, AT_ONCE = range(2)
NO_CORRECTION, BAUMGARTE, SOFT, SPLIT, PROJECTION = range(5)
# of counters: time s, length of the last part s, collisions so far, rounds and bounces of the last part
CLOCK, LAST_H, MADE, ROUNDS, BOUNCES = range(5)
COUNTERS = 8


class BodyMotion(NamedTuple):
    """Arrays of a part: where spheres are, how bodies move, and how far they go."""

    places: NDArray[np.float64]  # (s, 3) m
    work: NDArray[np.float64]  # (n + 1, WORK_COLUMNS)
    shifts: NDArray[np.float64]  # (n + 1, 4) m, and inverse mass 1/kg


@inner_kernel
def turn_bodies(state, work, h, exact):
    """Orientations after h (s): by Euler's step and normalised, or by the exponential map."""
    for i in range(state.orientations.shape[0]):
        x, y, z = work[i, spheres.WX], work[i, spheres.WY], work[i, spheres.WZ]
        if x == 0.0 and y == 0.0 and z == 0.0:
            continue
        q = state.orientations
        now = (q[i, 0], q[i, 1], q[i, 2], q[i, 3])
        if exact:
            turned = multiply(exponentiate((h * x, h * y, h * z)), now)
        else:
            turned = multiply((1.0, 0.5 * h * x, 0.5 * h * y, 0.5 * h * z), now)
        q[i, 0], q[i, 1], q[i, 2], q[i, 3] = normalize(turned)


@inner_kernel
def apply_forces(work, pulls, h, gravity, drag):
    """Velocities after h (s) of gravity, drag and the pulls (n, 6): forces N and torques N m."""
    for i in range(pulls.shape[0]):
        weight = work[i, spheres.WEIGHT]
        if weight <= 0.0:
            continue
        keep = 1.0 / (1.0 + h * drag * weight)
        work[i, spheres.VX] = (work[i, spheres.VX] + h * weight * pulls[i, 0]) * keep
        work[i, spheres.VY] = (work[i, spheres.VY] + h * (weight * pulls[i, 1] - gravity)) * keep
        work[i, spheres.VZ] = (work[i, spheres.VZ] + h * weight * pulls[i, 2]) * keep


@inner_kernel
def apply_torques(work, pulls, h):
    """Angular velocities after h (s) of the torques in pulls (n, 6)."""
    for i in range(pulls.shape[0]):
        x, y, z = h * pulls[i, 3], h * pulls[i, 4], h * pulls[i, 5]
        if x != 0.0 or y != 0.0 or z != 0.0:
            work[i, spheres.WX] += work[i, 7] * x + work[i, 10] * y + work[i, 11] * z
            work[i, spheres.WY] += work[i, 10] * x + work[i, 8] * y + work[i, 12] * z
            work[i, spheres.WZ] += work[i, 11] * x + work[i, 12] * y + work[i, 9] * z


@lean_kernel
def move_by_velocity(state, composition, work, numbers):
    """Explicit Euler: positions and orientations by the velocities that there are."""
    h = numbers.h
    gather_velocities(state, composition, work)
    for i in range(state.positions.shape[0]):
        state.positions[i, 0] += h * work[i, spheres.VX]
        state.positions[i, 1] += h * work[i, spheres.VY]
        state.positions[i, 2] += h * work[i, spheres.VZ]
    if numbers.mask & ROTATION_BIT:
        turn_bodies(state, work, h, False)


@inner_kernel
def start_shifts(work, shifts, h, scheme):
    """Displacement of bodies by the velocities before forces act: none, none, or half of h."""
    part = 0.5 * h if scheme == EXACT else 0.0
    for i in range(shifts.shape[0]):
        shifts[i, 0] = part * work[i, spheres.VX]
        shifts[i, 1] = part * work[i, spheres.VY]
        shifts[i, 2] = part * work[i, spheres.VZ]
        shifts[i, 3] = work[i, spheres.WEIGHT]


@inner_kernel
def add_shifts(work, shifts, h, scheme):
    """Their displacement by the new velocities: not at all, for h, or for half of it."""
    part = 0.0 if scheme == EXPLICIT else 0.5 * h if scheme == EXACT else h
    for i in range(shifts.shape[0]):
        shifts[i, 0] += part * work[i, spheres.VX]
        shifts[i, 1] += part * work[i, spheres.VY]
        shifts[i, 2] += part * work[i, spheres.VZ]


@inner_kernel
def swing_on(state, work, surroundings, owners):
    """What hangs on a taut string goes on along its circle: as fast as before, and not off it."""
    for k in range(surroundings.hung.shape[0]):
        i = owners[surroundings.hung[k]]
        x = state.positions[i, 0] - surroundings.strings[k, 0]
        y = state.positions[i, 1] - surroundings.strings[k, 1]
        z = state.positions[i, 2] - surroundings.strings[k, 2]
        length = math.sqrt(x * x + y * y + z * z)
        if not length > surroundings.strings[k, 3] * (1.0 - 1e-12):
            continue
        x, y, z = x / length, y / length, z / length
        back = length - surroundings.strings[k, 3]
        state.positions[i, 0] -= back * x
        state.positions[i, 1] -= back * y
        state.positions[i, 2] -= back * z
        vx, vy, vz = work[i, spheres.VX], work[i, spheres.VY], work[i, spheres.VZ]
        out = vx * x + vy * y + vz * z
        square = vx * vx + vy * vy + vz * vz
        along = square - out * out
        if out > 0.0 and along > 0.5 * square:
            scale = math.sqrt(square / along)
            work[i, spheres.VX] = scale * (vx - out * x)
            work[i, spheres.VY] = scale * (vy - out * y)
            work[i, spheres.VZ] = scale * (vz - out * z)


@inner_kernel
def finish_part(state, world, numbers, work, shifts, counters):
    """New positions, orientations and momenta."""
    composition, mask = world.composition, numbers.mask
    for i in range(state.positions.shape[0]):
        if work[i, spheres.WEIGHT] > 0.0:
            state.positions[i, 0] += shifts[i, 0]
            state.positions[i, 1] += shifts[i, 1]
            state.positions[i, 2] += shifts[i, 2]
    if mask & STRINGS_BIT:
        swing_on(state, work, world.surroundings, composition.owners)
    if mask & ROTATION_BIT and numbers.scheme != EXPLICIT:
        turn_bodies(state, work, numbers.h, numbers.scheme == EXACT)
    for i in range(state.positions.shape[0]):
        mass = composition.masses[i] if work[i, spheres.WEIGHT] > 0.0 else 0.0
        state.momenta[i, 0] = mass * work[i, spheres.VX]
        state.momenta[i, 1] = mass * work[i, spheres.VY]
        state.momenta[i, 2] = mass * work[i, spheres.VZ]
        state.spins[i, 0], state.spins[i, 1], state.spins[i, 2] = spin_of(work, i)
    counters[CLOCK] += numbers.h
    counters[LAST_H] = numbers.h


@inner_kernel
def resting_part(work, contacts, count, rows, shifts, pulls, numbers):
    """Forces, resting contacts, and how far bodies go. The contacts' impulses are written."""
    pass_over(work, contacts, count, rows, numbers)
    start_shifts(work, shifts, numbers.h, numbers.scheme)
    apply_forces(work, pulls, numbers.h, numbers.gravity, numbers.drag)
    apply_torques(work, pulls, numbers.h)
    start_warm(work, contacts, count, rows)
    for _ in range(numbers.iterations):
        sweep_rows(work, contacts, count, rows)
    add_shifts(work, shifts, numbers.h, numbers.scheme)
    if numbers.correction == SOFT:
        harden_rows(count, rows)
        sweep_rows(work, contacts, count, rows)
    keep_impulses(contacts, count, rows)


@lean_kernel
def general_part(state, world, numbers, motion, contacts, count, past, rows, log):
    """All of a part but for finding contacts, for any bodies. motion: `BodyMotion`, places up to date."""
    radii, counters = world.composition.radii, log.counters
    places, work, shifts = motion
    gather_velocities(state, world.composition, work)
    recall_impulses(contacts, count, past)
    fastest = prepare_rows(state, world, places, work, contacts, count, rows, numbers)
    counters[ROUNDS] = counters[BOUNCES] = 0.0
    if fastest > 0.0:
        if numbers.law == AT_ONCE:
            turns, made = collide_at_once(
                work, state.positions, radii, contacts, count, rows, fastest, numbers, log
            )
        else:
            turns, made = collide_in_turn(
                work, state.positions, radii, contacts, count, rows, fastest, numbers, log
            )
        counters[ROUNDS] = turns
        counters[BOUNCES] = made
    resting_part(work, contacts, count, rows, shifts, world.pulls, numbers)
    if numbers.correction == SPLIT:
        split_apart(contacts, count, shifts, numbers)
    elif numbers.correction == PROJECTION:
        project_apart(places, radii, contacts, count, shifts, numbers)
    finish_part(state, world, numbers, work, shifts, counters)
