"""Conjugate gradients with a modified incomplete factorisation, MIC(0), on the wet cells alone.

Hestenes and Stiefel 1952; Gustafsson 1978; the factors 0.97 and 0.25 as in Bridson's book (2008). Of bodies
only the diagonal is in the factorisation: each costs a few turns.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel
from game.physics.liquid.bodies import answer, stiffen

MODIFIED, SAFETY = 0.97, 0.25


@inner_kernel
def factorise(s, grips, count):
    """The incomplete factor, with all that its two sweeps multiply by. The diagonal is that of bodies too."""
    for k in range(count + 1):
        s.d[k] = s.diagonal[k]
    stiffen(grips, s.d)
    for k in range(1, count + 1):
        left, below, down = s.left[k], s.below[k], s.down[k]
        a, b = left * s.factor[k - 1], below * s.factor[down]
        rest = s.d[k] - a * a - b * b
        rest -= MODIFIED * left * s.below[s.up[k - 1]] * (s.factor[k - 1] * s.factor[k - 1])
        rest -= MODIFIED * below * s.left[down + 1] * (s.factor[down] * s.factor[down])
        if rest < SAFETY * s.d[k]:
            rest = s.d[k]
        here = 1.0 / math.sqrt(rest) if rest > 0.0 else 0.0
        s.factor[k] = here
        s.back[k, 0], s.back[k, 1] = a * here, b * here
    for k in range(1, count + 1):
        square = s.factor[k] * s.factor[k]
        s.back[k, 2] = s.left[k + 1] * square
        s.back[k, 3] = s.below[s.up[k]] * square if s.up[k] > 0 else 0.0


@inner_kernel
def _walk(s, count, alpha):
    """p += alpha d, r -= alpha z, and z = L^-1 r; the largest of |r|. One loop: the sweep waits for itself
    at each row, and the rest is done meanwhile.
    """
    last, worst = 0.0, 0.0
    for k in range(1, count + 1):
        s.p[k] += alpha * s.d[k]
        rest = s.r[k] - alpha * s.z[k]
        s.r[k], worst = rest, max(worst, abs(rest))
        last = rest * s.factor[k] + s.back[k, 1] * s.z[s.down[k]] + s.back[k, 0] * last
        s.z[k] = last
    return worst


@inner_kernel
def _return(s, count):
    """z = L^-T z; r times z."""
    last, total = 0.0, 0.0
    for k in range(count, 0, -1):
        last = s.z[k] * s.factor[k] + s.back[k, 3] * s.z[s.up[k]] + s.back[k, 2] * last
        s.z[k] = last
        total += last * s.r[k]
    return total


@inner_kernel
def _apply(s, field, count, out):
    """out = A field; field times A field."""
    total = 0.0
    for k in range(1, count + 1):
        up = s.up[k]
        near = s.left[k] * field[k - 1] + s.left[k + 1] * field[k + 1]
        far = s.below[k] * field[s.down[k]] + s.below[up] * field[up]
        out[k] = s.diagonal[k] * field[k] - (near + far)
        total += out[k] * field[k]
    return total


@inner_kernel
def solve(s, grips, count, most, goal):
    """Improve p until the largest residual is at most goal. (turns, largest residual before, after)."""
    s.below[0], s.left[0], s.z[0], s.d[0], s.p[0] = 0.0, 0.0, 0.0, 0.0, 0.0
    s.left[count + 1], s.d[count + 1], s.p[count + 1], s.z[count + 1] = 0.0, 0.0, 0.0, 0.0
    _apply(s, s.p, count, s.z)
    answer(grips, s.p, s.z)
    for k in range(1, count + 1):
        s.r[k], s.d[k] = s.b[k], 0.0
    worst = _walk(s, count, 1.0)
    before, turns, old = worst, 0, 0.0
    while turns < most and worst > goal:
        new = _return(s, count)
        if not new > 0.0:
            break
        beta = new / old if old > 0.0 else 0.0
        for k in range(1, count + 1):
            s.d[k] = s.z[k] + beta * s.d[k]
        steep = _apply(s, s.d, count, s.z) + answer(grips, s.d, s.z)
        if not steep > 0.0:
            break
        worst = _walk(s, count, new / steep)
        old = new
        turns += 1
    return turns, before, worst
