"""The pressure by Jacobi's sweeps: every cell from its neighbours' values of the sweep before.

With the whole step a checkerboard between walls would never die out, so a little less is taken.
"""

from __future__ import annotations

from game.compiler.decorator import lean_kernel
from game.physics.multigrid.equation import residual_of
from game.physics.multigrid.smoothing import wrap_ghosts

DAMPING = 0.95  # of the whole step


@lean_kernel
def solve_jacobi(e, most, goal):
    """Improve e.p. (turns, largest residual before, after)."""
    before = residual_of(e)
    now, turns = before, 0
    while turns < most and now > goal:
        for j in range(e.b.shape[0]):
            for i in range(e.b.shape[1]):
                e.p[j + 1, i + 1] += DAMPING * e.inverse[j, i] * e.r[j, i]
        now = residual_of(e)
        turns += 1
    wrap_ghosts(e.p, e.joined[0], e.joined[1])
    return turns, before, now
