"""Relaxation by gradient with a fixed step: every joint turns a little the way that helps.

    Δθ = α Jᵀe,   α = step / Σ r_i²

Σ r_i² over the stretched chain is the largest eigenvalue that J Jᵀ can have. A step of 1 is safe in every
pose; from 2 on a straight chain oscillates. Convergence is linear, with the factor 1 - α λ of the smallest λ.

Arrays as in `ik_chain`.
"""

from __future__ import annotations

from game.compiler.decorator import kernel
from game.physics.animation.ik.chain import ANGLE, REACH_SQUARE, STEP, place_points, turn_joints


@kernel(inline="always")
def relax_by_gradient(base, links, target, points, numbers):
    """One iteration; gives the number of times that the chain was placed. Row PULL must hold Jᵀe."""
    turn_joints(links, numbers[STEP] / numbers[REACH_SQUARE])
    place_points(base, links, ANGLE, points)
    return 1
