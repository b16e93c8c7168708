"""When which two balls meet: a table of contact times, renewed only for balls that changed.

Plane MEET of pairs (s) holds for each two balls the time of their next contact, NEVER, or AT_REST for two
that touch without closing. Each ball keeps the least of its row (PAIR_TIME, PARTNER) and the least
of that and its own plan (NEXT_TIME), so the next event of the table is one look at each ball.
"""

from __future__ import annotations

import math

from game.billiards.detection import first_touch
from game.billiards.elements import LONGEST_SEARCH
from game.billiards.state import (
    AT_REST,
    AX,
    AY,
    CONTACT_GAP,
    MEET,
    MOTION,
    NEVER,
    NEXT_TIME,
    OWN_TIME,
    PAIR_TIME,
    PARTNER,
    POCKETED,
    RADIUS,
    ROLLING,
    SLIDING,
    TIME,
    VX,
    VY,
    X,
    Y,
)
from game.physics.jit import kernel


@kernel(inline="always")
def reach_of(radius_i, radius_j):
    """Horizontal distance at which two balls on the cloth touch, 2 sqrt(R1 R2), m."""
    if radius_i == radius_j:
        return 2.0 * radius_i
    return 2.0 * math.sqrt(radius_i * radius_j)


@kernel(inline="always")
def stays_apart(x, y, vx, vy, ax, ay, reach, horizon):
    """Cheap proof that x + vx t + ax t^2 (and y) stays further than `reach` from 0 for `horizon` s.

    Measured along and across the relative velocity, both times |v|, the path stays in a box.
    """
    square = reach * reach * (vx * vx + vy * vy)
    bend = horizon * horizon
    across = abs(x * vy - y * vx) - bend * abs(ax * vy - ay * vx)
    if across > 0.0 and across * across > square:
        return True
    speed_square = vx * vx + vy * vy
    along = x * vx + y * vy
    push = bend * (ax * vx + ay * vy)
    latest = along + horizon * speed_square + max(push, 0.0)
    if latest < 0.0 and latest * latest > square:
        return True
    earliest = along + min(push, 0.0)
    return earliest > 0.0 and earliest * earliest > square


@kernel(inline="always")
def _contact_time(state, modes, i, j, now):
    """Time of the next contact of balls i and j, where i stands at `now`, s."""
    moving = modes[MOTION, i] == SLIDING or modes[MOTION, i] == ROLLING
    elapsed = now - state[TIME, j]
    ax = state[AX, j]
    ay = state[AY, j]
    vx = state[VX, j] + elapsed * ax
    vy = state[VY, j] + elapsed * ay
    x = state[X, j] + elapsed * vx - state[X, i]
    y = state[Y, j] + elapsed * vy - state[Y, i]
    reach = reach_of(state[RADIUS, i], state[RADIUS, j])
    if not moving and modes[MOTION, j] != SLIDING and modes[MOTION, j] != ROLLING:
        if x * x + y * y > 1.1 * reach * reach:
            return NEVER
        return AT_REST if math.sqrt(x * x + y * y) - reach <= CONTACT_GAP else NEVER
    vx += elapsed * ax - state[VX, i]
    vy += elapsed * ay - state[VY, i]
    ax -= state[AX, i]
    ay -= state[AY, i]
    horizon = min(min(state[OWN_TIME, i], state[OWN_TIME, j]) - now, LONGEST_SEARCH)
    if stays_apart(x, y, vx, vy, ax, ay, reach, horizon):
        return NEVER
    t = first_touch(x, y, vx, vy, ax, ay, reach, horizon)
    return t if t >= AT_REST else now + t


@kernel(inline="always")
def _rescan(state, modes, pairs, j):
    """Find the least of row j anew."""
    best = NEVER
    partner = -1
    for k in range(state.shape[1]):
        if pairs[MEET, j, k] < best:
            best = pairs[MEET, j, k]
            partner = k
    state[PAIR_TIME, j] = best
    modes[PARTNER, j] = partner
    state[NEXT_TIME, j] = min(best, state[OWN_TIME, j])


@kernel
def refresh_pairs(state, modes, pairs, i):
    """Renew all contact times of ball i, which has just changed and whose plan is made."""
    now = state[TIME, i]
    gone = modes[MOTION, i] == POCKETED
    best = NEVER
    partner = -1
    for j in range(state.shape[1]):
        if j == i:
            continue
        t = NEVER
        if not gone and modes[MOTION, j] != POCKETED:
            t = _contact_time(state, modes, i, j, now)
        pairs[MEET, i, j] = t
        pairs[MEET, j, i] = t
        if t < best:
            best = t
            partner = j
        if modes[PARTNER, j] == i:
            _rescan(state, modes, pairs, j)
        elif t < state[PAIR_TIME, j]:
            state[PAIR_TIME, j] = t
            modes[PARTNER, j] = i
            state[NEXT_TIME, j] = min(t, state[OWN_TIME, j])
    state[PAIR_TIME, i] = best
    modes[PARTNER, i] = partner
    state[NEXT_TIME, i] = min(best, state[OWN_TIME, i])
