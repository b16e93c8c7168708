"""Signed distances in place and time: how far each place of a recorded run is from the liquid's surface.

A run is a stack of pictures. Its surface is a surface in (t, y, x), with times as lengths by a speed. Nearest
points pass from node to node in eight sweeps (Danielsson 1980).
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats, Longs
from game.compiler.decorator import inner_kernel, lean_kernel

INSIDE = 0.5  # of a node's surroundings: more is liquid
PLANE = 3.0  # steps: nearer to the surface, distances are from the plane through the nearest point
ROUNDS = 2  # of all eight sweeps


class Run(NamedTuple):
    """A recorded run. distance: (frames, rows, columns) m, below 0 in the liquid; points, normals: (n, 3) of
    its surface, outwards; steps: (3,) m from frame to frame, row to row, column to column.
    """

    distance: Floats
    points: Floats
    normals: Floats
    steps: Floats

    @property
    def empty(self) -> bool:
        """Whether there is no surface at all."""
        return len(self.points) == 0


@inner_kernel
def _square(points, k, t, y, x, steps):
    """Square of the distance from a node to a point, m²."""
    dt, dy, dx = points[k, 0] - t * steps[0], points[k, 1] - y * steps[1], points[k, 2] - x * steps[2]
    return dt * dt + dy * dy + dx * dx


@lean_kernel
def find_nearest(points, steps, nearest, square):
    """Number of the nearest point of each node (-1: none yet), and the square of its distance, m²."""
    frames, rows, columns = nearest.shape
    for k in range(len(points)):
        t, y, x = points[k, 0] / steps[0], points[k, 1] / steps[1], points[k, 2] / steps[2]
        for a in range(math.floor(t), math.ceil(t) + 1):
            for b in range(math.floor(y), math.ceil(y) + 1):
                for c in range(math.floor(x), math.ceil(x) + 1):
                    if 0 <= a < frames and 0 <= b < rows and 0 <= c < columns:
                        found = _square(points, k, a, b, c, steps)
                        if found < square[a, b, c]:
                            nearest[a, b, c], square[a, b, c] = k, found
    for sweep in range(8 * ROUNDS):
        da, db, dc = 1 - 2 * (sweep & 1), 1 - (sweep & 2), 1 - (sweep & 4) // 2
        for m in range(frames):
            a = m if da > 0 else frames - 1 - m
            for n in range(rows):
                b = n if db > 0 else rows - 1 - n
                for o in range(columns):
                    c = o if dc > 0 else columns - 1 - o
                    for side in range(1, 8):
                        i, j, k = a - da * (side & 1), b - db * (side >> 1 & 1), c - dc * (side >> 2)
                        if 0 <= i < frames and 0 <= j < rows and 0 <= k < columns and nearest[i, j, k] >= 0:
                            found = _square(points, nearest[i, j, k], a, b, c, steps)
                            if found < square[a, b, c]:
                                nearest[a, b, c], square[a, b, c] = nearest[i, j, k], found


def surface_points(fill: Floats, steps: Floats) -> tuple[Floats, Floats]:
    """Where a fill (frames, rows, columns) passes a half between nodes, (n, 3) m, and normals."""
    slopes = np.stack(
        [
            np.gradient(fill, step, axis=k) if fill.shape[k] > 1 else np.zeros_like(fill)
            for k, step in enumerate(steps.tolist())
        ],
        axis=-1,
    )
    points, normals = [], []
    for axis in range(3):
        low, high = (
            np.take(fill, range(fill.shape[axis] - 1), axis),
            np.take(fill, range(1, fill.shape[axis]), axis),
        )
        at = np.argwhere((low > INSIDE) != (high > INSIDE))
        here = tuple(at.T)
        share = (INSIDE - low[here]) / (high[here] - low[here])
        place = at.astype(np.float64)
        place[:, axis] += share
        points.append(place * steps)
        beyond = at.copy()
        beyond[:, axis] += 1
        slope = slopes[here] + share[:, None] * (slopes[tuple(beyond.T)] - slopes[here])
        normals.append(-slope / np.maximum(np.sqrt(np.sum(slope * slope, axis=1)), 1e-12)[:, None])
    return np.concatenate(points), np.concatenate(normals)


def run_of(fill: Floats, steps: tuple[float, float, float]) -> Run:
    """The run of a fill (frames, rows, columns) at nodes, 0 to 1; steps: m. ValueError for nonsense.

    Without a surface all distances are the diagonal, with the sign of what is there.
    """
    fill, lengths = np.ascontiguousarray(fill, dtype=np.float64), np.array(steps, dtype=np.float64)
    if fill.ndim != 3 or not fill.size or not np.isfinite(fill).all():
        raise ValueError(f"fill: expected finite numbers (frames, rows, columns), not {fill.shape}")
    if lengths.shape != (3,) or not ((lengths > 0.0) & np.isfinite(lengths)).all():
        raise ValueError(f"steps = {steps!r}: expected three lengths above 0 m")
    points, normals = surface_points(fill, lengths)
    far = float(np.sqrt(np.sum(np.square(lengths * fill.shape))))
    nearest: Longs = np.full(fill.shape, -1, dtype=np.int64)
    square: Floats = np.full(fill.shape, far * far)
    find_nearest(points, lengths, nearest, square)
    distance = np.sqrt(square)
    at = np.argwhere((nearest >= 0) & (distance < PLANE * float(np.max(lengths))))
    here = tuple(at.T)
    across = np.abs(np.sum((at * lengths - points[nearest[here]]) * normals[nearest[here]], axis=1))
    distance[here] = np.maximum(across, 0.5 * distance[here])
    return Run(np.where(fill > INSIDE, -1.0, 1.0) * distance, points, normals, lengths)


def lasting(run: Run, frames: int) -> Run:
    """The run with its last picture held until there are so many frames. It never becomes shorter."""
    more = frames - len(run.distance)
    if more <= 0:
        return run
    held = np.concatenate([run.distance, np.repeat(run.distance[-1:], more, axis=0)])
    return run._replace(distance=held)


def area_of(distance: Floats, cell: float) -> float:
    """m² of liquid in a picture (rows, columns) of signed distances m; nodes at its rim count in part."""
    share = np.clip(0.5 - distance / cell, 0.0, 1.0)
    rows, columns = (np.ones(length) for length in distance.shape)
    rows[[0, -1]], columns[[0, -1]] = 0.5, 0.5
    return float(np.sum(share * rows[:, None] * columns[None, :])) * cell * cell
