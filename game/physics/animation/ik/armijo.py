"""Relaxation by gradient with a line search: the step is halved until the error falls enough.

    |e(θ + s)|² / 2  <=  |e(θ)|² / 2 - c |s|² / α,     s = the turn by α Jᵀe, cut at the limits

Armijo 1966, projected on the limits as by Bertsekas 1976. The error never grows, whatever the target. The
first try is twice the step that held last time.

Arrays as in `ik_chain`.
"""

from __future__ import annotations

from game.compiler.decorator import kernel
from game.physics.animation.ik import chain
from game.physics.animation.ik.chain import copy_row, error_of, place_points, turn_joints

DECREASE = 1e-4  # c, the share of the promised decrease that is asked for
HALVINGS = 40
FIRST = 4.0  # first try over the safe step


@kernel(_nrt=False)
def relax_by_armijo(base, links, target, points, numbers):
    """One iteration; gives how often the chain was placed, negative if no step helps. PULL holds Jᵀe."""
    before = error_of(points, target)
    copy_row(links, chain.ANGLE, chain.TRIAL)
    step = numbers[chain.MEMORY] if numbers[chain.MEMORY] > 0.0 else FIRST / numbers[chain.REACH_SQUARE]
    for halving in range(HALVINGS):
        turn_joints(links, step)
        place_points(base, links, chain.ANGLE, points)
        after = error_of(points, target)
        square = 0.0
        for i in range(links.shape[1]):
            turn = links[chain.ANGLE, i] - links[chain.TRIAL, i]
            square += turn * turn
        if 0.5 * (before - after) * (before + after) >= DECREASE * square / step:
            numbers[chain.MEMORY] = 2.0 * step
            return halving + 1
        copy_row(links, chain.TRIAL, chain.ANGLE)
        step *= 0.5
    place_points(base, links, chain.ANGLE, points)
    numbers[chain.MEMORY] = 0.0
    return -HALVINGS - 1
