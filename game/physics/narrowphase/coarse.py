"""Coarse outlines of large polygons: every eighth vertex, every 64th, and so on.

Vertices of a convex polygon, some of them left out, are a convex polygon within it. What is closest on the
coarse one is near to what is closest on the finer. Source: Dobkin and Kirkpatrick 1990, of polyhedra.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from game.compiler.decorator import inner_kernel
from game.physics.narrowphase.features import Polygon

RATIO = 8  # vertices of an outline to one of the next coarser
SMALL = 16  # vertices of which no coarser outline is made


def coarse_outlines(outline: NDArray[np.float64]) -> list[NDArray[np.float64]]:
    """The coarser outlines of one (n, 2), from the finest of them; none of a small one."""
    coarser = []
    while len(outline) > SMALL:
        outline = outline[::RATIO]
        coarser.append(outline)
    return coarser


@inner_kernel
def levels_of(size):
    """How many coarser outlines a polygon of ``size`` vertices has."""
    levels = 0
    while size > SMALL:
        size = (size + RATIO - 1) // RATIO
        levels += 1
    return levels


@inner_kernel
def coarse_polygon(side, k, level):
    """Polygon k of a `Side` in its outline ``level``, 0 for its own; the coarsest if it has not so many."""
    size = side.first[k + 1] - side.first[k]
    if level == 0 or size <= SMALL:
        return Polygon(side.vertices, side.first[k], size)
    first = side.coarse[k]
    size = (size + RATIO - 1) // RATIO
    while level > 1 and size > SMALL:
        first += size
        size = (size + RATIO - 1) // RATIO
        level -= 1
    return Polygon(side.outlines, first, size)


@inner_kernel
def finer_feature(code, size, finer_size):
    """Where a feature of an outline of ``size`` vertices lies in the next finer one, of ``finer_size``.

    A vertex stays itself; of an edge it is the vertex in the middle of what it spans, or near it.
    """
    if size == finer_size:  # the polygon has no finer one here
        return code
    return 2 * min(RATIO * (code >> 1) + RATIO // 2 * (code & 1), finer_size - 1)
