"""What accelerates one particle: gravity, drag, wind, a vortex of air, a pull to a point.

    a = g - (k + q |v - w|) (v - w) - s² (x - c)

with w the velocity of the air. The mask of terms is known when a kernel is compiled. So a term that is not
asked for leaves no instruction behind.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from game.compiler.decorator import lean_kernel
from game.physics.particles.effects import (
    ATTRACTOR_BIT,
    DRAG_BIT,
    GRAVITY_BIT,
    QUADRATIC_BIT,
    WHIRL_BIT,
    WIND_BIT,
)

AIR_BITS = DRAG_BIT | QUADRATIC_BIT  # only with one of these is the air felt
SIDEWAYS_BITS = AIR_BITS | ATTRACTOR_BIT  # without these the horizontal velocity never changes
FORCE_BITS = GRAVITY_BIT | SIDEWAYS_BITS | WIND_BIT | WHIRL_BIT


class Forces(NamedTuple):
    """The numbers of the force law, per unit mass."""

    gravity: float  # g, m/s², downwards
    drag: float  # k, 1/s
    quadratic_drag: float  # q, 1/m
    wind_x: float  # m/s
    wind_y: float  # m/s
    whirl_x: float  # m, centre of the vortex
    whirl_y: float  # m
    whirl_strength: float  # m²/s, circulation / 2π, counter-clockwise
    whirl_core: float  # m, radius within which the air turns as a solid; above 0
    pull_x: float  # m, centre of the pull
    pull_y: float  # m
    pull: float  # s², 1/s²: square of the angular frequency about the centre


@lean_kernel(forceinline=True)
def air_velocity(mask, forces, x, y):
    """Velocity (m/s) of the air at a point: wind, and a Kaufmann (Scully) vortex, strength r/(r² + core²)."""
    wx = 0.0
    wy = 0.0
    if mask & WIND_BIT:
        wx = forces.wind_x
        wy = forces.wind_y
    if mask & WHIRL_BIT:
        rx = x - forces.whirl_x
        ry = y - forces.whirl_y
        turn = forces.whirl_strength / (rx * rx + ry * ry + forces.whirl_core * forces.whirl_core)
        wx = wx - turn * ry
        wy = wy + turn * rx
    return wx, wy


@lean_kernel(forceinline=True)
def field_acceleration(mask, forces, x, y):
    """Acceleration (m/s²) by all that does not depend on the velocity: gravity and the pull."""
    ax = 0.0
    ay = 0.0
    if mask & GRAVITY_BIT:
        ay = -forces.gravity
    if mask & ATTRACTOR_BIT:
        ax = ax - forces.pull * (x - forces.pull_x)
        ay = ay - forces.pull * (y - forces.pull_y)
    return ax, ay


@lean_kernel(forceinline=True)
def acceleration(mask, forces, x, y, vx, vy):
    """Acceleration (m/s²) of a particle at a point with a velocity."""
    ax, ay = field_acceleration(mask, forces, x, y)
    if mask & AIR_BITS:
        wx, wy = air_velocity(mask, forces, x, y)
        rx = vx - wx
        ry = vy - wy
        rate = 0.0
        if mask & DRAG_BIT:
            rate = forces.drag
        if mask & QUADRATIC_BIT:
            rate = rate + forces.quadratic_drag * math.sqrt(rx * rx + ry * ry)
        ax = ax - rate * rx
        ay = ay - rate * ry
    return ax, ay


@lean_kernel(forceinline=True)
def unpack_forces(row):
    """`Forces` from its row of numbers."""
    return Forces(
        row[0], row[1], row[2], row[3], row[4], row[5], row[6], row[7], row[8], row[9], row[10], row[11]
    )
