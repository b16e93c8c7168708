"""Ball on ball along the line of centres: Newton's law of restitution, for any two masses.

Balls of different radius are in contact at the horizontal distance 2 sqrt(R1 R2), their line of centres
tilted. The cloth takes the vertical part of the impulse (neglected: that a ball might hop), so the horizontal
part P alone reverses the closing speed. With e = 1 kinetic energy is kept, and equal balls exchange their
normal velocities. (Newton 1687, Principia, Scholium to the laws; Leckie and Greenspan 2006.)
"""

from __future__ import annotations

import math

from game.billiards.laws.lean import inner_kernel
from game.billiards.laws.state import MASS, VX, VY


@inner_kernel(inline="always")
def reach_of(radius_i, radius_j):
    """Horizontal distance at which two balls on the cloth are in contact, 2 sqrt(R1 R2), m."""
    if radius_i == radius_j:
        return 2.0 * radius_i
    return 2.0 * math.sqrt(radius_i * radius_j)


@inner_kernel(inline="always")
def closing_speed(state, i, j, nx, ny):
    """Speed at which i approaches j along the unit vector n from i to j, m/s."""
    return (state[VX, i] - state[VX, j]) * nx + (state[VY, i] - state[VY, j]) * ny


@inner_kernel(inline="always")
def reduced_mass(state, i, j):
    """m1 m2/(m1 + m2), kg."""
    mass_i = state[MASS, i]
    mass_j = state[MASS, j]
    if mass_i == mass_j:
        return 0.5 * mass_i
    return mass_i / (mass_i + mass_j) * mass_j


@inner_kernel(inline="always")
def push_apart(state, i, j, nx, ny, impulse):
    """Give ball j the impulse (N s) along n, and ball i its opposite."""
    to_i = impulse / state[MASS, i]
    to_j = impulse / state[MASS, j]
    state[VX, i] -= to_i * nx
    state[VY, i] -= to_i * ny
    state[VX, j] += to_j * nx
    state[VY, j] += to_j * ny


@inner_kernel(inline="always")
def collide_along_normal(state, i, j, nx, ny, restitution):
    """Turn the closing speed round, times `restitution`. Returns the impulse, N s."""
    impulse = (1.0 + restitution) * reduced_mass(state, i, j) * closing_speed(state, i, j, nx, ny)
    push_apart(state, i, j, nx, ny, impulse)
    return impulse
