"""Cooling by radiation, exactly: dT/dt = -b (T⁴ - Ta⁴), with b = ε σ A / C (1/(K³ s)).

With x = T / Ta and s = ln(|x - 1| / (x + 1)) the solution is, for x > 1, s - 2 atan x = s0 - 2 atan x0 - 4
Ta³ b t, and for x < 1 s - 2 atan x with the signs of both sides turned. Both sides are monotone in s and bend
one way only, so Newton's steps come to it from one side. However long the step, T never passes Ta.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.kernels import elementary

STEFAN_BOLTZMANN = 5.670374419e-8  # W/(m² K⁴)
MOST_NEWTON = 60
SMALL = 5e-4  # b T³ dt below which four terms of the series will do
MODERATE = 0.01  # the same for eight terms
PARTS = 8  # up to which a longer step is cut; Newton's steps take as long as twelve


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
def _by_series(start, ambient, most, way):
    """After ``way`` = b most³ dt, at most MODERATE, by eight terms of Taylor's series; most: at least both.

    With x = T / most, dx/dt = -(x⁴ - a⁴) by the series of x² = p and x⁴ = q, term by term. What follows is
    below 1e-13 of T: the terms are at most those of (1 + 3 way)^(-1/3).
    """
    x0, a = start / most, ambient / most
    p0 = x0 * x0
    q0 = p0 * p0
    x1 = (a * a) * (a * a) - q0
    p1 = 2.0 * x0 * x1
    q1 = 2.0 * p0 * p1
    x2 = -q1 / 2.0
    p2 = 2.0 * x0 * x2 + x1 * x1
    q2 = 2.0 * p0 * p2 + p1 * p1
    x3 = -q2 / 3.0
    p3 = 2.0 * (x0 * x3 + x1 * x2)
    q3 = 2.0 * (p0 * p3 + p1 * p2)
    x4 = -q3 / 4.0
    p4 = 2.0 * (x0 * x4 + x1 * x3) + x2 * x2
    q4 = 2.0 * (p0 * p4 + p1 * p3) + p2 * p2
    x5 = -q4 / 5.0
    p5 = 2.0 * (x0 * x5 + x1 * x4 + x2 * x3)
    q5 = 2.0 * (p0 * p5 + p1 * p4 + p2 * p3)
    x6 = -q5 / 6.0
    p6 = 2.0 * (x0 * x6 + x1 * x5 + x2 * x4) + x3 * x3
    q6 = 2.0 * (p0 * p6 + p1 * p5 + p2 * p4) + p3 * p3
    x7 = -q6 / 7.0
    rest = x1 + way * (x2 + way * (x3 + way * (x4 + way * (x5 + way * (x6 + way * x7)))))
    return start + most * (way * rest)


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
    if small < PARTS * MODERATE:
        parts = int(small / MODERATE) + 1
        after = start
        for _ in range(parts):
            after = _by_series(after, ambient, most, small / parts)
        return max(min(after, most), min(start, ambient))
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
