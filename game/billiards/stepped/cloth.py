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

from game.billiards.laws import state as s
from game.billiards.laws.lean import lean_kernel
from game.billiards.laws.motion import spin_after


@lean_kernel
def slide(state, modes, i, dt, physics):
    """Friction of a sliding ball in one step. Returns the event."""
    radius = state[s.RADIUS, i]
    ux = state[s.VX, i] - radius * state[s.WY, i]
    uy = state[s.VY, i] + radius * state[s.WX, i]
    slip = math.sqrt(ux * ux + uy * uy)
    most = physics[s.SLIDING_FRICTION] * physics[s.GRAVITY] * dt
    stopping = 2.0 / 7.0 * slip
    share = most / slip if stopping > most else 2.0 / 7.0
    state[s.VX, i] -= share * ux
    state[s.VY, i] -= share * uy
    if stopping > most:
        lever = 2.5 * share / radius
        state[s.WX, i] -= lever * uy
        state[s.WY, i] += lever * ux
        return s.NO_EVENT
    state[s.WX, i] = -state[s.VY, i] / radius
    state[s.WY, i] = state[s.VX, i] / radius
    modes[s.MOTION, i] = s.ROLLING
    return s.SLIDING_ROLLING


@lean_kernel
def roll(state, modes, i, dt, physics):
    """Friction of a rolling ball in one step. Returns the event."""
    vx = state[s.VX, i]
    vy = state[s.VY, i]
    speed = math.sqrt(vx * vx + vy * vy)
    lost = physics[s.ROLLING_FRICTION] * physics[s.GRAVITY] * dt
    left = 1.0 - lost / speed if speed > lost else 0.0
    radius = state[s.RADIUS, i]
    state[s.VX, i] = left * vx
    state[s.VY, i] = left * vy
    state[s.WX, i] = -left * vy / radius
    state[s.WY, i] = left * vx / radius
    if left > 0.0:
        return s.NO_EVENT
    if state[s.WZ, i] != 0.0:
        modes[s.MOTION, i] = s.SPINNING
        return s.ROLLING_SPINNING
    modes[s.MOTION, i] = s.STATIONARY
    return s.ROLLING_STATIONARY


@lean_kernel
def step_on_cloth(state, modes, i, dt, physics):
    """Friction and displacement of ball i in one step of dt s. Returns the event."""
    motion = modes[s.MOTION, i]
    state[s.WZ, i] = spin_after(state[s.WZ, i], dt, state[s.RADIUS, i], physics)
    if motion == s.SPINNING:
        if state[s.WZ, i] != 0.0:
            return s.NO_EVENT
        modes[s.MOTION, i] = s.STATIONARY
        return s.SPINNING_STATIONARY
    event = slide(state, modes, i, dt, physics) if motion == s.SLIDING else roll(state, modes, i, dt, physics)
    state[s.X, i] += dt * state[s.VX, i]
    state[s.Y, i] += dt * state[s.VY, i]
    return event
