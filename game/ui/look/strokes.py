"""Strokes that signs are made of, drawn by their exact distance.

numpy draws them, because signs are needed while kernels still compile. A sign is a list of parts on a square
of 20 design px with the origin in its middle, x right, y down.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise

import numpy as np

Coverage = np.ndarray  # (n, n) 0 to 1, [x, y]
Part = Callable[["Paper"], None]
GRID = 20.0  # design px along a sign's side


class Paper:
    """A square picture of coverage that strokes are added to; lengths are design px."""

    def __init__(self, size: int) -> None:
        self.scale = size / GRID
        axis = (np.arange(size) + 0.5) / self.scale - 0.5 * GRID
        self.x, self.y = np.meshgrid(axis, axis, indexing="ij")
        self.coverage = np.zeros((size, size))

    def add(self, distance: np.ndarray, width: float = 0.0) -> None:
        """Add what lies within half a ``width`` of the zero of a distance; with no width, its inside."""
        half = 0.5 * width * self.scale
        d = distance * self.scale
        if width == 0.0:
            share = np.clip(0.5 - d, 0.0, 1.0)
        else:
            share = np.clip(np.minimum(half, np.abs(d) + 0.5) - np.maximum(-half, np.abs(d) - 0.5), 0.0, 1.0)
        self.coverage = np.maximum(self.coverage, share)

    def segment(self, x0: float, y0: float, x1: float, y1: float) -> np.ndarray:
        """Distance from a straight line between two points."""
        dx, dy = x1 - x0, y1 - y0
        t = np.clip(((self.x - x0) * dx + (self.y - y0) * dy) / (dx * dx + dy * dy), 0.0, 1.0)
        return np.hypot(self.x - x0 - t * dx, self.y - y0 - t * dy)

    def arc(self, x: float, y: float, radius: float, start: float, sweep: float) -> np.ndarray:
        """Distance from part of a circle; angles in degrees, clockwise on the screen."""
        dx, dy = self.x - x, self.y - y
        middle = math.radians(start + 0.5 * sweep)
        within = dx * math.cos(middle) + dy * math.sin(middle) >= np.hypot(dx, dy) * math.cos(
            math.radians(0.5 * sweep)
        )
        ends = [
            np.hypot(dx - radius * math.cos(math.radians(a)), dy - radius * math.sin(math.radians(a)))
            for a in (start, start + sweep)
        ]
        return np.where(within, np.abs(np.hypot(dx, dy) - radius), np.minimum(*ends))

    def polygon(self, points: tuple[tuple[float, float], ...]) -> np.ndarray:
        """Distance, negative inside, from a convex polygon given clockwise on the screen."""
        result = np.full(self.x.shape, -np.inf)
        for (x0, y0), (x1, y1) in zip(points, (*points[1:], points[0]), strict=True):
            length = math.hypot(x1 - x0, y1 - y0)
            side = ((self.x - x0) * (y1 - y0) - (self.y - y0) * (x1 - x0)) / length
            result = np.maximum(result, side)
        return result

    def box(self, half_x: float, half_y: float, radius: float, x: float = 0.0, y: float = 0.0) -> np.ndarray:
        """Distance, negative inside, from a box with round corners."""
        qx, qy = np.abs(self.x - x) - half_x + radius, np.abs(self.y - y) - half_y + radius
        outside = np.hypot(np.maximum(qx, 0.0), np.maximum(qy, 0.0))
        return outside + np.minimum(np.maximum(qx, qy), 0.0) - radius


def line(*points: tuple[float, float], width: float = 1.7) -> Part:
    """A stroke through points."""

    def draw(paper: Paper) -> None:
        for (x0, y0), (x1, y1) in pairwise(points):
            paper.add(paper.segment(x0, y0, x1, y1), width)

    return draw


def arc(x: float, y: float, radius: float, start: float, sweep: float, width: float = 1.6) -> Part:
    """A stroke along part of a circle; angles in degrees, clockwise on the screen."""
    return lambda paper: paper.add(paper.arc(x, y, radius, start, sweep), width)


def ring(x: float, y: float, radius: float, width: float = 1.6) -> Part:
    """A circle."""
    return lambda paper: paper.add(np.hypot(paper.x - x, paper.y - y) - radius, width)


def disc(x: float, y: float, radius: float) -> Part:
    """A filled circle."""
    return lambda paper: paper.add(np.hypot(paper.x - x, paper.y - y) - radius)


def solid(*points: tuple[float, float]) -> Part:
    """A filled convex polygon, its corners clockwise on the screen."""
    return lambda paper: paper.add(paper.polygon(points))


def frame(half_x: float, half_y: float, radius: float, width: float, x: float = 0.0, y: float = 0.0) -> Part:
    """The outline of a box with round corners."""
    return lambda paper: paper.add(paper.box(half_x, half_y, radius, x, y), width)


def right_half(radius: float) -> Part:
    """The right half of a filled circle."""
    return lambda paper: paper.add(np.maximum(np.hypot(paper.x, paper.y) - radius, -paper.x))


def teeth(count: int, inner: float, outer: float, width: float) -> Part:
    """Short strokes outwards, evenly about the middle."""

    def draw(paper: Paper) -> None:
        for i in range(count):
            c, s = math.cos(2.0 * math.pi * i / count), math.sin(2.0 * math.pi * i / count)
            paper.add(paper.segment(inner * c, inner * s, outer * c, outer * s), width)

    return draw
