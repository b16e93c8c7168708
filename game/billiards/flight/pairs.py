"""When which two balls meet if some of them are in the air: as `exact.pairs`, in three dimensions.

The difference of two positions is quadratic in time, level or not, so the gap is a quartic whose fourth
derivative is not negative. Its first root is found as on the slate (`detection.first_closing`).
"""

from __future__ import annotations

import math

from game.billiards.exact.detection import first_closing
from game.billiards.exact.elements import LONGEST_SEARCH
from game.billiards.exact.pairs import contact_time, refresh_pairs, rescan
from game.billiards.laws import state as s
from game.billiards.laws.lean import inner_kernel


@inner_kernel
def _time_in_space(state, modes, i, j, now, physics):
    """Time of the next contact of balls i and j, where i stands at `now` and one of them is in the air, s."""
    t = now - state[s.TIME, j]
    fall_i = 0.5 * physics[s.GRAVITY] if modes[s.MOTION, i] == s.AIRBORNE else 0.0
    fall_j = 0.5 * physics[s.GRAVITY] if modes[s.MOTION, j] == s.AIRBORNE else 0.0
    x = state[s.X, j] + t * (state[s.VX, j] + t * state[s.AX, j]) - state[s.X, i]
    y = state[s.Y, j] + t * (state[s.VY, j] + t * state[s.AY, j]) - state[s.Y, i]
    z = (
        state[s.Z, j]
        + t * (state[s.VZ, j] - t * fall_j)
        + state[s.RADIUS, j]
        - state[s.Z, i]
        - state[s.RADIUS, i]
    )
    vx = state[s.VX, j] + 2.0 * t * state[s.AX, j] - state[s.VX, i]
    vy = state[s.VY, j] + 2.0 * t * state[s.AY, j] - state[s.VY, i]
    vz = state[s.VZ, j] - 2.0 * t * fall_j - state[s.VZ, i]
    ax = state[s.AX, j] - state[s.AX, i]
    ay = state[s.AY, j] - state[s.AY, i]
    az = fall_i - fall_j
    reach = state[s.RADIUS, i] + state[s.RADIUS, j]
    horizon = min(min(state[s.OWN_TIME, i], state[s.OWN_TIME, j]) - now, LONGEST_SEARCH)
    distance = math.sqrt(x * x + y * y + z * z)
    c1 = 2.0 * (x * vx + y * vy + z * vz)
    threshold = 2.0 * reach * s.CLOSING_SPEED
    t = first_closing(
        (distance - reach) * (distance + reach),
        c1,
        vx * vx + vy * vy + vz * vz + 2.0 * (x * ax + y * ay + z * az),
        2.0 * (vx * ax + vy * ay + vz * az),
        ax * ax + ay * ay + az * az,
        threshold,
        s.AT_REST if distance - reach <= s.CONTACT_GAP and c1 <= threshold else s.NEVER,
        horizon,
    )
    return t if t >= s.AT_REST else now + t


@inner_kernel
def _meeting_time(state, modes, i, j, now, physics):
    """Time of the next contact of balls i and j, wherever they are, s."""
    if modes[s.MOTION, i] == s.POCKETED or modes[s.MOTION, j] == s.POCKETED:
        return s.NEVER
    if modes[s.MOTION, i] == s.AIRBORNE or modes[s.MOTION, j] == s.AIRBORNE:
        return _time_in_space(state, modes, i, j, now, physics)
    return contact_time(state, i, j, now)


@inner_kernel
def refresh_everywhere(state, modes, pairs, i, physics):
    """Renew all contact times of ball i, which has just changed and whose plan is made."""
    n = state.shape[1]
    flying = 0
    for j in range(n):
        flying += 1 if modes[s.MOTION, j] == s.AIRBORNE else 0
    if flying == 0:
        refresh_pairs(state, modes, pairs, i)
        return
    best = s.NEVER
    partner = -1
    for j in range(n):
        if j == i:
            continue
        t = _meeting_time(state, modes, i, j, state[s.TIME, i], physics)
        pairs[s.MEET, i, j] = t
        pairs[s.MEET, j, i] = t
        if t < best:
            best = t
            partner = j
        if t < state[s.PAIR_TIME, j]:
            state[s.PAIR_TIME, j] = t
            modes[s.PARTNER, j] = i
            state[s.NEXT_TIME, j] = min(t, state[s.OWN_TIME, j])
        elif modes[s.PARTNER, j] == i:
            rescan(state, modes, pairs, j)
    state[s.PAIR_TIME, i] = best
    modes[s.PARTNER, i] = partner
    state[s.NEXT_TIME, i] = min(best, state[s.OWN_TIME, i])
