"""How a ball moves between events: sliding, rolling, spinning, each in closed form.

Frame as in `table`: z up. The slip at the cloth is u = v + w x (0, 0, -R) = (vx - R wy, vy + R wx). Coulomb
friction mu_s m g opposes it, its direction stays, so a sliding ball runs on a parabola and its spin changes
linearly. When the slip is gone the ball rolls, w = (-vy, vx)/R, and slows at mu_r g along its path. Spin
about z falls at 5 mu_sp g/(2 R) meanwhile. (Marlow 1995, The Physics of Pocket Billiards, ch. 4; Leckie and
Greenspan 2006, An event-based pool physics simulator, eq. 4 to 10.)

The phase of ball i stands in the working arrays `state` as position r, velocity v and half acceleration a at
the time TIME: r(t) = r + v t + a t^2. A ball at rest, or spinning in place, has a = v = 0.
"""

from __future__ import annotations

import math

from game.billiards.laws.lean import inner_kernel
from game.billiards.laws.state import (
    AX,
    AY,
    GRAVITY,
    MOTION,
    NEVER,
    PHASE_END,
    RADIUS,
    ROLLING,
    ROLLING_FRICTION,
    ROLLING_SPINNING,
    ROLLING_STATIONARY,
    SLIDING,
    SLIDING_FRICTION,
    SLIDING_ROLLING,
    SPINNING,
    SPINNING_FRICTION,
    SPINNING_STATIONARY,
    STATIONARY,
    TIME,
    VX,
    VY,
    WX,
    WY,
    WZ,
    X,
    Y,
)


@inner_kernel(inline="always")
def spin_after(wz, elapsed, radius, physics):
    """Spin about z, rad/s, `elapsed` s later."""
    lost = 2.5 * physics[SPINNING_FRICTION] * physics[GRAVITY] / radius * elapsed
    if wz > lost:
        return wz - lost
    if wz < -lost:
        return wz + lost
    return 0.0


@inner_kernel
def advance(state, modes, i, time, physics):
    """Bring the state of ball i to `time`, within its phase. Its phase goes on."""
    elapsed = time - state[TIME, i]
    state[TIME, i] = time
    motion = modes[MOTION, i]
    if motion == STATIONARY:
        return
    radius = state[RADIUS, i]
    state[WZ, i] = spin_after(state[WZ, i], elapsed, radius, physics)
    if motion == SPINNING:
        return
    ax = state[AX, i]
    ay = state[AY, i]
    state[X, i] += elapsed * (state[VX, i] + elapsed * ax)
    state[Y, i] += elapsed * (state[VY, i] + elapsed * ay)
    state[VX, i] += 2.0 * elapsed * ax
    state[VY, i] += 2.0 * elapsed * ay
    if motion == ROLLING:
        state[WX, i] = -state[VY, i] / radius
        state[WY, i] = state[VX, i] / radius
    else:
        # the torque of the same friction force: w' = 5/(2 R) (2 a) x z
        state[WX, i] += 5.0 * elapsed * ay / radius
        state[WY, i] -= 5.0 * elapsed * ax / radius


@inner_kernel
def enter_phase(state, modes, i, motion, physics):
    """Start a phase of ball i from its present state: sets a, the phase's end (s), and the motion."""
    modes[MOTION, i] = motion
    now = state[TIME, i]
    radius = state[RADIUS, i]
    gravity = physics[GRAVITY]
    state[AX, i] = 0.0
    state[AY, i] = 0.0
    state[PHASE_END, i] = NEVER
    if motion == SLIDING:
        ux = state[VX, i] - radius * state[WY, i]
        uy = state[VY, i] + radius * state[WX, i]
        slip = math.sqrt(ux * ux + uy * uy)
        force = physics[SLIDING_FRICTION] * gravity
        if slip == 0.0:
            state[PHASE_END, i] = now
        elif force > 0.0:
            state[AX, i] = -0.5 * force * (ux / slip)
            state[AY, i] = -0.5 * force * (uy / slip)
            state[PHASE_END, i] = now + 2.0 * slip / (7.0 * force)
    elif motion == ROLLING:
        vx = state[VX, i]
        vy = state[VY, i]
        speed = math.sqrt(vx * vx + vy * vy)
        force = physics[ROLLING_FRICTION] * gravity
        if speed == 0.0:
            state[PHASE_END, i] = now
        elif force > 0.0:
            state[AX, i] = -0.5 * force * (vx / speed)
            state[AY, i] = -0.5 * force * (vy / speed)
            state[PHASE_END, i] = now + speed / force
    elif motion == SPINNING:
        decay = 2.5 * physics[SPINNING_FRICTION] * gravity / radius
        if decay > 0.0:
            state[PHASE_END, i] = now + abs(state[WZ, i]) / decay


@inner_kernel
def end_phase(state, modes, i, physics):
    """Go to the end of the phase of ball i and into the next; what has run out is exactly zero.

    Returns the event.
    """
    advance(state, modes, i, state[PHASE_END, i], physics)
    motion = modes[MOTION, i]
    if motion == SLIDING:
        state[WX, i] = -state[VY, i] / state[RADIUS, i]
        state[WY, i] = state[VX, i] / state[RADIUS, i]
        enter_phase(state, modes, i, ROLLING, physics)
        return SLIDING_ROLLING
    state[VX, i] = 0.0
    state[VY, i] = 0.0
    state[WX, i] = 0.0
    state[WY, i] = 0.0
    if motion == ROLLING and state[WZ, i] != 0.0:
        enter_phase(state, modes, i, SPINNING, physics)
        return ROLLING_SPINNING
    state[WZ, i] = 0.0
    enter_phase(state, modes, i, STATIONARY, physics)
    return ROLLING_STATIONARY if motion == ROLLING else SPINNING_STATIONARY
