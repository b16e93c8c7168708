"""Where a figure is drawn: the whole picture, or a cell of it beside other figures."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


class Cell(NamedTuple):
    """Where a figure is drawn: its own coordinates times ``scale``, plus an origin."""

    x: float = 0.0
    y: float = 0.0
    scale: float = 1.0

    def out(self, points: Array) -> Array:
        """Places in the picture of points (m, 2) of the figure."""
        if self is WHOLE:
            return points
        origin = np.array((self.x, self.y))
        return points + origin if self.scale == 1.0 else points * self.scale + origin

    def into(self, x: float, y: float) -> tuple[float, float]:
        """The point of the figure at a place in the picture."""
        return (x - self.x) / self.scale, (y - self.y) / self.scale


WHOLE = Cell()
