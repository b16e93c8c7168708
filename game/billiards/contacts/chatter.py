"""The rule that ends chatter: contacts that repeat without end in finite time (Zeno's paradox).

A ball pressed against another, or against a rail, by its own spin bounces ever faster and lower. The k-th
further repeat of a contact within CHATTER_TIME, after ALLOWED_REPEATS, leaves with a separating speed of at
least FIRST_SPEED 4^k, at most LARGEST_SPEED. The energy for it is taken from the spin of the balls in the
contact; what they do not have is not given. So no chatter lasts longer than about fifteen contacts in a
row, no balls sink into each other, and energy never rises.
"""

from __future__ import annotations

import math

from game.billiards.contacts.ball_ball_normal import closing_speed, push_apart, reduced_mass
from game.billiards.lean import inner_kernel
from game.billiards.state import MASS, RADIUS, VX, VY, WX, WY, WZ

CHATTER_TIME = 0.02  # s
ALLOWED_REPEATS = 3
FIRST_SPEED = 1e-6  # m/s
LARGEST_SPEED = 3e-3  # m/s; a parting of 2 ms on cloth with mu = 0.2


@inner_kernel(inline="always")
def least_parting_speed(repeats):
    """Separating speed that the rule asks for after so many repeats, at least ALLOWED_REPEATS, m/s."""
    speed = FIRST_SPEED
    for _ in range(repeats - ALLOWED_REPEATS):
        speed *= 4.0
        if speed >= LARGEST_SPEED:
            return LARGEST_SPEED
    return speed


@inner_kernel(inline="always")
def spin_energy(state, i):
    """Rotational energy of ball i, J."""
    radius = state[RADIUS, i]
    square = state[WX, i] * state[WX, i] + state[WY, i] * state[WY, i] + state[WZ, i] * state[WZ, i]
    return 0.2 * state[MASS, i] * radius * radius * square


@inner_kernel(inline="always")
def scale_spin(state, i, factor):
    """Slow all spin of ball i."""
    state[WX, i] *= factor
    state[WY, i] *= factor
    state[WZ, i] *= factor


@inner_kernel(inline="always")
def affordable_speed(parting, wanted, mass, available):
    """Parting speed up to `wanted` that `available` J can pay for, and the share of them that remains."""
    cost = 0.5 * mass * (wanted - parting) * (wanted + parting)
    if cost <= available:
        return wanted, (1.0 - cost / available if available > 0.0 else 1.0)
    return math.sqrt(parting * parting + 2.0 * available / mass), 0.0


@inner_kernel(inline="always")
def part_balls(state, i, j, nx, ny, wanted):
    """Raise the parting speed of two balls to `wanted` m/s, at the cost of their spin."""
    parting = -closing_speed(state, i, j, nx, ny)
    if parting >= wanted:
        return
    parting = max(parting, 0.0)
    mass = reduced_mass(state, i, j)
    available = spin_energy(state, i) + spin_energy(state, j)
    speed, left = affordable_speed(parting, wanted, mass, available)
    push_apart(state, i, j, nx, ny, mass * (speed + closing_speed(state, i, j, nx, ny)))
    factor = math.sqrt(left)
    scale_spin(state, i, factor)
    scale_spin(state, j, factor)


@inner_kernel(inline="always")
def part_from_rail(state, i, nx, ny, wanted):
    """Raise the speed at which ball i leaves a rail to `wanted` m/s, at the cost of its spin."""
    parting = state[VX, i] * nx + state[VY, i] * ny
    if parting >= wanted:
        return
    speed, left = affordable_speed(max(parting, 0.0), wanted, state[MASS, i], spin_energy(state, i))
    state[VX, i] += (speed - parting) * nx
    state[VY, i] += (speed - parting) * ny
    scale_spin(state, i, math.sqrt(left))
