"""When which two balls meet: a table of contact times, renewed only for balls that changed.

Plane MEET of pairs (s) holds for each two balls the time of their next contact, NEVER, or AT_REST for two in
contact without closing. Each ball keeps the least of its row (PAIR_TIME, PARTNER) and the least of that and
its own plan (NEXT_TIME). So the next event of the table is one look at each ball.
"""

from __future__ import annotations

import numpy as np

from game.billiards.exact.detection import first_contact_time
from game.billiards.exact.elements import LONGEST_SEARCH
from game.billiards.laws import state as s
from game.billiards.laws.contacts.ball_ball_normal import reach_of
from game.billiards.laws.lean import inner_kernel

BLOCK = 32  # balls whose bits stand in one number
NEAR = 1.2  # of the square of two balls' reach; two that lie still and are no nearer are not in contact
RENEWED = 4  # mark of a ball whose contact times were renewed at this very moment


@inner_kernel(inline="always")
def _look_at(state, modes, pairs, i, first, width):
    """Bits of `width` balls from number `first` on: see `may_meet`.

    One expression without branches, a width written out, an index that cannot be negative: so the compiler
    takes all balls at a time.
    """
    now = state[s.TIME, i]
    xi = state[s.X, i]
    yi = state[s.Y, i]
    vxi = state[s.VX, i]
    vyi = state[s.VY, i]
    axi = state[s.AX, i]
    ayi = state[s.AY, i]
    own = min(state[s.OWN_TIME, i], now + LONGEST_SEARCH)
    four_radius = 4.0 * state[s.RADIUS, i]
    bits = 0
    foreseen = 0
    for k in range(width):
        j = np.uintp(first + k)
        elapsed = now - state[s.TIME, j]
        ax = state[s.AX, j]
        ay = state[s.AY, j]
        vx = state[s.VX, j] + elapsed * ax
        vy = state[s.VY, j] + elapsed * ay
        x = state[s.X, j] + elapsed * vx - xi
        y = state[s.Y, j] + elapsed * vy - yi
        vx = vx + elapsed * ax - vxi
        vy = vy + elapsed * ay - vyi
        ax -= axi
        ay -= ayi
        horizon = min(own, state[s.OWN_TIME, j]) - now
        reach_square = four_radius * state[s.RADIUS, j]
        # half of the square of the distance, less the reach: its value, slope and least curvature
        gap = 0.5 * (x * x + y * y - reach_square)
        along = x * vx + y * vy
        push = ax * vx + ay * vy
        speed_square = vx * vx + vy * vy
        third = horizon * min(push, 0.0)
        curvature = speed_square + 2.0 * (x * ax + y * ay) + 2.0 * third
        grows = along + horizon * min(curvature + third, 0.0) > 0.0
        bend = horizon * horizon
        above = gap + horizon * along + 0.5 * bend * curvature > 0.0
        dips = (along < 0.0) & (along + horizon * curvature > 0.0) & (along * along >= 2.0 * curvature * gap)
        limit = reach_square * speed_square
        across = abs(x * vy - y * vx) - bend * abs(ax * vy - ay * vx)
        latest = along + horizon * speed_square + bend * max(push, 0.0)
        ruled_out = (
            grows | ((gap > 1e-11 * reach_square) & above & (not dips)) | (modes[s.MOTION, j] == s.POCKETED)
        )
        ruled_out |= ((across > 0.0) & (across * across > limit)) | (
            (latest < 0.0) & (latest * latest > limit)
        )
        ruled_out |= (speed_square == 0.0) & (gap > 0.1 * reach_square)
        bits |= (0 if ruled_out else 1) << k
        foreseen |= (1 if pairs[s.MEET, i, j] < s.NEVER else 0) << k
    return bits, foreseen


@inner_kernel(forceinline=True)
def may_meet(state, modes, pairs, i, start, count):
    """Bits of `count` balls from number start on: for which a contact with ball i is not ruled out, and
    with which one was foreseen so far. At most BLOCK of them, from a multiple of it on.

    With x + v t + a t^2 the position of ball j seen from i, and a horizon of h s in which both keep their
    phases. There is no contact if
    - the distance only grows, or the parabola that lies under its square (see `detection`) stays above; or
    - the path keeps off: along and across v, both times |v|, it stays in a box that ends before the ball; or
    - both lie still, apart.
    Balls are looked at in whole vectors, the last of which takes some a second time: one by one each ball of
    a rest would cost a third of a vector.
    """
    bits = 0
    foreseen = 0
    end = start + count
    if end >= 8:
        for number in range(start, end, 8):
            first = min(number, end - 8)
            found, before = _look_at(state, modes, pairs, i, first, 8)
            bits |= found >> max(start - first, 0) << max(first - start, 0)
            foreseen |= before >> max(start - first, 0) << max(first - start, 0)
    elif end >= 4:
        bits, foreseen = _look_at(state, modes, pairs, i, 0, 4)
        found, before = _look_at(state, modes, pairs, i, end - 4, 4)
        bits |= found << (end - 4)
        foreseen |= before << (end - 4)
    else:
        for j in range(end):
            if j != i:
                found, before = _look_at(state, modes, pairs, i, j, 1)
                bits |= found << j
                foreseen |= before << j
    return bits, foreseen


@inner_kernel(inline="always")
def contact_time(state, i, j, now):
    """Time of the next contact of balls i and j, where i stands at `now`, s."""
    elapsed = now - state[s.TIME, j]
    ax = state[s.AX, j]
    ay = state[s.AY, j]
    vx = state[s.VX, j] + elapsed * ax
    vy = state[s.VY, j] + elapsed * ay
    x = state[s.X, j] + elapsed * vx - state[s.X, i]
    y = state[s.Y, j] + elapsed * vy - state[s.Y, i]
    vx += elapsed * ax - state[s.VX, i]
    vy += elapsed * ay - state[s.VY, i]
    ax -= state[s.AX, i]
    ay -= state[s.AY, i]
    reach = reach_of(state[s.RADIUS, i], state[s.RADIUS, j])
    horizon = min(min(state[s.OWN_TIME, i], state[s.OWN_TIME, j]) - now, LONGEST_SEARCH)
    t = first_contact_time(x, y, vx, vy, ax, ay, reach, horizon)
    return t if t >= s.AT_REST else now + t


@inner_kernel(inline="always")
def rescan(state, modes, pairs, j):
    """Find the least of row j again."""
    best = s.NEVER
    partner = -1
    for k in range(state.shape[1]):
        if pairs[s.MEET, j, k] < best:
            best = pairs[s.MEET, j, k]
            partner = k
    state[s.PAIR_TIME, j] = best
    modes[s.PARTNER, j] = partner
    state[s.NEXT_TIME, j] = min(best, state[s.OWN_TIME, j])


@inner_kernel(inline="always")
def lies_apart(state, modes, i):
    """True if ball i lies still, and no ball is so near that they may be in contact; or if it is pocketed."""
    motion = modes[s.MOTION, i]
    reach = NEAR * 4.0 * state[s.RADIUS, i]
    near = 0
    for j in range(state.shape[1]):
        x = state[s.X, j] - state[s.X, i]
        y = state[s.Y, j] - state[s.Y, i]
        near += 1 if x * x + y * y <= reach * state[s.RADIUS, j] else 0
    return motion == s.POCKETED or (motion == s.STATIONARY and near == 1)


@inner_kernel(forceinline=True)
def refresh_pairs(state, modes, pairs, i):
    """Renew all contact times of ball i, which has just changed and whose plan is made.

    Those with balls that are marked RENEWED are right already.
    """
    n = state.shape[1]
    now = state[s.TIME, i]
    gone = modes[s.MOTION, i] == s.POCKETED
    best = s.NEVER
    partner = -1
    for start in range(0, n, BLOCK):
        end = min(start + BLOCK, n)
        bits, foreseen = may_meet(state, modes, pairs, i, start, end - start)
        if gone:
            bits = 0
        for j in range(start, end):
            if j == i or not ((bits | foreseen) >> (j - start)) & 1:
                continue
            t = s.NEVER
            if modes[s.MARK, j] == RENEWED:
                t = pairs[s.MEET, i, j]
            elif (bits >> (j - start)) & 1:
                t = contact_time(state, i, j, now)
            if t < best:
                best = t
                partner = j
            if modes[s.MARK, j] == RENEWED:
                continue
            pairs[s.MEET, i, j] = t
            pairs[s.MEET, j, i] = t
            if t < state[s.PAIR_TIME, j]:
                state[s.PAIR_TIME, j] = t
                modes[s.PARTNER, j] = i
                state[s.NEXT_TIME, j] = min(t, state[s.OWN_TIME, j])
            elif modes[s.PARTNER, j] == i:
                rescan(state, modes, pairs, j)
    state[s.PAIR_TIME, i] = best
    modes[s.PARTNER, i] = partner
    state[s.NEXT_TIME, i] = min(best, state[s.OWN_TIME, i])
