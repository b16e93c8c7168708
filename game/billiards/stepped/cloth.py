"""One step of a ball on the cloth: friction first, then the displacement with the new velocity.

Semi-implicit Euler. Friction is that of `motion`: mu_s m g against the slip u = (vx - R wy, vy + R wx) while
the ball slides, mu_r m g against the velocity while it rolls; the spin about z falls at 5 mu_sp g/(2 R).
What friction would turn round within the step it stops: then the ball rolls, or rests. (Marlow 1995, The
Physics of Pocket Billiards, ch. 4.)

Needs steps that are short against the time in which a phase ends, a few tenths of a second for a slide. Any
step is stable, for friction never does more than stop.

Arrays: state (FLOAT_ROWS, n), modes (INTEGER_ROWS, n) and physics (20,), see `state`.
"""

from __future__ import annotations

import math

from game.billiards.laws.lean import lean_kernel
from game.billiards.laws.motion import spin_after
from game.billiards.laws.state import (
    GRAVITY,
    MOTION,
    NO_EVENT,
    RADIUS,
    ROLLING,
    ROLLING_FRICTION,
    ROLLING_SPINNING,
    ROLLING_STATIONARY,
    SLIDING,
    SLIDING_FRICTION,
    SLIDING_ROLLING,
    SPINNING,
    SPINNING_STATIONARY,
    STATIONARY,
    VX,
    VY,
    WX,
    WY,
    WZ,
    X,
    Y,
)


@lean_kernel
def slide(state, modes, i, dt, physics):
    """Friction of a sliding ball in one step. Returns the event."""
    radius = state[RADIUS, i]
    ux = state[VX, i] - radius * state[WY, i]
    uy = state[VY, i] + radius * state[WX, i]
    slip = math.sqrt(ux * ux + uy * uy)
    most = physics[SLIDING_FRICTION] * physics[GRAVITY] * dt
    stopping = 2.0 / 7.0 * slip
    share = most / slip if stopping > most else 2.0 / 7.0
    state[VX, i] -= share * ux
    state[VY, i] -= share * uy
    if stopping > most:
        lever = 2.5 * share / radius
        state[WX, i] -= lever * uy
        state[WY, i] += lever * ux
        return NO_EVENT
    state[WX, i] = -state[VY, i] / radius
    state[WY, i] = state[VX, i] / radius
    modes[MOTION, i] = ROLLING
    return SLIDING_ROLLING


@lean_kernel
def roll(state, modes, i, dt, physics):
    """Friction of a rolling ball in one step. Returns the event."""
    vx = state[VX, i]
    vy = state[VY, i]
    speed = math.sqrt(vx * vx + vy * vy)
    lost = physics[ROLLING_FRICTION] * physics[GRAVITY] * dt
    left = 1.0 - lost / speed if speed > lost else 0.0
    radius = state[RADIUS, i]
    state[VX, i] = left * vx
    state[VY, i] = left * vy
    state[WX, i] = -left * vy / radius
    state[WY, i] = left * vx / radius
    if left > 0.0:
        return NO_EVENT
    if state[WZ, i] != 0.0:
        modes[MOTION, i] = SPINNING
        return ROLLING_SPINNING
    modes[MOTION, i] = STATIONARY
    return ROLLING_STATIONARY


@lean_kernel
def step_on_cloth(state, modes, i, dt, physics):
    """Friction and displacement of ball i in one step of dt s. Returns the event."""
    motion = modes[MOTION, i]
    state[WZ, i] = spin_after(state[WZ, i], dt, state[RADIUS, i], physics)
    if motion == SPINNING:
        if state[WZ, i] != 0.0:
            return NO_EVENT
        modes[MOTION, i] = STATIONARY
        return SPINNING_STATIONARY
    event = slide(state, modes, i, dt, physics) if motion == SLIDING else roll(state, modes, i, dt, physics)
    state[X, i] += dt * state[VX, i]
    state[Y, i] += dt * state[VY, i]
    return event
