"""One part of a step of spheres that stay in a plane: as in steps.py, with less to do.

Arrays: flat (n + 1, FLAT_COLUMNS), velocities and displacements; rows (capacity, PLANAR_COLUMNS);
counters (COUNTERS,), see steps.py. What goes together: state (`MotionState`), world (`World`), numbers
(`Numbers`), contacts (`Contacts`), log (`Ledger`).
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.spheres import ledger, steps
from game.physics.spheres import planar_impulses as flat_law
from game.physics.spheres.contacts import recall_impulses
from game.physics.spheres.effects import ROTATION_BIT
from game.physics.spheres.ledger import taken_by_fixed


@lean_kernel
def move_flat(state, composition, flat, numbers):
    """Explicit Euler in the plane: positions and orientations by the velocities that there are."""
    h = numbers.h
    flat_law.flatten_bodies(state, composition, flat)
    for i in range(state.positions.shape[0]):
        state.positions[i, 0] += h * flat[i, flat_law.VX]
        state.positions[i, 1] += h * flat[i, flat_law.VY]
    if numbers.mask & ROTATION_BIT:
        flat_law.turn_flat(state.orientations, flat, h)


@inner_kernel
def speeds_before(state, flat, rows, m, a, b):
    """Speeds along and across the normal of contact m (m/s) by the momenta, which do not know of the
    collisions yet.
    """
    x = y = rim = 0.0
    if b < state.momenta.shape[0]:
        x, y = flat[b, flat_law.WEIGHT] * state.momenta[b, 0], flat[b, flat_law.WEIGHT] * state.momenta[b, 1]
        rim = flat[b, flat_law.LEVER] * state.spins[b, 2]
    x -= flat[a, flat_law.WEIGHT] * state.momenta[a, 0]
    y -= flat[a, flat_law.WEIGHT] * state.momenta[a, 1]
    rim += flat[a, flat_law.LEVER] * state.spins[a, 2]
    nx, ny = rows[m, flat_law.PX], rows[m, flat_law.PY]
    return x * nx + y * ny, y * nx - x * ny - rows[m, flat_law.ARMS] * rim


@inner_kernel
def lost_momentum(state, flat, taken_x, taken_y):
    """Momentum (kg m/s) that the collisions of a part have made or lost, but for what fixed things took."""
    x, y = taken_x, taken_y
    for i in range(state.momenta.shape[0]):
        weight = flat[i, flat_law.WEIGHT]
        if weight > 0.0:
            x += flat[i, flat_law.VX] / weight - state.momenta[i, 0]
            y += flat[i, flat_law.VY] / weight - state.momenta[i, 1]
    return math.sqrt(x * x + y * y)


@inner_kernel
def note_flat(state, flat, radii, contacts, count, rows, log):
    """Enter the collisions of a part into the ledger, with their shares of the energy that they took.

    A share is J (u + u') / 2 by the speeds before and after all collisions of the part; in sum that is all
    the energy. Bodies have several collisions at once, so momentum is weighed for all of them together: each
    entry has what the part has lost.
    """
    ring, counters = log.ring, log.counters
    first = counters[steps.MADE]
    taken_x = taken_y = 0.0
    for m in range(count):
        j = rows[m, flat_law.HIT]
        if j > 0.0:
            entry = ring[int(counters[steps.MADE]) % ring.shape[0]]
            counters[steps.MADE] += 1.0
            entry[:] = 0.0
            nx, ny, jt = rows[m, flat_law.PX], rows[m, flat_law.PY], rows[m, flat_law.HIT_T]
            entry[ledger.TIME] = counters[steps.CLOCK]
            entry[ledger.ONE], entry[ledger.OTHER] = contacts.spheres[m, 0], max(contacts.spheres[m, 1], -1)
            entry[ledger.REBOUND] = rows[m, flat_law.REBOUND]
            a, b = contacts.bodies[m, 0], contacts.bodies[m, 1]
            reach = radii[a] * rows[m, flat_law.ARMS]
            entry[ledger.X] = state.positions[a, 0] + nx * reach
            entry[ledger.Y] = state.positions[a, 1] + ny * reach
            entry[ledger.Z] = state.positions[a, 2]
            entry[ledger.JX], entry[ledger.JY], entry[ledger.JZ] = j * nx - jt * ny, j * ny + jt * nx, 0.0
            entry[ledger.BEFORE], across = speeds_before(state, flat, rows, m, a, b)
            entry[ledger.AFTER], slip = flat_law.speeds_of(flat, rows, m, a, b)
            entry[ledger.CHANGE] = 0.5 * (
                j * (entry[ledger.BEFORE] + entry[ledger.AFTER]) + jt * (across + slip)
            )
            entry[ledger.EXPECTED] = entry[ledger.CHANGE]
            taken = taken_by_fixed(flat[a, flat_law.WEIGHT], flat[b, flat_law.WEIGHT])
            taken_x += taken * entry[ledger.JX]
            taken_y += taken * entry[ledger.JY]
    lost = lost_momentum(state, flat, taken_x, taken_y)
    for k in range(max(int(first), int(counters[steps.MADE]) - ring.shape[0]), int(counters[steps.MADE])):
        ring[k % ring.shape[0], ledger.LOST_MOMENTUM] = lost


@inner_kernel
def force_flat(flat, pulls, numbers):
    """Displacements before the forces, if the scheme has it so, and velocities after them."""
    h = numbers.h
    part = 0.5 * h if numbers.scheme == steps.EXACT else 0.0
    for i in range(pulls.shape[0]):
        weight = flat[i, flat_law.WEIGHT]
        vx, vy = flat[i, flat_law.VX], flat[i, flat_law.VY]
        flat[i, flat_law.WAY_X] = part * vx
        flat[i, flat_law.WAY_Y] = part * vy
        if weight > 0.0:
            keep = 1.0 / (1.0 + h * numbers.drag * weight) if numbers.drag > 0.0 else 1.0
            flat[i, flat_law.VX] = (vx + h * weight * pulls[i, 0]) * keep
            flat[i, flat_law.VY] = (vy + h * (weight * pulls[i, 1] - numbers.gravity)) * keep
            flat[i, flat_law.TURN] += h * pulls[i, 5] * flat[i, flat_law.LEVER] / flat[i, flat_law.RADIUS]


@inner_kernel
def finish_flat(state, composition, flat, numbers, counters):
    """New positions, orientations and momenta."""
    for i in range(state.positions.shape[0]):
        if flat[i, flat_law.WEIGHT] > 0.0:
            state.positions[i, 0] += flat[i, flat_law.WAY_X]
            state.positions[i, 1] += flat[i, flat_law.WAY_Y]
    if numbers.mask & ROTATION_BIT and numbers.scheme != steps.EXPLICIT:
        flat_law.turn_flat(state.orientations, flat, numbers.h)
    flat_law.keep_motion(state, composition, flat)
    counters[steps.CLOCK] += numbers.h
    counters[steps.LAST_H] = numbers.h


@lean_kernel
def planar_part(state, world, numbers, flat, contacts, count, past, rows, log):
    """All of a part but for finding contacts, for single spheres in a plane that hang from no strings."""
    composition, counters = world.composition, log.counters
    flat_law.flatten_bodies(state, composition, flat)
    recall_impulses(contacts, count, past)
    fastest = flat_law.prepare_planar(world, flat, contacts, count, rows, numbers)
    counters[steps.ROUNDS] = counters[steps.BOUNCES] = 0.0
    if fastest > 0.0:
        turns, made = flat_law.collide_flat(flat, composition, contacts, count, rows, fastest, numbers)
        counters[steps.ROUNDS] = turns
        counters[steps.BOUNCES] = made
        note_flat(state, flat, composition.radii, contacts, count, rows, log)
    flat_law.pass_over_flat(flat, contacts, count, rows, numbers)
    force_flat(flat, world.pulls, numbers)
    flat_law.start_flat(flat, contacts, count, rows)
    for _ in range(numbers.iterations):
        flat_law.sweep_flat(flat, contacts, count, rows)
    h = (
        0.0
        if numbers.scheme == steps.EXPLICIT
        else 0.5 * numbers.h
        if numbers.scheme == steps.EXACT
        else numbers.h
    )
    for i in range(flat.shape[0]):
        flat[i, flat_law.WAY_X] += h * flat[i, flat_law.VX]
        flat[i, flat_law.WAY_Y] += h * flat[i, flat_law.VY]
    if numbers.correction == steps.SOFT:
        flat_law.harden_flat(count, rows)
        flat_law.sweep_flat(flat, contacts, count, rows)
    flat_law.keep_flat(contacts, count, rows)
    for m in range(count):
        contacts.pushes[m] = 0.0
    for _ in range(numbers.passes):
        if numbers.correction == steps.SPLIT:
            flat_law.split_flat(flat, contacts, count, rows, numbers)
        else:
            flat_law.project_flat(state.positions, flat, contacts, count, numbers)
    finish_flat(state, composition, flat, numbers, counters)
