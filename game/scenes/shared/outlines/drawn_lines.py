"""Lines of a picture that words had better keep off, and the place among several where fewest of them run."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

import numpy as np

from game.arrays import Floats
from game.ui.canvas.canvas import Canvas

Offset = tuple[float, float]
SPACING = 7.0  # design px between the points that stand for a line
MOST_POINTS = 4_000  # of one line
SLIGHT = 2  # points under words that do not make them hard to read
OUTSIDE = 10_000  # what it counts to reach over the edge


class DrawnLines:
    """Points along the lines of one picture; places and sizes in design px about a world point."""

    def __init__(self, canvas: Canvas, lines: Iterable[tuple[Floats, bool]]):
        """lines: corners (n, 2) in the world, and whether the last leads back to the first."""
        self.canvas = canvas
        parts = [self._along(corners, closed) for corners, closed in lines]
        self.points: Floats = np.concatenate(parts) if parts else np.empty((0, 2))

    def _along(self, corners: Floats, closed: bool) -> Floats:
        """Points (m, 2) px along a line."""
        ends = np.array(self.canvas.place_all(np.asarray(corners, dtype=np.float64)))
        if closed and len(ends) > 2:
            ends = np.concatenate((ends, ends[:1]))
        if not len(ends) or not np.isfinite(ends).all():
            return ends[:0]
        if len(ends) == 1:
            return np.repeat(ends, SLIGHT + 1, axis=0)
        steps = np.diff(ends, axis=0)
        reach = np.concatenate(([0.0], np.cumsum(np.sqrt((steps * steps).sum(axis=1)))))
        count = min(math.ceil(reach[-1] / (SPACING * self.canvas.k)) + 1, MOST_POINTS)
        at = np.linspace(0.0, reach[-1], count)
        return np.column_stack([np.interp(at, reach, ends[:, axis]) for axis in range(2)])

    def under(self, point: Sequence[float], size: Offset, offset: Offset) -> int:
        """How many points lie under words of a size, whose middle is ``offset`` off a world point."""
        k, rect = self.canvas.k, self.canvas.rect
        x, y = self.canvas.place(point)
        x, y = x + offset[0] * k, y + offset[1] * k
        wide, high = 0.5 * size[0] * k, 0.5 * size[1] * k
        inside = (np.abs(self.points[:, 0] - x) < wide) & (np.abs(self.points[:, 1] - y) < high)
        count = int(np.count_nonzero(inside))
        if not (rect.left + wide <= x <= rect.right - wide and rect.top + high <= y <= rect.bottom - high):
            count += OUTSIDE
        return count

    def clearest(self, point: Sequence[float], size: Offset, offsets: Sequence[Offset], kept: int = 0) -> int:
        """Which of several offsets to take: the one ``kept`` before while it will do, else the clearest."""
        crossed = self.under(point, size, offsets[kept])
        if crossed <= SLIGHT:  # nearly always, so the others are not looked at
            return kept
        counts = [self.under(point, size, offset) for offset in offsets]
        least = min(counts)
        return kept if crossed <= 2 * least else counts.index(least)
