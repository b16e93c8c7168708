"""Brute force: every motion of a grid in (x, y, angle), tested by separating axes of each pair of parts."""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.kernels import elementary


@inner_kernel
def _gap(one, of_one, pose, other, of_other):
    """How far (m) part ``other`` lies beyond the edge of ``one``, turned and moved, that separates best."""
    (first, last), (begin, end), (c, s, x, y) = of_one, of_other, pose
    best = -math.inf
    for k in range(first, last):
        k2 = k + 1 if k + 1 < last else first
        ex, ey = one[k2, 0] - one[k, 0], one[k2, 1] - one[k, 1]
        length = math.sqrt(ex * ex + ey * ey)
        nx, ny = (c * ey + s * ex) / length, (s * ey - c * ex) / length
        px, py = c * one[k, 0] - s * one[k, 1] + x, s * one[k, 0] + c * one[k, 1] + y
        least = math.inf
        for m in range(begin, end):
            least = min(least, nx * (other[m, 0] - px) + ny * (other[m, 1] - py))
        best = max(best, least)
    return best


@lean_kernel
def overlap_of(a, b, x, y, angle):
    """The deepest overlap (m) of a part of A, turned by ``angle`` and moved by (x, y), with one of B; at most
    0 if they have no common interior."""
    c, s = elementary.cos(angle), elementary.sin(angle)
    deepest = -math.inf
    bx, by = -(c * x + s * y), s * x - c * y  # B as A sees it
    for i in range(a.starts.shape[0] - 1):
        for j in range(b.starts.shape[0] - 1):
            of_a, of_b = (a.starts[i], a.starts[i + 1]), (b.starts[j], b.starts[j + 1])
            apart = _gap(a.corners, of_a, (c, s, x, y), b.corners, of_b)
            if apart < 0.0:
                apart = max(apart, _gap(b.corners, of_b, (c, -s, bx, by), a.corners, of_a))
            deepest = max(deepest, -apart)
    return deepest


@lean_kernel
def grid_search(a, b, gyration, reach, counts, slack, answer):
    """The shortest motion of a grid that separates: sigma, x, y, angle, motions tested, into answer (5,).

    reach: m; places from -reach to reach and angles whose turn alone is not longer. counts: (2,) places of an
    axis and angles, odd so that 0 is one of them. slack: m of overlap that is none.
    """
    most = math.pi if reach >= 2.0 * gyration else 2.0 * elementary.asin(0.5 * reach / gyration)
    answer[:] = 0.0
    answer[0] = math.inf
    side, turns = counts
    for t in range(turns):
        step = (t + 1) // 2 * (1 if t % 2 else -1)
        angle = most * step / (turns // 2)
        turn = 2.0 * gyration * elementary.sin(0.5 * angle)
        if abs(turn) >= answer[0]:
            break
        for i in range(side):
            x = reach * (2.0 * i / (side - 1) - 1.0)
            for j in range(side):
                y = reach * (2.0 * j / (side - 1) - 1.0)
                sigma = math.sqrt(turn * turn + x * x + y * y)
                if sigma >= answer[0]:
                    continue
                answer[4] += 1.0
                if overlap_of(a, b, x, y, angle) <= slack:
                    answer[0], answer[1], answer[2], answer[3] = sigma, x, y, angle
