"""The pressure by V-cycles, each with a step of conjugate gradients (Tatebe 1993; McAdams et al. 2010).

The cycle alone leaves errors of wave lengths between the levels; conjugate gradients take what it leaves,
and make walls harmless that the coarser levels cannot show.
"""

from __future__ import annotations

from game.physics.kernels.jit import kernel
from game.physics.multigrid.cycle import cells, padded, v_cycle
from game.physics.multigrid.equation import apply, direct, dot, residual_of, walk
from game.physics.multigrid.smoothing import wrap_ghosts


@kernel
def solve_multigrid(e, h, most, goal):
    """Improve e.p until the largest residual is at most goal, in at most so many turns.

    (turns, largest residual before, after).
    """
    before = residual_of(e)
    now, turns, old = before, 0, 0.0
    right, z = cells(h.b, h.at, 0), padded(h.p, h.at, 0)
    inner = z[1:-1, 1:-1]
    while turns < most and now > goal:
        for j in range(right.shape[0]):
            goal_row, source = right[j], e.r[j]
            for i in range(right.shape[1]):
                goal_row[i] = source[i]
        v_cycle(h)
        new = dot(e.r, inner)
        if not new > 0.0:
            break
        direct(e, z, new / old if turns > 0 else 0.0)
        steep = apply(e)
        if not steep > 0.0:
            break
        now = walk(e, new / steep)
        old = new
        turns += 1
    wrap_ghosts(e.p, e.joined[0], e.joined[1])
    return turns, before, now


@kernel
def solve_cycles(e, h, most, goal):
    """The same by V-cycles alone."""
    before = residual_of(e)
    now, turns = before, 0
    right, z = cells(h.b, h.at, 0), padded(h.p, h.at, 0)
    while turns < most and now > goal:
        right[:] = e.r
        v_cycle(h)
        for j in range(right.shape[0]):
            for i in range(right.shape[1]):
                e.p[j + 1, i + 1] += z[j + 1, i + 1]
        now = residual_of(e)
        turns += 1
    wrap_ghosts(e.p, e.joined[0], e.joined[1])
    return turns, before, now
