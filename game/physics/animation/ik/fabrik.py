"""FABRIK: forward and backward reaching. Points are pulled along the chain and back, and no angle is needed.

Backward: the end is put on the target, and each joint on the line to the one before, a link's length off.
Forward: the same from the root, which is put back in its place. Aristidou and Lasenby 2011, "FABRIK: a fast,
iterative solver for the inverse kinematics problem". A target out of reach is met at once, straight. Limits
are kept in the forward pass: a link that would bend too far is turned back to its limit. That alone gets
stuck wherever limits matter, so a pass that a limit has kept from coming nearer is taken back. One of cyclic
coordinate descent is made in its place.

Arrays as in `ik_chain`.
"""

from __future__ import annotations

import math

from game.compiler.decorator import kernel
from game.physics.animation.ik import chain
from game.physics.animation.ik.ccd import relax_by_cycle
from game.physics.animation.ik.chain import copy_row, error_of, place_points, turn_between
from game.physics.kernels import elementary


@kernel(_nrt=False)
def relax_by_reaching(base, links, target, points, numbers):
    """One pass back and forth; gives how often the chain was placed, which a pass counts for."""
    n = links.shape[1]
    before = error_of(points, target)
    copy_row(links, chain.ANGLE, chain.TRIAL)
    reach = 0.0
    for i in range(n):
        reach += links[chain.LENGTH, i]
    tx, ty = target[0] - base[0], target[1] - base[1]
    if tx * tx + ty * ty < reach * reach:
        points[n, 0], points[n, 1] = target[0], target[1]
        for k in range(n - 1):
            i = n - 1 - k
            _pull(points, i + 1, i, links[chain.LENGTH, i])
    else:
        for i in range(1, n + 1):
            points[i, 0], points[i, 1] = target[0], target[1]
    held = _reach_forward(base, links, points)
    if not held or error_of(points, target) < before:
        return 1
    copy_row(links, chain.TRIAL, chain.ANGLE)
    place_points(base, links, chain.ANGLE, points)
    return 2 + relax_by_cycle(base, links, target, points, numbers)


@kernel(inline="always")
def _pull(points, fixed, free, length):
    """Put one point a link's length from another, on the line between them; on it if it has no line."""
    dx, dy = points[free, 0] - points[fixed, 0], points[free, 1] - points[fixed, 1]
    distance = math.sqrt(dx * dx + dy * dy)
    share = length / distance if distance > 0.0 else 0.0
    if distance > 0.0:
        points[free, 0], points[free, 1] = points[fixed, 0] + share * dx, points[fixed, 1] + share * dy
    else:
        points[free, 0], points[free, 1] = points[fixed, 0] + length, points[fixed, 1]


@kernel(_nrt=False)
def _reach_forward(base, links, points):
    """From the root on: angles within their limits, and points that are those of the angles.

    True if a limit held a link back.
    """
    held = False
    x, y, ux, uy = base[0], base[1], elementary.cos(base[2]), elementary.sin(base[2])
    for i in range(links.shape[1]):
        before = links[chain.ANGLE, i]
        turn = turn_between(ux, uy, points[i + 1, 0] - x, points[i + 1, 1] - y)
        turn += chain.FULL_TURN * math.floor((before - turn) / chain.FULL_TURN + 0.5)
        free, turn = turn, min(max(turn, links[chain.LOWER, i]), links[chain.UPPER, i])
        held = held or turn != free
        links[chain.ANGLE, i] = turn
        c, s = elementary.cos(turn), elementary.sin(turn)
        ux, uy = c * ux - s * uy, s * ux + c * uy
        points[i, 0], points[i, 1] = x, y
        x, y = x + links[chain.LENGTH, i] * ux, y + links[chain.LENGTH, i] * uy
    n = links.shape[1]
    points[n, 0], points[n, 1] = x, y
    return held
