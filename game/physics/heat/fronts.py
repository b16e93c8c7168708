"""Fronts that burn their way on: u_t = D lap u + R(u) on a grid of square cells, insulated at its edges.

Reactions: FISHER k u (1 - u), pulled by its tip (Fisher 1937; Kolmogorov, Petrovsky and Piskunov 1937).
IGNITION k u (1 - u)(u - a), which only spreads above a threshold a and has an exact speed (Nagumo and others
1962). SELF_HEATING k exp u, which has a steady state or none (Frank-Kamenetskii 1939), with u = 0 at the
edges.
"""

from __future__ import annotations

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.kernels import elementary

FISHER, IGNITION, SELF_HEATING = range(3)
REACTIONS = ("fisher", "ignition", "self-heating")
HOTTEST = 50.0  # of u in a self-heating: beyond, it has run away


@inner_kernel
def _reaction(u, kind, rate, threshold):
    if kind == FISHER:
        return rate * u * (1.0 - u)
    if kind == IGNITION:
        return rate * u * (1.0 - u) * (u - threshold)
    return rate * elementary.exp(min(u, HOTTEST))


@inner_kernel
def _beside(u, here, inside, kind):
    """A neighbour, or beyond an edge: the same value, of a self-heating its mirror, so that it is 0 there."""
    if inside:
        return u
    return -here if kind == SELF_HEATING else here


@lean_kernel
def front_step(u, new, number, kind, rate, threshold, dt):
    """One step of explicit Euler into ``new``; number: D dt / cell², at most 1/4 (1/2 in one row)."""
    ny, nx = u.shape
    for j in range(ny):
        for i in range(nx):
            here = u[j, i]
            left = _beside(u[j, max(i - 1, 0)], here, i > 0, kind)
            right = _beside(u[j, min(i + 1, nx - 1)], here, i < nx - 1, kind)
            around = left + right - 2.0 * here
            if ny > 1:
                below = _beside(u[max(j - 1, 0), i], here, j > 0, kind)
                above = _beside(u[min(j + 1, ny - 1), i], here, j < ny - 1, kind)
                around += below + above - 2.0 * here
            new[j, i] = here + number * around + dt * _reaction(here, kind, rate, threshold)
