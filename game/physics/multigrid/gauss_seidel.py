"""The pressure by Gauss-Seidel sweeps, cell after cell, as Stam 2003 prints it."""

from __future__ import annotations

from game.compiler.decorator import lean_kernel
from game.physics.multigrid.equation import residual_of
from game.physics.multigrid.smoothing import wrap_ghosts

CHECKED = 10  # sweeps between two looks at the residual


@lean_kernel
def solve_sweeps(e, most, goal):
    """Improve e.p. (turns, largest residual before, after)."""
    before = residual_of(e)
    now, turns = before, 0
    while turns < most and now > goal:
        wrap_ghosts(e.p, e.joined[0], e.joined[1])
        for j in range(e.b.shape[0]):
            for i in range(e.b.shape[1]):
                near = e.cx[j, i] * e.p[j + 1, i] + e.cx[j, i + 1] * e.p[j + 1, i + 2]
                near += e.cy[j, i] * e.p[j, i + 1] + e.cy[j + 1, i] * e.p[j + 2, i + 1]
                if e.inverse[j, i] > 0.0:
                    e.p[j + 1, i + 1] = e.inverse[j, i] * (e.b[j, i] + near)
        turns += 1
        if turns % CHECKED == 0 or turns == most:
            now = residual_of(e)
    wrap_ghosts(e.p, e.joined[0], e.joined[1])
    return turns, before, now
