"""Smoothing kernels in the plane: how much of a particle is felt at a distance.

Each is normalised so that its integral over the plane is 1. The factors of the papers are those of space;
here they are 4/π (poly6), 10/π (spiky), 10/(3π) (for viscosity) after Müller, Charypar and Gross 2003,
40/(7π) (cubic spline, Monaghan 1992) and 7/π (Wendland C2, 1995), for a support of 1.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, lean_kernel

CUBIC, WENDLAND, POLY6, SPIKY, VISCOUS = range(5)
NAMES = ("cubic", "wendland", "poly6", "spiky", "viscous")
FACTORS = (40.0 / (7.0 * math.pi), 7.0 / math.pi, 4.0 / math.pi, 10.0 / math.pi, 10.0 / (3.0 * math.pi))
LEAST = 0.05  # of the support: nearer particles feel the slope there, so that two on one spot part


@inner_kernel
def weight(kind, q):
    """Value of a kernel at q supports; 0 beyond 1."""
    if q >= 1.0:
        return 0.0
    rest = 1.0 - q
    if kind == CUBIC:
        shape = 1.0 - 6.0 * q * q * rest if q < 0.5 else 2.0 * rest * rest * rest
    elif kind == WENDLAND:
        shape = rest * rest * rest * rest * (1.0 + 4.0 * q)
    elif kind == POLY6:
        base = 1.0 - q * q
        shape = base * base * base
    elif kind == SPIKY:
        shape = rest * rest * rest
    else:
        shape = q * q * (1.0 - 0.5 * q) + 0.5 / q - 1.0
    return FACTORS[kind] * shape


@inner_kernel
def slope(kind, q):
    """Derivative of a kernel by q; 0 beyond 1."""
    if q >= 1.0:
        return 0.0
    rest = 1.0 - q
    if kind == CUBIC:
        shape = -6.0 * q * (2.0 - 3.0 * q) if q < 0.5 else -6.0 * rest * rest
    elif kind == WENDLAND:
        shape = -20.0 * q * rest * rest * rest
    elif kind == POLY6:
        base = 1.0 - q * q
        shape = -6.0 * q * base * base
    elif kind == SPIKY:
        shape = -3.0 * rest * rest
    else:
        shape = q * (2.0 - 1.5 * q) - 0.5 / (q * q)
    return FACTORS[kind] * shape


@lean_kernel
def fill_kernel(kind, distances, values, slopes):
    """Values and slopes of a kernel of support 1 at distances (n,)."""
    for i in range(len(distances)):
        values[i] = weight(kind, distances[i])
        slopes[i] = slope(kind, distances[i])
