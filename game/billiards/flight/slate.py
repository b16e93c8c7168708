"""Ball on slate: the bounce, and how a stroke with a raised cue or a cushion presses a ball down.

Newton's restitution e for the normal speed, and Coulomb's friction mu_s for the slip, with the impulse
m (1 + e)|v_z| in place of m g dt: the tangential impulse is the lesser of mu_s times it and of what stops the
slip, 2/7 m |u|. Spin about z loses 5/2 mu_sp of it over m R. (Cross 2002, Grip-slip behavior of a bouncing
ball, Am. J. Phys. 70, 1093; Marlow 1995, The Physics of Pocket Billiards, ch. 4, for the cloth's laws.)

No impulse at the lowest point changes (5 v + 2 R w x z)/7, the velocity at which the ball will roll: a masse
ends in the same direction whether or not the ball hopped first (Coriolis 1835; Alciatore, technical proof
A.19).
"""

from __future__ import annotations

import math

from game.billiards.laws import state as s
from game.billiards.laws.lean import inner_kernel


@inner_kernel
def bounce_on_level(state, i, physics):
    """Ball i meets a level from above, v_z < 0. It stays down if it would rise at LANDING_SPEED or less."""
    press_on_level(state, i, physics[s.SLATE_RESTITUTION], physics)


@inner_kernel
def press_on_level(state, i, restitution, physics):
    """`bounce_on_level` with another restitution."""
    closing = -state[s.VZ, i]
    if restitution * closing <= s.LANDING_SPEED:
        restitution = 0.0
    state[s.VZ, i] = restitution * closing
    pressed = (1.0 + restitution) * closing  # impulse over mass, m/s
    radius = state[s.RADIUS, i]
    ux = state[s.VX, i] - radius * state[s.WY, i]
    uy = state[s.VY, i] + radius * state[s.WX, i]
    slip = math.sqrt(ux * ux + uy * uy)
    if slip > 0.0:
        share = min(physics[s.SLIDING_FRICTION] * pressed, 2.0 / 7.0 * slip) / slip
        state[s.VX, i] -= share * ux
        state[s.VY, i] -= share * uy
        state[s.WX, i] -= 2.5 * share * uy / radius
        state[s.WY, i] += 2.5 * share * ux / radius
    lost = 2.5 * physics[s.SPINNING_FRICTION] * pressed / radius
    state[s.WZ, i] = math.copysign(max(abs(state[s.WZ, i]) - lost, 0.0), state[s.WZ, i])
