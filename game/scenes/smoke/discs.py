"""Discs that stand or move in the smoke."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.physics.surfaces.surface import Sample, empty_sample

X, Y, RADIUS, VX, VY = range(5)  # columns of a disc: place m, radius m, velocity m/s


class DiscObstacles:
    """Discs (n, 5) as solids of a gas."""

    def __init__(self) -> None:
        self.rows: Floats = np.zeros((0, 5))

    def sample(self, points: ArrayLike) -> Sample:
        """Of the nearest disc."""
        places = np.asarray(points, dtype=np.float64)
        found = empty_sample(len(places))
        for number, (x, y, radius, vx, vy) in enumerate(self.rows.tolist()):
            dx, dy = places[:, 0] - x, places[:, 1] - y
            away = np.sqrt(dx * dx + dy * dy)
            nearer = away - radius < found.distance
            found.distance[nearer] = away[nearer] - radius
            found.velocity[nearer] = vx, vy
            found.body[nearer] = number
        return found
