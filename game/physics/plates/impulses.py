"""Impulses between plates that touch: they push apart, rub, and put what was pushed where it may be.

Impulses are added up one after the other (Gauss-Seidel), beginning with those of the last step, pushing only,
rubbing at most as Coulomb says. A plate that was pushed goes on from where it was by its new velocity. What
overlaps is moved apart a little each step, without velocity.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.plates import contacts, law

WARM = 3  # of a contact of the last step: its key, push and rub (N s)
SLOP = 2e-4  # m that contacts may overlap
MENDED = 0.2  # of the rest that is mended in a step
ITERATIONS = 6
SCATTER = 2_654_435_761  # of keys over the table of a hash (Knuth)
CREEP, CALMING = 0.01, 30.0  # m/s, 1/s: what creeps while it is touched comes to rest at this rate


@inner_kernel
def speed_of(state, row, at, i, dx, dy):
    """Speed of a body at a contact in a direction."""
    return (
        dx * state[law.VX, i]
        + dy * state[law.VY, i]
        + row[at] * state[law.SPIN, i]
        + row[at + 1] * state[law.BEND_RATE, i]
    )


@inner_kernel
def give(state, row, at, i, impulse):
    """An impulse (N s) on a body."""
    state[law.VX, i] += impulse * row[at + 2]
    state[law.VY, i] += impulse * row[at + 3]
    state[law.SPIN, i] += impulse * row[at + 4]
    state[law.BEND_RATE, i] += impulse * row[at + 5]


@inner_kernel
def push_both(state, rows, ids, k, push, rub):
    """Impulses (N s) along and across the normal of a contact."""
    give(state, rows[k], contacts.ARMS, ids[k, 0], push)
    give(state, rows[k], contacts.ARMS + 6, ids[k, 0], rub)
    if ids[k, 1] != contacts.NOBODY:
        give(state, rows[k], contacts.ARMS + contacts.LEVERS, ids[k, 1], push)
        give(state, rows[k], contacts.ARMS + contacts.LEVERS + 6, ids[k, 1], rub)


@inner_kernel
def begin_warm(state, found, count, warm, table):
    """Begin with the impulses that the same contacts had in the last step; table (2^p,): scratch, a hash of
    them."""
    rows, ids, keys, _ = found
    last = len(table) - 1
    for k in range(len(table)):
        table[k] = -1
    for k in range(len(warm)):
        at = (int(warm[k, 0]) * SCATTER >> 7) & last
        while table[at] >= 0:
            at = (at + 1) & last
        table[at] = k
    for k in range(count):
        at = (int(keys[k]) * SCATTER >> 7) & last
        while table[at] >= 0:
            if warm[table[at], 0] == keys[k]:
                rows[k, contacts.PUSH], rows[k, contacts.RUB] = warm[table[at], 1], warm[table[at], 2]
                push_both(state, rows, ids, k, rows[k, contacts.PUSH], rows[k, contacts.RUB])
                break
            at = (at + 1) & last


@lean_kernel
def solve_contacts(world, found, order, before, warm, table, touched, dt):
    """Push apart and rub, and take what was pushed from where it was ``before`` (STATE, n) by its new
    velocity.

    order (count,): contacts from the lowest up; sweeps go up and down by turns. warm (k, WARM): the
    contacts of the last step, whose impulses are begun with; touched (n,): written, the impulse (N s) that
    each plate got.
    """
    state, laws, _ = world
    rows, ids, _, _ = found
    n, count = state.shape[1], len(order)
    for i in range(n):
        touched[i] = 0.0
    begin_warm(state, found, count, warm, table)
    for sweep in range(ITERATIONS):
        for place in range(count):
            k = order[place if sweep % 2 == 0 else count - 1 - place]
            row, i, j = rows[k], ids[k, 0], ids[k, 1]
            nx, ny = row[contacts.NORMAL_X], row[contacts.NORMAL_Y]
            speed = speed_of(state, row, contacts.ARMS, i, nx, ny)
            if j != contacts.NOBODY:
                speed += speed_of(state, row, contacts.ARMS + contacts.LEVERS, j, -nx, -ny)
            wanted = row[contacts.PUSH] - (speed + max(row[contacts.GAP], 0.0) / dt) / row[contacts.YIELDS]
            push = max(wanted, 0.0)
            change, row[contacts.PUSH] = push - row[contacts.PUSH], push
            give(state, row, contacts.ARMS, i, change)
            if j != contacts.NOBODY:
                give(state, row, contacts.ARMS + contacts.LEVERS, j, change)
            most = row[contacts.FRICTION] * row[contacts.PUSH]
            speed = speed_of(state, row, contacts.ARMS + 6, i, -ny, nx)
            if j != contacts.NOBODY:
                speed += speed_of(state, row, contacts.ARMS + contacts.LEVERS + 6, j, ny, -nx)
            rub = min(max(row[contacts.RUB] - speed / row[contacts.YIELDS_ACROSS], -most), most)
            change, row[contacts.RUB] = rub - row[contacts.RUB], rub
            give(state, row, contacts.ARMS + 6, i, change)
            if j != contacts.NOBODY:
                give(state, row, contacts.ARMS + contacts.LEVERS + 6, j, change)
    for k in range(count):
        touched[ids[k, 0]] += rows[k, contacts.PUSH]
        if ids[k, 1] != contacts.NOBODY:
            touched[ids[k, 1]] += rows[k, contacts.PUSH]
    for i in range(n):
        if touched[i] > 0.0:
            slow = (
                math.sqrt(state[law.VX, i] * state[law.VX, i] + state[law.VY, i] * state[law.VY, i])
                + abs(state[law.SPIN, i]) * laws[law.HALF, i]
            )
            if slow < CREEP:
                calm = 1.0 / (1.0 + CALMING * dt)
                state[law.VX, i] *= calm
                state[law.VY, i] *= calm
                state[law.SPIN, i] *= calm
            state[law.X, i] = before[law.X, i] + dt * state[law.VX, i]
            state[law.Y, i] = before[law.Y, i] + dt * state[law.VY, i]
            state[law.THETA, i] = before[law.THETA, i] + dt * state[law.SPIN, i]
            state[law.BEND, i] = min(
                max(before[law.BEND, i] + dt * state[law.BEND_RATE, i], -law.MOST_BEND), law.MOST_BEND
            )
    for k in range(count):
        deep = -rows[k, contacts.GAP] - SLOP
        if deep > 0.0:
            i, j = ids[k, 0], ids[k, 1]
            part = MENDED * deep * (1.0 if j == contacts.NOBODY else 0.5)
            state[law.X, i] += part * rows[k, contacts.NORMAL_X]
            state[law.Y, i] += part * rows[k, contacts.NORMAL_Y]
            if j != contacts.NOBODY:
                state[law.X, j] -= part * rows[k, contacts.NORMAL_X]
                state[law.Y, j] -= part * rows[k, contacts.NORMAL_Y]


@lean_kernel
def copy_state(state, before):
    """Keep a state (STATE, n)."""
    for k in range(law.STATE):
        for i in range(state.shape[1]):
            before[k, i] = state[k, i]
