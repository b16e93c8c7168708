"""Islands: bodies that touch or are joined fall asleep together, and wake together.

Union-find over contacts that carry an impulse and over joints; fixed and key-framed bodies join nothing.
A sleeping island wakes when something awake touches it, or when one of its bodies is marked WAKING.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel
from game.physics.solids.arrays import state
from game.physics.solids.arrays.layout import BROKEN, MOUSE, NO_JOINT


@inner_kernel
def root_of(parents, i):
    """Representative of an island; the way there is halved."""
    while parents[i] != i:
        parents[i] = parents[parents[i]]
        i = parents[i]
    return i


@inner_kernel
def unite(parents, i, j):
    """Two islands become one; the lower number represents it."""
    i, j = root_of(parents, i), root_of(parents, j)
    if i < j:
        parents[j] = i
    else:
        parents[i] = j


@inner_kernel
def find_islands(bodies, contacts, joints, parents):
    """Representatives (n,) of all dynamic bodies' islands, awake and asleep."""
    flags = bodies.flags
    for i in range(flags.shape[0]):
        parents[i] = i
    for p in range(contacts.count[0]):
        i, j = contacts.bodies[p, 0], contacts.bodies[p, 1]
        if contacts.marks[p, state.TOUCHING] == 1 and flags[i] & flags[j] & state.DYNAMIC:
            unite(parents, i, j)
    for k in range(joints.kinds.shape[0]):
        if joints.kinds[k] == NO_JOINT or joints.flags[k] & BROKEN or joints.kinds[k] == MOUSE:
            continue
        i, j = joints.bodies[k, 0], joints.bodies[k, 1]
        if flags[i] & flags[j] & state.DYNAMIC:
            unite(parents, i, j)


@inner_kernel
def is_moving(bodies, i):
    """True for a key-framed body that has a velocity or spin."""
    if not bodies.flags[i] & state.KEY_FRAMED:
        return False
    return bodies.velocities[i, 0] != 0.0 or bodies.velocities[i, 1] != 0.0 or bodies.spins[i] != 0.0


@inner_kernel
def wake_islands(bodies, contacts, joints, scratch):
    """Wake all islands of which a body is marked WAKING, and what rests on such a body that nothing moves."""
    flags, parents, marked = bodies.flags, scratch.parents, False
    for i in range(flags.shape[0]):
        marked = marked or flags[i] & state.WAKING != 0
    if not marked:
        return
    for p in range(contacts.count[0]):
        i, j = contacts.bodies[p, 0], contacts.bodies[p, 1]
        if contacts.marks[p, state.TOUCHING] == 1:
            if flags[i] & (state.WAKING | state.DYNAMIC) == state.WAKING:
                flags[j] |= state.WAKING
            if flags[j] & (state.WAKING | state.DYNAMIC) == state.WAKING:
                flags[i] |= state.WAKING
    find_islands(bodies, contacts, joints, parents)
    for i in range(flags.shape[0]):
        if flags[i] & state.WAKING and flags[i] & state.DYNAMIC:
            flags[root_of(parents, i)] |= state.WAKING
    for i in range(flags.shape[0]):
        if flags[i] & state.DYNAMIC and flags[root_of(parents, i)] & state.WAKING:
            flags[i] &= ~state.ASLEEP
            bodies.quiet[i] = 0.0
    for i in range(flags.shape[0]):
        flags[i] &= ~state.WAKING


@inner_kernel
def mark_touched(bodies, contacts, rows):
    """Mark what sleeps and was touched in this step; true if there is any."""
    flags, any_asleep, any_marked = bodies.flags, 0, False
    for i in range(flags.shape[0]):
        any_asleep |= flags[i] & state.ASLEEP
    if not any_asleep:
        return False
    for c in range(rows.count[0]):
        a, b = rows.ends[c, state.END_A], rows.ends[c, state.END_B]
        if (flags[a] | flags[b]) & state.ASLEEP and contacts.marks[
            rows.ends[c, state.END_PAIR], state.TOUCHING
        ] == 1:
            if flags[a] & state.ASLEEP:
                flags[a] |= state.WAKING
            if flags[b] & state.ASLEEP:
                flags[b] |= state.WAKING
            any_marked = True
    return any_marked


@inner_kernel
def count_quiet(bodies, rows, motion, numbers):
    """Count for how long each body has been slow; true if some have been so for long enough.

    What overlap drives apart moves without a velocity.
    """
    flags, quiet, over = bodies.flags, bodies.quiet, 1.0 / numbers.dt
    for i in range(flags.shape[0]):
        if flags[i] & (state.DYNAMIC | state.ASLEEP) != state.DYNAMIC:
            continue
        vx, vy = bodies.velocities[i, 0], bodies.velocities[i, 1]
        speed = math.sqrt(vx * vx + vy * vy) + abs(bodies.spins[i]) * bodies.reaches[i]
        gone = (
            abs(motion[i, state.DX]) + abs(motion[i, state.DY]) + abs(motion[i, state.DA]) * bodies.reaches[i]
        )
        speed = max(speed, over * gone)
        quiet[i] = 0.0 if speed > numbers.calm or flags[i] & state.RESTLESS else quiet[i] + numbers.dt
    for c in range(rows.count[0]):  # what lies on something that moves does not sleep
        a, b = rows.ends[c, state.END_A], rows.ends[c, state.END_B]
        if is_moving(bodies, a):
            quiet[b] = 0.0
        if is_moving(bodies, b):
            quiet[a] = 0.0
    for i in range(flags.shape[0]):
        if flags[i] & (state.DYNAMIC | state.ASLEEP) == state.DYNAMIC and quiet[i] >= numbers.patience:
            return True
    return False


@inner_kernel
def send_to_sleep(bodies, rows, contacts, joints, scratch, numbers):
    """Put islands to sleep of which every body has been slow for long enough."""
    if not count_quiet(bodies, rows, scratch.motion, numbers):
        return
    flags, parents, quiet = bodies.flags, scratch.parents, bodies.quiet
    find_islands(bodies, contacts, joints, parents)
    for k in range(joints.kinds.shape[0]):  # what a hand holds, or a moving body is joined to, stays awake
        if joints.kinds[k] != NO_JOINT and not joints.flags[k] & BROKEN:
            a, b = joints.bodies[k, 0], joints.bodies[k, 1]
            if joints.kinds[k] == MOUSE or is_moving(bodies, a) or is_moving(bodies, b):
                quiet[a], quiet[b] = 0.0, 0.0
    for i in range(flags.shape[0]):
        if flags[i] & (state.DYNAMIC | state.ASLEEP) == state.DYNAMIC and quiet[i] < numbers.patience:
            flags[root_of(parents, i)] |= state.WAKING  # for now: this island stays awake
    for i in range(flags.shape[0]):
        if (
            flags[i] & (state.DYNAMIC | state.ASLEEP) == state.DYNAMIC
            and not flags[root_of(parents, i)] & state.WAKING
        ):
            flags[i] |= state.ASLEEP
            bodies.velocities[i, 0], bodies.velocities[i, 1], bodies.spins[i] = 0.0, 0.0, 0.0
    for i in range(flags.shape[0]):
        flags[i] &= ~state.WAKING
