"""Minkowski differences of convex parts as half-planes, for one angle of A.

A moved by t has common interior with B just where t lies inside one of the convex polygons B_j - A_i. Their
edges are those of B_j and of -A_i, merged by direction in O(n + m) (de Berg and others 2008, 13.3).
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.compiler.decorator import inner_kernel
from game.physics.kernels import elementary

NX, NY, OFFSET = range(3)


class Parts(NamedTuple):
    """Convex parts about the centroid of A. corners: (n, 2) m, counterclockwise; starts: (parts + 1,) where
    each begins; reaches: (parts,) m from the centroid of A to the farthest corner."""

    corners: Floats
    starts: NDArray[np.int64]
    reaches: Floats


class Differences(NamedTuple):
    """planes: (n, 3) unit normal and offset of each edge, m; starts: (polygons + 1,); shrunk: (polygons,) by
    how much each is eroded, m."""

    planes: Floats
    starts: NDArray[np.int64]
    shrunk: Floats


@inner_kernel
def _lowest(corners, first, last, c, s, sign):
    """The lowest (then leftmost) corner of a part that is turned, and turned about if sign is -1."""
    best, bx, by = first, math.inf, math.inf
    for k in range(first, last):
        x = sign * (c * corners[k, 0] - s * corners[k, 1])
        y = sign * (s * corners[k, 0] + c * corners[k, 1])
        if y < by or (y == by and x < bx):
            best, bx, by = k, x, y
    return best


@inner_kernel
def _add_difference(a, i, b, j, c, s, planes, row):
    """Write the edges of B_j - A_i, A turned by (c, s), from ``row`` on; the row after them."""
    a0, a1, b0, b1 = a.starts[i], a.starts[i + 1], b.starts[j], b.starts[j + 1]
    p = _lowest(a.corners, a0, a1, c, s, -1.0)
    q = _lowest(b.corners, b0, b1, 1.0, 0.0, 1.0)
    x = b.corners[q, 0] - (c * a.corners[p, 0] - s * a.corners[p, 1])
    y = b.corners[q, 1] - (s * a.corners[p, 0] + c * a.corners[p, 1])
    left, right = a1 - a0, b1 - b0
    while left > 0 or right > 0:
        p2 = p + 1 if p + 1 < a1 else a0
        q2 = q + 1 if q + 1 < b1 else b0
        ex, ey = a.corners[p, 0] - a.corners[p2, 0], a.corners[p, 1] - a.corners[p2, 1]
        ux, uy = c * ex - s * ey, s * ex + c * ey
        vx, vy = b.corners[q2, 0] - b.corners[q, 0], b.corners[q2, 1] - b.corners[q, 1]
        # both begin lowest, so that the next edges of the two never differ by half a turn or more
        if right == 0 or (left > 0 and ux * vy - uy * vx >= 0.0):
            ex, ey, p, left = ux, uy, p2, left - 1
        else:
            ex, ey, q, right = vx, vy, q2, right - 1
        length = math.sqrt(ex * ex + ey * ey)
        nx, ny = ey / length, -ex / length
        planes[row, NX], planes[row, NY], planes[row, OFFSET] = nx, ny, nx * x + ny * y
        x, y, row = x + ex, y + ey, row + 1
    return row


@inner_kernel
def build_differences(a, b, angle, differences):
    """All B_j - A_i for A turned by ``angle`` (rad) about its centroid."""
    c, s = elementary.cos(angle), elementary.sin(angle)
    row, polygon = 0, 0
    for i in range(a.starts.shape[0] - 1):
        for j in range(b.starts.shape[0] - 1):
            row = _add_difference(a, i, b, j, c, s, differences.planes, row)
            polygon += 1
            differences.starts[polygon] = row


@inner_kernel
def shrink(a, b, by, differences):
    """Erode each B_j - A_i by ``by`` times the reach of A_i, m."""
    count = b.starts.shape[0] - 1
    for polygon in range(differences.shrunk.shape[0]):
        differences.shrunk[polygon] = by * a.reaches[polygon // count]
