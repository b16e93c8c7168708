"""Damped least squares: the joint turns that meet the linearised error, held back by a damping λ.

    Δθ = Jᵀ (J Jᵀ + λ² 1)⁻¹ e         Wampler 1986, Nakamura and Hanafusa 1986

In the plane J Jᵀ is 2 x 2. With a fixed λ a target out of reach makes the chain thrash: near the straight
pose J Jᵀ loses a rank and the turns become huge. The adaptive λ (Levenberg 1944, Marquardt 1963) takes a turn
back that does not help, and damps more; after one that helps it damps less, and convergence is nearly
quadratic. Joints that stand at a limit and are pulled beyond it do not take part.

Arrays as in `ik_chain`.
"""

from __future__ import annotations

from game.compiler.decorator import kernel
from game.physics.animation.ik import chain
from game.physics.animation.ik.chain import copy_row, error_of, place_points, pull_joints, turn_joints

FIRST, LEAST = 1e-3, 1e-12  # λ² over Σ r_i²
LESS, MORE = 0.1, 10.0  # change of λ² after a turn that helped, and one that did not
TRIES = 16  # dampings in one iteration; beyond, no turn helps


@kernel(_nrt=False)
def solve_damped(links, target, points, square):
    """Write the joint turns (rad) for a damping λ² (m²) into the row PULL, which must hold Jᵀe."""
    n = links.shape[1]
    x, y = points[n, 0], points[n, 1]
    a, b, d = square, 0.0, square
    for i in range(n):
        if _held(links, i):
            continue
        jx, jy = points[i, 1] - y, x - points[i, 0]
        a += jx * jx
        b += jx * jy
        d += jy * jy
    ex, ey = target[0] - x, target[1] - y
    determinant = a * d - b * b
    share = 1.0 / determinant if determinant > 0.0 else 0.0
    fx, fy = share * (d * ex - b * ey), share * (a * ey - b * ex)
    for i in range(n):
        turn = (points[i, 1] - y) * fx + (x - points[i, 0]) * fy
        links[chain.PULL, i] = 0.0 if _held(links, i) else turn


@kernel(inline="always")
def _held(links, i):
    """Does a joint stand at a limit and is pulled beyond it?"""
    angle, pull = links[chain.ANGLE, i], links[chain.PULL, i]
    return (pull > 0.0 and angle >= links[chain.UPPER, i]) or (pull < 0.0 and angle <= links[chain.LOWER, i])


@kernel(_nrt=False)
def relax_adaptively(base, links, target, points, numbers):
    """One turn that helps; gives how often the chain was placed, negative if there is none."""
    size = numbers[chain.REACH_SQUARE]
    square = numbers[chain.MEMORY] if numbers[chain.MEMORY] > 0.0 else FIRST * size
    before = error_of(points, target)
    copy_row(links, chain.ANGLE, chain.TRIAL)
    for tries in range(TRIES):
        pull_joints(points, target, links)
        solve_damped(links, target, points, square)
        turn_joints(links, 1.0)
        place_points(base, links, chain.ANGLE, points)
        if error_of(points, target) < before:
            numbers[chain.MEMORY] = max(LESS * square, LEAST * size)
            return 2 * tries + 1
        copy_row(links, chain.TRIAL, chain.ANGLE)
        place_points(base, links, chain.ANGLE, points)
        square *= MORE
    return -2 * TRIES


@kernel(_nrt=False)
def relax_damped(base, links, target, points, numbers):
    """One iteration with the fixed damping λ (m); gives the number of times that the chain was placed."""
    solve_damped(links, target, points, numbers[chain.DAMPING] * numbers[chain.DAMPING])
    turn_joints(links, 1.0)
    place_points(base, links, chain.ANGLE, points)
    return 1
