"""Ball on cushion with a compliant nose, after Stronge 2000, Impact Mechanics (Cambridge, ch. 5).

As in `cushion_han_2005`, the nose meets the ball at the angle th = asin(h/R - 1) above its centre. The
impulse is found in the frame tilted by th, where the normal and the tangential motion of a sphere do not mix.
Stronge puts two springs between the bodies, one along the normal and one across it, softer by eta^2. The
normal one is stiffer in restitution than in compression by 1/e^2, so that it gives e^2 of its work back (the
energetic restitution). The tangential one holds the surface while its force is below mu times the normal
force, and follows the slip at that limit else. So a ball that comes in with spin may leave with its surface
moving the other way, which no rigid law gives.

Stronge follows one direction of slip; here the deflection is a vector (both slide together), and its
motion is stepped: STEPS in compression, as many in restitution, along the normal's own sine. With
STEPS = 64 the velocities are right to 2e-3 of the ball's speed.
"""

from __future__ import annotations

import math

from game.billiards.laws import state as s
from game.billiards.laws.contacts.cushion_restitution import restitution_at
from game.billiards.laws.lean import inner_kernel
from game.physics.kernels import elementary

STEPS = 64


@inner_kernel
def compliant_impulse(sx, sy, closing, restitution, friction, compliance):
    """Tangential impulse per unit of mass, (Px, Py) m/s, from slip (sx, sy) and closing speed, m/s.

    Time is counted in the normal spring's own, so its compression is a quarter of a turn. The force of the
    normal spring per unit of mass is c sin(t) in compression and c cos((t - pi/2)/e) in restitution.
    """
    inertia = 2.0 / 7.0  # share of the ball's mass that resists the slip of its surface
    ux = 0.0
    uy = 0.0
    total_x = 0.0
    total_y = 0.0
    for phase in range(2):
        scale = 1.0 if phase == 0 else restitution
        step = 0.5 * math.pi / STEPS * scale
        for k in range(STEPS):
            turn = 0.5 * math.pi * (k + 0.5) / STEPS
            limit = friction * closing * (elementary.sin(turn) if phase == 0 else elementary.cos(turn))
            ux += 0.5 * step * sx
            uy += 0.5 * step * sy
            stretch = math.sqrt(ux * ux + uy * uy)
            if stretch > limit * compliance:
                share = limit * compliance / stretch
                ux *= share
                uy *= share
            px = -step * ux / compliance
            py = -step * uy / compliance
            total_x += px
            total_y += py
            sx += px / inertia
            sy += py / inertia
            ux += 0.5 * step * sx
            uy += 0.5 * step * sy
    return total_x, total_y


@inner_kernel
def bounce_stronge_2000(state, i, nx, ny, physics):
    """Bounce of ball i; n is the unit vector from the cushion to the ball. Needs |h/R - 1| < 1."""
    radius = state[s.RADIUS, i]
    mass = state[s.MASS, i]
    sine = physics[s.CUSHION_HEIGHT] / radius - 1.0
    cosine = math.sqrt((1.0 - sine) * (1.0 + sine))
    x0 = -nx
    x1 = -ny
    speed = state[s.VX, i] * x0 + state[s.VY, i] * x1
    along = state[s.VY, i] * x0 - state[s.VX, i] * x1
    spin_x = state[s.WX, i] * x0 + state[s.WY, i] * x1
    spin_y = state[s.WY, i] * x0 - state[s.WX, i] * x1
    restitution = restitution_at(speed, physics)
    # slip as in Han's frame: the impulse on the ball is against it, so its sign there is turned round
    sx = speed * sine + radius * spin_y
    sy = -along - radius * state[s.WZ, i] * cosine + radius * spin_x * sine
    closing = speed * cosine
    px_tilted, py = compliant_impulse(
        sx, sy, closing, restitution, physics[s.CUSHION_FRICTION], physics[s.CUSHION_COMPLIANCE]
    )
    px_tilted *= -mass
    py *= -mass
    pz_tilted = (1.0 + restitution) * closing * mass
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
