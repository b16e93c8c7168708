"""The Minkowski difference A - B as a polygon, for pictures and tests: GJK itself never builds it."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.physics.kernels import elementwise


def minkowski_difference(a: Floats, b: Floats) -> Floats:
    """Corners (k, 2) of A - B, counterclockwise, of convex polygons (n, 2), (m, 2) that turn left.

    Its edges are those of A and of -B, in the order of their directions (de Berg and others 2008, 13.3).
    """
    first, second = np.asarray(a, dtype=np.float64), -np.asarray(b, dtype=np.float64)
    if len(first) == 1 or len(second) == 1:
        return first + second
    corners = np.vstack((_from_lowest(first), _from_lowest(second)))
    edges = np.vstack((_edges(corners[: len(first)]), _edges(corners[len(first) :])))
    angles = elementwise.arctan2(edges[:, 1], edges[:, 0])
    angles[angles < 0.0] += 2.0 * np.pi
    order = np.argsort(angles, kind="stable")
    start = corners[0] + corners[len(first)]
    return start + np.vstack((np.zeros((1, 2)), np.cumsum(edges[order], axis=0)[:-1]))


def _from_lowest(polygon: Floats) -> Floats:
    """The polygon from its lowest (then leftmost) corner on."""
    lowest = int(np.lexsort((polygon[:, 0], polygon[:, 1]))[0])
    return np.roll(polygon, -lowest, axis=0)


def _edges(polygon: Floats) -> Floats:
    return np.roll(polygon, -1, axis=0) - polygon
