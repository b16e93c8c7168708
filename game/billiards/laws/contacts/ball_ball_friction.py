"""Ball on ball across the line of centres: Coulomb friction, which throws and passes spin on.

The surfaces slip at c = v1 - v2 + (R1 w1 + R2 w2) x n3 less its part along the true normal n3. The
tangential impulse opposes c; it is mu times the normal impulse, but never more than what stops the slip,
|c|/(3.5 (1/m1 + 1/m2)) for solid spheres. (Wallace and Schroeder 1988, Analysis of billiard ball collisions
in two dimensions, Am. J. Phys. 56, 815; Alciatore, technical proofs A.5 and A.14, for the law of mu.)

The vertical part of that impulse turns the balls but does not lift them: the cloth takes it. Unequal balls
meet along n3 = (2 sqrt(R1 R2) n, R2 - R1)/(R1 + R2), where the normal impulse is P/cos phi.

Two forms of the limit:
- the reference's (`frictional`, `frictional-alciatore`) takes e |closing speed| for the normal impulse;
- the physical one (`wallace-1988`, `alciatore-2006`) takes the impulse itself, (1 + e)/2 |closing speed|.
"""

from __future__ import annotations

import math

from game.billiards.laws import state as s
from game.billiards.laws.contacts import ALCIATORE_FRICTION
from game.billiards.laws.lean import inner_kernel
from game.physics.kernels import elementary


@inner_kernel(inline="always")
def friction_limit(slip, impulse, physics):
    """Most that friction may do at a slip speed (m/s), for a normal impulse (its horizontal part), N s.

    mu is constant, or Alciatore's fit to Marlow's measurements (A.14, eq. 13).
    """
    mu = physics[s.BALL_FRICTION]
    if physics[s.BALL_LAW] == ALCIATORE_FRICTION:
        mu = 0.009951 + 0.108 * elementary.exp(-1.088 * slip)
    return mu * physics[s.BALL_LIMIT] * impulse


@inner_kernel
def slip_between(state, i, j, nx, ny):
    """Slip of the surface of i on that of j, c (3 numbers), m/s; and cos phi, of the true normal's tilt."""
    radius_i = state[s.RADIUS, i]
    radius_j = state[s.RADIUS, j]
    cosine = 1.0
    sine = 0.0
    if radius_i != radius_j:
        sine = (radius_j - radius_i) / (radius_i + radius_j)
        cosine = 2.0 * math.sqrt(radius_i * radius_j) / (radius_i + radius_j)
    n3x = cosine * nx
    n3y = cosine * ny
    wx = radius_i * state[s.WX, i] + radius_j * state[s.WX, j]
    wy = radius_i * state[s.WY, i] + radius_j * state[s.WY, j]
    wz = radius_i * state[s.WZ, i] + radius_j * state[s.WZ, j]
    cx = state[s.VX, i] - state[s.VX, j] + (wy * sine - wz * n3y)
    cy = state[s.VY, i] - state[s.VY, j] + (wz * n3x - wx * sine)
    cz = wx * n3y - wy * n3x
    along = cx * n3x + cy * n3y + cz * sine
    return cx - along * n3x, cy - along * n3y, cz - along * sine, cosine


@inner_kernel(inline="always")
def torque_direction(state, i, j, nx, ny, px, py, pz):
    """n3 x p, which turns both balls alike when i gets the impulse p (N s) and j its opposite."""
    radius_i = state[s.RADIUS, i]
    radius_j = state[s.RADIUS, j]
    if radius_i == radius_j:
        return ny * pz, -nx * pz, nx * py - ny * px
    sine = (radius_j - radius_i) / (radius_i + radius_j)
    cosine = 2.0 * math.sqrt(radius_i * radius_j) / (radius_i + radius_j)
    return cosine * ny * pz - sine * py, sine * px - cosine * nx * pz, cosine * (nx * py - ny * px)


@inner_kernel(inline="always")
def rub(state, i, j, nx, ny, px, py, pz):
    """Apply the tangential impulse p (N s) to ball i and its opposite to ball j, with their torques."""
    turn_x, turn_y, turn_z = torque_direction(state, i, j, nx, ny, px, py, pz)
    inverse_i = 1.0 / state[s.MASS, i]
    inverse_j = 1.0 / state[s.MASS, j]
    state[s.VX, i] += px * inverse_i
    state[s.VY, i] += py * inverse_i
    state[s.VX, j] -= px * inverse_j
    state[s.VY, j] -= py * inverse_j
    lever_i = 2.5 * inverse_i / state[s.RADIUS, i]
    lever_j = 2.5 * inverse_j / state[s.RADIUS, j]
    state[s.WX, i] += lever_i * turn_x
    state[s.WY, i] += lever_i * turn_y
    state[s.WZ, i] += lever_i * turn_z
    state[s.WX, j] += lever_j * turn_x
    state[s.WY, j] += lever_j * turn_y
    state[s.WZ, j] += lever_j * turn_z


@inner_kernel(inline="always")
def sticking_impulse(state, i, j, slip):
    """Tangential impulse that stops a slip of two solid spheres, N s."""
    return slip / (3.5 * (1.0 / state[s.MASS, i] + 1.0 / state[s.MASS, j]))


@inner_kernel
def rub_in_contact(state, i, j, nx, ny, impulse, physics):
    """Friction of one contact whose normal impulse was `impulse` (horizontal part, N s)."""
    cx, cy, cz, cosine = slip_between(state, i, j, nx, ny)
    slip = math.sqrt(cx * cx + cy * cy + cz * cz)
    if slip == 0.0:
        return
    limit = friction_limit(slip, impulse, physics) / cosine
    share = -min(limit, sticking_impulse(state, i, j, slip)) / slip
    rub(state, i, j, nx, ny, share * cx, share * cy, share * cz)
