"""The pressure by conjugate gradients with a modified incomplete factorisation, MIC(0).

Hestenes and Stiefel 1952; Gustafsson 1978; the factors 0.97 and 0.25 as in Bridson's book (2008). Periodic
links are left out of the factorisation, not out of the equation.
"""

from __future__ import annotations

import math

from game.compiler.decorator import lean_kernel
from game.physics.multigrid.equation import advance_conjugate, residual_of
from game.physics.multigrid.smoothing import wrap_ghosts

MODIFIED, SAFETY = 0.97, 0.25


@lean_kernel
def factorise(e, factor):
    """factor (ny + 2, nx + 2): one over the diagonal of the incomplete factor, 0 for closed cells."""
    factor[:] = 0.0
    for j in range(e.b.shape[0]):
        for i in range(e.b.shape[1]):
            if e.inverse[j, i] <= 0.0:
                continue
            full = 1.0 / e.inverse[j, i]
            left, down = e.cx[j, i], e.cy[j, i]
            a, b = left * factor[j + 1, i], down * factor[j, i + 1]
            rest = full - a * a - b * b
            if i > 0:
                rest -= MODIFIED * left * e.cy[j + 1, i - 1] * (factor[j + 1, i] * factor[j + 1, i])
            if j > 0:
                rest -= MODIFIED * down * e.cx[j - 1, i + 1] * (factor[j, i + 1] * factor[j, i + 1])
            if rest < SAFETY * full:
                rest = full
            factor[j + 1, i + 1] = 1.0 / math.sqrt(rest)


@lean_kernel
def _precondition(e, factor, out):
    """out (ny + 2, nx + 2) = (L L^T)^-1 r."""
    ny, nx = e.b.shape
    for j in range(ny):
        for i in range(nx):
            total = e.r[j, i] + e.cx[j, i] * factor[j + 1, i] * out[j + 1, i]
            total += e.cy[j, i] * factor[j, i + 1] * out[j, i + 1]
            out[j + 1, i + 1] = total * factor[j + 1, i + 1]
    for j in range(ny - 1, -1, -1):
        for i in range(nx - 1, -1, -1):
            here = factor[j + 1, i + 1]
            right = e.cx[j, i + 1] * out[j + 1, i + 2] if i < nx - 1 else 0.0
            above = e.cy[j + 1, i] * out[j + 2, i + 1] if j < ny - 1 else 0.0
            out[j + 1, i + 1] = (out[j + 1, i + 1] + here * (right + above)) * here


@lean_kernel
def solve_gradients(e, factor, room, most, goal):
    """Improve e.p; space: (ny + 2, nx + 2), 0 at its rim. (turns, largest residual before, after)."""
    before = residual_of(e)
    now, turns, old = before, 0, 0.0
    while turns < most and now > goal:
        _precondition(e, factor, room)
        old, left = advance_conjugate(e, room, old)
        if not old > 0.0:
            break
        now = left
        turns += 1
    wrap_ghosts(e.p, e.joined[0], e.joined[1])
    return turns, before, now
