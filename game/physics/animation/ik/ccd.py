"""Cyclic coordinate descent: joint by joint from the tip, each turns so that the end points at the target.

Wang and Chen 1991; Canutescu and Dunbrack 2003. Each turn is the exact minimum along one angle, so the error
never grows. Joints near the tip turn most, and long chains curl up.

Arrays as in `ik_chain`.
"""

from __future__ import annotations

from game.compiler.decorator import kernel
from game.physics.animation.ik.chain import ANGLE, LOWER, UPPER, place_points, turn_between
from game.physics.kernels import elementary


@kernel(_nrt=False)
def relax_by_cycle(base, links, target, points, numbers):
    """One pass from tip to root; gives the number of times that the chain was placed."""
    n = links.shape[1]
    x, y = points[n, 0], points[n, 1]
    for k in range(n):
        i = n - 1 - k
        px, py = points[i, 0], points[i, 1]
        turn = turn_between(x - px, y - py, target[0] - px, target[1] - py)
        before = links[ANGLE, i]
        links[ANGLE, i] = min(max(before + turn, links[LOWER, i]), links[UPPER, i])
        turn = links[ANGLE, i] - before
        c, s = elementary.cos(turn), elementary.sin(turn)
        dx, dy = x - px, y - py
        x, y = px + c * dx - s * dy, py + s * dx + c * dy
    place_points(base, links, ANGLE, points)
    return 1
