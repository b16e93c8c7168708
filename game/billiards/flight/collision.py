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
from game.billiards.laws import state as s
from game.billiards.laws.contacts import NO_FRICTION
from game.billiards.laws.contacts.ball_ball_friction import friction_limit, sticking_impulse
from game.billiards.laws.lean import inner_kernel


@inner_kernel
def _push(state, i, px, py, pz):
    """Give ball i an impulse, N s."""
    state[s.VX, i] += px / state[s.MASS, i]
    state[s.VY, i] += py / state[s.MASS, i]
    state[s.VZ, i] += pz / state[s.MASS, i]


@inner_kernel
def _turn(state, i, tx, ty, tz):
    """Turn ball i by R t, t in N s."""
    lever = 2.5 / (state[s.MASS, i] * state[s.RADIUS, i])
    state[s.WX, i] += lever * tx
    state[s.WY, i] += lever * ty
    state[s.WZ, i] += lever * tz


@inner_kernel
def _rub(state, i, j, nx, ny, nz, impulse, physics):
    """Friction of a contact along n with the normal impulse `impulse`, N s."""
    wx = state[s.RADIUS, i] * state[s.WX, i] + state[s.RADIUS, j] * state[s.WX, j]
    wy = state[s.RADIUS, i] * state[s.WY, i] + state[s.RADIUS, j] * state[s.WY, j]
    wz = state[s.RADIUS, i] * state[s.WZ, i] + state[s.RADIUS, j] * state[s.WZ, j]
    cx = state[s.VX, i] - state[s.VX, j] + wy * nz - wz * ny
    cy = state[s.VY, i] - state[s.VY, j] + wz * nx - wx * nz
    cz = state[s.VZ, i] - state[s.VZ, j] + wx * ny - wy * nx
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
    nx = state[s.X, j] - state[s.X, i]
    ny = state[s.Y, j] - state[s.Y, i]
    nz = state[s.Z, j] + state[s.RADIUS, j] - state[s.Z, i] - state[s.RADIUS, i]
    distance = math.sqrt(nx * nx + ny * ny + nz * nz)
    nx /= distance
    ny /= distance
    nz /= distance
    closing = (state[s.VX, i] - state[s.VX, j]) * nx + (state[s.VY, i] - state[s.VY, j]) * ny
    closing += (state[s.VZ, i] - state[s.VZ, j]) * nz
    if closing <= 0.0:
        return
    flat = nx * nx + ny * ny
    holds_i = state[s.Z, i] <= 0.0 and nz > 0.0
    holds_j = state[s.Z, j] <= 0.0 and nz < 0.0
    give = (flat if holds_i else 1.0) / state[s.MASS, i] + (flat if holds_j else 1.0) / state[s.MASS, j]
    restitution = physics[s.BALL_RESTITUTION]
    if holds_i or holds_j:
        restitution = max(restitution, min(s.LANDING_SPEED / closing, 1.0))
    impulse = (1.0 + restitution) * closing / give
    _push(state, i, -impulse * nx, -impulse * ny, -impulse * nz)
    _push(state, j, impulse * nx, impulse * ny, impulse * nz)
    smooth = closing <= s.LANDING_SPEED and (holds_i or holds_j)
    if physics[s.BALL_LAW] != NO_FRICTION and not smooth:
        _rub(state, i, j, nx, ny, nz, impulse, physics)
    for ball in (i, j):
        if state[s.Z, ball] <= 0.0 and state[s.VZ, ball] < 0.0:
            if smooth:
                state[s.VZ, ball] = 0.0
            else:
                press_on_level(state, ball, 0.0, physics)


@inner_kernel
def meet_in_air(state, modes, i, j, now, physics):
    """Balls i and j, one of them in the air, come into contact at `now` (s); both begin a new phase."""
    advance_anywhere(state, modes, i, now, physics)
    advance_anywhere(state, modes, j, now, physics)
    collide_in_space(state, i, j, physics)
    modes[s.MEMBER, 0] = i
    modes[s.MEMBER, 1] = j
    for ball in (i, j):
        modes[s.AIR_COUNT, ball] += 1
        enter_air_or_slate(state, modes, ball, physics)
