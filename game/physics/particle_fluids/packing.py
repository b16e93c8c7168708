"""Places of particles at rest."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats


def lattice(low: tuple[float, float], high: tuple[float, float], spacing: float) -> Floats:
    """Places (n, 2) m that fill a rectangle, half a spacing off its edges, row by row."""
    across, up = (max(0, round((high[k] - low[k]) / spacing)) for k in range(2))
    x = low[0] + (np.arange(across) + 0.5) * spacing
    y = low[1] + (np.arange(up) + 0.5) * spacing
    return np.stack([np.tile(x, up), np.repeat(y, across)], axis=1)
