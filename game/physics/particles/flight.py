"""One step of free flight of one particle, by each method.

Every method keeps position and velocity at the same instant, so that it may be changed live, restarted at a
contact and begun in mid-step. Sources: Hairer, Lubich, Wanner 2006, "Geometric numerical integration", ch. I
(one-step form of Störmer and Verlet); Swope and others 1982 (velocity Verlet); Strang 1968 (splitting).

The method of Störmer as lectures print it, started with x₋₁ = x₀ - v₀ h and with drag from the difference (xₙ
- xₙ₋₁)/h, is the semi-implicit Euler method letter for letter. It is of first order like it.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from game.compiler.decorator import lean_kernel
from game.physics.kernels import elementary
from game.physics.particles.forces import (
    AIR_BITS,
    DRAG_BIT,
    QUADRATIC_BIT,
    acceleration,
    air_velocity,
    field_acceleration,
)

METHODS = (
    "explicit-euler",
    "semi-implicit-euler",
    "midpoint",
    "verlet",
    "stormer-verlet",
    "rk4",
    "exponential",
)
ORDERS = (1, 1, 2, 2, 2, 4, 2)  # in free flight; the last is exact for gravity, linear drag, steady wind
EVALUATIONS = (1, 1, 2, 2, 2, 4, 1)  # of the force in a step
# the largest stable product of drag and step
STABILITY_LIMITS = (2.0, 2.0, 2.0, 2.0, math.inf, 2.785293563405282, math.inf)

EXPLICIT_EULER, SEMI_IMPLICIT_EULER, MIDPOINT, VERLET, STORMER_VERLET, RK4, EXPONENTIAL = range(7)


class Decay(NamedTuple):
    """What linear drag does to a flight of length h, exactly (all of them functions of k h)."""

    factor: float  # exp(-k h)
    reach: float  # s, (1 - exp(-k h)) / k
    drift: float  # s², (h - reach) / k


@lean_kernel
def decay_over(drag, h):
    """The `Decay` of a drag k (1/s) over h (s), by a series where k h is small."""
    z = drag * h
    if z < 1e-3:
        reach = h * (1.0 - z / 2.0 * (1.0 - z / 3.0 * (1.0 - z / 4.0 * (1.0 - z / 5.0))))
        drift = h * h * (0.5 - z / 6.0 * (1.0 - z / 4.0 * (1.0 - z / 5.0 * (1.0 - z / 6.0))))
        return Decay(elementary.exp(-z), reach, drift)
    reach = -elementary.expm1(-z) / drag
    return Decay(elementary.exp(-z), reach, (h - reach) / drag)


@lean_kernel(forceinline=True)
def explicit_euler(mask, forces, x, y, vx, vy, h):
    """Both from the old state (Euler 1768). Like all steppers here: m and m/s after h s, as four numbers."""
    ax, ay = acceleration(mask, forces, x, y, vx, vy)
    return x + h * vx, y + h * vy, vx + h * ax, vy + h * ay


@lean_kernel(forceinline=True)
def semi_implicit_euler(mask, forces, x, y, vx, vy, h):
    """Velocity first, position with the new velocity; symplectic without drag."""
    ax, ay = acceleration(mask, forces, x, y, vx, vy)
    ux = vx + h * ax
    uy = vy + h * ay
    return x + h * ux, y + h * uy, ux, uy


@lean_kernel(forceinline=True)
def midpoint(mask, forces, x, y, vx, vy, h):
    """Slope in the middle, reached by half an Euler step (Runge 1895)."""
    half = 0.5 * h
    ax, ay = acceleration(mask, forces, x, y, vx, vy)
    ux = vx + half * ax
    uy = vy + half * ay
    bx, by = acceleration(mask, forces, x + half * vx, y + half * vy, ux, uy)
    return x + h * ux, y + h * uy, vx + h * bx, vy + h * by


@lean_kernel(forceinline=True)
def velocity_verlet(mask, forces, x, y, vx, vy, h):
    """Drag at the new point is taken with the predicted velocity v + h a."""
    half = 0.5 * h
    ax, ay = acceleration(mask, forces, x, y, vx, vy)
    x1 = x + h * (vx + half * ax)
    y1 = y + h * (vy + half * ay)
    bx, by = acceleration(mask, forces, x1, y1, vx + h * ax, vy + h * ay)
    return x1, y1, vx + half * (ax + bx), vy + half * (ay + by)


@lean_kernel(forceinline=True)
def stormer_verlet(mask, forces, x, y, vx, vy, h):
    """Central differences, x₋₁ = x₀ - v₀ h + a₀ h²/2; drag at the new point solved for exactly.

    The relative velocity r there obeys r (1 + h k/2 + (h q/2) |r|) = b: a quadratic equation for |r|.
    """
    half = 0.5 * h
    ax, ay = acceleration(mask, forces, x, y, vx, vy)
    ux = vx + half * ax
    uy = vy + half * ay
    x1 = x + h * ux
    y1 = y + h * uy
    fx, fy = field_acceleration(mask, forces, x1, y1)
    ux = ux + half * fx
    uy = uy + half * fy
    if mask & AIR_BITS:
        wx, wy = air_velocity(mask, forces, x1, y1)
        rx = ux - wx
        ry = uy - wy
        divisor = 1.0
        if mask & DRAG_BIT:
            divisor = 1.0 + half * forces.drag
        if mask & QUADRATIC_BIT:
            grip = half * forces.quadratic_drag * math.sqrt(rx * rx + ry * ry)
            divisor = 0.5 * (divisor + math.sqrt(divisor * divisor + 4.0 * grip))
        ux = wx + rx / divisor
        uy = wy + ry / divisor
    return x1, y1, ux, uy


@lean_kernel(forceinline=True)
def runge_kutta_4(mask, forces, x, y, vx, vy, h):
    """The classical method of fourth order (Kutta 1901)."""
    half = 0.5 * h
    ax, ay = acceleration(mask, forces, x, y, vx, vy)
    ux = vx + half * ax
    uy = vy + half * ay
    bx, by = acceleration(mask, forces, x + half * vx, y + half * vy, ux, uy)
    sx = vx + half * bx
    sy = vy + half * by
    cx, cy = acceleration(mask, forces, x + half * ux, y + half * uy, sx, sy)
    tx = vx + h * cx
    ty = vy + h * cy
    dx, dy = acceleration(mask, forces, x + h * sx, y + h * sy, tx, ty)
    sixth = h / 6.0
    return (
        x + sixth * (vx + 2.0 * (ux + sx) + tx),
        y + sixth * (vy + 2.0 * (uy + sy) + ty),
        vx + sixth * (ax + 2.0 * (bx + cx) + dx),
        vy + sixth * (ay + 2.0 * (by + cy) + dy),
    )


@lean_kernel(forceinline=True)
def exponential(mask, forces, decay, x, y, vx, vy, h):
    """Linear drag solved exactly; quadratic drag, exact by itself, half before and half after (Strang).

    The pull and the vortex are taken at the middle of the path.
    """
    half = 0.5 * h
    px = x + half * vx
    py = y + half * vy
    wx = 0.0
    wy = 0.0
    if mask & AIR_BITS:
        wx, wy = air_velocity(mask, forces, px, py)
    fx, fy = field_acceleration(mask, forces, px, py)
    rx = vx - wx
    ry = vy - wy
    if mask & QUADRATIC_BIT:
        slow = 1.0 / (1.0 + half * forces.quadratic_drag * math.sqrt(rx * rx + ry * ry))
        rx = rx * slow
        ry = ry * slow
    x1 = x + h * wx + decay.reach * rx + decay.drift * fx
    y1 = y + h * wy + decay.reach * ry + decay.drift * fy
    rx = decay.factor * rx + decay.reach * fx
    ry = decay.factor * ry + decay.reach * fy
    if mask & QUADRATIC_BIT:
        slow = 1.0 / (1.0 + half * forces.quadratic_drag * math.sqrt(rx * rx + ry * ry))
        rx = rx * slow
        ry = ry * slow
    return x1, y1, wx + rx, wy + ry


@lean_kernel(forceinline=True)
def fly(method, mask, forces, decay, x, y, vx, vy, h):
    """Position and velocity after h (s) of free flight: (x, y, vx, vy)."""
    if method == EXPLICIT_EULER:
        return explicit_euler(mask, forces, x, y, vx, vy, h)
    if method == SEMI_IMPLICIT_EULER:
        return semi_implicit_euler(mask, forces, x, y, vx, vy, h)
    if method == MIDPOINT:
        return midpoint(mask, forces, x, y, vx, vy, h)
    if method == VERLET:
        return velocity_verlet(mask, forces, x, y, vx, vy, h)
    if method == STORMER_VERLET:
        return stormer_verlet(mask, forces, x, y, vx, vy, h)
    if method == RK4:
        return runge_kutta_4(mask, forces, x, y, vx, vy, h)
    return exponential(mask, forces, decay, x, y, vx, vy, h)


@lean_kernel
def fly_alone(method, mask, forces, x, y, vx, vy, h):
    """`fly` for one particle with any method and mask, not specialised."""
    decay = Decay(1.0, h, 0.5 * h * h)
    if method == EXPONENTIAL and mask & DRAG_BIT:
        decay = decay_over(forces.drag, h)
    return fly(method, mask, forces, decay, x, y, vx, vy, h)
