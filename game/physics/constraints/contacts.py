"""Pairs of balls that bounce off each other: what a Newton's cradle needs.

Before a substep, pairs that would touch within it exchange impulses one after the other until none
approaches. These are sequential impacts by Newton's law, as shocks run through a row of balls. Were they let
overlap first, the projection would take their speed away. What still overlaps is pushed apart as a
constraint.

Arrays: x, y (n,) m; vx, vy (n,) m/s; w (n,) 1/kg; fresh (n,); pairs (c, 2); distances (c,) m.
"""

from __future__ import annotations

import math

from game.compiler.decorator import lean_kernel
from game.physics.constraints.links import TINY

AT_REST = 1e-9  # m/s; an approach as slow as this is rounding
MOST_PASSES = 64  # over all pairs; a shock runs through a row of so many balls in the worst order


@lean_kernel
def bounce_pairs(now, w, fresh, pairs, distances, restitution, h):
    """Impulses between pairs (c, 2) that would touch within h (s); velocities and FRESH are written.

    now: x, y, vx, vy.
    """
    x, y, vx, vy = now
    for _ in range(MOST_PASSES):
        struck = False
        for j in range(pairs.shape[0]):
            a = pairs[j, 0]
            b = pairs[j, 1]
            mobility = w[a] + w[b]
            dx = x[b] - x[a]
            dy = y[b] - y[a]
            length = math.sqrt(dx * dx + dy * dy)
            if mobility == 0.0 or length <= TINY:
                continue
            approach = -((vx[b] - vx[a]) * dx + (vy[b] - vy[a]) * dy) / length
            if approach <= AT_REST or length - h * approach > distances[j]:
                continue
            pull = (1.0 + restitution) * approach / (mobility * length)
            vx[a] -= w[a] * pull * dx
            vy[a] -= w[a] * pull * dy
            vx[b] += w[b] * pull * dx
            vy[b] += w[b] * pull * dy
            fresh[a] = 1.0
            fresh[b] = 1.0
            struck = True
        if not struck:
            break


@lean_kernel
def push_apart(x, y, w, pairs, distances):
    """Move pairs that are nearer than their distance apart to it."""
    for j in range(pairs.shape[0]):
        a = pairs[j, 0]
        b = pairs[j, 1]
        mobility = w[a] + w[b]
        dx = x[b] - x[a]
        dy = y[b] - y[a]
        length = math.sqrt(dx * dx + dy * dy)
        if mobility == 0.0 or length <= TINY or length >= distances[j]:
            continue
        pull = (1.0 - distances[j] / length) / mobility
        x[a] += w[a] * pull * dx
        y[a] += w[a] * pull * dy
        x[b] -= w[b] * pull * dx
        y[b] -= w[b] * pull * dy
