"""The two solves of a step: the pressure, and what moves crowded particles apart."""

from __future__ import annotations

from game.compiler.decorator import lean_kernel
from game.physics.liquid import equation, gradients
from game.physics.liquid.bodies import gather, sweep, tie

CROWDED = 0.01  # of a cell: crowding that is let be


@lean_kernel
def find_pressure(cells, walls, s, grips, settings, wet):
    """q of so many wet cells, and its sums over bodies. (regions, turns, largest outflow left over, m/s)."""
    equation.assemble(cells, walls, s, wet, settings.surface == 0)
    regions = equation.free_regions(s, wet)
    tie(grips, s.region, s.sums[2], regions)
    equation.outflow(cells, walls, s, wet)
    sweep(grips, walls, s.b)
    equation.balance(s, s.b, wet, regions)
    gradients.factorise(s, grips, wet)
    most = 0.0
    for k in range(1, wet + 1):
        most = max(most, abs(s.b[k]))
    turns, _, after = gradients.solve(s, grips, wet, settings.turns, settings.residual * most)
    equation.balance(s, s.p, wet, regions)
    gather(grips, s.p)
    equation.keep(s, wet, cells.q)
    return regions, turns, after


@lean_kernel
def find_shift(cells, s, grips, settings, wet, regions):
    """q_shift, by the system that `find_pressure` left; turns of the solver. Bodies stay where they are."""
    if grips.sizes[0] > 0:
        grips.sizes[0] = 0
        equation.free_regions(s, wet)
    equation.crowding(cells, s, wet, settings.keeping)
    equation.balance(s, s.b, wet, regions)
    turns, _, _ = gradients.solve(s, grips, wet, settings.turns, CROWDED * settings.keeping)
    equation.keep(s, wet, cells.q_shift)
    return turns
