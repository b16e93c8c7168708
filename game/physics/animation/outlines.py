"""Closed outlines of skin: the area they enclose, rounder ones from few points, and points within."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.compiler.decorator import kernel
from game.physics.animation.weights import WeightError, checked_points

MOST_INSIDE = 200_000


@kernel
def sum_areas(points, starts, areas):
    """Write the signed areas (m,) of outlines, corners from ``starts[j]`` to ``starts[j + 1]``."""
    for j in range(areas.shape[0]):
        first, last = starts[j], starts[j + 1]
        twice = 0.0
        for k in range(first, last):
            m = k + 1 if k + 1 < last else first
            ax, ay = points[k, 0] - points[first, 0], points[k, 1] - points[first, 1]
            bx, by = points[m, 0] - points[first, 0], points[m, 1] - points[first, 1]
            twice += ax * by - ay * bx
        areas[j] = 0.5 * twice


@kernel
def mark_inside(points, outline, inside):
    """Write 1 for points (v, 2) within an outline (m, 2) by the even-odd rule, else 0."""
    for v in range(points.shape[0]):
        x, y = points[v, 0], points[v, 1]
        crossings = 0
        j = outline.shape[0] - 1
        for k in range(outline.shape[0]):
            low, high = outline[j, 1] > y, outline[k, 1] > y
            if low != high:
                part = (y - outline[j, 1]) / (outline[k, 1] - outline[j, 1])
                if x < outline[j, 0] + part * (outline[k, 0] - outline[j, 0]):
                    crossings += 1
            j = k
        inside[v] = crossings % 2


def area(outline: ArrayLike) -> float:
    """Area of a closed outline (m, 2), positive if counterclockwise."""
    points = checked_points(outline)
    areas = np.empty(1)
    sum_areas(points, np.array([0, len(points)]), areas)
    return float(areas[0])


def rounded(outline: ArrayLike, spacing: float) -> Floats:
    """A closed outline through the same points along uniform Catmull-Rom curves, a point each ``spacing`` m.

    Made for skins drawn by a few clicks, whose limbs would bend in corners. WeightError below three points.
    """
    points = checked_points(outline)
    if len(points) < 3 or not spacing > 0.0:
        raise WeightError("outline: expected at least three points and a spacing above 0 m")
    along = np.roll(points, -1, 0) - points
    counts = np.clip(np.ceil(np.sqrt((along * along).sum(axis=1)) / spacing), 1.0, 1_000.0).astype(np.int64)
    segment = np.repeat(np.arange(len(points)), counts)
    t = ((np.arange(len(segment)) - (np.cumsum(counts) - counts)[segment]) / counts[segment])[:, None]
    p0, p1, p2, p3 = (np.roll(points, shift, 0)[segment] for shift in (1, 0, -1, -2))
    curve = 2.0 * p1 + (p2 - p0) * t + (2.0 * p0 - 5.0 * p1 + 4.0 * p2 - p3) * t * t
    return 0.5 * (curve + (3.0 * (p1 - p2) + p3 - p0) * (t * t * t))


def points_inside(outline: ArrayLike, spacing: float) -> Floats:
    """Points (v, 2) m of a triangular grid within a closed outline (n, 2) m, so far apart (m).

    At most MOST_INSIDE or so, then coarser. WeightError unless the spacing is finite and above 0.
    """
    corners = checked_points(outline)
    if not 0.0 < spacing < math.inf:
        raise WeightError(f"spacing: expected a finite number above 0 m, got {spacing!r}")
    low, high = corners.min(axis=0), corners.max(axis=0)
    box = (high[0] - low[0]) * (high[1] - low[1])
    longest = float(max(high - low))  # of an outline without area the rows alone could be too many
    step = max(spacing, math.sqrt(box / MOST_INSIDE), longest / MOST_INSIDE)
    rows = np.arange(low[1] + 0.5 * step, high[1], step * math.sqrt(0.75))
    columns = np.arange(low[0], high[0], step)
    x = columns[None, :] + (0.5 * step * (np.arange(len(rows)) % 2))[:, None]
    grid = np.column_stack([x.ravel(), np.repeat(rows, len(columns))])
    inside = np.empty(len(grid), dtype=np.int64)
    mark_inside(grid, corners, inside)
    return grid[inside == 1]
