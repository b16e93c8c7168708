"""Ball on cushion by Han 2005, Dynamics in carom and three cushion billiards (J. Mech. Sci. Tech. 19, 976).

The nose meets the ball above its centre, at the angle th = asin(h/R - 1). There the ball gets a normal
impulse by restitution. The tangential one is the lesser of what stops the slip and what Coulomb friction
allows. In Han's frame X points out of the table and Y = z x X along the rail; E marks the frame tilted by th.
"""

from __future__ import annotations

import math

from game.billiards.laws import state as s
from game.billiards.laws.contacts.cushion_restitution import restitution_at
from game.billiards.laws.lean import inner_kernel


@inner_kernel(inline="always")
def tilted_impulse(sx, sy, c, mass, restitution, friction):
    """Impulse in the tilted frame, (PxE, PyE, PzE) N s, from slip (sx, sy) and normal speed c, m/s."""
    normal = -(1.0 + restitution) * c * mass
    slip = math.sqrt(sx * sx + sy * sy)
    stopping = slip * 2.0 * mass / 7.0
    if slip == 0.0 or stopping <= friction * normal:
        return 2.0 * mass / 7.0 * sx, 2.0 * mass / 7.0 * sy, normal
    return friction * normal * sx / slip, friction * normal * sy / slip, normal


@inner_kernel
def bounce_han_2005(state, i, nx, ny, physics):
    """Bounce of ball i; n is the unit vector from the cushion to the ball. Needs |h/R - 1| < 1."""
    radius = state[s.RADIUS, i]
    mass = state[s.MASS, i]
    sine = physics[s.CUSHION_HEIGHT] / radius - 1.0
    cosine = math.sqrt((1.0 - sine) * (1.0 + sine))
    x0 = -nx
    x1 = -ny
    speed = state[s.VX, i] * x0 + state[s.VY, i] * x1
    restitution = restitution_at(speed, physics)
    along = state[s.VY, i] * x0 - state[s.VX, i] * x1
    spin_x = state[s.WX, i] * x0 + state[s.WY, i] * x1
    spin_y = state[s.WY, i] * x0 - state[s.WX, i] * x1
    sx = speed * sine + radius * spin_y
    sy = -along - radius * state[s.WZ, i] * cosine + radius * spin_x * sine
    px_tilted, py, pz_tilted = tilted_impulse(
        sx, sy, -speed * cosine, mass, restitution, physics[s.CUSHION_FRICTION]
    )
    px = -px_tilted * sine - pz_tilted * cosine
    pz = px_tilted * cosine - pz_tilted * sine
    lever = 2.5 / (mass * radius)
    speed += px / mass
    along += py / mass
    # so steep a contact, or so much spin, does not turn the ball round by the formula: the rail holds it
    speed = min(speed, 0.0)
    spin_x -= lever * py * sine
    spin_y += lever * (px * sine - pz * cosine)
    state[s.VX, i] = speed * x0 - along * x1
    state[s.VY, i] = speed * x1 + along * x0
    state[s.WX, i] = spin_x * x0 - spin_y * x1
    state[s.WY, i] = spin_x * x1 + spin_y * x0
    state[s.WZ, i] += lever * py * cosine
