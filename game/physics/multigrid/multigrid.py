"""The pressure by V-cycles, each with a step of conjugate gradients (Tatebe 1993; McAdams et al. 2010).

The cycle alone leaves errors of wave lengths between the levels. Conjugate gradients take what it leaves, and
make walls harmless that the coarser levels cannot show.
"""

from __future__ import annotations

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.multigrid.cycle import cells, padded, v_cycle
from game.physics.multigrid.equation import advance_conjugate, residual_of
from game.physics.multigrid.smoothing import wrap_ghosts


@inner_kernel
def _take_residual(e, right):
    """The residual as the right side of the cycle."""
    for j in range(right.shape[0]):
        goal, source = right[j], e.r[j]
        for i in range(goal.size):
            goal[i] = source[i]


@lean_kernel
def solve_multigrid(e, h, most, goal):
    """Improve e.p until the largest residual is at most goal, in at most so many turns.

    (turns, largest residual before, after).
    """
    before = residual_of(e)
    now, turns, old = before, 0, 0.0
    right, z = cells(h.b, h.at, 0), padded(h.p, h.at, 0)
    while turns < most and now > goal:
        _take_residual(e, right)
        v_cycle(h)
        old, left = advance_conjugate(e, z, old)
        if not old > 0.0:
            break
        now = left
        turns += 1
    wrap_ghosts(e.p, e.joined[0], e.joined[1])
    return turns, before, now


@lean_kernel
def solve_cycles(e, h, most, goal):
    """The same by V-cycles alone."""
    before = residual_of(e)
    now, turns = before, 0
    right, z = cells(h.b, h.at, 0), padded(h.p, h.at, 0)
    while turns < most and now > goal:
        _take_residual(e, right)
        v_cycle(h)
        for j in range(right.shape[0]):
            for i in range(right.shape[1]):
                e.p[j + 1, i + 1] += z[j + 1, i + 1]
        now = residual_of(e)
        turns += 1
    wrap_ghosts(e.p, e.joined[0], e.joined[1])
    return turns, before, now
