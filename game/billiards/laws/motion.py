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

from game.billiards.laws import state as s
from game.billiards.laws.lean import inner_kernel


@inner_kernel(inline="always")
def spin_after(wz, elapsed, radius, physics):
    """Spin about z, rad/s, `elapsed` s later."""
    lost = 2.5 * physics[s.SPINNING_FRICTION] * physics[s.GRAVITY] / radius * elapsed
    if wz > lost:
        return wz - lost
    if wz < -lost:
        return wz + lost
    return 0.0


@inner_kernel
def advance(state, modes, i, time, physics):
    """Bring the state of ball i to `time`, within its phase. Its phase goes on."""
    elapsed = time - state[s.TIME, i]
    state[s.TIME, i] = time
    motion = modes[s.MOTION, i]
    if motion == s.STATIONARY:
        return
    radius = state[s.RADIUS, i]
    state[s.WZ, i] = spin_after(state[s.WZ, i], elapsed, radius, physics)
    if motion == s.SPINNING:
        return
    ax = state[s.AX, i]
    ay = state[s.AY, i]
    state[s.X, i] += elapsed * (state[s.VX, i] + elapsed * ax)
    state[s.Y, i] += elapsed * (state[s.VY, i] + elapsed * ay)
    state[s.VX, i] += 2.0 * elapsed * ax
    state[s.VY, i] += 2.0 * elapsed * ay
    if motion == s.ROLLING:
        state[s.WX, i] = -state[s.VY, i] / radius
        state[s.WY, i] = state[s.VX, i] / radius
    else:
        # the torque of the same friction force: w' = 5/(2 R) (2 a) x z
        state[s.WX, i] += 5.0 * elapsed * ay / radius
        state[s.WY, i] -= 5.0 * elapsed * ax / radius


@inner_kernel
def enter_phase(state, modes, i, motion, physics):
    """Start a phase of ball i from its present state: sets a, the phase's end (s), and the motion."""
    modes[s.MOTION, i] = motion
    now = state[s.TIME, i]
    radius = state[s.RADIUS, i]
    gravity = physics[s.GRAVITY]
    state[s.AX, i] = 0.0
    state[s.AY, i] = 0.0
    state[s.PHASE_END, i] = s.NEVER
    if motion == s.SLIDING:
        ux = state[s.VX, i] - radius * state[s.WY, i]
        uy = state[s.VY, i] + radius * state[s.WX, i]
        slip = math.sqrt(ux * ux + uy * uy)
        force = physics[s.SLIDING_FRICTION] * gravity
        if slip == 0.0:
            state[s.PHASE_END, i] = now
        elif force > 0.0:
            state[s.AX, i] = -0.5 * force * (ux / slip)
            state[s.AY, i] = -0.5 * force * (uy / slip)
            state[s.PHASE_END, i] = now + 2.0 * slip / (7.0 * force)
    elif motion == s.ROLLING:
        vx = state[s.VX, i]
        vy = state[s.VY, i]
        speed = math.sqrt(vx * vx + vy * vy)
        force = physics[s.ROLLING_FRICTION] * gravity
        if speed == 0.0:
            state[s.PHASE_END, i] = now
        elif force > 0.0:
            state[s.AX, i] = -0.5 * force * (vx / speed)
            state[s.AY, i] = -0.5 * force * (vy / speed)
            state[s.PHASE_END, i] = now + speed / force
    elif motion == s.SPINNING:
        decay = 2.5 * physics[s.SPINNING_FRICTION] * gravity / radius
        if decay > 0.0:
            state[s.PHASE_END, i] = now + abs(state[s.WZ, i]) / decay


@inner_kernel
def end_phase(state, modes, i, physics):
    """Go to the end of the phase of ball i and into the next; what has run out is exactly zero.

    Returns the event.
    """
    advance(state, modes, i, state[s.PHASE_END, i], physics)
    motion = modes[s.MOTION, i]
    if motion == s.SLIDING:
        state[s.WX, i] = -state[s.VY, i] / state[s.RADIUS, i]
        state[s.WY, i] = state[s.VX, i] / state[s.RADIUS, i]
        enter_phase(state, modes, i, s.ROLLING, physics)
        return s.SLIDING_ROLLING
    state[s.VX, i] = 0.0
    state[s.VY, i] = 0.0
    state[s.WX, i] = 0.0
    state[s.WY, i] = 0.0
    if motion == s.ROLLING and state[s.WZ, i] != 0.0:
        enter_phase(state, modes, i, s.SPINNING, physics)
        return s.ROLLING_SPINNING
    state[s.WZ, i] = 0.0
    enter_phase(state, modes, i, s.STATIONARY, physics)
    return s.ROLLING_STATIONARY if motion == s.ROLLING else s.SPINNING_STATIONARY
