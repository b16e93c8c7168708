"""Boxes as solids of a gas: a few numbers each, sampled as surfaces are."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.compiler.decorator import lean_kernel
from game.physics.kernels import elementary
from game.physics.surfaces.surface import Sample, empty_sample

# of a box: middle m, direction of its length, half its length and thickness m, half its extent across and
# up m
X, Y, C, S, LONG, THICK, WIDE, TALL = range(8)
BOX_WIDTH = 8


def box_rows(places: Floats, directions: Floats, halves: Floats) -> Floats:
    """(k, BOX_WIDTH) of places m, directions (cosine and sine), halves of length and thickness m, (k, 2)
    each.
    """
    c, s = np.abs(directions).T
    long, thick = halves.T
    extents = np.column_stack([c * long + s * thick, s * long + c * thick])
    return np.ascontiguousarray(np.concatenate([places, directions, halves, extents], axis=1))


@lean_kernel
def sample_boxes(points, boxes, distance, body):
    """Write signed distances m (n,) and rows (n,) of the nearest of boxes (k, BOX_WIDTH) at points (n, 2)
    m.
    """
    for n in range(points.shape[0]):
        best, nearest = 1e30, -1
        for k in range(boxes.shape[0]):
            dx, dy = points[n, 0] - boxes[k, X], points[n, 1] - boxes[k, Y]
            if abs(dy) - boxes[k, TALL] > best or abs(dx) - boxes[k, WIDE] > best:
                continue
            along = abs(boxes[k, C] * dx + boxes[k, S] * dy) - boxes[k, LONG]
            across = abs(boxes[k, C] * dy - boxes[k, S] * dx) - boxes[k, THICK]
            outside = along > 0.0 and across > 0.0
            away = elementary.hypot(along, across) if outside else max(along, across)
            if away < best:
                best, nearest = away, k
        distance[n], body[n] = best, nearest


class Boxes:
    """``rows`` (k, BOX_WIDTH), those that the gas knows of; all are at rest for it."""

    def __init__(self) -> None:
        self.rows: Floats = np.zeros((0, BOX_WIDTH))

    def sample(self, points: Floats) -> Sample:
        """Of the nearest box at points (n, 2) m."""
        found = empty_sample(len(points))
        if len(self.rows):
            places = np.ascontiguousarray(points, dtype=np.float64)
            sample_boxes(places, self.rows, found.distance, found.body)
        return found

    def differ(self, rows: Floats, moved: float) -> bool:
        """Whether boxes (k, BOX_WIDTH) are more or fewer than those that the gas knows of, or lie elsewhere,
        or are larger or smaller, by more than ``moved``, m.
        """
        if rows.shape != self.rows.shape:
            return True
        apart = np.abs(rows - self.rows)
        apart[:, C : S + 1] *= rows[:, LONG, None]
        return bool(np.max(apart[:, : THICK + 1], initial=0.0) > moved)
