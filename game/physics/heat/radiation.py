"""Cooling by radiation, exactly: dT/dt = -b (T⁴ - Ta⁴), with b = ε σ A / C (1/(K³ s)).

With x = T / Ta and s = ln(|x - 1| / (x + 1)) the solution is, for x > 1, s - 2 atan x = s0 - 2 atan x0 - 4
Ta³ b t, and for x < 1 s - 2 atan x with the signs of both sides turned; both sides are monotone in s and bend
one way only, so Newton's steps come to it from one side. However long the step, T never passes Ta.
"""

from __future__ import annotations

import math

from game.physics.kernels import elementary
from game.physics.kernels.lean import inner_kernel, lean_kernel

STEFAN_BOLTZMANN = 5.670374419e-8  # W/(m² K⁴)
MOST_NEWTON = 60
SMALL = 5e-4  # b T³ dt below which the series will do


@inner_kernel
def _above(x0, way):
    """x > 1 after ``way`` = 4 Ta³ b t."""
    s0 = elementary.log((x0 - 1.0) / (x0 + 1.0)) if x0 < 1e8 else -2.0 / x0
    goal = s0 - 2.0 * elementary.atan(x0) - way
    s = s0 - way * 0.5 * (x0 * x0 + 1.0) if x0 < 1e8 else s0 - way * 0.5 * x0 * x0
    for _ in range(MOST_NEWTON):
        if s < -700.0:
            s = goal + 0.5 * math.pi  # x is 1: the rest is a straight line
            break
        x = -1.0 / elementary.tanh(0.5 * s)
        change = (goal - (s - 2.0 * elementary.atan(x))) * 0.5 * (x * x + 1.0)
        s += change
        if abs(change) <= 4e-16 * abs(s):
            break
    return -1.0 / elementary.tanh(0.5 * s) if s > -700.0 else 1.0


@inner_kernel
def _below(x0, way):
    """x < 1 after ``way`` = 4 Ta³ b t."""
    s0 = elementary.log((1.0 - x0) / (1.0 + x0))
    goal = s0 - 2.0 * elementary.atan(x0) - way
    s = s0
    for _ in range(MOST_NEWTON):
        x = -elementary.tanh(0.5 * s)
        change = (goal - (s - 2.0 * elementary.atan(x))) * 0.5 * (1.0 + x * x)
        s += change
        if abs(change) <= 4e-16 * abs(s):
            break
    return -elementary.tanh(0.5 * s)


@inner_kernel
def cooled_inside(start, ambient, rate, dt):
    """`cooled`, for other kernels."""
    if not rate * dt > 0.0 or start == ambient:
        return start
    most = max(start, ambient)
    small = rate * dt * most * most * most
    if small < SMALL:  # four terms of Taylor's series: what follows is below 1e-12 of T
        f = rate * (start * start * start * start - ambient * ambient * ambient * ambient)
        slope, bend = 4.0 * rate * start * start * start, 12.0 * rate * start * start
        third = f * slope * slope + f * f * bend
        return start - dt * (f - dt * (0.5 * f * slope - dt * third / 6.0))
    if ambient < 1e-3 * start:  # as into empty space; what is left out is (Ta / T)⁴ of the rate
        lower = start / elementary.cbrt(1.0 + 3.0 * rate * dt * start * start * start)
        if lower > 1e3 * ambient or ambient == 0.0:
            return lower
    x, way = start / ambient, 4.0 * rate * dt * ambient * ambient * ambient
    if x > 1.0:
        return min(max(ambient * _above(x, way), ambient), start)
    return max(min(ambient * _below(x, way), ambient), start)


@lean_kernel
def cooled(start, ambient, rate, dt):
    """Temperature (K) after dt (s) of radiating to an ambient (K); rate: b, 1/(K³ s). All at least 0."""
    return cooled_inside(float(start), float(ambient), float(rate), float(dt))
