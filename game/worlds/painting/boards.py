"""Boards and boxes as polygons, to be painted at once."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.physics.kernels import elementwise

Floats = NDArray[np.float64]
Longs = NDArray[np.int64]
SMOOTH = 0.5  # rad: where a floor turns by more, its board ends


class Shapes(NamedTuple):
    """Corners (v, 2) m of polygons, and the first corner of each, (m + 1,)."""

    corners: Floats
    starts: Longs


def boards_of(points: Floats, thick: float) -> Shapes:
    """What a floor is made of, ``thick`` m deep; a polygon for each smooth run."""
    along = np.diff(points, axis=0)
    angles = elementwise.arctan2(along[:, 1], along[:, 0])
    turns = np.abs(np.remainder(np.diff(angles) + math.pi, math.tau) - math.pi)
    cuts = [0, *(np.flatnonzero(turns > SMOOTH) + 1).tolist(), len(along)]
    parts = []
    for first, last in pairwise(cuts):
        run = points[first : last + 1]
        normals = np.stack(
            [elementwise.sin(angles[first:last]), -elementwise.cos(angles[first:last])], axis=1
        )
        both = np.concatenate([normals[:1], 0.5 * (normals[1:] + normals[:-1]), normals[-1:]])
        parts.append(np.concatenate([run, (run + thick * both)[::-1]]))
    return joined(parts)


def joined(parts: list[Floats]) -> Shapes:
    """Polygons one after the other."""
    starts = np.cumsum([0, *(len(part) for part in parts)])
    return Shapes(np.concatenate([np.zeros((0, 2)), *parts]), starts.astype(np.int64))


def moved(shapes: Shapes, by: Floats) -> Shapes:
    """The same elsewhere: ``by`` (2,) m."""
    return Shapes(shapes.corners + by, shapes.starts)


def placed(box: tuple[float, float, float, float], sizes: Floats, places: Floats, turned: Floats) -> Floats:
    """Corners (4 n, 2) m of a part of n boxes: ``box`` in shares of half sizes (n, 2), at places and cosine
    and sine (n, 2)."""
    x0, y0, x1, y1 = box
    unit = np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1)])
    own = sizes[:, None, :] * unit[None]
    c, s = turned[:, 0, None], turned[:, 1, None]
    x, y = own[..., 0], own[..., 1]
    corners = np.stack([c * x - s * y, s * x + c * y], axis=2) + places[:, None, :]
    return corners.reshape(-1, 2)
