"""A ball in the air: a parabola, its spin kept. And whether it is one.

z is the height of a ball above where it lies on the slate, so that its lowest point is at z and its centre at
z + R. There is no drag: at 5 m/s it would be a hundredth of the weight of a billiard ball (c_d = 0.47).
"""

from __future__ import annotations

import math

from game.billiards.laws import state as s
from game.billiards.laws.lean import inner_kernel
from game.billiards.laws.motion import advance, enter_phase


@inner_kernel
def advance_anywhere(state, modes, i, now, physics):
    """Bring the state of ball i to `now` (s), on the slate or in the air."""
    if modes[s.MOTION, i] != s.AIRBORNE:
        advance(state, modes, i, now, physics)
        return
    t = now - state[s.TIME, i]
    state[s.TIME, i] = now
    state[s.X, i] += t * state[s.VX, i]
    state[s.Y, i] += t * state[s.VY, i]
    state[s.Z, i] += t * (state[s.VZ, i] - 0.5 * physics[s.GRAVITY] * t)
    state[s.VZ, i] -= physics[s.GRAVITY] * t


@inner_kernel
def enter_air_or_slate(state, modes, i, physics):
    """Start the phase that follows from height and vertical speed of ball i: in the air, or sliding."""
    if state[s.Z, i] <= 0.0 and state[s.VZ, i] <= s.LANDING_SPEED:
        state[s.Z, i] = 0.0
        state[s.VZ, i] = 0.0
        modes[s.AIR_COUNT, i] = 0
        enter_phase(state, modes, i, s.SLIDING, physics)
        return
    modes[s.MOTION, i] = s.AIRBORNE
    state[s.AX, i] = 0.0
    state[s.AY, i] = 0.0
    state[s.PHASE_END, i] = s.NEVER


@inner_kernel(inline="always")
def height_after(state, i, t, physics):
    """Height z of ball i t s from now if it is in the air, m."""
    return state[s.Z, i] + t * (state[s.VZ, i] - 0.5 * physics[s.GRAVITY] * t)


@inner_kernel
def falls_to(z, vz, level, gravity):
    """Time until a ball at z with vertical speed vz falls through a level, s; NEVER if it does not rise to
    it."""
    above = z - level
    square = vz * vz + 2.0 * gravity * above
    if square < 0.0:
        return s.NEVER
    root = math.sqrt(square)
    if vz >= 0.0:
        return (vz + root) / gravity
    return 2.0 * above / (root - vz) if above > 0.0 else s.NEVER
