"""Random convex polygons: on a small lattice, where ties abound, and with corners anywhere."""

from __future__ import annotations

import math

import numpy as np

from game.physics.narrowphase import ConvexPolygon, convex_hull


def lattice_polygon(random, side=7):
    """Hull of one to eight points of a small lattice."""
    corner = random.integers(-side // 2, side // 2, 2)
    return convex_hull(random.integers(0, side, (random.integers(1, 9), 2)) + corner)


def random_polygon(random, most=20):
    """Corners on an ellipse, in size from a tenth to ten."""
    count = int(random.integers(3, most))
    turns = np.sort(random.uniform(0.0, 2.0 * math.pi, count))
    points = np.column_stack((np.cos(turns), np.sin(turns))) * (1.0, random.uniform(0.05, 1.0))
    angle, size = random.uniform(0.0, math.pi), 10.0 ** random.uniform(-1.0, 1.0)
    c, s = math.cos(angle), math.sin(angle)
    return ConvexPolygon(size * points @ np.array([[c, s], [-s, c]]) + random.normal(0.0, 2.0, 2))
