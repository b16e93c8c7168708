"""Two balls meet, one at least of them in the air: the laws of ball on ball along any line of centres.

n points from the centre of i to that of j. The normal impulse is (1 + e) times the closing speed over the sum
of the inverse masses, the tangential one as in `contacts.ball_ball_friction`, in three dimensions.

A ball that lies and is pressed down is held by the slate while the two collide: its inverse mass counts along
the bed only, 1/m (n_x^2 + n_y^2), and the slate rubs on it (`slate`) without giving anything back. Taken one
after the other instead, ball on ball, ball on slate, ball on ball again, ..., the impacts of one moment would
not end.

No ball comes off such a contact more slowly than at LANDING_SPEED, unless it came more slowly; then the
contact is elastic and smooth. Else a ball that comes down on another would bounce without end in finite time.
It slides off in small hops instead, and energy does not rise.
"""

from __future__ import annotations

import math

from game.billiards.flight.air import advance_anywhere, enter_air_or_slate
from game.billiards.flight.slate import press_on_level
from game.billiards.laws.contacts import NO_FRICTION
from game.billiards.laws.contacts.ball_ball_friction import friction_limit, sticking_impulse
from game.billiards.laws.lean import inner_kernel
from game.billiards.laws.state import (
    AIR_COUNT,
    BALL_LAW,
    BALL_RESTITUTION,
    LANDING_SPEED,
    MASS,
    MEMBER,
    RADIUS,
    VX,
    VY,
    VZ,
    WX,
    WY,
    WZ,
    X,
    Y,
    Z,
)


@inner_kernel
def _push(state, i, px, py, pz):
    """Give ball i an impulse, N s."""
    state[VX, i] += px / state[MASS, i]
    state[VY, i] += py / state[MASS, i]
    state[VZ, i] += pz / state[MASS, i]


@inner_kernel
def _turn(state, i, tx, ty, tz):
    """Turn ball i by R t, t in N s."""
    lever = 2.5 / (state[MASS, i] * state[RADIUS, i])
    state[WX, i] += lever * tx
    state[WY, i] += lever * ty
    state[WZ, i] += lever * tz


@inner_kernel
def _rub(state, i, j, nx, ny, nz, impulse, physics):
    """Friction of a contact along n with the normal impulse `impulse`, N s."""
    wx = state[RADIUS, i] * state[WX, i] + state[RADIUS, j] * state[WX, j]
    wy = state[RADIUS, i] * state[WY, i] + state[RADIUS, j] * state[WY, j]
    wz = state[RADIUS, i] * state[WZ, i] + state[RADIUS, j] * state[WZ, j]
    cx = state[VX, i] - state[VX, j] + wy * nz - wz * ny
    cy = state[VY, i] - state[VY, j] + wz * nx - wx * nz
    cz = state[VZ, i] - state[VZ, j] + wx * ny - wy * nx
    along = cx * nx + cy * ny + cz * nz
    cx -= along * nx
    cy -= along * ny
    cz -= along * nz
    slip = math.sqrt(cx * cx + cy * cy + cz * cz)
    if slip == 0.0:
        return
    share = -min(friction_limit(slip, impulse, physics), sticking_impulse(state, i, j, slip)) / slip
    px = share * cx
    py = share * cy
    pz = share * cz
    _push(state, i, px, py, pz)
    _push(state, j, -px, -py, -pz)
    for ball in (i, j):
        _turn(state, ball, ny * pz - nz * py, nz * px - nx * pz, nx * py - ny * px)


@inner_kernel
def collide_in_space(state, i, j, physics):
    """Balls i and j, both at the same time, collide where they are. The lying one is pressed on the slate."""
    nx = state[X, j] - state[X, i]
    ny = state[Y, j] - state[Y, i]
    nz = state[Z, j] + state[RADIUS, j] - state[Z, i] - state[RADIUS, i]
    distance = math.sqrt(nx * nx + ny * ny + nz * nz)
    nx /= distance
    ny /= distance
    nz /= distance
    closing = (state[VX, i] - state[VX, j]) * nx + (state[VY, i] - state[VY, j]) * ny
    closing += (state[VZ, i] - state[VZ, j]) * nz
    if closing <= 0.0:
        return
    flat = nx * nx + ny * ny
    holds_i = state[Z, i] <= 0.0 and nz > 0.0
    holds_j = state[Z, j] <= 0.0 and nz < 0.0
    give = (flat if holds_i else 1.0) / state[MASS, i] + (flat if holds_j else 1.0) / state[MASS, j]
    restitution = physics[BALL_RESTITUTION]
    if holds_i or holds_j:
        restitution = max(restitution, min(LANDING_SPEED / closing, 1.0))
    impulse = (1.0 + restitution) * closing / give
    _push(state, i, -impulse * nx, -impulse * ny, -impulse * nz)
    _push(state, j, impulse * nx, impulse * ny, impulse * nz)
    smooth = closing <= LANDING_SPEED and (holds_i or holds_j)
    if physics[BALL_LAW] != NO_FRICTION and not smooth:
        _rub(state, i, j, nx, ny, nz, impulse, physics)
    for ball in (i, j):
        if state[Z, ball] <= 0.0 and state[VZ, ball] < 0.0:
            if smooth:
                state[VZ, ball] = 0.0
            else:
                press_on_level(state, ball, 0.0, physics)


@inner_kernel
def meet_in_air(state, modes, i, j, now, physics):
    """Balls i and j, one of them in the air, come into contact at `now` (s); both begin a new phase."""
    advance_anywhere(state, modes, i, now, physics)
    advance_anywhere(state, modes, j, now, physics)
    collide_in_space(state, i, j, physics)
    modes[MEMBER, 0] = i
    modes[MEMBER, 1] = j
    for ball in (i, j):
        modes[AIR_COUNT, ball] += 1
        enter_air_or_slate(state, modes, ball, physics)
