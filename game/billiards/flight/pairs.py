"""When which two balls meet if some of them are in the air: as `exact.pairs`, in three dimensions.

The difference of two positions is quadratic in time, level or not, so the gap is a quartic whose fourth
derivative is not negative, and its first root is found as on the slate (`detection.first_closing`).
"""

from __future__ import annotations

import math

from game.billiards.exact.detection import first_closing
from game.billiards.exact.elements import LONGEST_SEARCH
from game.billiards.exact.pairs import contact_time, refresh_pairs, rescan
from game.billiards.laws.lean import inner_kernel
from game.billiards.laws.state import (
    AIRBORNE,
    AT_REST,
    AX,
    AY,
    CLOSING_SPEED,
    CONTACT_GAP,
    GRAVITY,
    MEET,
    MOTION,
    NEVER,
    NEXT_TIME,
    OWN_TIME,
    PAIR_TIME,
    PARTNER,
    POCKETED,
    RADIUS,
    TIME,
    VX,
    VY,
    VZ,
    X,
    Y,
    Z,
)


@inner_kernel
def _time_in_space(state, modes, i, j, now, physics):
    """Time of the next contact of balls i and j, where i stands at `now` and one of them is in the air, s."""
    t = now - state[TIME, j]
    fall_i = 0.5 * physics[GRAVITY] if modes[MOTION, i] == AIRBORNE else 0.0
    fall_j = 0.5 * physics[GRAVITY] if modes[MOTION, j] == AIRBORNE else 0.0
    x = state[X, j] + t * (state[VX, j] + t * state[AX, j]) - state[X, i]
    y = state[Y, j] + t * (state[VY, j] + t * state[AY, j]) - state[Y, i]
    z = state[Z, j] + t * (state[VZ, j] - t * fall_j) + state[RADIUS, j] - state[Z, i] - state[RADIUS, i]
    vx = state[VX, j] + 2.0 * t * state[AX, j] - state[VX, i]
    vy = state[VY, j] + 2.0 * t * state[AY, j] - state[VY, i]
    vz = state[VZ, j] - 2.0 * t * fall_j - state[VZ, i]
    ax = state[AX, j] - state[AX, i]
    ay = state[AY, j] - state[AY, i]
    az = fall_i - fall_j
    reach = state[RADIUS, i] + state[RADIUS, j]
    horizon = min(min(state[OWN_TIME, i], state[OWN_TIME, j]) - now, LONGEST_SEARCH)
    distance = math.sqrt(x * x + y * y + z * z)
    c1 = 2.0 * (x * vx + y * vy + z * vz)
    threshold = 2.0 * reach * CLOSING_SPEED
    t = first_closing(
        (distance - reach) * (distance + reach),
        c1,
        vx * vx + vy * vy + vz * vz + 2.0 * (x * ax + y * ay + z * az),
        2.0 * (vx * ax + vy * ay + vz * az),
        ax * ax + ay * ay + az * az,
        threshold,
        AT_REST if distance - reach <= CONTACT_GAP and c1 <= threshold else NEVER,
        horizon,
    )
    return t if t >= AT_REST else now + t


@inner_kernel
def _meeting_time(state, modes, i, j, now, physics):
    """Time of the next contact of balls i and j, wherever they are, s."""
    if modes[MOTION, i] == POCKETED or modes[MOTION, j] == POCKETED:
        return NEVER
    if modes[MOTION, i] == AIRBORNE or modes[MOTION, j] == AIRBORNE:
        return _time_in_space(state, modes, i, j, now, physics)
    return contact_time(state, i, j, now)


@inner_kernel
def refresh_everywhere(state, modes, pairs, i, physics):
    """Renew all contact times of ball i, which has just changed and whose plan is made."""
    n = state.shape[1]
    flying = 0
    for j in range(n):
        flying += 1 if modes[MOTION, j] == AIRBORNE else 0
    if flying == 0:
        refresh_pairs(state, modes, pairs, i)
        return
    best = NEVER
    partner = -1
    for j in range(n):
        if j == i:
            continue
        t = _meeting_time(state, modes, i, j, state[TIME, i], physics)
        pairs[MEET, i, j] = t
        pairs[MEET, j, i] = t
        if t < best:
            best = t
            partner = j
        if t < state[PAIR_TIME, j]:
            state[PAIR_TIME, j] = t
            modes[PARTNER, j] = i
            state[NEXT_TIME, j] = min(t, state[OWN_TIME, j])
        elif modes[PARTNER, j] == i:
            rescan(state, modes, pairs, j)
    state[PAIR_TIME, i] = best
    modes[PARTNER, i] = partner
    state[NEXT_TIME, i] = min(best, state[OWN_TIME, i])
