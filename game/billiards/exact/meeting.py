"""Two balls meet on the exact table: alone, or together with all in contact with them at that moment."""

from __future__ import annotations

from game.billiards.exact.cluster import collide_jointly, gather_contacts, has_company
from game.billiards.laws import state as s
from game.billiards.laws.impacts import collide_pair, end_chatter, normal_between
from game.billiards.laws.lean import inner_kernel
from game.billiards.laws.motion import advance, enter_phase

HIT = 3  # mark of a ball that got an impulse


@inner_kernel(forceinline=True)
def meet_alone(state, modes, pairs, i, j, now, physics):
    """Balls i and j collide, and no other contact is involved. Returns whether they are stuck."""
    advance(state, modes, i, now, physics)
    advance(state, modes, j, now, physics)
    nx, ny = normal_between(state, i, j)
    collide_pair(state, i, j, nx, ny, physics)
    stuck = end_chatter(state, pairs, i, j, nx, ny, now)
    modes[s.MEMBER, 0] = i
    modes[s.MEMBER, 1] = j
    enter_phase(state, modes, i, s.SLIDING, physics)
    enter_phase(state, modes, j, s.SLIDING, physics)
    return stuck


@inner_kernel
def meet_in_company(arrays, i, j, now, physics):
    """Balls i and j collide together with all in contact with them.

    Moves the contacts that got an impulse to the front of ends, and writes their balls to row MEMBER of
    modes. Returns the numbers of both, and a ball that is stuck, -1 if none is.
    """
    state, modes, pairs, cluster = arrays
    ends, forces, normals = cluster.ends, cluster.forces, cluster.normals
    count, found = gather_contacts(state, modes, pairs, i, j, now, ends, normals)
    for q in range(found):
        advance(state, modes, modes[s.MEMBER, q], now, physics)
    collide_jointly(state, modes, found, count, cluster, physics)
    written = 0
    stuck = -1
    for m in range(count):
        if forces[s.IMPULSE, m] > 0.0:
            a = ends[s.FIRST, m]
            b = ends[s.SECOND, m]
            if end_chatter(state, pairs, a, b, normals[m, 0], normals[m, 1], now):
                stuck = a
            ends[s.FIRST, written] = a
            ends[s.SECOND, written] = b
            written += 1
            modes[s.MARK, a] = HIT
            modes[s.MARK, b] = HIT
    changed = 0
    for q in range(found):
        k = modes[s.MEMBER, q]
        if modes[s.MARK, k] == HIT:
            modes[s.MEMBER, changed] = k
            changed += 1
            enter_phase(state, modes, k, s.SLIDING, physics)
    return written, changed, stuck


@inner_kernel(inline="always")
def meet(arrays, i, j, now, physics):
    """Balls i and j come into contact at `now` (s): what comes of it, and of all in contact with them.

    arrays: see `batch.Arrays`. The contacts that got an impulse come first in ends, their balls in
    row MEMBER of modes. Returns the numbers of both, and a ball that is stuck (see `settling`), or -1.
    """
    ends = arrays.cluster.ends
    ends[s.FIRST, 0] = i
    ends[s.SECOND, 0] = j
    if has_company(arrays.pairs, i, j, now):
        return meet_in_company(arrays, i, j, now, physics)
    stuck = meet_alone(arrays.state, arrays.modes, arrays.pairs, i, j, now, physics)
    return 1, 2, i if stuck else -1
