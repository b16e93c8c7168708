"""Relaxation by gradient with Buss's step: as far as the linearised error falls.

    α = <e, JJᵀe> / |JJᵀe|²        Buss 2004 (2009), "Introduction to inverse kinematics", eq. 8

About ten times fewer iterations than the fixed step. Where the chain is nearly straight towards a target out
of reach, JJᵀe goes to 0 and the step to infinity. So a step that does not make the error smaller is taken
back, and the safe fixed one is made instead.

Arrays as in `ik_chain`.
"""

from __future__ import annotations

from game.compiler.decorator import kernel
from game.physics.animation.ik.chain import (
    ANGLE,
    REACH_SQUARE,
    TRIAL,
    copy_row,
    error_of,
    follow_pull,
    place_points,
    turn_joints,
)


@kernel(inline="always")
def buss_step(links, target, points):
    """The step α (1/m²), or 0 if the pull moves the end nowhere. Row PULL must hold Jᵀe."""
    n = links.shape[1]
    mx, my = follow_pull(links, points)
    square = mx * mx + my * my
    along = (target[0] - points[n, 0]) * mx + (target[1] - points[n, 1]) * my
    return along / square if square > 0.0 else 0.0


@kernel(_nrt=False)
def relax_by_buss(base, links, target, points, numbers):
    """One iteration; gives the number of times that the chain was placed. Row PULL must hold Jᵀe."""
    before = error_of(points, target)
    copy_row(links, ANGLE, TRIAL)
    turn_joints(links, buss_step(links, target, points))
    place_points(base, links, ANGLE, points)
    if error_of(points, target) < before:
        return 1
    copy_row(links, TRIAL, ANGLE)
    turn_joints(links, 1.0 / numbers[REACH_SQUARE])
    place_points(base, links, ANGLE, points)
    return 2
